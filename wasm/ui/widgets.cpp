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
  bool pressed, hovered, active;
  Asked asked;
  ImVec2 middle() const { return {(low.x + high.x) / 2, (low.y + high.y) / 2}; }
};

// Lays out the control that `control` describes.
Area area(const Ui& ui, ImVec2 size, Control control) {
  Area a;
  const bool enabled = control.enabled;
  a.pressed = tapped(ui, ImGui::InvisibleButton(control.name.c_str(), size)) && enabled;
  a.low = ImGui::GetItemRectMin();
  a.high = ImGui::GetItemRectMax();
  a.hovered = ImGui::IsItemHovered() && enabled;
  a.active = ImGui::IsItemActive() && enabled;
  a.asked = list_control(std::move(control));
  a.pressed |= a.asked.pressed;
  if (a.hovered) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  return a;
}

Control button_control(const char* id, const char* label, bool enabled = true) {
  Control control;
  control.name = id;
  control.label = label;
  control.enabled = enabled;
  return control;
}

Control toggle_control(const char* id, const char* label, bool on) {
  Control control = button_control(id, label);
  control.kind = ControlKind::toggle;
  control.on = on;
  return control;
}

// A button, or a toggle where it can be on.
Control pressed_control(const char* id, const char* label, bool enabled, Pressed on) {
  if (!on) return button_control(id, label, enabled);
  Control control = toggle_control(id, label, *on);
  control.enabled = enabled;
  return control;
}

Control number_control(const char* id, const char* label, const char* setting,
                       const std::string& value) {
  Control control = button_control(id, label);
  control.kind = ControlKind::number;
  control.setting = setting;
  control.value = value;
  return control;
}

Control slider_control(const char* id, const char* label, double at, double low, double high,
                       double step) {
  Control control = button_control(id, label);
  control.kind = ControlKind::slider;
  control.at = at;
  control.low = low;
  control.high = high;
  control.step = step;
  return control;
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
  for (int line = 0; line < 11; ++line) {
    const float x = -16 + 4.5f * static_cast<float>(line);
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
    case Swatch::halo:
      list.AddCircleFilled(ImVec2(low.x + 8, y), 2.5f, shade(t.text).packed(), 12);
      for (int i = 0; i < 8; ++i) {
        const float from = static_cast<float>(i) * 0.785f;
        list.PathArcTo(ImVec2(low.x + 8, y), 7, from, from + 0.5f, 4);
        list.PathStroke(shade(t.hull_outline).packed(), 0, 1.5f);
      }
      break;
    case Swatch::candidate:
      for (const float x : {0.0f, 6.0f, 12.0f}) {
        list.AddLine(ImVec2(low.x + x, y), ImVec2(low.x + x + 3.5f, y),
                     shade(t.second_text).packed(), 1.4f);
      }
      break;
  }
}

}  // namespace

