// Writes a whole trace as `evenlift trace` prints it.
#pragma once

#include <optional>
#include <string>

#include "evenlift/result.h"
#include "evenlift/trace.h"

namespace evenlift {

// Checks that a whole trace has at most most_printed_steps steps, and that its number of `scores`
// steps times its number of candidates is at most most_printed_comparisons. The error says which
// limit is exceeded.
inline constexpr std::uint32_t most_printed_steps = 50000;
inline constexpr std::uint64_t most_printed_comparisons = 1u << 21;
std::optional<InputError> check_printed_size(const Trace& trace);

// Returns an array with one object for each step. The object contains `kind`, `chapter`, `item`,
// `caption`, `formula`, `code` (the line of pseudo-code), `numbers`, and up to a hundred of the
// step's figures, without outline and holes. In `scores` steps, it also contains the ten best
// candidates; in steps with a question for a learner, the question and its answer. The bytes are
// the same on every platform. O(output), plus the cost of look_at() for each step.
std::string trace_json(const Trace& trace);

// Returns the captions and formulas of all steps as a numbered list under the titles of the
// chapters.
std::string trace_list(const Trace& trace);

}  // namespace evenlift
