#include "output/trace_words/pseudo_code.h"

#include <algorithm>
#include <span>

#include "evenlift/output/trace_words.h"
#include "evenlift/stands.h"
#include "output/trace_words/step_words.h"

namespace evenlift {
namespace {

struct Line {
  Statement statement;
  std::string_view text;
};

constexpr Line head[] = {
    {Statement::centre, "C := the given centre of mass, or else the centroid of the object"}};
constexpr Line with_cargo[] = {
    {Statement::cargo, "for each item of cargo: C := (W C + w q) / (W + w), W := W + w"}};
constexpr Line with_a_size[] = {
    {Statement::stands, "use only the parts of the boundary where a robot can stand"}};
constexpr Line by_candidates[] = {
    {Statement::each_vertex, "for each vertex v, in the order in which C sees them"},
    {Statement::each_hit, "  for each boundary point r straight across C: note the chord v r"},
    {Statement::sort_chords, "sort the chords by slope"},
    {Statement::each_pair, "for each pair of edges a, b that face each other across C"},
    {Statement::sections, "  a', b' := the parts of a and b that face each other"},
    {Statement::parallel, "  if a' and b' are parallel: chord := the one between their middles"},
    {Statement::bisecting, "  else if C bisects a chord between a' and b': chord := that one"},
    {Statement::nearer_end, "  else: chord := the one at the end with the larger load ratio"},
    {Statement::accept, "  if its load ratio ≥ the minimum: it is a candidate"},
    {Statement::opposite, "the same for each chord between two vertices opposite across C"},
    {Statement::merge, "merge candidates that are the same chord"},
    {Statement::order, "keep the candidates in order of slope"},
    {Statement::first_team, "first team := the longest even candidate, else the most even one"},
    {Statement::first_base, "H := the segment between its robots"},
    {Statement::each_team, "for each further team, while candidates are left"},
    {Statement::scores, "  for each candidate r1 r2: score := f(r1) + f(r2)"},
    {Statement::next_team, "  team := the candidate with the largest score"},
    {Statement::wider_base, "  H := the convex hull of H and its robots"}};
constexpr Line in_ranges[] = {
    {Statement::range,
     "  the same for chords 1/16 from either end of the range of load ratios ≥ the minimum"}};
constexpr Line longest_first[] = {{Statement::first_team, "first team := the longest candidate"}};
constexpr Line to_hold[] = {
    {Statement::swap, "while a swap of a team for a candidate is better: make the best swap"}};
constexpr Line by_angle[] = {
    {Statement::open_directions,
     "V := the directions whose line through C meets the boundary on both sides"},
    {Statement::each_team, "for each team k = 1 … t"},
    {Statement::direction,
     "  direction := at (k − 1/2)/t of V; robots at the farthest boundary points"},
    {Statement::wider_base, "  H := the convex hull of H and its robots"}};
constexpr Line by_chance[] = {
    {Statement::each_team, "for each team"},
    {Statement::first_robot, "  r1 := a random point of the boundary"},
    {Statement::second_robot,
     "  r2 := one of the boundary points straight across C; if none, draw again"},
    {Statement::wider_base, "  H := the convex hull of H and its robots"}};
constexpr Line by_centroid[] = {
    {Statement::centroid_law, "m robots can carry W/m each if C is the centroid of their places"},
    {Statement::each_number, "for i = 2 … m: to a set Q of i − 2 robots, add two more"},
    {Statement::middle, "  M := (i C − the sum of Q) / 2, the middle between the two"},
    {Statement::even_chords,
     "  chords := through M, between points where P meets P turned about M"},
    {Statement::best_set,
     "  S(i) := the best of S(i − 2) plus two, S(i − 3) plus a trial point and two"},
    {Statement::exchange, "for each three robots of S: S := the best with three others instead"},
    {Statement::rounds, "repeat until a round changes nothing, at most 8 times"}};
constexpr Line equal_loads[] = {
    {Statement::equal_loads, "loads := W/m for each robot"},
    {Statement::failures, "for each robot that fails: is C within the hull of the others?"}};
constexpr Line by_hand[] = {
    {Statement::each_support, "for each support: it stands at the edge if near it, else beneath"},
    {Statement::wider_base, "H := the convex hull of the robots"}};
constexpr Line loads_of_springs[] = {
    {Statement::equations, "if C is outside H: the object falls"},
    {Statement::springs, "loads := max(0, a + b · p) for a robot at p, in balance about C"}};
constexpr Line loads_of_teams[] = {
    {Statement::loads, "for each team: a robot carries W/t × the other's arm / the chord"}};
constexpr Line tail[] = {
    {Statement::coverage, "coverage := area of the object in H / area of the object"},
    {Statement::cut, "for each contact: cut the free rotation centres at its normal line"},
    {Statement::slide, "slide := is some direction blocked by no contact?"},
    {Statement::form_closure, "form closure := no rotation centre is left, and no slide"},
    {Statement::second_order,
     "second order := does the curvature stop every motion that is left?"}};

// For positions in the range and for the goal `hold`.
void adapt(std::vector<Line>& lines, const Settings& settings) {
  const auto at = [&](Statement statement) {
    return std::find_if(lines.begin(), lines.end(),
                        [&](const Line& line) { return line.statement == statement; });
  };
  if (settings.positions == Positions::range) {
    *at(Statement::first_team) = longest_first[0];
    lines.insert(at(Statement::opposite), in_ranges[0]);
  }
  if (swaps_teams(settings)) lines.insert(at(Statement::loads), to_hold[0]);
}

std::vector<Line> program(const Settings& settings) {
  const Method method = settings.method;
  std::span<const Line> selection = by_candidates;
  if (method == Method::distributed) selection = by_angle;
  if (method == Method::random) selection = by_chance;
  if (method == Method::balanced) selection = by_centroid;
  if (method == Method::given) selection = by_hand;
  const std::span<const Line> loads =
      method == Method::balanced ? std::span<const Line>(equal_loads)
      : method == Method::given  ? std::span<const Line>(loads_of_springs)
                                 : loads_of_teams;
  std::vector<Line> lines(std::begin(head), std::end(head));
  if (!settings.cargo.empty()) lines.push_back(with_cargo[0]);
  if (!stands_anywhere(settings)) lines.push_back(with_a_size[0]);
  lines.insert(lines.end(), selection.begin(), selection.end());
  lines.insert(lines.end(), loads.begin(), loads.end());
  lines.insert(lines.end(), std::begin(tail), std::end(tail));
  if (selects_candidates(method)) adapt(lines, settings);
  return lines;
}

}  // namespace

Statement statement_of_outcome(const Trace&, const StepDetail& detail) {
  switch (detail.pair->outcome) {
    case Outcome::bisecting:
      return Statement::bisecting;
    case Outcome::nearer_end:
      return Statement::nearer_end;
    case Outcome::midpoint:
      return Statement::parallel;
    case Outcome::too_uneven:
    case Outcome::parallel_low:
      break;
  }
  return Statement::accept;
}

Statement statement_of_scores(const Trace&, const StepDetail& detail) {
  return detail.step.item == 0 ? Statement::first_team : Statement::scores;
}

Statement statement_of_team(const Trace& trace, const StepDetail& detail) {
  switch (trace.placement.settings.method) {
    case Method::distributed:
      return Statement::direction;
    case Method::random:
      return Statement::first_robot;
    case Method::area:
    case Method::circle:
    case Method::distance:
    case Method::balanced:
    case Method::given:
      break;
  }
  return detail.step.item == 0 ? Statement::first_team : Statement::next_team;
}

Statement statement_of_fewer(const Trace& trace, const StepDetail&) {
  return trace.balanced() ? Statement::each_number : Statement::each_team;
}

Statement statement_of_loads(const Trace& trace, const StepDetail&) {
  return trace.balanced() ? Statement::equal_loads
         : trace.given()  ? Statement::springs
                          : Statement::loads;
}

Statement statement_of_base(const Trace& trace, const StepDetail& detail) {
  return trace.by_candidates() && detail.step.item == 0 ? Statement::first_base
                                                        : Statement::wider_base;
}

std::vector<std::string_view> pseudo_code(const Settings& settings) {
  std::vector<std::string_view> texts;
  for (const Line& line : program(settings)) texts.push_back(line.text);
  return texts;
}

std::uint32_t pseudo_line(const Trace& trace, const StepDetail& detail) {
  const Statement statement = statement_of(trace, detail);
  const std::vector<Line> lines = program(trace.placement.settings);
  const auto line = std::find_if(lines.begin(), lines.end(),
                                 [&](const Line& l) { return l.statement == statement; });
  return static_cast<std::uint32_t>(line - lines.begin());
}

}  // namespace evenlift
