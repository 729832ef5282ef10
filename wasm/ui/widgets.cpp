#include "ui/widgets.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "state/browser.h"

namespace evenlift::view {
namespace {

constexpr float shake = 8;  // CSS pixels that a finger may move and still mean a tap
bool slider_held = false;   // a slider takes the finger's way for itself

ImVec2 vec(double x, double y) { return {static_cast<float>(x), static_cast<float>(y)}; }

// A pressable area at the cursor.
struct Area {
  ImVec2 low, high;
  bool pressed, hovered, active, focused;
  ImVec2 middle() const { return {(low.x + high.x) / 2, (low.y + high.y) / 2}; }
};

struct Sought {
  std::string name;  // empty: nothing is sought
  std::optional<Rect> found;
};
Sought sought;

void offer_control(std::string_view group, std::string_view id) {
  if (sought.name.empty() || sought.found) return;
  const std::string name =
      group.empty() ? std::string(id) : std::string(group) + ' ' + std::string(id);
  if (name != sought.name) return;
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  sought.found = Rect{low.x, low.y, high.x, high.y};
}

Area area(const Ui& ui, const char* id, ImVec2 size, bool enabled = true,
          std::string_view group = {}) {
  Area a;
  a.pressed = tapped(ui, ImGui::InvisibleButton(id, size)) && enabled;
  a.low = ImGui::GetItemRectMin();
  a.high = ImGui::GetItemRectMax();
  a.hovered = ImGui::IsItemHovered() && enabled;
  a.active = ImGui::IsItemActive() && enabled;
  a.focused = ImGui::IsItemFocused();
  offer_control(group, id);
  if (a.hovered) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  return a;
}

// Draws the background of a button, which shows whether the pointer is over it.
void ground(const Ui& ui, const Area& a, float rounding, Colour still) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Colour colour = a.active || a.hovered ? ui.theme.panel_line : still;
  list.AddRectFilled(a.low, a.high, colour.packed(), rounding);
}

// True when pressed, and repeatedly while held.
bool repeats(const Area& a) {
  if (!a.active) return a.pressed && ImGui::GetIO().MouseDownDurationPrev[0] < 0.35f;
  const ImGuiIO& io = ImGui::GetIO();
  browser::request_frame();
  const float held = io.MouseDownDuration[0];
  if (held < 0.35f) return false;
  constexpr float every = 0.09f;
  return std::floor(held / every) > std::floor((held - io.DeltaTime) / every);
}

void hatch_swatch(ImDrawList& list, ImVec2 low, ImVec2 high, Colour colour, bool rising) {
  list.PushClipRect(low, high, true);
  for (float x = -16; x < 32; x += 4.5f) {
    const ImVec2 from(low.x + x, rising ? high.y : low.y),
        to(low.x + x + 16, rising ? high.y - 16 : low.y + 16);
    list.AddLine(from, to, colour.packed(), 1.3f);
  }
  list.PopClipRect();
}

void draw_swatch(const Ui& ui, Swatch swatch, ImVec2 low, bool on) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Theme& t = ui.theme;
  const ImVec2 high(low.x + 16, low.y + 16);
  const float y = low.y + 8;
  const auto shade = [&](Colour c) { return on ? c : t.quiet; };
  switch (swatch) {
    case Swatch::hull:
      list.AddRectFilled(low, high, (on ? t.hull : t.quiet.at(0.15f)).packed(), 3);
      list.AddRect(low, high, shade(t.hull_outline).packed(), 3, 0, 1.5f);
      break;
    case Swatch::clockwise:
    case Swatch::counterclockwise: {
      const bool clockwise = swatch == Swatch::clockwise;
      const Colour line = shade(clockwise ? t.clockwise_line : t.counter_line);
      list.AddRectFilled(low, high, line.at(0.16f).packed(), 3);
      hatch_swatch(list, low, high, line.at(0.8f), clockwise);
      break;
    }
    case Swatch::chord:
      list.AddLine(ImVec2(low.x, y), ImVec2(high.x, y), shade(t.chord).packed(), 2);
      list.AddCircleFilled(ImVec2(low.x + 2, y), 3, shade(t.text).packed(), 12);
      list.AddCircleFilled(ImVec2(high.x - 2, y), 3, shade(t.text).packed(), 12);
      break;
    case Swatch::tipping:
      for (int i = 0; i < 4; ++i) {
        const float left = low.x + 4 * static_cast<float>(i);
        const Colour band =
            on ? t.heat[2 * i] : t.quiet.at(0.2f + 0.15f * static_cast<float>(3 - i));
        list.AddRectFilled(ImVec2(left, low.y), ImVec2(left + 4, high.y), band.packed());
      }
      break;
    case Swatch::candidate:
      for (float x = 0; x < 16; x += 6) {
        list.AddLine(ImVec2(low.x + x, y), ImVec2(low.x + x + 3.5f, y),
                     shade(t.second_text).packed(), 1.4f);
      }
      break;
  }
}

}  // namespace

