#include "widgets/buttons.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "ui/controls.h"
#include "ui/theme.h"
#include "widgets/fields.h"
#include "widgets/text.h"

namespace evenlift::view {
namespace {

// The background shows hovering.
void ground(const Ui& ui, const Area& a, float rounding, Colour still) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Colour colour = a.active || a.hovered ? ui.theme.panel_line : still;
  list.AddRectFilled(a.low, a.high, colour.packed(), rounding);
}

}  // namespace

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
                 bool strong, const char* spoken) {
  const Area a =
      area(ui, ImVec2(width, ui.control()), button_control(id, spoken ? spoken : label, enabled));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Colour still = strong && enabled ? ui.theme.accent : ui.theme.well;
  const Colour hovered = strong ? ui.theme.accent.at(0.88f) : ui.theme.panel_line;
  list.AddRectFilled(a.low, a.high, (a.hovered ? hovered : still).packed(), 7);
  // A long label is smaller, and cut if that does not suffice.
  const float room = width - 8;
  const Face face = text_size(Face::text, label).x <= room ? Face::text : Face::label;
  note_room(label, text_size(face, label).x, width);
  const std::string words = cut_off(face, label, room);
  const ImVec2 text = text_size(face, words);
  const Colour ink = !enabled ? ui.theme.quiet : strong ? ui.theme.on_accent : ui.theme.text;
  draw_text(list, face, ImVec2(a.middle().x - text.x / 2, a.middle().y - text.y / 2), ink, words);
  if (a.hovered && words != label) tip(ui, label);
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
  note_room(label, text.x, width);
  draw_text(list, Face::text, ImVec2(a.middle().x - text.x / 2, a.middle().y - text.y / 2),
            on ? ui.theme.on_accent : ui.theme.text, label);
  if (a.hovered) tip(ui, about);
  return a.pressed;
}

PressableRow pressable_row(const Ui& ui, const char* id, const std::string& label, float width,
                           float height, bool enabled) {
  const Area a = area(ui, ImVec2(width, height), button_control(id, label.c_str(), enabled));
  return {a.low, a.high, a.pressed, a.hovered};
}

namespace {

bool finger_is_taken = false;  // it holds an item that follows the pointer
// The scroll bar leaves out the padding above and below, so that it does not lengthen the content.
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

// While there is more below: fades the content at the foot, `inset` from the sides and above the
// border.
void shade_foot(const Ui& ui, float inset, float border) {
  if (ImGui::GetScrollY() > ImGui::GetScrollMaxY() - 1) return;
  constexpr float height = 36;
  const ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  const float bottom = low.y + size.y - border;
  const ImU32 clear = ui.theme.panel.at(0).packed(), full = ui.theme.panel.packed();
  ImGui::GetWindowDrawList()->AddRectFilledMultiColor(ImVec2(low.x + inset, bottom - height),
                                                      ImVec2(low.x + size.x - inset, bottom), clear,
                                                      clear, full, full);
}

// While there is more above: a line cut there would look like a fault.
void shade_head(const Ui& ui) {
  if (ImGui::GetScrollY() < 1) return;
  constexpr float height = 20;
  const ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  const ImU32 clear = ui.theme.panel.at(0).packed(), full = ui.theme.panel.packed();
  ImGui::GetWindowDrawList()->AddRectFilledMultiColor(low, ImVec2(low.x + size.x, low.y + height),
                                                      full, full, clear, clear);
}

}  // namespace

