#include "ui/icons.h"

#include <imgui.h>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>

#include "evenlift/output/json_text.h"
#include "evenlift/wording.h"
#include "ui/controls.h"
#include "ui/theme.h"

namespace evenlift::view {
namespace {

constexpr float pi = 3.14159265f;

// The side of an icon's square, with y down (web/kit/icons.js).
constexpr float side = 20;
constexpr float stroke_width = 1.7f, dot_radius = 1.35f;

// In hundredths of a unit.
struct Point {
  std::int16_t x, y;
};
// A single point is a dot.
struct Stroke {
  std::int16_t first, count;
  bool closed;
};
struct Strokes {
  Icon icon;
  std::int16_t first, count;
};
#include "icon_strokes.inc"

static_assert(std::size(icons) == icon_count, "web/kit/icons.js has a stroke for each icon");

}  // namespace

void draw_icon(ImDrawList& list, Icon icon, ImVec2 middle, float size, Colour colour) {
  const Strokes* found = std::find_if(std::begin(icons), std::end(icons),
                                      [&](const Strokes& s) { return s.icon == icon; });
  if (found == std::end(icons)) return;  // Icon::none
  const float unit = size / side;
  const auto at = [&](const Point& p) {
    return ImVec2(middle.x + (p.x / 100.0f - side / 2) * unit,
                  middle.y + (p.y / 100.0f - side / 2) * unit);
  };
  for (const Stroke* s = strokes + found->first; s != strokes + found->first + found->count; ++s) {
    if (s->count == 1) {
      list.AddCircleFilled(at(points[s->first]), dot_radius * unit, colour.packed(), 16);
      continue;
    }
    for (int i = 0; i < s->count; ++i) list.PathLineTo(at(points[s->first + i]));
    list.PathStroke(colour.packed(), s->closed ? ImDrawFlags_Closed : ImDrawFlags_None,
                    stroke_width * unit);
  }
}

void draw_centre_mark(ImDrawList& list, ImVec2 middle, float radius, Colour dark, Colour light) {
  list.AddCircleFilled(middle, radius, light.packed(), 32);
  for (float start : {0.0f, pi}) {
    list.PathLineTo(middle);
    list.PathArcTo(middle, radius, start, start + pi / 2, 10);
    list.PathFillConvex(dark.packed());
  }
  list.AddCircle(middle, radius, dark.packed(), 32, radius / 5);
}

namespace {

struct Request {
  ControlRequest what;
  std::string card, name;
  double value;
  int passes = 0;  // since the request
};

struct Listed {
  std::vector<Control> of_pass;
  std::string card;
  bool on_list = false;
  std::optional<Rect> open_list;
  std::vector<Request> requests;  // in order
};
Listed listed;

Rect rectangle(ImVec2 low, ImVec2 high) { return {low.x, low.y, high.x, high.y}; }

std::optional<Request> taken_request(const Control& control) {
  std::vector<Request>& all = listed.requests;
  const auto found = std::find_if(all.begin(), all.end(), [&](const Request& request) {
    return request.card == control.card && request.name == control.name;
  });
  if (found == all.end()) return std::nullopt;
  Request request = std::move(*found);
  all.erase(found);
  return request;
}

// JSON has no infinity, so a missing bound is null.
std::string number_json(double value) {
  return std::isfinite(value) ? json::number(value) : "null";
}

std::string control_json(const Control& c, double zoom) {
  constexpr std::string_view kinds[] = {"button", "toggle", "number", "slider", "choice", "text"};
  static_assert(std::size(kinds) == static_cast<std::size_t>(ControlKind::end_of_kinds));
  std::vector<std::string> choices;
  for (const std::string& choice : c.choices) choices.push_back(json::text(choice));
  return json::object({{"kind", json::text(kinds[static_cast<std::size_t>(c.kind)])},
                       {"card", json::text(c.card)},
                       {"name", json::text(c.name)},
                       {"label", json::text(c.label)},
                       {"value", json::text(c.value)},
                       {"exact", json::text(c.exact)},
                       {"setting", json::text(c.setting)},
                       {"is_length", json::boolean(c.is_length)},
                       {"enabled", json::boolean(c.enabled)},
                       {"on", json::boolean(c.on)},
                       {"place", place_json(c.place, zoom)},
                       {"window", place_json(c.window, zoom)},
                       {"low", number_json(c.low)},
                       {"high", number_json(c.high)},
                       {"step", number_json(c.step)},
                       {"at", number_json(c.at)},
                       {"choices", json::array(choices)},
                       {"current", c.current ? std::to_string(*c.current) : "null"}});
}

}  // namespace

void begin_controls() {
  listed.of_pass.clear();
  listed.open_list.reset();
  // Requests expire if their controls are no longer laid out.
  for (Request& request : listed.requests) ++request.passes;
  std::erase_if(listed.requests, [](const Request& request) { return request.passes > 4; });
}

void enter_list(bool on_list) {
  listed.on_list = on_list;
  if (!on_list) return;
  const ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  listed.open_list = rectangle(low, ImVec2(low.x + size.x, low.y + size.y));
}
const std::optional<Rect>& open_list() { return listed.open_list; }

void enter_card(const char* name) { listed.card = name; }

Asked list_control(Control control) {
  control.card = listed.card;
  control.label = translated(control.label);
  control.value = translated(control.value);
  for (std::string& choice : control.choices) choice = translated(choice);
  control.place = rectangle(ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
  const ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  const bool covered = !listed.on_list && ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId |
                                                                     ImGuiPopupFlags_AnyPopupLevel);
  if (!covered) control.window = rectangle(low, ImVec2(low.x + size.x, low.y + size.y));
  note_room(control.label, static_cast<float>(control.place.right) - low.x, size.x);
  Asked asked;
  if (const std::optional<Request> request = taken_request(control)) {
    if (request->what == ControlRequest::reveal) ImGui::SetScrollHereY();
    if (control.enabled) {
      asked.pressed =
          request->what == ControlRequest::press || request->what == ControlRequest::enter;
      if (request->what == ControlRequest::move || request->what == ControlRequest::enter)
        asked.moved = request->value;
      asked.withdrawn = request->what == ControlRequest::withdraw;
      if (request->what == ControlRequest::choose && request->value >= 0 &&
          request->value < static_cast<double>(control.choices.size()))
        asked.chosen = static_cast<std::size_t>(request->value);
    }
  }
  listed.of_pass.push_back(std::move(control));
  return asked;
}

void list_text(std::string label, std::string value) {
  Control control{ControlKind::text, label};
  control.label = std::move(label);
  control.value = std::move(value);
  list_control(std::move(control));
}

void cover_controls(const Rect& place) {
  for (Control& control : listed.of_pass)
    if (control.card != listed.card && place.overlaps(control.place)) control.window = {};
}

const std::vector<Control>& controls() { return listed.of_pass; }

std::string place_json(const Rect& place, double zoom) {
  return json::object({{"left", json::number(place.left * zoom)},
                       {"top", json::number(place.top * zoom)},
                       {"width", json::number(place.width() * zoom)},
                       {"height", json::number(place.height() * zoom)}});
}

std::string controls_json(double zoom) {
  std::vector<std::string> all;
  for (const Control& control : listed.of_pass) all.push_back(control_json(control, zoom));
  return json::array(all);
}

void ask_control(ControlRequest what, std::string card, std::string name, double value) {
  // A newly typed value replaces the earlier one.
  std::erase_if(listed.requests, [&](const Request& request) {
    return request.what == ControlRequest::move && request.card == card && request.name == name;
  });
  listed.requests.push_back({what, std::move(card), std::move(name), value});
}

}  // namespace evenlift::view
