#include "marks/marks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "evenlift/output/carrying_words.h"
#include "evenlift/output/words.h"
#include "evenlift/plane.h"
#include "evenlift/wording.h"
#include "tools/pick.h"
#include "ui/icons.h"
#include "ui/theme.h"

namespace evenlift::view {
namespace {

constexpr double least_radius = 5;      // pixels
constexpr double most_radius = 48;      // pixels, for an item that is all the weight
constexpr double most_share = 0.18;     // the same, of the object's size
constexpr double own_centre_reach = 7;  // pixels
constexpr std::size_t most_labelled_items = 60;

const std::vector<Cargo>& cargo_of(const CanvasView& view) {
  return view.state.work.document().settings.cargo;
}

double whole_radius(const CanvasView& view) {
  if (!view.placement) return most_radius;
  const double size = std::sqrt(view.placement->polygon().area()) * view.camera.scale;
  return std::min(most_radius, most_share * size);
}

std::string label_of(const Cargo& item, const Units& units) {
  return item.name.empty() ? given_weight(item.weight, units) : item.name;
}

void draw_disc(const Painter& painter, const Theme& theme, const CargoDisc& disc, bool marked) {
  ImDrawList& list = painter.list();
  const ImVec2 at = vec(disc.middle);
  const auto radius = static_cast<float>(disc.radius);
  const Colour line = marked ? theme.accent_on_object : theme.chord;
  if (marked) list.AddCircleFilled(at, radius + 9, theme.accent.at(0.22f).packed(), 48);
  list.AddCircle(at, radius + 1.5f, theme.object.packed(), 48, 1.5f);
  list.AddCircleFilled(at, radius, theme.object.at(0.75f).packed(), 48);
  list.AddCircleFilled(at, radius, line.at(0.4f).packed(), 48);
  list.AddCircle(at, radius, line.packed(), 48, 2);
  list.AddCircleFilled(at, 2.5f, line.packed(), 12);
}

}  // namespace

std::vector<CargoDisc> cargo_discs(const CanvasView& view) {
  const double total = total_weight(view.state.work.document().settings),
               whole = whole_radius(view);
  std::vector<CargoDisc> discs;
  for (const Cargo& item : cargo_of(view))
    discs.push_back({view.camera.to_screen(item.at),
                     std::max(least_radius, whole * std::sqrt(item.weight / total))});
  return discs;
}

std::vector<CargoLabel> cargo_labels(const CanvasView& view, Occupied& occupied) {
  const std::vector<Cargo>& cargo = cargo_of(view);
  if (cargo.size() > most_labelled_items) return {};
  const std::vector<CargoDisc> discs = cargo_discs(view);
  std::vector<LabelRequest> requests;
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < cargo.size(); ++i) {
    if (!view.window.contains(discs[i].middle)) continue;
    const AsTyped typed;
    texts.push_back(label_of(cargo[i], shown(view.state).units));
    const ImVec2 text = text_size(Face::label, texts.back());
    requests.push_back(
        {discs[i].middle, Vec2(1, 0), Vec2(text.x + 10, text.y + 4), discs[i].radius + 4});
  }
  const auto places = place_labels(requests, occupied, 0, cargo.size() <= 8 ? 60 : 8);
  std::vector<CargoLabel> labels;
  for (std::size_t i = 0; i < places.size(); ++i)
    if (places[i]) labels.push_back({*places[i], std::move(texts[i])});
  return labels;
}

void occupy_by_cargo(const CanvasView& view, Occupied& occupied) {
  const std::vector<CargoDisc> discs = cargo_discs(view);
  if (discs.empty()) return;
  for (const auto& [middle, radius] : discs) occupied.disc(middle, radius + 2);
  const Vec2 own = view.camera.to_screen(own_centre(view.state));
  occupied.disc(own, own_centre_reach);
  occupied.line(own, view.camera.to_screen(centre_of_mass(view.state)));
}

void draw_cargo(const Painter& painter, const CanvasView& view) {
  const std::vector<CargoDisc> discs = cargo_discs(view);
  if (discs.empty()) return;
  const std::size_t first = count_vertices(view.state.work.document());
  for (std::size_t i = 0; i < discs.size(); ++i)
    draw_disc(
        painter, view.theme, discs[i],
        is_hovered(view.state, Pick::Kind::cargo, i) || view.state.view.selected == first + i);
  if (!view.placement) return;
  for (const auto& [box, text] : labels_of_cargo(view)) {
    painter.list().AddRectFilled(vec(box.left, box.top), vec(box.right, box.bottom),
                                 view.theme.panel.at(0.88f).packed(), 6);
    const AsTyped typed;
    draw_text(painter.list(), Face::label, vec(box.left + 5, box.top + 2), view.theme.text, text);
  }
}

