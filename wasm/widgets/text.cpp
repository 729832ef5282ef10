#include "widgets/text.h"

#include <algorithm>
#include <cmath>

#include "evenlift/wording.h"
#include "ui/controls.h"
#include "ui/theme.h"
#include "widgets/buttons.h"

namespace evenlift::view {

void text_line(Face face, Colour colour, const std::string& text) {
  const std::string_view said = translated(text);
  note_drawn(said);
  note_letters(*font(face), said);
  push_face(face);
  ImGui::PushStyleColor(ImGuiCol_Text, colour.vec());
  ImGui::TextUnformatted(said.data(), said.data() + said.size());
  ImGui::PopStyleColor();
  pop_face();
}

// Dear ImGui's wrapped text also breaks lines after a decimal point, and has no line height.
std::vector<std::string_view> broken_lines(Face face, std::string_view english, float width) {
  const std::string_view text = translated(english);
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

std::string cut_off(Face face, std::string text, float width) {
  if (text_size(face, text).x <= width) return text;
  while (!text.empty() && text_size(face, text + "…").x > width) {
    while (text.size() > 1 && (text.back() & 0xC0) == 0x80) text.pop_back();
    text.pop_back();
  }
  return text + "…";
}

void text_block_of(Face face, Colour colour, const std::string& text, float width,
                   std::size_t lines) {
  const std::vector<std::string_view> broken = broken_lines(face, text, width);
  const ImVec2 start = ImGui::GetCursorScreenPos();
  ImVec2 at = start;
  for (std::size_t i = 0; i < std::min(lines, broken.size()); ++i) {
    const bool cut = i + 1 == lines && broken.size() > lines;
    if (cut) note_room(text, 1, 0);
    const std::string line =
        cut ? cut_off(face, std::string(broken[i]) + " " + std::string(broken[i + 1]), width)
            : std::string(broken[i]);
    draw_text(*ImGui::GetWindowDrawList(), face, at, colour, line);
    at.y += line_height(face);
  }
  ImGui::Dummy(ImVec2(width, line_height(face) * static_cast<float>(lines)));
}

float labelled(const Ui& ui, const char* label, const char* about, float label_width) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float left = ImGui::GetContentRegionAvail().x;
  const ImVec2 text = text_size(Face::label, label);
  note_room(label, text.x, label_width - 8);
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

namespace {

// Above the finger, or below it at the top of the screen.
void place_tip_of_finger(const Screen& screen, ImVec2 size) {
  constexpr float above = 44, below = 56;
  const ImVec2 at = ImGui::GetIO().MousePos;
  const float most = std::max(8.0f, static_cast<float>(screen.width) - size.x - 8),
              top = at.y - above - size.y;
  ImGui::SetNextWindowPos(
      ImVec2(std::clamp(at.x - size.x / 2, 8.0f, most), top >= 8 ? top : at.y + below));
}

// A tip covers neither its control nor neighbours: it is beside the panel, and below or above a
// bar.
void place_tip(const Ui& ui, ImVec2 size) {
  constexpr float away = 14;
  if (ui.state.session.screen.asking && ui.state.session.screen.touch)
    return place_tip_of_finger(ui.state.session.screen, size);
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax(),
               pointer = ImGui::GetIO().MousePos;
  const float panel = static_cast<float>(ui.layout.panel.left);
  if (ui.layout.wide && ui.layout.panel.width() > 0 && pointer.x >= panel)
    return ImGui::SetNextWindowPos(
        ImVec2(std::max(8.0f, panel - size.x - 8), pointer.y - size.y / 2));
  const auto width = static_cast<float>(ui.state.session.screen.width),
             height = static_cast<float>(ui.state.session.screen.height);
  const bool wide = high.x - low.x > 240;  // a timeline, whose tip belongs to the pointer's place
  const float left = wide ? pointer.x - size.x / 2 : low.x;
  const bool below = low.y < height / 2 ||
                     ui.state.session.screen.foot > 0;  // a card of the page may appear above it
  ImGui::SetNextWindowPos(ImVec2(std::clamp(left, 8.0f, std::max(8.0f, width - size.x - 8)),
                                 below ? high.y + away : low.y - away - size.y));
}

}  // namespace

void tip(const Ui& ui, const char* text) {
  const Screen& screen = ui.state.session.screen;
  if (!text || ((screen.touch || screen.finger) && !screen.asking)) return;
  const ImVec2 padding(10, 7);
  const std::vector<std::string_view> lines =
      broken_lines(Face::label, text, static_cast<float>(screen.width) - 16 - 2 * padding.x);
  float width = 0;
  for (const std::string_view line : lines) width = std::max(width, text_size(Face::label, line).x);
  place_tip(ui, ImVec2(width + 2 * padding.x, height_of(Face::label, lines) + 2 * padding.y));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padding);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 7.0f);
  ImGui::BeginTooltip();
  draw_lines(*ImGui::GetWindowDrawList(), Face::label, ImGui::GetCursorScreenPos(), ui.theme.text,
             lines);
  ImGui::Dummy(ImVec2(width, height_of(Face::label, lines)));
  ImGui::EndTooltip();
  ImGui::PopStyleVar(2);
}

