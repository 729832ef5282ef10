#include "output/trace_words/step_words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "evenlift/output/trace_words.h"
#include "evenlift/output/words.h"
#include "evenlift/stands.h"
#include "evenlift/wording.h"

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

namespace {

class FigureWords {
 public:
  FigureWords(const Trace& trace, const StepDetail& detail, const Figure& figure)
      : trace_(trace), detail_(detail), figure_(figure), index_(figure.item.value_or(0)) {}

  std::string item() const { return written(counted_from_1(index_)); }
  std::string number_of_robot() const { return written(whole(trace_.placement.number_of(index_))); }
  std::string ratio() const { return written(ratio_text(figure_.value, least_ratio())); }
  std::string point() const { return written(point_text(trace_, figure_.points[0])); }
  std::string length() const { return written(length_text(trace_, figure_.value)); }
  std::string gain() const { return written(score_text(trace_, Rule::score, figure_.value, 0)); }

  std::string signed_share() const {
    return (figure_.value < 0 ? "−" : "") + written(percent(std::abs(figure_.value)));
  }
  std::string start_of_chord() const {
    return written(counted_from_1(trace_.rays.chords[index_].vertex));
  }
  std::string robot_of_contact() const {
    return written(whole(trace_.placement.number_of(trace_.contacts[index_].point)));
  }
  std::string edge_of_contact() const {
    return written(counted_from_1(trace_.contacts[index_].edge));
  }
  std::string edge_of_unusable() const {
    return written(counted_from_1(trace_.placement.stands->unusable()[index_].edge));
  }
  std::string why_unusable() const {
    const Stands& stands = *trace_.placement.stands;
    return unusable_in_words(stands.unusable()[index_].why, stands.robot(), trace_.units);
  }

  std::string chosen() const {
    if (detail_.balanced) return "The chord that two robots take, with M in its middle";
    return fill(detail_.opposite ? "The chord between the two vertices, load ratio {ratio}"
                : !figure_.item  ? "The best chord of the edge pair, load ratio {ratio}"
                                 : "The edge pair's candidate, load ratio {ratio}",
                {ratio()});
  }
  std::string candidate() const {
    const Piece ratio = ratio_text(trace_.placement.candidates[index_].chord.ratio, least_ratio());
    if (!detail_.scores || detail_.scores->rule == Rule::most_even)
      return fill("Candidate {candidate}, load ratio {ratio}", {item(), ratio});
    const Score& score = detail_.scores->of_candidate[index_];
    const Rule rule = detail_.scores->rule;
    return fill(
        rule == Rule::score ? "Candidate {candidate}, load ratio {ratio}, score {score}"
                            : "Candidate {candidate}, load ratio {ratio}, length {length}",
        {item(), ratio, score_or_bound(score_text(trace_, rule, score.value, 0), score.exact)});
  }
  std::string gain_area() const {
    switch (trace_.metric()) {
      case Metric::area:
        return fill("Adds {area} of the object to H", {gain()});
      case Metric::circle:
      case Metric::distance:
        break;
    }
    return "Triangle between H and the end";
  }
  std::string robot() const {
    std::string text;
    if (trace_.balanced() || trace_.given()) {
      text = fill("Robot {robot}", {number_of_robot()});
    } else {
      const auto [team, number] = find_robot(trace_.placement.teams, index_);
      text = fill("Team {team}, robot {robot}", {counted_from_1(team), counted_from_1(number)});
    }
    if (!(figure_.value > 0)) return text;
    const double largest = trace_.balanced() ? figure_.value : trace_.placement.loads->max;
    return text + ": " + written(weight_text(trace_, figure_.value, largest));
  }
  std::string load() const { return written(weight_text(trace_, figure_.value)); }
  std::string cargo() const { return cargo_text(trace_, index_); }
  std::string weight() const { return given_weight(figure_.value, trace_.units); }
  std::string body() const {
    return figure_.item ? fill("No robot: {reason}", {why_unusable()}) : "A robot that fits";
  }

 private:
  double least_ratio() const { return trace_.placement.settings.min_ratio; }

