// The lesson in words: captions with this polygon's own numbers, formulas with the numbers filled
// in, the algorithm as pseudo-code, and answers to "why not this one?". All texts are plain English
// in UTF-8, the same bytes on every platform. Vertices, edges, candidates and teams count from 1.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "evenlift/trace.h"
#include "evenlift/why_not.h"

namespace evenlift {

// "Edges that face each other". O(1).
std::string_view title(Chapter chapter);

// One to three sentences about a step. O(1) besides numbers(); of `slopes` and `duplicates` linear.
std::string caption(const Trace& trace, const StepDetail& detail);

// The caption of the step `sections` for a learner who is going to be asked which end is more even:
// it leaves the load ratios out. O(1).
std::string caption_before_choice(const Trace& trace, const StepDetail& detail);

// The step's formula with the numbers filled in, "load ratio = 47.5 / 50.1 = 0.948 ≥ 0.8"; empty
// where there is nothing to calculate. O(1).
std::string formula(const Trace& trace, const StepDetail& detail);

// What the letters of the step's formula stand for, in one or two sentences; empty if it has no
// letters that need a word. O(1).
std::string_view formula_letters(const Trace& trace, const StepDetail& detail);

// The algorithm as pseudo-code, for the method, positions and goal of the settings. Each line is a
// statement, indented by two spaces for each level. O(1).
std::vector<std::string_view> pseudo_code(const Settings& settings);

// Which of these lines the step carries out, from 0. O(1).
std::uint32_t pseudo_line(const Trace& trace, const StepDetail& detail);

// What a learner is asked before the step is shown: question(trace, detail) in words. O(1).
std::string question_text(const Trace& trace, const StepDetail& detail, const Question& question);

// Why a team stands where it does, with the numbers, for somebody who does not know the algorithm.
// O(1).
std::string why_here_text(const Trace& trace, const TeamScores& scores);

// Why a chord is not a team, or which one it is, with the numbers. O(1).
std::string why_not_text(const Trace& trace, const WhyNot& answer);

// Why no balanced robot stands at a place, or why one does. O(1).
std::string why_no_robot_text(const Trace& trace, const WhyNoRobot& answer);

// What the set would be like with two robots on another of the even chords. The cost is that of
// compare_even_chord().
std::string even_chord_text(const Trace& trace, const StepDetail& detail, std::uint32_t choice);

// What another answer to a question about an exchange of teams would lead to. The cost is that of
// compare_swap().
std::string other_swap_text(const Trace& trace, const StepDetail& detail, const Question& question,
                            std::uint32_t choice);

// What a figure is, shown when the pointer is over it: "candidate 4, ratio 0.951", "team 2, robot
// 1: 15.7 of 100". O(1).
std::string figure_text(const Trace& trace, const StepDetail& detail, const Figure& figure);

// What is written beside a part of the object in a picture: "edge 4", "vertex 2", "image of edge
// 1", "centroid"; empty for any other figure. O(1).
std::string part_name(const Figure& figure);

}  // namespace evenlift
