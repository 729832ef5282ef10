#include "marks/carrying.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "evenlift/output/carrying_words.h"
#include "marks/boxed_text.h"
#include "ui/vec.h"

namespace evenlift::view {
namespace {

const ExtraLoad* shown_extra(const CanvasView& view) {
  if (!shown(view.state).overlays.load || !view.current() || !view.placement) return nullptr;
  const std::optional<ExtraLoad>& extra = view.report().extra;
  return extra ? &*extra : nullptr;
}

bool shows_tilt(const CanvasView& view) {
  return shown(view.state).overlays.tilt && view.current() && view.placement;
}

// Stripes at 45 degrees.
RowFill stripes_of(const RowFill& rows) {
  constexpr float period = 9, width = 2.5f;
  RowFill stripes{{}, rows.height};
  for (const RowSpan& span : rows.spans) {
    const float phase = std::fmod(span.left + span.top, period);
    for (float left = span.left - phase; left < span.right; left += period) {
      const float from = std::max(left, span.left), to = std::min(left + width, span.right);
      if (from < to) stripes.spans.push_back({from, to, span.top});
    }
  }
  return stripes;
}

// A person, or another load: a head and shoulders above a point.
void draw_figure(ImDrawList& list, ImVec2 foot, Colour colour, Colour halo) {
  const ImVec2 head(foot.x, foot.y - 20);
  const auto body = [&](float more, Colour of) {
    list.AddCircleFilled(head, 4.5f + more, of.packed(), 20);
    list.AddRectFilled(ImVec2(foot.x - 5 - more, foot.y - 14 - more),
                       ImVec2(foot.x + 5 + more, foot.y + more), of.packed(), 4);
  };
  body(2, halo);
  body(0, colour);
}

void draw_words(const Painter& painter, const CanvasView& view, const Vec2& at,
                const std::string& words, bool fine) {
  const ImVec2 spot = painter.at(at);
  draw_word(painter.list(), Vec2(static_cast<double>(spot.x), static_cast<double>(spot.y)),
            view.uncovered(), view.theme, fine ? view.theme.text : view.theme.amber, words);
}

}  // namespace

void draw_load_region(const Painter& painter, const CanvasView& view) {
  const ExtraLoad* extra = shown_extra(view);
  if (!extra) return;
  const RowFill rows = painter.rows(view.placement->vertices(), view.scene.holes);
  painter.fill(stripes_of(rows), view.theme.amber_on_object.at(0.5f));
  if (extra->region.empty()) return;
  painter.fill(rows, view.theme.object, extra->region);
  painter.fill(rows, view.theme.hull, extra->region);
}

void draw_tilt(const Painter& painter, const CanvasView& view) {
  if (!shows_tilt(view)) return;
  const ImVec2 at = painter.at(view.placement->centre_of_mass);
  for (const TiltCircle& circle :
       tilt_circles({*view.placement, shown(view.state)}, view.camera.scale)) {
    const auto size = static_cast<float>(circle.radius * view.camera.scale);
    painter.list().AddCircle(at, size, view.theme.hull_text.at(0.7f).packed(), 96, 1.25f);
    if (!circle.is_labelled) continue;
    const std::string label = degrees_in_words(circle.degrees);
    const ImVec2 text = text_size(Face::tiny, label);
    const ImVec2 low(at.x - text.x / 2, at.y - size - text.y / 2);
    painter.list().AddRectFilled(ImVec2(low.x - 3, low.y),
                                 ImVec2(low.x + text.x + 3, low.y + text.y),
                                 view.theme.panel.at(0.85f).packed(), 3);
    draw_text(painter.list(), Face::tiny, low, view.theme.text, label);
  }
}

bool draw_carrying_here(const Painter& painter, const CanvasView& view) {
  const Pick& hover = view.state.view.hover;
  if (hover.kind != Pick::Kind::object || hover.second != view.second) return false;
  const ShownPlacement of{*view.placement, shown(view.state)};
  if (const ExtraLoad* extra = shown_extra(view)) {
    const LoadHere here = extra_here_in_words(*extra, hover.at, of);
    draw_figure(painter.list(), painter.at(hover.at),
                here.is_fine ? view.theme.hull_text : view.theme.amber_on_object, view.theme.panel);
    draw_words(painter, view, hover.at, here.words, here.is_fine);
    return true;
  }
  if (!shows_tilt(view)) return false;
  const std::string words = tilt_towards_in_words(hover.at, of);
  if (words.empty()) return false;
  painter.line(of.placement.centre_of_mass, hover.at, view.theme.hull_text, 1.5f);
  draw_words(painter, view, hover.at, words, true);
  return true;
}

}  // namespace evenlift::view
