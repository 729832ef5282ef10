#include "output/trace_words/step_formulas.h"

#include <algorithm>
#include <cmath>

#include "evenlift/angles.h"
#include "evenlift/numbers.h"
#include "evenlift/output/words.h"
#include "evenlift/selection.h"

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

}  // namespace evenlift
