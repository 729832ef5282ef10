#include "walkthrough/under_pointer.h"

#include <vector>

#include "evenlift/plane.h"

namespace evenlift::view {

std::optional<std::uint32_t> choice_at(const AppState& state, const Vec2& screen) {
  const Walkthrough& walk = state.view.walkthrough;
  if (!walk.ask) return std::nullopt;
  std::optional<std::uint32_t> nearest;
  double least = state.session.screen.touch ? 22 : 12;
  for (const std::uint32_t choice : walk.ask->choices) {
    const Chord& chord = chord_of_choice(*walk.trace, walk.ask->detail, walk.ask->question, choice);
    const Vec2 a = state.view.camera.to_screen(chord.r1.position);
    const Vec2 b = state.view.camera.to_screen(chord.r2.position);
    const double away = length(nearest_on_segment(a, b, screen) - screen);
    if (away < least) {
      least = away;
      nearest = choice;
    }
  }
  return nearest;
}

std::optional<std::size_t> figure_at(const AppState& state, const Vec2& screen) {
  const std::vector<Figure>& figures = state.view.walkthrough.figures;
  std::optional<std::size_t> best;
  double best_score = 0;
  // Later figures are above earlier ones.
  for (std::size_t i = figures.size(); i-- > 0;) {
    const Points& p = figures[i].points;
    std::optional<double> score;
    if (p.size() == 1 && figures[i].kind != FigureKind::gain_circle) {
      const double away = length(state.view.camera.to_screen(p[0]) - screen);
      if (away <= 14) score = away;
    } else if (p.size() == 2) {
      const Vec2 a = state.view.camera.to_screen(p[0]), b = state.view.camera.to_screen(p[1]);
      const double away = length(nearest_on_segment(a, b, screen) - screen);
      if (away <= 7) score = 100 + away;
    } else if (p.size() > 2 && inside(p, state.view.camera.to_world(screen))) {
      score = 1000;
    }
    if (score && (!best || *score < best_score)) {
      best_score = *score;
      best = i;
    }
  }
  return best;
}

}  // namespace evenlift::view