  const Trace& trace_;
  const StepDetail& detail_;
  const Figure& figure_;
  std::uint32_t index_;
};

// `blanks`: the texts for the {names}.
struct FigureRow {
  FigureKind kind;
  std::string_view pattern;
  std::array<std::string (FigureWords::*)() const, 3> blanks = {};
};

using W = FigureWords;

// clang-format off
constexpr FigureRow figure_rows[] = {
    {FigureKind::object,        "The object"},
    {FigureKind::triangle,      "Triangle at edge {edge}: {share} of the area", {&W::item, &W::signed_share}},
    {FigureKind::centroid,      "Centroid {point}", {&W::point}},
    {FigureKind::centre,        "Centre of mass C {point}", {&W::point}},
    {FigureKind::vertex,        "Vertex {vertex} {point}", {&W::item, &W::point}},
    {FigureKind::radial_edge,   "Edge {edge}, in line with C", {&W::item}},
    {FigureKind::ray,           "Ray from vertex {vertex} through C", {&W::item}},
    {FigureKind::chord,         "Chord from vertex {vertex}, load ratio {ratio}", {&W::start_of_chord, &W::ratio}},
    {FigureKind::edge,          "Edge {edge}", {&W::item}},
    {FigureKind::section,       "Section of edge {edge}", {&W::item}},
    {FigureKind::reflected,     "Edge {edge} reflected through C", {&W::item}},
    {FigureKind::section_end,   "End of the sections, load ratio {ratio}", {&W::ratio}},
    {FigureKind::bisecting,     "The chord between the edges' lines that C bisects"},
    {FigureKind::chosen,        "{chord}", {&W::chosen}},
    {FigureKind::candidate,     "{candidate}", {&W::candidate}},
    {FigureKind::team,          "Team {team}, load ratio {ratio}", {&W::item, &W::ratio}},
    {FigureKind::robot,         "{robot}", {&W::robot}},
    {FigureKind::gain_triangle, "{gain}", {&W::gain_area}},
    {FigureKind::gain_part,     "{gain}", {&W::gain_area}},
    {FigureKind::gain_circle,   "Inscribed circle, radius {radius}", {&W::length}},
    {FigureKind::arm_before,    "Arm to H's edge: {length}", {&W::length}},
    {FigureKind::arm_after,     "Arm to the new edge: {length}", {&W::length}},
    {FigureKind::base_before,   "Lifting base H before"},
    {FigureKind::base,          "Lifting base H"},
    {FigureKind::contact,       "Contact {contact}: robot {robot} on edge {edge}", {&W::item, &W::robot_of_contact, &W::edge_of_contact}},
    {FigureKind::normal,        "Normal line of contact {contact}", {&W::item}},
    {FigureKind::clockwise,     "It can turn clockwise about these points"},
    {FigureKind::counterclockwise, "It can turn counter-clockwise about these points"},
    {FigureKind::translation,   "It can slide this way"},
    {FigureKind::lever,         "A lever that turns about C"},
    {FigureKind::side,          "Two robots that lift together, as if at the middle between them"},
    {FigureKind::arm,           "From C to robot {robot}", {&W::number_of_robot}},
    {FigureKind::sum,           "The arrows end to end, each scaled to its share of the weight: they return to C"},
    {FigureKind::middle,        "M {point}, the middle between two robots", {&W::point}},
    {FigureKind::stand,         "A trial point {point}, where one robot goes", {&W::point}},
    {FigureKind::mirrored,      "The object turned about M by half a turn"},
    {FigureKind::even_chord,    "Chord {chord}, with M in its middle", {&W::item}},
    {FigureKind::left,          "Where robot {robot} stood before", {&W::item}},
    {FigureKind::way,           "The robot's way to its new place"},
    {FigureKind::range,         "Where a robot may stand on edge {edge}, with its partner straight across C", {&W::item}},
    {FigureKind::range_end,     "End of the range, load ratio {ratio}", {&W::ratio}},
    {FigureKind::former,        "Candidate {candidate}, which a team left, load ratio {ratio}", {&W::item, &W::ratio}},
    {FigureKind::unusable,      "Edge {edge}: {reason}", {&W::edge_of_unusable, &W::why_unusable}},
    {FigureKind::body,          "{body}", {&W::body}},
    {FigureKind::hand,          "{body}", {&W::body}},
    {FigureKind::share,         "The share of robot {robot}: {share}", {&W::number_of_robot, &W::signed_share}},
    {FigureKind::level,         "Here springs would carry {load}", {&W::load}},
    {FigureKind::sinks,         "The object sinks most in this direction"},
    {FigureKind::hole,          "Hole {hole}", {&W::item}},
    {FigureKind::hole_part,     "Triangle of hole {hole}: {share} of the area", {&W::item, &W::signed_share}},
    {FigureKind::cargo,         "{cargo} weighs {weight}", {&W::cargo, &W::weight}},
    {FigureKind::old_centre,    "Centre of mass before, {point}", {&W::point}},
};
// clang-format on

constexpr bool in_order() {
  for (std::size_t i = 0; i < std::size(figure_rows); ++i)
    if (figure_rows[i].kind != static_cast<FigureKind>(i)) return false;
  return std::size(figure_rows) == figure_kind_count;
}
static_assert(in_order(), "figure_text() finds a row by its kind");

}  // namespace

std::string figure_text(const Trace& trace, const StepDetail& detail, const Figure& figure) {
  const FigureWords words(trace, detail, figure);
  const FigureRow& row = figure_rows[static_cast<std::size_t>(figure.kind)];
  std::array<std::string, 3> blanks;
  std::size_t number = 0;
  for (const auto blank : row.blanks)
    if (blank) blanks[number++] = written((words.*blank)());
  return say_written(row.pattern, blanks.data(), number);
}

std::string part_name(const Figure& figure) {
  if (figure.kind == FigureKind::centroid) return written("centroid");
  if (!figure.item) return {};
  const Piece number = counted_from_1(*figure.item);
  if (figure.kind == FigureKind::edge) return fill("edge {edge}", {number});
  if (figure.kind == FigureKind::vertex) return fill("vertex {vertex}", {number});
  if (figure.kind == FigureKind::reflected) return fill("image of edge {edge}", {number});
  return {};
}

}  // namespace evenlift
