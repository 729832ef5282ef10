// A whole trace as `evenlift trace` prints it.
#pragma once

#include <optional>
#include <string>

#include "evenlift/result.h"
#include "evenlift/trace.h"

namespace evenlift {

// Bounds of a trace that is printed as a whole: its steps, and the candidates compared in all its
// choices together. The error says which bound it exceeds.
inline constexpr std::uint32_t most_printed_steps = 50000;
inline constexpr std::uint64_t most_printed_comparisons = 1u << 21;
std::optional<InputError> check_printed_size(const Trace& trace);

// An array with one object for each step: kind, chapter, item, caption, formula, code (the line of
// pseudo-code), numbers, the ten best of a choice, a learner's question with its answer, and up to
// a hundred shapes. As in json.h: the same bytes on every platform. O(output) and look_at for each
// step.
std::string trace_json(const Trace& trace);

// The trace for people: a numbered list of captions and formulas under the chapters' titles.
std::string trace_list(const Trace& trace);

}  // namespace evenlift