void seek_control(std::string name) { sought = {std::move(name), std::nullopt}; }

std::optional<Rect> found_control() {
  const std::optional<Rect> found = sought.found;
  sought = {};
  return found;
}

void begin_card(const Ui& ui, const char* id, const Rect& place, const CardOptions& options) {
  ImGui::SetNextWindowPos(vec(place.left, place.top));
  if (options.fixed_height) {
    ImGui::SetNextWindowSize(vec(place.width(), place.height()));
  } else {
    const double least = options.fixed_width ? place.width() : 0;
    ImGui::SetNextWindowSizeConstraints(vec(least, 0), vec(place.width(), place.height()));
  }
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(options.padding, options.padding));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 10.0f);
  ImGuiWindowFlags flags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove |
                           ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoSavedSettings |
                           ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoNavInputs;
  if (!options.fixed_height) flags |= ImGuiWindowFlags_AlwaysAutoResize;
  if (!options.scrolls) flags |= ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse;
  ImGui::Begin(id, nullptr, flags);
  const ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  sharpen(*ImGui::GetWindowDrawList(), ui.state);
  soft_shadow(ui, low, ImVec2(low.x + size.x, low.y + size.y));
}

void soft_shadow(const Ui& ui, ImVec2 low, ImVec2 high) {
  constexpr int layers = 8;
  for (int i = 1; i <= layers; ++i) {
    const float grow = static_cast<float>(i) * 1.5f;
    ImGui::GetBackgroundDrawList()->AddRectFilled(
        ImVec2(low.x - grow, low.y - grow + 3), ImVec2(high.x + grow, high.y + grow + 3),
        ui.theme.shadow.at(1.0f / layers).packed(), 10 + grow);
  }
}

void scroll_by_finger(const Ui& ui) {
  const ImGuiIO& io = ImGui::GetIO();
  if (!ui.state.screen.touch || slider_held || !io.MouseDown[0] || ImGui::GetScrollMaxY() <= 0)
    return;
  if (!ImGui::IsWindowHovered(ImGuiHoveredFlags_ChildWindows |
                              ImGuiHoveredFlags_AllowWhenBlockedByActiveItem))
    return;
  if (io.MouseDragMaxDistanceSqr[0] > shake * shake)
    ImGui::SetScrollY(ImGui::GetScrollY() - io.MouseDelta.y);
}

bool tapped(const Ui& ui, bool pressed) {
  return pressed &&
         !(ui.state.screen.touch && ImGui::GetIO().MouseDragMaxDistanceSqr[0] > shake * shake);
}

void end_card(const Ui& ui) {
  scroll_by_finger(ui);
  ImGui::End();
  ImGui::PopStyleVar(2);
}

bool icon_button(const Ui& ui, const char* id, Icon icon, bool enabled, const char* about,
                 float size) {
  const Area a = area(ui, id, ImVec2(size, size), enabled);
  ground(ui, a, 7, ui.theme.panel.at(0));
  const Colour colour = enabled ? ui.theme.text : ui.theme.quiet.at(0.6f);
  draw_icon(*ImGui::GetWindowDrawList(), icon, a.middle(), 18, colour);
  if (ImGui::IsItemHovered()) tip(ui, about);
  return a.pressed;
}

bool text_button(const Ui& ui, const char* id, Icon icon, const char* label, const char* about,
                 float height, Icon after) {
  const ImVec2 text = text_size(Face::text, label);
  const float before = icon == Icon::none ? 12.0f : 38.0f,
              behind = after == Icon::none ? 12.0f : 30.0f;
  const Area a = area(ui, id, ImVec2(before + text.x + behind, height));
  ground(ui, a, 7, ui.theme.panel.at(0));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float y = a.middle().y;
  draw_icon(list, icon, ImVec2(a.low.x + 20, y), 18, ui.theme.text);
  draw_text(list, Face::text, ImVec2(a.low.x + before, y - text.y / 2), ui.theme.text, label);
  draw_icon(list, after, ImVec2(a.high.x - 18, y), 12, ui.theme.second_text);
  if (a.hovered && about) tip(ui, about);
  return a.pressed;
}