void begin_card(const Ui& ui, const char* id, const Rect& place, const CardOptions& options) {
  ImGui::SetNextWindowPos(vec(place.left, options.at_bottom ? place.bottom : place.top),
                          ImGuiCond_Always, ImVec2(0, options.at_bottom ? 1.0f : 0.0f));
  if (options.fixed_height) {
    // A window begins at a whole pixel and ends with the place; otherwise a strip of the drawing
    // would be visible below it.
    ImGui::SetNextWindowSize(vec(place.width(), std::ceil(place.bottom - std::floor(place.top))));
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
  if (options.stays_below) flags |= ImGuiWindowFlags_NoBringToFrontOnFocus;
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
  if (!ui.state.session.screen.touch || finger_is_taken || !io.MouseDown[0] ||
      ImGui::GetScrollMaxY() <= 0)
    return;
  if (!ImGui::IsWindowHovered(ImGuiHoveredFlags_ChildWindows |
                              ImGuiHoveredFlags_AllowWhenBlockedByActiveItem))
    return;
  if (is_dragged()) ImGui::SetScrollY(ImGui::GetScrollY() - io.MouseDelta.y);
}

void take_way_of_finger() {
  if (ImGui::IsItemActivated()) finger_is_taken = true;
  if (ImGui::IsItemDeactivated()) finger_is_taken = false;
}

void begin_scrolling_box(const Ui& ui, const char* id, float height) {
  constexpr float bar = 6, gap = 4;
  const float width = ImGui::GetContentRegionAvail().x;
  ImGui::PushStyleVar(ImGuiStyleVar_ScrollbarSize, bar);
  ImGui::SetNextWindowContentSize(ImVec2(width, 0));
  ImGui::BeginChild(id, ImVec2(width + gap + bar, height));
  ImGui::PopStyleVar();
  scroll_by_finger(ui);
}

void end_scrolling_box(const Ui& ui) {
  shade_head(ui);
  shade_foot(ui, 0, 0);
  ImGui::EndChild();
}

int in_last_frame(const char* id, int now, int at_first) {
  int& seen = *ImGui::GetStateStorage()->GetIntRef(ImGui::GetID(id), at_first);
  return std::exchange(seen, now);
}

void show_opened(const Ui& ui, const char* id, bool open, float head) {
  const bool was_open = in_last_frame(id, open, open) != 0;
  if (!open || was_open) return;
  const float pad = ImGui::GetStyle().WindowPadding.y,
              beyond = ImGui::GetCursorPosY() + pad - ImGui::GetWindowHeight();
  const float wanted = std::min(beyond, head - pad);
  if (wanted <= ImGui::GetScrollY()) return;
  ImGui::SetScrollY(wanted);
  ui.push(LayOutAgain{});
}

bool is_dragged() {
  constexpr float shake = 8;  // pixels that a tap may move
  return ImGui::GetIO().MouseDragMaxDistanceSqr[0] > shake * shake;
}

bool tapped(const Ui& ui, bool pressed) {
  const Screen& screen = ui.state.session.screen;
  return pressed && !(screen.touch && (screen.asking || is_dragged()));
}

void end_card(const Ui& ui) {
  const bool scrolls = ImGui::GetStateStorage()->GetBool(ImGui::GetID("scrolls"));
  if (scrolls) shade_foot(ui, ImGui::GetStyle().WindowPadding.x, 1);
  if (scrolls && ImGui::GetScrollMaxY() > 0) draw_scroll_bar(ui);
  scroll_by_finger(ui);
  const ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  cover_controls({low.x, low.y, low.x + size.x, low.y + size.y});
  ImGui::End();
  ImGui::PopStyleVar(2);
}

namespace {

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
    case Swatch::tilt:
      for (const float radius : {3.0f, 7.0f})
        list.AddCircle(ImVec2(low.x + 8, y), radius, shade(t.hull_outline).packed(), 20, 1.5f);
      break;
    case Swatch::load:
      list.AddCircleFilled(ImVec2(low.x + 8, low.y + 4), 3, shade(t.hull_outline).packed(), 16);
      list.AddRectFilled(ImVec2(low.x + 4, low.y + 8), ImVec2(low.x + 12, high.y),
                         shade(t.hull_outline).packed(), 3);
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

bool chip(const Ui& ui, const char* id, Swatch swatch, const char* label, bool on) {
  const ImVec2 text = text_size(Face::label, label);
  const float height = ui.control() - 2;
  const Area a =
      area(ui, ImVec2(16 + 9 + 6 + text.x + 11, height), pressed_control(id, label, true, on));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Colour fill = a.hovered ? ui.theme.panel_line : on ? ui.theme.well : ui.theme.panel;
  list.AddRectFilled(a.low, a.high, fill.packed(), height / 2);
  list.AddRect(a.low, a.high, (on ? ui.theme.text : ui.theme.quiet).packed(), height / 2, 0, 1);
  const float y = a.middle().y;
  draw_swatch(ui, swatch, ImVec2(a.low.x + 9, y - 8), on);
  draw_text(list, Face::label, ImVec2(a.low.x + 31, y - text.y / 2),
            on ? ui.theme.text : ui.theme.second_text, label);
  return a.pressed;
}

}  // namespace evenlift::view
