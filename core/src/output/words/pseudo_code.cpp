// The algorithm in our own words, and which line of it a step carries out.
#include "evenlift/output/trace_words.h"

namespace evenlift {
namespace {

constexpr std::string_view head = "C := the centre of mass given, or else the centroid of P";
constexpr std::string_view candidate_lines[] = {
    "for each vertex v, in the order in which C sees them",
    "  for each boundary point r straight across C: note the chord v r",
    "sort the chords by slope",
    "for each pair of edges a, b that face each other across C",
    "  a', b' := the parts that do; they end at two of the chords",
    "  if a' and b' are parallel: chord := the one between their middles",
    "  else if C bisects a chord between a' and b': chord := that one",
    "  else: chord := the one at the end with the larger load ratio",
    "  if its load ratio ≥ the minimum: it is a candidate",
    "likewise the chord between each two vertices opposite each other across C",
    "merge candidates that are the same chord",
    "keep the candidates in order of slope",
    "first team := the longest even candidate, else the most even one",
    "H := the segment between its robots",
    "for each further team, while candidates are left",
    "  for each candidate r1 r2: score := gain(r1) + gain(r2)",
    "  team := the candidate with the largest score",
    "  H := the convex hull of H and its robots"};
constexpr std::string_view distributed_lines[] = {
    "V := the directions whose line through C meets the boundary on both sides",
    "for each team k = 1 … t",
    "  direction := at (k − 1/2)/t of V; robots at the farthest boundary points",
    "  H := the convex hull of H and its robots"};
constexpr std::string_view random_lines[] = {
    "for each team", "  r1 := a random point of the boundary",
    "  r2 := one of the boundary points straight across C; if none, draw again",
    "  H := the convex hull of H and its robots"};
constexpr std::string_view tail[] = {
    "for each team: a robot bears W/t × the other's arm / the chord",
    "coverage := area of P in H / area of P",
    "for each contact: cut the free rotation centres by its normal line",
    "slide := is some direction against no contact?",
    "form closure := no rotation centre is left, and no slide",
    "second order := does the curvature stop every motion that is left?"};

// Lines counted from the first after the head.
std::uint32_t line_by_candidates(const StepDetail& detail) {
  switch (detail.step.kind) {
    case StepKind::radial:
      return 0;
    case StepKind::ray:
      return 1;
    case StepKind::slopes:
      return 2;
    case StepKind::sections:
      return 4;
    case StepKind::outcome:
      switch (detail.pair->outcome) {
        case Outcome::bisecting:
          return 6;
        case Outcome::nearer_end:
          return 7;
        case Outcome::midpoint:
          return 5;
        default:
          return 8;
      }
    case StepKind::opposite:
      return 9;
    case StepKind::duplicates:
      return 10;
    case StepKind::candidates:
      return 11;
    case StepKind::scores:
      return detail.step.item == 0 ? 12 : 15;
    case StepKind::team:
      return detail.step.item == 0 ? 12 : 16;
    case StepKind::base:
      return detail.step.item == 0 ? 13 : 17;
    default:
      return 14;  // fewer
  }
}

std::uint32_t line_of_other(Method method, StepKind kind) {
  const bool distributed = method == Method::distributed;
  switch (kind) {
    case StepKind::directions:
      return 0;
    case StepKind::team:
      return distributed ? 2 : 1;
    case StepKind::base:
      return 3;
    default:
      return distributed ? 1 : 0;  // fewer
  }
}

// Of the tail.
std::uint32_t line_of_tail(StepKind kind) {
  switch (kind) {
    case StepKind::share:
    case StepKind::loads:
      return 0;
    case StepKind::coverage:
      return 1;
    case StepKind::contacts:
    case StepKind::cut:
      return 2;
    case StepKind::slide:
      return 3;
    case StepKind::second_order:
      return 5;
    default:
      return 4;
  }
}

std::vector<std::string_view> middle(Method method) {
  if (method == Method::distributed)
    return {std::begin(distributed_lines), std::end(distributed_lines)};
  if (method == Method::random) return {std::begin(random_lines), std::end(random_lines)};
  return {std::begin(candidate_lines), std::end(candidate_lines)};
}

}  // namespace

std::vector<std::string_view> pseudo_code(Method method) {
  std::vector<std::string_view> lines = middle(method);
  lines.insert(lines.begin(), head);
  lines.insert(lines.end(), std::begin(tail), std::end(tail));
  return lines;
}

std::uint32_t pseudo_line(const Trace& trace, const StepDetail& detail) {
  const Method method = trace.placement.settings.method;
  if (detail.step.chapter == Chapter::object) return 0;
  if (detail.step.chapter >= Chapter::loads)
    return 1 + static_cast<std::uint32_t>(middle(method).size()) + line_of_tail(detail.step.kind);
  return 1 + (trace.by_candidates() ? line_by_candidates(detail)
                                    : line_of_other(method, detail.step.kind));
}

}  // namespace evenlift
