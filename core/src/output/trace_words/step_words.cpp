#include "output/trace_words/step_words.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "evenlift/angles.h"
#include "evenlift/numbers.h"
#include "evenlift/output/trace_words.h"
#include "evenlift/output/words.h"
#include "evenlift/selection.h"
#include "evenlift/stands.h"
#include "evenlift/wording.h"

namespace evenlift {
namespace {

// Whether the numbers as written add up.
bool add_up(const Piece& a, const Piece& b, const Piece& total) {
  const auto x = read_number(written(a)), y = read_number(written(b)),
             all = read_number(written(total));
  return !x || !y || !all || std::abs(*x + *y - *all) <= 1e-9 * *all;
}

// "a + b = total", or "≈" if the written numbers do not add up.
std::string sum(const Piece& a, const Piece& b, const Piece& total) {
  return fill(add_up(a, b, total) ? "{a} + {b} = {total}" : "{a} + {b} ≈ {total}", {a, b, total});
}

// "total − a = rest", or "≈".
std::string difference(const Piece& total, const Piece& a, const Piece& rest) {
  return fill(add_up(a, rest, total) ? "{total} − {a} = {rest}" : "{total} − {a} ≈ {rest}",
              {total, a, rest});
}

}  // namespace

Piece StepFormulas::load(double value) const { return load_text(trace_, value); }

Piece StepFormulas::corners(const Points& base) { return counted(base.size(), "corner"); }

std::string StepFormulas::ratio(const Chord& chord, const char* pattern) const {
  const double least = placement_.settings.min_ratio;
  return fill(pattern, {length_text(trace_, std::min(chord.arm1, chord.arm2)),
                        length_text(trace_, std::max(chord.arm1, chord.arm2)),
                        ratio_text(chord.ratio, least)});
}

const Chord& StepFormulas::chord(std::uint32_t i) const { return trace_.rays.chords[i].chord; }

std::string StepFormulas::compared_with_minimum(const Chord& chord,
                                                std::optional<std::uint32_t> candidate) const {
  return ratio(chord) + (candidate ? " ≥ " : " < ") + written(exact(placement_.settings.min_ratio));
}

std::string StepFormulas::score(const TeamScores& scores) const {
  const std::uint32_t winner = scores.ranking.front();
  const Candidate& candidate = placement_.candidates[winner];
  if (scores.rule != Rule::score)
    return fill(
        "|r1 r2| = {sum}, load ratio {ratio}",
        {sum(length_text(trace_, candidate.chord.arm1), length_text(trace_, candidate.chord.arm2),
             length_text(trace_, candidate.length)),
         ratio_text(candidate.chord.ratio)});
  const Score& score = scores.of_candidate[winner];
  if (detail_.step.kind == StepKind::team && scores.ranking.size() > 1) {
    const Score& second = scores.of_candidate[scores.ranking[1]];
    return fill(scores.decided_by != DecidedBy::first_key ? "score: {score} ties with {next}"
                : second.exact                            ? "score: {score} > {next}"
                                                          : "score: {score} > at most {next}",
                {score_text(trace_, scores.rule, score.value, second.value),
                 score_text(trace_, scores.rule, second.value, score.value)});
  }
  return fill("score = f(r1) + f(r2) = {sum}",
              {sum(score_text(trace_, scores.rule, score.ends[0].value, 0),
                   score_text(trace_, scores.rule, score.ends[1].value, 0),
                   score_text(trace_, scores.rule, score.value, 0))});
}

std::string StepFormulas::polygon() const {
  const PolygonWithHoles& object = trace_.object();
  double holes = 0;
  for (const Polygon& hole : object.holes()) holes += hole.area();
  if (holes > 0)
    return fill("area = |x1·y2 − x2·y1 + x2·y3 − …| / 2 − Σ holes = {difference}",
                {difference(area_text(trace_, object.outline().area()), area_text(trace_, holes),
                            area_text(trace_, object.area()))});
  return fill("area = |x1·y2 − x2·y1 + x2·y3 − …| / 2 = {area}",
              {area_text(trace_, trace_.object().area())});
}

std::string StepFormulas::centroid() const {
  return fill(
      trace_.object().holes().empty()
          ? "sum of area × centroid / sum of areas = {point}"
          : "sum of area × centroid / sum of areas, both minus those of the holes = {point}",
      {point_text(trace_, trace_.object().centroid())});
}

std::string StepFormulas::cargo() const {
  const Cargo& item = placement_.settings.cargo[item_];
  const Loaded before = with_cargo(item_), after = with_cargo(item_ + std::size_t{1});
  const auto weight = [](double value) { return significant(value, 6); };
  return fill(
      "C := (W C + w q) / (W + w) = ({before} × {centre} + {cargo} × {place}) / {all} = {point}",
      {weight(before.weight), point_text(trace_, before.centre), weight(item.weight),
       point_text(trace_, item.at), weight(after.weight), point_text(trace_, after.centre)});
}

std::string StepFormulas::ray() const {
  const std::uint32_t begin = trace_.rays.begins[item_], end = trace_.rays.begins[item_ + 1];
  if (begin == end) return {};
  std::uint32_t best = begin;
  for (std::uint32_t i = begin; i < end; ++i)
    if (chord(i).ratio > chord(best).ratio) best = i;
  return end - begin > 1 ? ratio(chord(best), "best load ratio = {shorter} / {longer} = {ratio}")
                         : ratio(chord(best));
}

std::string StepFormulas::sections() const {
  return fill("g = |C rb| / |C ra|: from {first} to {last}",
              {ratio_text(detail_.pair->verdict.g0), ratio_text(detail_.pair->verdict.g1)});
}

std::string StepFormulas::outcome() const {
  if (detail_.pair->standing == Standing::nowhere && detail_.pair->verdict.candidate) return {};
  return compared_with_minimum(detail_.pair->chosen, detail_.pair->candidate);
}

std::string StepFormulas::opposite() const {
  if (placement_.stands && !detail_.opposite->candidate) return {};
  return compared_with_minimum(detail_.opposite->chord, detail_.opposite->candidate);
}

std::string StepFormulas::duplicates() const {
  return written(counted(placement_.candidates.size(), "candidate"));
}

std::string StepFormulas::directions() const {
  const double open = 180 / pi * open_directions_rad(trace_.polygon(), trace_.centre);
  return fill("team k at (k − 1/2) / {teams} × {degrees}°",
              {whole(placement_.requested_teams), with_decimals(open, 1)});
}

std::string StepFormulas::scores() const {
  return detail_.scores ? score(*detail_.scores) : ratio(chord_of(placement_.teams[item_]));
}

std::string StepFormulas::base() const {
  const std::size_t before = detail_.base_before.size(), now = detail_.base.size();
  if (before == now)
    return now == 2 ? "H is still a segment"
                    : fill("H still has {corners}", {corners(detail_.base)});
  const std::string was = before == 0   ? "H was empty"
                          : before == 2 ? "H was a segment"
                                        : fill("H had {corners}", {corners(detail_.base_before)}),
                    is = now == 2 ? "now it is a segment"
                                  : fill("now it has {corners}", {corners(detail_.base)});
  return fill("{was}; {is}", {was, is});
}

std::string StepFormulas::share() const {
  const Team& team = placement_.teams[item_];
  const Piece weight = exact(placement_.weight());
  const Chord chord = chord_of(team);
  const double load1 = team.robots[0].load, load2 = team.robots[1].load;
  return fill(
      "W1 = {weight} / {teams} × |C r2| / |r1 r2| = {share} × {arm} / {length} = {load}",
      {weight, whole(placement_.teams.size()), load(load1 + load2), length_text(trace_, chord.arm2),
       length_text(trace_, chord.arm1 + chord.arm2), weight_text(trace_, load1)});
}

std::string StepFormulas::loads() const {
  return fill(
      "mean = {weight} / {robots} = {mean}, greatest − least = {spread}",
      {exact(placement_.weight()), whole(count_robots(placement_.teams)),
       weight_text(trace_, placement_.loads->mean), weight_text(trace_, placement_.loads->spread)});
}

std::string StepFormulas::coverage() const {
  return fill("area of the object in H / area of the object = {covered} / {area} = {coverage}",
              {area_text(trace_, placement_.coverage * trace_.object().area()),
               area_text(trace_, trace_.object().area()), with_decimals(placement_.coverage, 3)});
}

std::string StepFormulas::cut() const {
  const Contact& contact = trace_.contacts[item_];
  const Vec2 n = inward_normal(trace_.polygon(), contact.edge);
  return fill("normal n = ({x}, {y}) at {point}",
              {with_decimals(n.x, 3), with_decimals(n.y, 3), point_text(trace_, contact.position)});
}

std::string StepFormulas::closure() const {
  if (!placement_.closure.margin) return {};
  return fill("least over u of the greatest u · w = {margin}",
              {margin_text(*placement_.closure.margin)});
}

// --- Numbers and figures of steps are rows of trace/steps.cpp.

namespace {

constexpr std::string_view titles[] = {"The object and its centre of mass",
                                       "From the lever to the centroid",
                                       "Where the robots stand",
                                       "Chords from the vertices",
                                       "In order of slope",
                                       "Edges that face each other",
                                       "The candidates",
                                       "The first team",
                                       "Further teams",
                                       "A first set",
                                       "Three robots move at a time",
                                       "Teams are swapped",
                                       "The load of each robot",
                                       "If a robot fails",
                                       "The hold"};
static_assert(std::size(titles) == chapter_count);

template <Statement statement>
Statement always(const Trace&, const StepDetail&) {
  return statement;
}

struct StepRow {
  StepKind kind;
  std::string (StepCaptions::*caption)() const;
  std::string (StepFormulas::*formula)() const;
  Statement (*statement)(const Trace&, const StepDetail&);
};

using C = StepCaptions;
using F = StepFormulas;
using S = Statement;
// clang-format off
constexpr StepRow steps[] = {
    {StepKind::polygon,      &C::polygon,      &F::polygon,    always<S::centre>},
    {StepKind::centroid,     &C::centroid,     &F::centroid,   always<S::centre>},
    {StepKind::centre,       &C::centre,       &F::none,       always<S::centre>},
    {StepKind::radial,       &C::radial,       &F::none,       always<S::each_vertex>},
    {StepKind::ray,          &C::ray,          &F::ray,        always<S::each_hit>},
    {StepKind::slopes,       &C::slopes,       &F::none,       always<S::sort_chords>},
    {StepKind::sections,     &C::sections,     &F::sections,   always<S::sections>},
    {StepKind::outcome,      &C::outcome,      &F::outcome,    statement_of_outcome},
    {StepKind::opposite,     &C::opposite,     &F::opposite,   always<S::opposite>},
    {StepKind::duplicates,   &C::duplicates,   &F::duplicates, always<S::merge>},
    {StepKind::candidates,   &C::candidates,   &F::none,       always<S::order>},
    {StepKind::directions,   &C::directions,   &F::directions, always<S::open_directions>},
    {StepKind::scores,       &C::scores,       &F::scores,     statement_of_scores},
    {StepKind::team,         &C::team,         &F::scores,     statement_of_team},
    {StepKind::base,         &C::base,         &F::base,       statement_of_base},
    {StepKind::fewer,        &C::fewer,        &F::none,       statement_of_fewer},
    {StepKind::share,        &C::share,        &F::share,      always<S::loads>},
    {StepKind::loads,        &C::loads,        &F::loads,      statement_of_loads},
    {StepKind::coverage,     &C::coverage,     &F::coverage,   always<S::coverage>},
    {StepKind::contacts,     &C::contacts,     &F::none,       always<S::cut>},
    {StepKind::cut,          &C::cut,          &F::cut,        always<S::cut>},
    {StepKind::slide,        &C::slide,        &F::none,       always<S::slide>},
    {StepKind::closure,      &C::closure,      &F::closure,    always<S::form_closure>},
    {StepKind::second_order, &C::second_order, &F::none,       always<S::second_order>},
    {StepKind::result,       &C::result,       &F::none,       always<S::form_closure>},
    {StepKind::lever,        &C::lever,        &F::lever,      always<S::centroid_law>},
    {StepKind::three,        &C::three,        &F::three,      always<S::centroid_law>},
    {StepKind::many,         &C::many,         &F::many,       always<S::centroid_law>},
    {StepKind::rest,         &C::rest,         &F::rest,       always<S::middle>},
    {StepKind::mirror,       &C::mirror,       &F::none,       always<S::even_chords>},
    {StepKind::completion,   &C::completion,   &F::none,       always<S::best_set>},
    {StepKind::start,        &C::start,        &F::none,       always<S::best_set>},
    {StepKind::exchange,     &C::exchange,     &F::exchange,   always<S::exchange>},
    {StepKind::round,        &C::round,        &F::none,       always<S::rounds>},
    {StepKind::settled,      &C::settled,      &F::none,       always<S::rounds>},
    {StepKind::failure,      &C::failure,      &F::none,       always<S::failures>},
    {StepKind::failures,     &C::failures,     &F::none,       always<S::failures>},
    {StepKind::pairs,        &C::pairs,        &F::none,       always<S::failures>},
    {StepKind::range,        &C::range,        &F::none,       always<S::range>},
    {StepKind::swap,         &C::swap,         &F::none,       always<S::swap>},
    {StepKind::held,         &C::held,         &F::none,       always<S::swap>},
    {StepKind::stands,       &C::stands,       &F::stands,     always<S::stands>},
    {StepKind::support,      &C::support,      &F::none,       always<S::each_support>},
    {StepKind::equations,    &C::equations,    &F::equations,  always<S::equations>},
    {StepKind::by_lever,     &C::by_lever,     &F::by_lever,   always<S::springs>},
    {StepKind::by_areas,     &C::by_areas,     &F::by_areas,   always<S::springs>},
    {StepKind::by_springs,   &C::by_springs,   &F::by_springs, always<S::springs>},
    {StepKind::extremes,     &C::extremes,     &F::extremes,   always<S::springs>},
    {StepKind::falls,        &C::loads,        &F::none,       always<S::equations>},
    {StepKind::cargo,        &C::cargo,        &F::cargo,      always<S::cargo>},
};
// clang-format on

static_assert(has_each_step(steps));

const StepRow& row_of(const StepDetail& detail) {
  return steps[static_cast<std::size_t>(detail.step.kind)];
}

std::string_view letters_of_choice(const StepDetail& detail) {
  if (!detail.scores) return {};
  if (detail.scores->rule != Rule::score) return "r1 and r2 are the two ends of the chord.";
  return detail.step.kind == StepKind::scores
             ? "r1 and r2 are the candidate's two ends, and f is the gain from an end."
             : "";
}

std::string_view letters_of_stands(const RobotSize& robot) {
  const bool stands_off = robot.radius + robot.reach > 0, has_depth = robot.depth > 0;
  if (stands_off && has_depth)
    return "c is where a robot touches an edge, n points outwards there; s is the middle of its body, and p where it lifts.";
  if (stands_off)
    return "c is where a robot touches an edge and lifts, n points outwards there; s is the middle of its body.";
  if (has_depth)
    return "c is where a robot touches an edge, n points outwards there; p is where it lifts.";
  return "";
}

}  // namespace

std::string_view title(Chapter chapter) {
  return translated(titles[static_cast<std::size_t>(chapter)]);
}

// `written` translates captions and formulas without a number.
std::string caption(const Trace& trace, const StepDetail& detail) {
  return written((StepCaptions(trace, detail).*row_of(detail).caption)());
}

std::string caption_before_choice(const Trace& trace, const StepDetail& detail) {
  return StepCaptions(trace, detail).sections_before_choice();
}

std::string formula(const Trace& trace, const StepDetail& detail) {
  return written((StepFormulas(trace, detail).*row_of(detail).formula)());
}

std::string_view formula_letters(const Trace& trace, const StepDetail& detail) {
  switch (detail.step.kind) {
    case StepKind::polygon:
      return "x and y with a number are the coordinates of that vertex.";
    case StepKind::sections:
      return "ra and rb are the ends of a chord on the two edges. Where g is 1, the arms are equal; above 1, rb is the farther end.";
    case StepKind::scores:
    case StepKind::team:
      return letters_of_choice(detail);
    case StepKind::base:
      return "H is the lifting base.";
    case StepKind::share:
      return "W1 is the load of robot 1; r1 and r2 are the places of the team's two robots.";
    case StepKind::lever:
      return "W1 is the load of robot 1; r1 and r2 are the places of the two robots.";
    case StepKind::three:
      return "W3 is the load of robot 3; r3 is its place, and M the middle between the other two.";
    case StepKind::many:
      return "p with a number is the place of that robot.";
    case StepKind::rest:
      return detail.balanced->rest.size() == 1 ? "p1 is the place already taken." : "";
    case StepKind::exchange:
      return "M is the middle between the last two robots of the swap.";
    case StepKind::stands:
      return letters_of_stands(trace.placement.stands->robot());
    case StepKind::equations:
      return "W with i is the load of robot i, and x and y with i are its place.";
    case StepKind::by_springs:
    case StepKind::extremes:
      return "W with i is the load of robot i, and p with i its place.";
    case StepKind::by_lever:
    case StepKind::by_areas:
      return "W with a number is the load of that robot, and p its place.";
    case StepKind::cargo:
      return detail.step.item == 0
                 ? "W0 and C0 are the weight and the centre of mass of the object alone, w and q those of an item of cargo; W is the weight of all."
                 : "W0 and C0 are the weight and the centre of mass of the object alone, w and q those of an item of cargo; W is the weight of all. In the numbers, the object and the cargo before this item count as one.";
    case StepKind::coverage:
      return "P is the object, and H the lifting base.";
    case StepKind::closure:
      return trace.placement.closure.margin
                 ? "w is the push of a contact, force and moment together; u is a unit direction of such pushes."
                 : "";
    default:
      return {};
  }
}

Statement statement_of(const Trace& trace, const StepDetail& detail) {
  return row_of(detail).statement(trace, detail);
}

}  // namespace evenlift
