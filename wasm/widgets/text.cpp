#include "widgets/text.h"

#include <algorithm>
#include <cmath>

#include "evenlift/wording.h"
#include "ui/drawn_texts.h"
#include "ui/letters.h"

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

void text_block_of(Face face, Colour colour, const std::string& text, float width,
                   std::size_t lines) {
  const std::vector<std::string_view> broken = broken_lines(face, text, width);
  const ImVec2 start = ImGui::GetCursorScreenPos();
  ImVec2 at = start;
  for (std::size_t i = 0; i < std::min(lines, broken.size()); ++i) {
    const bool cut = i + 1 == lines && broken.size() > lines;
    if (cut) note_room(text, 1, 0);
    const std::string line = std::string(broken[i]) + (cut ? " …" : "");
    draw_text(*ImGui::GetWindowDrawList(), face, at, colour, line);
    at.y += line_height(face);
  }
  ImGui::Dummy(ImVec2(width, line_height(face) * static_cast<float>(lines)));
}

float labelled(const Ui& ui, const char* label, const char* about) {
  constexpr float label_width = 120;
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
  if (ui.state.session.screen.asking) return place_tip_of_finger(ui.state.session.screen, size);
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

}  // namespace evenlift::view