bool flat_button(const Ui& ui, const char* id, const char* label, float width, bool enabled,
                 bool strong) {
  const Area a = area(ui, id, ImVec2(width, ui.control()), enabled);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Colour still = strong && enabled ? ui.theme.accent : ui.theme.well;
  const Colour hovered = strong ? ui.theme.accent.at(0.88f) : ui.theme.panel_line;
  list.AddRectFilled(a.low, a.high, (a.hovered ? hovered : still).packed(), 7);
  const ImVec2 text = text_size(Face::text, label);
  const Colour ink = !enabled ? ui.theme.quiet : strong ? ui.theme.on_accent : ui.theme.text;
  draw_text(list, Face::text, ImVec2(a.middle().x - text.x / 2, a.middle().y - text.y / 2), ink,
            label);
  return a.pressed;
}

bool switch_chip(const Ui& ui, const char* label, bool on) {
  const ImVec2 text = text_size(Face::label, label);
  const float height = ui.control();
  const Area a = area(ui, label, ImVec2(text.x + 46, height));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(a.low, a.high, (a.hovered ? ui.theme.panel_line : ui.theme.panel).packed(),
                     height / 2);
  list.AddRect(a.low, a.high, (on ? ui.theme.accent : ui.theme.panel_line).packed(), height / 2, 0,
               1);
  const float y = a.middle().y;
  const ImVec2 low(a.low.x + 8, y - 7), high(a.low.x + 32, y + 7);
  list.AddRectFilled(low, high, (on ? ui.theme.accent : ui.theme.quiet).packed(), 7);
  list.AddCircleFilled(ImVec2(on ? high.x - 7 : low.x + 7, y), 5, ui.theme.panel.packed(), 16);
  draw_text(list, Face::label, ImVec2(a.low.x + 38, y - text.y / 2), ui.theme.text, label);
  return a.pressed;
}

int stepper(const Ui& ui, const char* id, const std::string& value, bool can_lower, bool can_raise,
            float width) {
  const float height = ui.control(), side = height + 4;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  ImGui::PushID(id);
  const ImVec2 low = ImGui::GetCursorScreenPos(), high(low.x + width, low.y + height);
  list.AddRectFilled(low, high, ui.theme.well.packed(), 7);
  int change = 0;
  const auto end = [&](const char* name, Icon icon, bool enabled, int by) {
    const Area a = area(ui, name, ImVec2(side, height), enabled, id);
    if (a.hovered || a.active) list.AddRectFilled(a.low, a.high, ui.theme.panel_line.packed(), 7);
    draw_icon(list, icon, a.middle(), 16, enabled ? ui.theme.text : ui.theme.quiet.at(0.6f));
    if (enabled && repeats(a)) change = by;
  };
  end("-", Icon::minus, can_lower, -1);
  ImGui::SameLine(0, width - 2 * side);
  end("+", Icon::plus, can_raise, 1);
  const ImVec2 text = text_size(Face::strong, value);
  draw_text(list, Face::strong,
            ImVec2((low.x + high.x - text.x) / 2, (low.y + high.y - text.y) / 2), ui.theme.text,
            value);
  ImGui::PopID();
  return change;
}

