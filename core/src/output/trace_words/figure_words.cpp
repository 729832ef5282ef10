#include <array>
#include <cmath>

#include "evenlift/output/trace_words.h"
#include "evenlift/output/words.h"
#include "evenlift/wording.h"
#include "output/trace_words/trace_text.h"

namespace evenlift {
namespace {

class FigureWords {
 public:
  FigureWords(const Trace& trace, const StepDetail& detail, const Figure& figure)
      : trace_(trace), detail_(detail), figure_(figure), index_(figure.item.value_or(0)) {}

  std::string item() const { return written(counted_from_1(index_)); }
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
    return written(counted_from_1(trace_.contacts[index_].point));
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
      text = fill("Robot {robot}", {item()});
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
    {FigureKind::arm,           "From C to robot {robot}", {&W::item}},
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
    {FigureKind::share,         "The share of robot {robot}: {share}", {&W::item, &W::signed_share}},
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