void begin_card(const Ui& ui, const char* id, const Rect& place, const CardOptions& options) {
  ImGui::SetNextWindowPos(vec(place.left, options.at_bottom ? place.bottom : place.top),
                          ImGuiCond_Always, ImVec2(0, options.at_bottom ? 1.0f : 0.0f));
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
                           ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoNavInputs |
                           ImGuiWindowFlags_NoScrollbar;
  if (!options.fixed_height) flags |= ImGuiWindowFlags_AlwaysAutoResize;
  if (!options.scrolls) flags |= ImGuiWindowFlags_NoScrollWithMouse;
  ImGui::Begin(id, nullptr, flags);
  ImGui::GetStateStorage()->SetBool(ImGui::GetID("scrolls"), options.scrolls);
  enter_card(id);
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

void begin_scrolling_box(const Ui& ui, const char* id, float height) {
  constexpr float bar = 6;
  const float width = ImGui::GetContentRegionAvail().x;
  ImGui::PushStyleVar(ImGuiStyleVar_ScrollbarSize, bar);
  ImGui::SetNextWindowContentSize(ImVec2(width, 0));
  ImGui::BeginChild(id, ImVec2(width + bar, height));
  ImGui::PopStyleVar();
  scroll_by_finger(ui);
}

bool tapped(const Ui& ui, bool pressed) {
  return pressed &&
         !(ui.state.screen.touch && ImGui::GetIO().MouseDragMaxDistanceSqr[0] > shake * shake);
}

// The scroll bar lies in the padding of the card, so that its content is as wide with it as without it. It stays between the
// first and the last line of the content, which it must not lengthen.
void draw_scroll_bar(const Ui& ui) {
  const float most = ImGui::GetScrollMaxY(), padding = ImGui::GetStyle().WindowPadding.y;
  const ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  const float right = low.x + size.x - 4, top = low.y + padding, track = size.y - 2 * padding,
              height = std::max(24.0f, track * track / (track + most));
  if (!(track > height)) return;
  const ImVec2 cursor = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos(ImVec2(right - 10, top));
  ImGui::InvisibleButton("scroll bar", ImVec2(10, track));
  ImGui::SetCursorScreenPos(cursor);
  const bool held = ImGui::IsItemActive(), hovered = ImGui::IsItemHovered();
  if (held && ImGui::GetIO().MouseDelta.y != 0)
    ImGui::SetScrollY(ImGui::GetScrollY() + ImGui::GetIO().MouseDelta.y * most / (track - height));
  const float at = top + (track - height) * ImGui::GetScrollY() / most;
  ImGui::GetWindowDrawList()->AddRectFilled(
      ImVec2(right - 6, at), ImVec2(right, at + height),
      (held || hovered ? ui.theme.second_text : ui.theme.quiet).packed(), 3);
}

void end_card(const Ui& ui) {
  const bool scrolls = ImGui::GetStateStorage()->GetBool(ImGui::GetID("scrolls"));
  if (scrolls && ImGui::GetScrollMaxY() > 0) draw_scroll_bar(ui);
  scroll_by_finger(ui);
  ImGui::End();
  ImGui::PopStyleVar(2);
}

bool icon_button(const Ui& ui, const char* id, Icon icon, bool enabled, const char* about,
                 float size, Pressed on) {
  const Area a = area(ui, ImVec2(size, size), pressed_control(id, about ? about : id, enabled, on));
  ground(ui, a, 7, on == true ? ui.theme.accent.at(0.18f) : ui.theme.panel.at(0));
  const Colour colour = on == true ? ui.theme.accent
                        : enabled  ? ui.theme.text
                                   : ui.theme.quiet.at(0.6f);
  draw_icon(*ImGui::GetWindowDrawList(), icon, a.middle(), 18, colour);
  if (ImGui::IsItemHovered()) tip(ui, about);
  return a.pressed;
}

bool text_button(const Ui& ui, const char* id, Icon icon, const char* label, const char* about,
                 float height, Icon after, Pressed on) {
  const ImVec2 text = text_size(Face::text, label);
  const float before = icon == Icon::none ? 12.0f : 38.0f,
              behind = after == Icon::none ? 12.0f : 30.0f;
  const Area a =
      area(ui, ImVec2(before + text.x + behind, height), pressed_control(id, label, true, on));
  ground(ui, a, 7, on == true ? ui.theme.accent.at(0.18f) : ui.theme.panel.at(0));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float y = a.middle().y;
  const Colour ink = on == true ? ui.theme.accent : ui.theme.text;
  draw_icon(list, icon, ImVec2(a.low.x + 20, y), 18, ink);
  draw_text(list, Face::text, ImVec2(a.low.x + before, y - text.y / 2), ink, label);
  draw_icon(list, after, ImVec2(a.high.x - 18, y), 12, ui.theme.second_text);
  if (a.hovered && about) tip(ui, about);
  return a.pressed;
}

float text_button_width(const char* label) { return 38 + text_size(Face::text, label).x + 12; }

bool flat_button(const Ui& ui, const char* id, const char* label, float width, bool enabled,
                 bool strong) {
  const Area a = area(ui, ImVec2(width, ui.control()), button_control(id, label, enabled));
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

float switch_chip_width(const char* label) { return text_size(Face::label, label).x + 46; }

bool switch_chip(const Ui& ui, const char* label, bool on) {
  const ImVec2 text = text_size(Face::label, label);
  const float height = ui.control();
  const Area a =
      area(ui, ImVec2(switch_chip_width(label), height), toggle_control(label, label, on));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(a.low, a.high, (a.hovered ? ui.theme.panel_line : ui.theme.panel).packed(),
                     height / 2);
  list.AddRect(a.low, a.high, (on ? ui.theme.accent : ui.theme.quiet).packed(), height / 2, 0, 1);
  const float y = a.middle().y;
  const ImVec2 low(a.low.x + 8, y - 7), high(a.low.x + 32, y + 7);
  list.AddRectFilled(low, high, (on ? ui.theme.accent : ui.theme.quiet).packed(), 7);
  list.AddCircleFilled(ImVec2(on ? high.x - 7 : low.x + 7, y), 5, ui.theme.panel.packed(), 16);
  draw_text(list, Face::label, ImVec2(a.low.x + 38, y - text.y / 2), ui.theme.text, label);
  return a.pressed;
}

bool toggle_button(const Ui& ui, const char* id, const char* label, const char* about, float width,
                   bool on) {
  const Area a = area(ui, ImVec2(width, ui.control()), toggle_control(id, about, on));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Colour ground = on ? ui.theme.accent : a.hovered ? ui.theme.panel_line : ui.theme.well;
  list.AddRectFilled(a.low, a.high, ground.packed(), 7);
  const ImVec2 text = text_size(Face::text, label);
  draw_text(list, Face::text, ImVec2(a.middle().x - text.x / 2, a.middle().y - text.y / 2),
            on ? ui.theme.on_accent : ui.theme.text, label);
  if (a.hovered) tip(ui, about);
  return a.pressed;
}

int stepper(const Ui& ui, const char* id, const std::string& value, float width,
            const StepperOptions& options) {
  const float height = ui.control(), side = height + 4;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  ImGui::PushID(id);
  const ImVec2 low = ImGui::GetCursorScreenPos(), high(low.x + width, low.y + height);
  list.AddRectFilled(low, high, ui.theme.well.packed(), 7);
  int change = 0;
  const auto end = [&](const char* sign, const char* word, Icon icon, bool enabled, int by) {
    const std::string name = std::string(id) + ' ' + sign,
                      label = std::string(options.label) + ": " + word;
    const Area a =
        area(ui, ImVec2(side, height), button_control(name.c_str(), label.c_str(), enabled));
    if (a.hovered || a.active) list.AddRectFilled(a.low, a.high, ui.theme.panel_line.packed(), 7);
    draw_icon(list, icon, a.middle(), 16, enabled ? ui.theme.text : ui.theme.quiet.at(0.6f));
    if (enabled && (a.asked.pressed || repeats(a))) change = by;
  };
  end("-", "less", Icon::minus, options.can_lower, -1);
  ImGui::SameLine(0, 0);
  const float middle = width - 2 * side;
  ImGui::Dummy(ImVec2(middle, height));
  if (*options.setting) list_control(number_control(id, options.label, options.setting, value));
  ImGui::SameLine(0, 0);
  end("+", "more", Icon::plus, options.can_raise, 1);
  const ImVec2 text = text_size(Face::strong, value);
  draw_text(list, Face::strong,
            ImVec2((low.x + high.x - text.x) / 2, (low.y + high.y - text.y) / 2), ui.theme.text,
            value);
  ImGui::PopID();
  return change;
}

void text_field(const Ui& ui, const char* id, const char* label, const char* setting,
                const std::string& value, float width) {
  ImGui::Dummy(ImVec2(width, ui.control()));
  list_control(number_control(id, label, setting, value));
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(low, high, true);
  draw_text(list, Face::text, ImVec2(low.x, (low.y + high.y - text_size(Face::text, value).y) / 2),
            ui.theme.text, value);
  list.PopClipRect();
}

void number_field(const Ui& ui, const char* id, const char* label, const char* setting,
                  const std::string& value, float width, Colour colour) {
  ImGui::Dummy(ImVec2(width, ui.control()));
  list_control(number_control(id, label, setting, value));
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  const ImVec2 text = text_size(Face::strong, value);
  draw_text(*ImGui::GetWindowDrawList(), Face::strong,
            ImVec2(high.x - text.x, (low.y + high.y - text.y) / 2), colour, value);
}

Asked typed_field(const Ui& ui, const char* id, const char* label, const std::string& value,
                  float width) {
  const ImVec2 name = text_size(Face::label, label), from = ImGui::GetCursorScreenPos();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  draw_text(list, Face::label, ImVec2(from.x, from.y + (ui.control() - name.y) / 2),
            ui.theme.second_text, label);
  ImGui::SetCursorScreenPos(ImVec2(from.x + name.x + 6, from.y));
  ImGui::Dummy(ImVec2(width, ui.control()));
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax(),
               text = text_size(Face::strong, value);
  list.AddRectFilled(low, high, ui.theme.well.packed(), 7);
  list.AddRect(low, high, ui.theme.quiet.packed(), 7, 0, 1);
  draw_text(list, Face::strong,
            ImVec2((low.x + high.x - text.x) / 2, (low.y + high.y - text.y) / 2), ui.theme.text,
            value);
  return list_control(number_control(id, label, "", value));
}

float knob_radius(const Ui& ui) { return ui.control() > 40 ? 11.0f : 8.0f; }

SliderResult slider(const Ui& ui, const char* id, const char* label, double value, double low,
                    double high, double step, float width, bool counts) {
  const Track even{[=](double at) { return (at - low) / (high - low); },
                   [=](double share) { return low + share * (high - low); }};
  return slider(ui, id, label, value, low, high, step, width, even, counts);
}

SliderResult slider(const Ui& ui, const char* id, const char* label, double value, double low,
                    double high, double step, float width, const Track& track, bool counts) {
  const Colour ink = counts ? ui.theme.accent : ui.theme.quiet;
  const float height = ui.control(), knob = knob_radius(ui);
  const Area a = area(ui, ImVec2(width, height), slider_control(id, label, value, low, high, step));
  SliderResult result{false, ImGui::IsItemDeactivated(), value};
  if (a.asked.moved && *a.asked.moved >= low && *a.asked.moved <= high)
    result = {*a.asked.moved != value, true, *a.asked.moved};
  if (ImGui::IsItemActivated()) slider_held = true;
  if (result.released) slider_held = false;
  const float from = a.low.x + knob, to = a.high.x - knob;
  if (a.active && ImGui::IsMouseDown(0)) {
    const double share =
        std::clamp(static_cast<double>((ImGui::GetIO().MousePos.x - from) / (to - from)), 0.0, 1.0);
    // Steps are decimals: dividing two integers gives the double nearest to the one shown.
    const double steps = std::round(1 / step);
    const double at = track.value(share);
    const double wanted =
        step < 1 ? std::round(at * steps) / steps : std::min(std::round(at / step) * step, high);
    result.changed = wanted != value;
    result.value = wanted;
  }
  const float x = from + (to - from) * static_cast<float>(track.share(result.value)),
              y = a.middle().y;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(ImVec2(a.low.x, y - 3), ImVec2(a.high.x, y + 3), ui.theme.quiet.packed(), 3);
  list.AddRectFilled(ImVec2(a.low.x, y - 3), ImVec2(x, y + 3), ink.packed(), 3);
  if (a.hovered || a.active)
    list.AddCircleFilled(ImVec2(x, y), knob + 5, ui.theme.accent.at(0.16f).packed(), 32);
  list.AddCircleFilled(ImVec2(x, y), knob, ui.theme.panel.packed(), 32);
  list.AddCircle(ImVec2(x, y), knob, ink.packed(), 32, 2);
  return result;
}

RowOfPlaces row_of_places(const Ui& ui, const char* id, const char* label, const std::string& value,
                          std::size_t count, std::optional<std::size_t> taken, ImVec2 size) {
  const double at = taken ? static_cast<double>(*taken) + 1 : 0, most = static_cast<double>(count);
  Control control = slider_control(id, label, at, 0, most, 1);
  control.value = value;
  control.enabled = count > 0;
  const Area a = area(ui, size, std::move(control));
  if (ImGui::IsItemActivated()) slider_held = true;
  if (ImGui::IsItemDeactivated()) slider_held = false;
  RowOfPlaces row{a.low, a.high, {}, taken};
  if (count == 0) return row;
  if (a.asked.moved && *a.asked.moved >= 0 && *a.asked.moved <= most) {
    const auto place = static_cast<std::size_t>(std::round(*a.asked.moved));
    row.taken = place > 0 ? std::optional(place - 1) : std::nullopt;
    return row;
  }
  const ImGuiIO& io = ImGui::GetIO();
  const float share = std::clamp((io.MousePos.x - a.low.x) / size.x, 0.0f, 1.0f);
  const auto under =
      std::min(count - 1, static_cast<std::size_t>(static_cast<double>(share) * most));
  if (a.hovered || a.active) row.hovered = under;
  const bool slid = io.MouseDragMaxDistanceSqr[0] > shake * shake;
  if (a.active && slid) row.taken = under;
  if (a.pressed && !slid) row.taken = taken == under ? std::nullopt : std::optional(under);
  return row;
}

bool chip(const Ui& ui, const char* id, Swatch swatch, const char* label, bool on, bool enabled) {
  const ImVec2 text = text_size(Face::label, label);
  const float height = ui.control() - 2;
  const Area a =
      area(ui, ImVec2(16 + 9 + 6 + text.x + 11, height), pressed_control(id, label, enabled, on));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Colour fill = a.hovered ? ui.theme.panel_line : on ? ui.theme.well : ui.theme.panel;
  list.AddRectFilled(a.low, a.high, fill.packed(), height / 2);
  list.AddRect(a.low, a.high, (on ? ui.theme.text : ui.theme.quiet).packed(), height / 2, 0, 1);
  const float y = a.middle().y;
  draw_swatch(ui, swatch, ImVec2(a.low.x + 9, y - 8), on);
  draw_text(list, Face::label, ImVec2(a.low.x + 31, y - text.y / 2),
            !enabled ? ui.theme.quiet
            : on     ? ui.theme.text
                     : ui.theme.second_text,
            label);
  return a.pressed;
}

PressableRow pressable_row(const Ui& ui, const char* id, const std::string& label, float width,
                           float height, bool enabled) {
  const Area a = area(ui, ImVec2(width, height), button_control(id, label.c_str(), enabled));
  return {a.low, a.high, a.pressed, a.hovered};
}

float labelled(const Ui& ui, const char* label, const char* about) {
  constexpr float label_width = 120;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float left = ImGui::GetContentRegionAvail().x;
  const ImVec2 text = text_size(Face::label, label);
  draw_text(*ImGui::GetWindowDrawList(), Face::label,
            ImVec2(at.x, at.y + (ui.control() - text.y) / 2), ui.theme.second_text, label);
  if (ImGui::IsWindowHovered() &&
      ImGui::IsMouseHoveringRect(at, ImVec2(at.x + label_width - 8, at.y + ui.control())))
    tip(ui, about);
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

float line_height(Face face) { return std::round(size(face) * 1.4f); }

// Dear ImGui's own wrapped text breaks lines after a decimal point, too, and has no line height.
std::vector<std::string_view> broken_lines(Face face, std::string_view text, float width) {
  std::vector<std::string_view> lines;
  std::size_t from = 0;
  while (from < text.size()) {
    std::size_t to = std::min(text.find(' ', from), text.size());
    while (to < text.size()) {
      const std::size_t next = std::min(text.find(' ', to + 1), text.size());
      if (text_size(face, text.substr(from, next - from)).x > width) break;
      to = next;
    }
    lines.push_back(text.substr(from, to - from));
    from = to + 1;
  }
  return lines;
}

void draw_lines(ImDrawList& list, Face face, ImVec2 at, Colour colour,
                const std::vector<std::string_view>& lines) {
  for (const std::string_view line : lines) {
    draw_text(list, face, at, colour, line);
    at.y += line_height(face);
  }
}

float height_of(Face face, const std::vector<std::string_view>& lines) {
  return line_height(face) * static_cast<float>(lines.size());
}

void text_block(Face face, Colour colour, const std::string& text, float kept_free) {
  const float wrap = ImGui::GetContentRegionAvail().x - kept_free;
  const std::vector<std::string_view> lines = broken_lines(face, text, wrap);
  text_block_of(face, colour, text, wrap, lines.size());
}

void text_block_of(Face face, Colour colour, const std::string& text, float width,
                   std::size_t lines) {
  const std::vector<std::string_view> broken = broken_lines(face, text, width);
  const ImVec2 start = ImGui::GetCursorScreenPos();
  ImVec2 at = start;
  for (std::size_t i = 0; i < std::min(lines, broken.size()); ++i) {
    const bool cut = i + 1 == lines && broken.size() > lines;
    const std::string line = std::string(broken[i]) + (cut ? " …" : "");
    draw_text(*ImGui::GetWindowDrawList(), face, at, colour, line);
    at.y += line_height(face);
  }
  ImGui::Dummy(ImVec2(width, line_height(face) * static_cast<float>(lines)));
}

}  // namespace evenlift::view
