#include "trace/step_figures.h"

namespace evenlift {

void StepFigures::add_balanced(double load) {
  const BalancedDetail& balanced = *detail_.balanced;
  for (std::size_t i = 0; i < balanced.robots.size(); ++i)
    add(FigureKind::robot, Points{balanced.robots[i].position}, balanced.numbers[i], load);
}

void StepFigures::add_arms() {
  const BalancedDetail& balanced = *detail_.balanced;
  for (std::size_t i = 0; i < balanced.robots.size(); ++i)
    add(FigureKind::arm, Points{trace_.centre, balanced.robots[i].position}, balanced.numbers[i]);
}

void StepFigures::lever() {
  const std::vector<LiftingPoint>& robots = detail_.balanced->robots;
  add(FigureKind::lever, positions(robots));
  add_balanced(placement_.weight() / 2);
}

void StepFigures::three() {
  const std::vector<LiftingPoint>& robots = detail_.balanced->robots;
  const Vec2 middle = (robots[0].position + robots[1].position) / 2;
  add(FigureKind::side, Points{robots[0].position, robots[1].position});
  add(FigureKind::lever, Points{robots[2].position, middle});
  add(FigureKind::middle, Points{middle});
  add_balanced(placement_.weight() / 3);
}

// The arms; then the arms, divided by the number of robots, end to end.
void StepFigures::many() {
  const std::vector<LiftingPoint>& robots = detail_.balanced->robots;
  const auto number = static_cast<double>(robots.size());
  Points sum{trace_.centre};
  for (std::size_t i = 0; i + 1 < robots.size(); ++i)
    sum.push_back(sum.back() + (robots[i].position - trace_.centre) / number);
  add_arms();
  add(FigureKind::sum, std::move(sum));
  add_balanced(placement_.weight() / number);
}

void StepFigures::rest() {
  const BalancedDetail& balanced = *detail_.balanced;
  add_balanced(0);
  if (balanced.stand) add(FigureKind::stand, Points{balanced.stand->position});
  add(FigureKind::middle, Points{balanced.middle});
}

void StepFigures::mirror() {
  const Vec2& middle = detail_.balanced->middle;
  Points turned;
  for (const Vec2& vertex : trace_.polygon().vertices()) turned.push_back(2 * middle - vertex);
  add(FigureKind::mirrored, std::move(turned));
  add_even_chords();
  rest();
}

void StepFigures::completion() {
  add(FigureKind::base, detail_.base);
  add_completion();
}

void StepFigures::add_completion() {
  add_even_chords();
  const BalancedDetail& balanced = *detail_.balanced;
  if (balanced.chords.empty()) return;  // the set was found at once
  const Chord& chosen = balanced.chords[balanced.chosen];
  add(FigureKind::chosen, chosen, balanced.chosen, chosen.ratio);
  rest();
}

void StepFigures::add_even_chords() {
  const std::vector<Chord>& chords = detail_.balanced->chords;
  for (std::uint32_t i = 0; i < chords.size(); ++i)
    add(FigureKind::even_chord, chords[i], i, chords[i].ratio);
}

void StepFigures::start() {
  add(FigureKind::base_before, detail_.base_before);
  add(FigureKind::base, detail_.base);
  add_arms();
  add_completion();
}

void StepFigures::exchange() {
  const BalancedDetail& balanced = *detail_.balanced;
  add(FigureKind::base_before, detail_.base_before);
  add(FigureKind::base, detail_.base);
  add_arms();
  for (std::size_t i = 0; i < balanced.moved.size(); ++i) {
    add(FigureKind::way, Points{balanced.ways[2 * i], balanced.ways[2 * i + 1]});
    add(FigureKind::left, Points{balanced.ways[2 * i]}, balanced.moved[i]);
  }
  add_balanced(0);
}

void StepFigures::round() {
  add(FigureKind::base, detail_.base);
  add_arms();
  add_balanced(0);
}

void StepFigures::failure() {
  const BalancedDetail& balanced = *detail_.balanced;
  add(FigureKind::base_before, detail_.base_before);
  add(FigureKind::base, detail_.base);
  add_arms();
  const Robot& failed = placement_.teams[0].robots[*balanced.failed];
  add(FigureKind::left, Points{failed.point.position}, balanced.failed);
  for (std::size_t i = 0; i < balanced.robots.size(); ++i)
    add(FigureKind::robot, Points{balanced.robots[i].position}, balanced.numbers[i],
        balanced.loads.empty() ? 0 : balanced.loads[i]);
}

void StepFigures::pairs() {
  const Placement& pairs = *trace_.in_pairs;
  add(FigureKind::base_before, detail_.base_before);
  add(FigureKind::base, detail_.base);
  for (std::uint32_t i = 0; i < pairs.teams.size(); ++i)
    add(FigureKind::team, chord_of(pairs.teams[i]), i, pairs.teams[i].ratio);
}

}  // namespace evenlift