bool begin_choices(const Ui& ui, const char* id, ImVec2 anchor_low, ImVec2 anchor_high,
                   float least_width) {
  const auto width = static_cast<float>(ui.state.session.screen.width),
             height = static_cast<float>(ui.state.session.screen.height);
  const float room_below = height - anchor_high.y - 16, room_above = anchor_low.y - 16;
  constexpr float enough = 340;  // for the longest list of the panel
  const bool below = room_below > enough || room_below >= room_above;
  // In the window's right half the list extends to the left, to stay inside.
  const bool leftwards = anchor_low.x + anchor_high.x > width;
  // A list too narrow for its longest row extends past its button to the right.
  constexpr float longest = 346;
  const float right = std::max(anchor_high.x, std::min(width - 8, longest));
  ImGui::SetNextWindowPos(
      ImVec2(leftwards ? right : anchor_low.x, below ? anchor_high.y + 6 : anchor_low.y - 6),
      ImGuiCond_Always, ImVec2(leftwards ? 1.0f : 0.0f, below ? 0.0f : 1.0f));
  const float widest = (leftwards ? right : width - anchor_low.x) - 8;
  ImGui::SetNextWindowSizeConstraints(
      ImVec2(std::min(least_width, widest), 0),
      ImVec2(std::min(widest, 420.0f), std::max(below ? room_below : room_above, 120.0f)));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(6, 6));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
  if (ImGui::BeginPopup(id, ImGuiWindowFlags_NoMove)) {
    if (ui.state.session.close_list) ImGui::CloseCurrentPopup();
    sharpen(*ImGui::GetWindowDrawList(), ui.state);
    const ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    soft_shadow(ui, low, ImVec2(low.x + size.x, low.y + size.y));
    enter_list(true);
    return true;
  }
  ImGui::PopStyleVar(2);
  return false;
}

void end_choices(const Ui& ui) {
  enter_list(false);
  scroll_by_finger(ui);
  ImGui::EndPopup();
  ImGui::PopStyleVar(2);
}

bool choice(const Ui& ui, const std::string& label, const char* about, bool current, Icon icon,
            bool enabled, const std::string& name) {
  // On the smallest phones the longest rows do not fit in larger letters.
  const Face face = ui.state.session.screen.width < 344 ? Face::label : Face::text;
  const ImVec2 title = text_size(face, label);
  const ImVec2 word = about ? text_size(Face::label, about) : ImVec2(0, 0);
  const float height = std::max(ui.control(), about ? 50.0f : 0.0f);
  const float width = std::max(ImGui::GetContentRegionAvail().x, std::max(title.x, word.x) + 56);
  const PressableRow row =
      pressable_row(ui, (name.empty() ? label : name).c_str(), label, width, height, enabled);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (row.hovered) list.AddRectFilled(row.low, row.high, ui.theme.well.packed(), 7);
  const ImVec2 sign(row.low.x + 18, row.low.y + height / 2);
  const Colour ink = enabled ? ui.theme.text : ui.theme.quiet;
  draw_icon(list, icon, sign, 18, ink);
  if (current) draw_icon(list, Icon::check, sign, 15, ui.theme.accent);
  const float text = title.y + (about ? word.y + 3 : 0), y = row.low.y + (height - text) / 2;
  draw_text(list, face, ImVec2(row.low.x + 36, y), ink, label);
  if (about)
    draw_text(list, Face::label, ImVec2(row.low.x + 36, y + title.y + 3), ui.theme.second_text,
              about);
  if (row.pressed) ImGui::CloseCurrentPopup();
  return row.pressed;
}

namespace {

bool dropdown_button(const Ui& ui, const std::string& label, float width) {
  const bool pressed = tapped(ui, ImGui::InvisibleButton("open", ImVec2(width, ui.control())));
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  const bool hovered = ImGui::IsItemHovered();
  if (hovered) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(low, high, (hovered ? ui.theme.panel_line : ui.theme.well).packed(), 7);
  const ImVec2 text = text_size(Face::text, label);
  note_room(label, text.x, width - 12 - 24);
  draw_text(list, Face::text, ImVec2(low.x + 12, (low.y + high.y - text.y) / 2), ui.theme.text,
            label);
  draw_icon(list, Icon::down, ImVec2(high.x - 18, (low.y + high.y) / 2), 12, ui.theme.second_text);
  return pressed;
}

Control choice_control(const char* id, const char* label, std::span<const Choice> choices,
                       std::size_t current) {
  Control control;
  control.kind = ControlKind::choice;
  control.name = id;
  control.label = label;
  for (const Choice& c : choices) control.choices.emplace_back(c.label);
  control.current = current;
  return control;
}

}  // namespace

std::optional<std::size_t> dropdown(const Ui& ui, const char* id, const char* label,
                                    std::span<const Choice> choices, std::size_t current,
                                    float width) {
  ImGui::PushID(id);
  const bool pressed = dropdown_button(ui, choices[current].label, width);
  const Asked asked = list_control(choice_control(id, label, choices, current));
  if (pressed || asked.pressed) ImGui::OpenPopup("list");
  std::optional<std::size_t> chosen = asked.chosen;
  if (begin_choices(ui, "list", ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), width)) {
    for (std::size_t i = 0; i < choices.size(); ++i)
      if (choice(ui, choices[i].label, choices[i].about, i == current)) chosen = i;
    end_choices(ui);
  }
  ImGui::PopID();
  return chosen;
}

}  // namespace evenlift::view
