// Puts the walkthrough into words: captions and formulas with the numbers of the traced polygon,
// the algorithm as pseudo-code, and answers to "why not this one?". All texts are in plain English
// or the reader's language (wording.h), in UTF-8, with the same bytes on every platform. Vertices,
// edges, candidates, teams and robots are counted from 1.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "evenlift/trace.h"
#include "evenlift/why_not.h"

namespace evenlift {

// Returns a chapter's title, such as "Edges that face each other". O(1).
std::string_view title(Chapter chapter);

// Describes a step in one to three sentences. Most steps cost O(1) plus the cost of numbers()
// (trace.h).
std::string caption(const Trace& trace, const StepDetail& detail);

// For the step `sections`, returns the caption that is shown until the learner has answered which
// of the two end chords is more even. The caption does not state the load ratios. O(1).
std::string caption_before_choice(const Trace& trace, const StepDetail& detail);

// Returns the step's formula, such as "load ratio = 47.5 / 50.1 = 0.948 ≥ 0.8". The text is empty
// if there is nothing to calculate. O(1).
std::string formula(const Trace& trace, const StepDetail& detail);

// Explains the formula's letters in one or two sentences. The text is empty if no letter needs an
// explanation. O(1).
std::string_view formula_letters(const Trace& trace, const StepDetail& detail);

// Returns the pseudo-code of the algorithm for the method, positions and goal in `settings`. Each
// line is one statement, indented by two spaces for each level. O(1).
std::vector<std::string_view> pseudo_code(const Settings& settings);

// Returns the index, from 0, of the line of pseudo_code() that the step executes. O(1).
std::uint32_t pseudo_line(const Trace& trace, const StepDetail& detail);

// Puts a question from question() (trace.h) into words. O(1).
std::string question_text(const Trace& trace, const StepDetail& detail, const Question& question);

// Explains with numbers why a team stands where it does, for readers who do not know the algorithm.
// O(1).
std::string why_here_text(const Trace& trace, const TeamScores& scores);

// Explains with numbers why no team stands on a chord, or which team does. O(1).
std::string why_not_text(const Trace& trace, const WhyNot& answer);

// Explains why no balanced robot stands at a place, or why one does. O(1).
std::string why_no_robot_text(const Trace& trace, const WhyNoRobot& answer);

// Compares the step's set of balanced robots with the set that would result if two of them took
// another even chord. `choice` is the number of that chord, from 0. The cost is that of
// compare_even_chord() (why_not.h).
std::string even_chord_text(const Trace& trace, const StepDetail& detail, std::uint32_t choice);

// Compares the step's swap of teams with the swap that a learner chooses by answering `choice`. The
// cost is that of compare_swap() (why_not.h).
std::string other_swap_text(const Trace& trace, const StepDetail& detail, const Question& question,
                            std::uint32_t choice);

// Describes a figure, such as the one under the pointer: "candidate 4, ratio 0.951", "team 2, robot
// 1: 15.7 of 100". O(1).
std::string figure_text(const Trace& trace, const StepDetail& detail, const Figure& figure);

// Returns the label of a part of the object: "edge 4", "vertex 2", "image of edge 1", "centroid".
// The text is empty for other figures. O(1).
std::string part_name(const Figure& figure);

}  // namespace evenlift