void draw_own_centre(const Painter& painter, const CanvasView& view) {
  if (cargo_of(view).empty()) return;
  const Theme& theme = view.theme;
  const Vec2 own = own_centre(view.state);
  const ImVec2 at = painter.at(own);
  const bool hovered = is_hovered(view.state, Pick::Kind::centre, 0);
  painter.line(own, centre_of_mass(view.state), theme.chord, 1.5f);
  if (hovered) painter.list().AddCircleFilled(at, 14, theme.accent.at(0.22f).packed(), 32);
  painter.list().AddCircleFilled(at, 6.5f, theme.object.packed(), 24);
  painter.list().AddCircle(at, 5, (hovered ? theme.accent_on_object : theme.robot).packed(), 24,
                           hovered ? 2.5f : 1.5f);
}

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
    painter.list().AddCircle(at, size,
                             view.theme.hull_text.at(circle.is_set ? 1.0f : 0.7f).packed(), 96,
                             circle.is_set ? 2.5f : 1.25f);
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

namespace {

// The knife edge on which the object balances.
void draw_tip(const Painter& painter, const ImVec2& tip, const Theme& theme, Colour colour) {
  const ImVec2 left(tip.x - 9, tip.y + 15), right(tip.x + 9, tip.y + 15);
  painter.list().AddTriangle(tip, left, right, theme.object.packed(), 5);
  painter.list().AddTriangleFilled(tip, left, right, colour.packed());
}

void draw_dashed_circle(ImDrawList& list, ImVec2 at, float radius, Colour colour) {
  const int dashes = std::clamp(static_cast<int>(radius * 0.6f), 12, 120);
  const float turn = 2 * 3.14159265f / static_cast<float>(dashes);
  for (int i = 0; i < dashes; ++i) {
    const float from = turn * static_cast<float>(i);
    list.PathArcTo(at, radius, from, from + turn * 0.6f, 6);
    list.PathStroke(colour.packed(), 0, 1.5f);
  }
}

}  // namespace

void draw_centre(const Painter& painter, const CanvasView& view) {
  const AppState& state = view.state;
  const Theme& theme = view.theme;
  const ImVec2 at = painter.at(centre_of_mass(state));
  if (view.placement && is_one_team(view.placement->settings.method))
    draw_tip(painter, ImVec2(at.x, at.y + 11), theme, theme.robot);
  // With cargo, the grip is the object's own centre of mass (cargo.h).
  const bool hovered = settings(state).cargo.empty() && is_hovered(state, Pick::Kind::centre, 0);
  if (hovered) painter.list().AddCircleFilled(at, 16, theme.accent.at(0.22f).packed(), 32);
  const bool wrong =
      state.derived().refusal && state.derived().refusal->place.kind == Place::Kind::centre_of_mass;
  painter.list().AddCircleFilled(at, 11.5f, theme.object.packed(), 32);
  draw_centre_mark(painter.list(), at, 9,
                   wrong     ? theme.amber_on_object
                   : hovered ? theme.accent_on_object
                             : theme.robot,
                   theme.object);
}

void draw_halo(const Painter& painter, const CanvasView& view) {
  const AppState& state = view.state;
  if (!shown(state).overlays.halo || view.placement->teams.empty()) return;
  const Theme& theme = view.theme;
  ImDrawList& list = painter.list();
  const ImVec2 at = painter.at(centre_of_mass(state));
  // `known` is how far from C the weight may act: C is off, or the object tilts or brakes.
  const double margin = view.report().robustness.tipping_distance,
               known = effect_on({*view.placement, shown(state)}).reach;
  const auto in_pixels = [&](double length) {
    return static_cast<float>(std::min(length * view.camera.scale, 1e5));
  };
  if (margin > 0) draw_dashed_circle(list, at, in_pixels(margin), theme.hull_text);
  const Colour ring = known < margin ? theme.accent_on_object : theme.amber_on_object;
  if (known > 0) {
    list.AddCircleFilled(at, in_pixels(known), ring.at(0.12f).packed(), 64);
    list.AddCircle(at, in_pixels(known), ring.packed(), 64, 2);
  }
  const std::optional<Vec2> grip = uncertainty_grip(state);
  if (!grip || view.second) return;
  const ImVec2 spot = vec(grip->x, grip->y);
  const ImVec2 foot(at.x + in_pixels(known) * 0.70710678f, at.y - in_pixels(known) * 0.70710678f);
  const bool hot = is_hovered(state, Pick::Kind::uncertainty, 0);
  list.AddLine(foot, spot, ring.packed(), 1.5f);
  if (hot) list.AddCircleFilled(spot, 14, theme.accent.at(0.22f).packed(), 32);
  list.AddCircleFilled(spot, 6, theme.object.packed(), 24);
  list.AddCircle(spot, 6, ring.packed(), 24, 2);
}

namespace {

// An arrow's meaning, in direction `along` from the point.
void draw_name(const Painter& painter, const CanvasView& view, const Vec2& at, const Vec2& along,
               Colour colour, const std::string& name, Occupied& occupied) {
  const ImVec2 text = text_size(Face::strong_label, name);
  const auto place = place_labels({{at, along, Vec2(text.x + 12, text.y + 6)}}, occupied, 4, 60)[0];
  if (!place) return;
  ImDrawList& list = painter.list();
  list.AddRectFilled(vec(place->left, place->top), vec(place->right, place->bottom),
                     view.theme.panel.at(0.88f).packed(), 6);
  draw_text(list, Face::strong_label, vec(place->left + 6, place->top + 3), colour, name);
}

// A load may cross a chord, but must not hide an arrow.
void keep_clear(const Segment& arrow, Occupied& occupied) {
  for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0})
    occupied.disc(arrow.from + share * (arrow.to - arrow.from), 6);
}

