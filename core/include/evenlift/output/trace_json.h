// Writes a whole trace as `evenlift trace` prints it.
#pragma once

#include <optional>
#include <string>

#include "evenlift/result.h"
#include "evenlift/trace.h"

namespace evenlift {

// Checks the limits on the steps of a whole trace, and on the candidates compared in all its
// choices together. The error says which limit is exceeded.
inline constexpr std::uint32_t most_printed_steps = 50000;
inline constexpr std::uint64_t most_printed_comparisons = 1u << 21;
std::optional<InputError> check_printed_size(const Trace& trace);

// Returns an array with one object for each step. It contains the kind, chapter, item, caption,
// formula, code (the line of pseudo-code), numbers, the ten best candidates of a choice, the
// question for a learner with its answer, and up to a hundred shapes. The bytes are the same on
// every platform. O(output), plus look_at() for each step.
std::string trace_json(const Trace& trace);

// Returns a numbered list of captions and formulas under the chapters' titles.
std::string trace_list(const Trace& trace);

}  // namespace evenlift