SliderResult slider(const Ui& ui, const char* id, double value, double low, double high,
                    double step, float width) {
  const float height = ui.control(), knob = ui.control() > 40 ? 11.0f : 8.0f;
  const Area a = area(ui, id, ImVec2(width, height));
  SliderResult result{false, ImGui::IsItemDeactivated(), value};
  if (ImGui::IsItemActivated()) slider_held = true;
  if (result.released) slider_held = false;
  const float from = a.low.x + knob, to = a.high.x - knob;
  if (a.active && ImGui::IsMouseDown(0)) {
    const double share =
        std::clamp(static_cast<double>((ImGui::GetIO().MousePos.x - from) / (to - from)), 0.0, 1.0);
    // Steps are decimals: dividing two integers gives the double nearest to the one shown.
    const double steps = std::round(1 / step);
    const double wanted = std::round((low + share * (high - low)) * steps) / steps;
    result.changed = wanted != value;
    result.value = wanted;
  }
  const float x = from + (to - from) * static_cast<float>((result.value - low) / (high - low)),
              y = a.middle().y;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(ImVec2(a.low.x, y - 3), ImVec2(a.high.x, y + 3), ui.theme.panel_line.packed(),
                     3);
  list.AddRectFilled(ImVec2(a.low.x, y - 3), ImVec2(x, y + 3), ui.theme.accent.packed(), 3);
  if (a.hovered || a.active)
    list.AddCircleFilled(ImVec2(x, y), knob + 5, ui.theme.accent.at(0.16f).packed(), 32);
  list.AddCircleFilled(ImVec2(x, y), knob, ui.theme.panel.packed(), 32);
  list.AddCircle(ImVec2(x, y), knob, ui.theme.accent.packed(), 32, 2);
  return result;
}

bool chip(const Ui& ui, const char* id, Swatch swatch, const char* label, bool on) {
  const ImVec2 text = text_size(Face::label, label);
  const float height = ui.control() - 2;
  const Area a = area(ui, id, ImVec2(16 + 9 + 6 + text.x + 11, height));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Colour fill = a.hovered ? ui.theme.panel_line : on ? ui.theme.well : ui.theme.panel;
  list.AddRectFilled(a.low, a.high, fill.packed(), height / 2);
  list.AddRect(a.low, a.high, (on ? ui.theme.quiet : ui.theme.panel_line).packed(), height / 2, 0,
               1);
  const float y = a.middle().y;
  draw_swatch(ui, swatch, ImVec2(a.low.x + 9, y - 8), on);
  draw_text(list, Face::label, ImVec2(a.low.x + 31, y - text.y / 2),
            on ? ui.theme.text : ui.theme.second_text, label);
  return a.pressed;
}

float labelled(const Ui& ui, const char* label, float label_width) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float left = ImGui::GetContentRegionAvail().x;
  const ImVec2 text = text_size(Face::label, label);
  draw_text(*ImGui::GetWindowDrawList(), Face::label,
            ImVec2(at.x, at.y + (ui.control() - text.y) / 2), ui.theme.second_text, label);
  ImGui::SetCursorScreenPos(ImVec2(at.x + label_width, at.y));
  return left - label_width;
}

void rule(const Ui& ui) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, y = at.y + 4;
  ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(at.x, y), ImVec2(at.x + width, y + 1),
                                            ui.theme.panel_line.packed());
  ImGui::Dummy(ImVec2(0, 9));
}

void tip(const Ui& ui, const char* text) {
  if (!text || ui.state.screen.touch || ui.state.screen.finger) return;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(10, 7));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 7.0f);
  ImGui::BeginTooltip();
  text_line(Face::label, ui.theme.text, text);
  ImGui::EndTooltip();
  ImGui::PopStyleVar(2);
}

void text_line(Face face, Colour colour, const std::string& text) {
  push_face(face);
  ImGui::PushStyleColor(ImGuiCol_Text, colour.vec());
  ImGui::TextUnformatted(text.data(), text.data() + text.size());
  ImGui::PopStyleColor();
  pop_face();
}

// Dear ImGui's own wrapped text breaks lines after a decimal point, too, and has no line height.
void text_block(Face face, Colour colour, const std::string& text, float kept_free) {
  const float wrap = ImGui::GetContentRegionAvail().x - kept_free,
              line = std::round(size(face) * 1.4f);
  const ImVec2 start = ImGui::GetCursorScreenPos();
  ImVec2 at = start;
  const std::string_view all = text;
  std::size_t from = 0;
  while (from < all.size()) {
    std::size_t to = std::min(all.find(' ', from), all.size());
    while (to < all.size()) {
      const std::size_t next = std::min(all.find(' ', to + 1), all.size());
      if (text_size(face, all.substr(from, next - from)).x > wrap) break;
      to = next;
    }
    draw_text(*ImGui::GetWindowDrawList(), face, at, colour, all.substr(from, to - from));
    from = to + 1;
    at.y += line;
  }
  ImGui::Dummy(ImVec2(wrap, at.y - start.y));
}

}  // namespace evenlift::view
