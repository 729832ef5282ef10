#include <algorithm>
#include <iterator>

#include "evenlift/trace.h"
#include "trace/step_figures.h"
#include "trace/step_numbers.h"

namespace evenlift {
namespace {

constexpr std::string_view chapter_names[] = {
    "object",   "law",        "robots",     "vertex_chords", "slopes",
    "pairs",    "candidates", "first_team", "further_teams", "start",
    "exchange", "swaps",      "loads",      "failures",      "grasp"};
static_assert(std::size(chapter_names) == chapter_count);

// The words are in a row of output/trace_words/step_words.cpp.
struct StepRow {
  StepKind kind;
  std::string_view name;
  void (StepNumbers::*numbers)();
  void (StepFigures::*figures)();
};

using N = StepNumbers;
using F = StepFigures;
// clang-format off
constexpr StepRow steps[] = {
    {StepKind::polygon,      "polygon",      &N::polygon,      &F::polygon},
    {StepKind::centroid,     "centroid",     &N::centroid,     &F::centroid},
    {StepKind::centre,       "centre",       &N::centre,       &F::centre},
    {StepKind::radial,       "radial",       &N::radial,       &F::radial},
    {StepKind::ray,          "ray",          &N::ray,          &F::ray},
    {StepKind::slopes,       "slopes",       &N::slopes,       &F::slopes},
    {StepKind::sections,     "sections",     &N::sections,     &F::sections},
    {StepKind::outcome,      "outcome",      &N::outcome,      &F::outcome},
    {StepKind::opposite,     "opposite",     &N::opposite,     &F::opposite},
    {StepKind::duplicates,   "duplicates",   &N::duplicates,   &F::candidates},
    {StepKind::candidates,   "candidates",   &N::candidates,   &F::candidates},
    {StepKind::directions,   "directions",   &N::directions,   &F::none},
    {StepKind::scores,       "scores",       &N::scores,       &F::scores},
    {StepKind::team,         "team",         &N::team,         &F::team},
    {StepKind::base,         "base",         &N::base,         &F::base},
    {StepKind::fewer,        "fewer",        &N::fewer,        &F::none},
    {StepKind::share,        "share",        &N::share,        &F::share},
    {StepKind::loads,        "loads",        &N::loads,        &F::loads},
    {StepKind::coverage,     "coverage",     &N::coverage,     &F::coverage},
    {StepKind::contacts,     "contacts",     &N::contacts,     &F::contacts},
    {StepKind::cut,          "cut",          &N::cut,          &F::cut},
    {StepKind::slide,        "slide",        &N::slide,        &F::slide},
    {StepKind::closure,      "closure",      &N::closure,      &F::closure},
    {StepKind::second_order, "second_order", &N::second_order, &F::closure},
    {StepKind::result,       "result",       &N::result,       &F::result},
    {StepKind::lever,        "lever",        &N::lever,        &F::lever},
    {StepKind::three,        "three",        &N::three,        &F::three},
    {StepKind::many,         "many",         &N::many,         &F::many},
    {StepKind::rest,         "rest",         &N::rest,         &F::rest},
    {StepKind::mirror,       "mirror",       &N::mirror,       &F::mirror},
    {StepKind::completion,   "completion",   &N::completion,   &F::completion},
    {StepKind::start,        "start",        &N::start,        &F::start},
    {StepKind::exchange,     "exchange",     &N::exchange,     &F::exchange},
    {StepKind::round,        "round",        &N::round,        &F::round},
    {StepKind::settled,      "settled",      &N::settled,      &F::round},
    {StepKind::failure,      "failure",      &N::failure,      &F::failure},
    {StepKind::failures,     "failures",     &N::failures,     &F::round},
    {StepKind::pairs,        "pairs",        &N::pairs,        &F::pairs},
    {StepKind::range,        "range",        &N::range,        &F::range},
    {StepKind::swap,         "swap",         &N::swap,         &F::swap},
    {StepKind::held,         "held",         &N::held,         &F::held},
    {StepKind::stands,       "stands",       &N::stands,       &F::stands},
    {StepKind::support,      "support",      &N::support,      &F::support},
    {StepKind::equations,    "equations",    &N::equations,    &F::equations},
    {StepKind::by_lever,     "by_lever",     &N::each_load,    &F::by_lever},
    {StepKind::by_areas,     "by_areas",     &N::each_load,    &F::by_areas},
    {StepKind::by_springs,   "by_springs",   &N::by_springs,   &F::by_springs},
    {StepKind::extremes,     "extremes",     &N::extremes,     &F::extremes},
    {StepKind::falls,        "falls",        &N::falls,        &F::falls},
    {StepKind::cargo,        "cargo",        &N::cargo,        &F::cargo},
};
// clang-format on

static_assert(has_each_step(steps));

const StepRow& row_of(StepKind kind) { return steps[static_cast<std::size_t>(kind)]; }

constexpr std::string_view figure_names[] = {
    "object",      "triangle",      "centroid",    "centre",
    "vertex",      "radial_edge",   "ray",         "chord",
    "edge",        "section",       "reflected",   "section_end",
    "bisecting",   "chosen",        "candidate",   "team",
    "robot",       "gain_triangle", "gain_part",   "gain_circle",
    "arm_before",  "arm_after",     "base_before", "base",
    "contact",     "normal",        "clockwise",   "counterclockwise",
    "translation", "lever",         "side",        "arm",
    "sum",         "middle",        "stand",       "mirrored",
    "even_chord",  "left",          "way",         "range",
    "range_end",   "former",        "unusable",    "body",
    "hand",        "share",         "level",       "sinks",
    "hole",        "hole_part",     "cargo",       "old_centre"};
static_assert(std::size(figure_names) == figure_kind_count);

}  // namespace

std::string_view name(Chapter chapter) { return chapter_names[static_cast<std::size_t>(chapter)]; }

std::string_view name(StepKind kind) { return row_of(kind).name; }

std::string_view name(FigureKind kind) { return figure_names[static_cast<std::size_t>(kind)]; }

std::optional<StepKind> step_kind_from_name(std::string_view text) {
  const auto* row = std::find_if(std::begin(steps), std::end(steps),
                                 [&](const StepRow& r) { return r.name == text; });
  return row == std::end(steps) ? std::nullopt : std::optional(row->kind);
}

std::vector<Number> numbers(const Trace& trace, const StepDetail& detail) {
  StepNumbers numbers(trace, detail);
  (numbers.*row_of(detail.step.kind).numbers)();
  return std::move(numbers).take();
}

std::vector<Figure> figures(const Trace& trace, const StepDetail& detail) {
  StepFigures figures(trace, detail);
  (figures.*row_of(detail.step.kind).figures)();
  return std::move(figures).take();
}

}  // namespace evenlift