// From the window's middle to the nearest point of a convex region, in pixels; nothing if part of
// it is visible.
std::optional<Vec2> way_out_of_sight(const CanvasView& view, const Rect& window,
                                     const Points& region) {
  Points seen;
  for (const Vec2& corner : region) seen.push_back(view.camera.to_screen(corner));
  const Vec2 middle = window.middle();
  Vec2 way = seen.front() - middle;
  for (std::size_t i = 0, j = seen.size() - 1; i < seen.size(); j = i++) {
    const Vec2 other = nearest_on_segment(seen[j], seen[i], middle) - middle;
    if (length(other) < length(way)) way = other;
  }
  const Box box{Vec2(window.left, window.top), Vec2(window.right, window.bottom)};
  return clip(std::move(seen), box).empty() ? std::optional(way) : std::nullopt;
}

// Also clear of the view tools, which are at the foot or, on a phone, at the right.
Rect without_tools(const CanvasView& view) {
  Rect window = view.uncovered();
  const Rect& tools = view.layout.tools;
  if (view.layout.wide)
    window.bottom = std::min(window.bottom, tools.top);
  else
    window.right = std::min(window.right, tools.left);
  return window;
}

// An arrow at the window's edge to a region beyond it, if there is room.
std::optional<Segment> arrow_to_region(const CanvasView& view, const Rect& window,
                                       const Points& region) {
  constexpr double from_edge = 22, arrow = 44;
  const std::optional<Vec2> way =
      region.empty() ? std::nullopt : way_out_of_sight(view, window, region);
  const Vec2 room(window.width() / 2 - from_edge, window.height() / 2 - from_edge);
  if (!way || !(room.x > arrow) || !(room.y > arrow)) return std::nullopt;
  // To the edge of the available area, on the way to the region.
  const double share = std::min(room.x / std::max(std::abs(way->x), 1e-9),
                                room.y / std::max(std::abs(way->y), 1e-9));
  const Vec2 head = window.middle() + share * *way;
  return Segment{head - arrow * *way / length(*way), head};
}

void draw_far_region(const Painter& painter, const CanvasView& view, const Points& region,
                     Colour colour, const std::string& name, Occupied* occupied) {
  std::optional<Segment> arrow = arrow_to_region(view, view.uncovered(), region);
  const Rect& tools = view.layout.tools;
  if (arrow && (tools.contains(arrow->to) || tools.contains(arrow->from)))
    arrow = arrow_to_region(view, without_tools(view), region);
  if (!arrow) return;
  painter.arrow(arrow->from, arrow->to, view.theme.ground, 7);
  painter.arrow(arrow->from, arrow->to, colour, 3);
  if (!occupied) return;
  occupied->line(arrow->from, arrow->to);
  const Vec2 back = (arrow->from - arrow->to) / length(arrow->to - arrow->from);
  draw_name(painter, view, arrow->from, back, colour, name, *occupied);
  keep_clear(*arrow, *occupied);
}

}  // namespace

Segment slide_arrow(const CanvasView& view) {
  const Vec2 from = view.camera.to_screen(view.placement->centre_of_mass),
             along = *view.placement->closure.translation, on_screen(along.x, -along.y);
  return {from + on_screen * 16, from + on_screen * 62};
}

void draw_slide(const Painter& painter, const CanvasView& view, Occupied* occupied) {
  const Closure& closure = view.placement->closure;
  if (!closure.translation_free || !closure.translation || view.placement->teams.empty()) return;
  if (!is_about_hold(view.state)) return;
  const auto [tail, head] = slide_arrow(view);
  const Vec2 along = (head - tail) / length(head - tail);
  painter.arrow(tail, head, view.theme.object, 7);
  painter.arrow(tail, head, view.theme.amber_on_object, 3);
  if (!occupied) return;
  occupied->line(tail, head);
  draw_name(painter, view, head, along, view.theme.amber, "slides", *occupied);
  keep_clear({tail, head}, *occupied);
}

void draw_far_regions(const Painter& painter, const CanvasView& view, Occupied* occupied) {
  const Closure& closure = view.placement->closure;
  if (!closure.margin || view.placement->teams.empty()) return;
  const Overlays& overlays = shown(view.state).overlays;
  if (overlays.clockwise)
    draw_far_region(painter, view, closure.clockwise.clipped, view.theme.clockwise_line,
                    "turns clockwise, far out", occupied);
  if (overlays.counterclockwise)
    draw_far_region(painter, view, closure.counterclockwise.clipped, view.theme.counter_line,
                    "turns counter-clockwise, far out", occupied);
}

}  // namespace evenlift::view
