// The player of the walkthrough: its timeline, and the buttons that move along it.
#include <algorithm>
#include <cmath>

#include "evenlift/output/words.h"
#include "panels/action_button.h"
#include "panels/panels.h"
#include "ui/widgets.h"
#include "walkthrough/walkthrough.h"

namespace evenlift::view {
namespace {

void button(const Ui& ui, ActionId id, float size) {
  action_button(ui, id, size);
  ImGui::SameLine(0, 0);
}

void draw_play(const Ui& ui, float size) {
  const bool playing = ui.state.walkthrough.playing;
  if (icon_button(ui, "play", playing ? Icon::pause : Icon::play, true,
                  playing ? "Pause (Space)" : "Play (Space)", size))
    ui.push(SetPlaying{!playing});
  ImGui::SameLine(0, 0);
}

// Marks over the track where chapters begin.
void draw_chapters(const Ui& ui, ImVec2 low, ImVec2 high, std::uint32_t count) {
  const Walkthrough& walk = ui.state.walkthrough;
  if (walk.script || count < 2) return;
  const float knob = ui.control() > 40 ? 11.0f : 8.0f, from = low.x + knob, to = high.x - knob;
  const float y = (low.y + high.y) / 2;
  for (std::uint32_t c = 0; c < chapter_count; ++c) {
    const auto begin = walk.trace->chapter_begin(static_cast<Chapter>(c));
    if (!begin) continue;
    const float x = from + (to - from) * static_cast<float>(*begin) / static_cast<float>(count - 1);
    ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(x - 1, y - 8), ImVec2(x + 1, y + 8),
                                              ui.theme.quiet.packed());
  }
}

void draw_timeline(const Ui& ui, float width) {
  const Timeline now = timeline(ui.state);
  const double last = std::max(now.count, 2u) - 1;
  const SliderResult moved = slider(ui, "timeline", now.at, 0, last, 1, width);
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  const bool hovered = ImGui::IsItemHovered();
  draw_chapters(ui, low, high, now.count);
  if (hovered) {
    const double share = std::clamp(
        static_cast<double>((ImGui::GetIO().MousePos.x - low.x) / (high.x - low.x)), 0.0, 1.0);
    const auto at = static_cast<std::uint32_t>(std::round(share * (now.count - 1)));
    const Step step = ui.state.walkthrough.trace->step(step_of(ui.state, at));
    tip(ui, ("Step " + std::to_string(at + 1) + ": " + std::string(title(step.chapter))).c_str());
  }
  if (moved.changed && moved.value < now.count)
    ui.push(GoToStep{step_of(ui.state, static_cast<std::uint32_t>(moved.value))});
}

void draw_transport(const Ui& ui, float size, bool all) {
  button(ui, ActionId::first_step, size);
  if (all) button(ui, ActionId::previous_chapter, size);
  button(ui, ActionId::step_back, size);
  draw_play(ui, size);
  button(ui, ActionId::step_on, size);
  if (all) button(ui, ActionId::next_chapter, size);
  button(ui, ActionId::last_step, size);
}

void draw_place(const Ui& ui, float size) {
  const Timeline now = timeline(ui.state);
  const std::string place =
      "Step " + std::to_string(now.at + 1) + " of " + std::to_string(now.count);
  const ImVec2 at = ImGui::GetCursorScreenPos(), text = text_size(Face::label, place);
  draw_text(*ImGui::GetWindowDrawList(), Face::label, ImVec2(at.x, at.y + (size - text.y) / 2),
            ui.theme.second_text, place);
  ImGui::Dummy(ImVec2(text.x + 24, size));
}

void draw_speed(const Ui& ui, float size) {
  const Walkthrough& walk = ui.state.walkthrough;
  const int by = stepper(ui, "speed", plain(walk.speed) + "×", walk.speed > slowest_speed,
                         walk.speed < fastest_speed, 3 * size + 8);
  if (by != 0) ui.push(SetSpeed{walk.speed * (by > 0 ? 2 : 0.5)});
}

void draw_switches(const Ui& ui) {
  const Walkthrough& walk = ui.state.walkthrough;
  if (switch_chip(ui, "Predict first", walk.predict)) ui.push(SetPredict{!walk.predict});
  if (!walk.script) return;
  ImGui::SameLine(0, 6);
  const float width = text_size(Face::text, "All steps").x + 28;
  if (flat_button(ui, "All steps", "All steps", width)) ui.push(LeaveScript{});
}

}  // namespace

// Timeline, buttons and switches. A wide player has the switches beside the buttons; a narrow one
// below them, and a closed sheet has none.
void draw_player(const Ui& ui) {
  const float width = ImGui::GetContentRegionAvail().x;
  // A side panel has the button that leaves; the walkthrough of an <iframe> cannot be left.
  const bool leaves = !ui.layout.wide && !ui.state.screen.embed;
  const int buttons = leaves ? 8 : 7;
  const float size = ui.control() <= 40
                         ? ui.control()
                         : std::clamp(width / static_cast<float>(buttons), 40.0f, ui.control());
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(8, 4));
  draw_timeline(ui, width);
  draw_transport(ui, size, width >= static_cast<float>(buttons) * size);
  if (leaves && icon_button(ui, "leave", Icon::close, true, "Leave the lesson (B)", size))
    ui.push(CloseWalkthrough{});
  if (width > 620) {
    ImGui::SameLine(0, 12);
    draw_place(ui, size);
    ImGui::SameLine(0, 8);
    draw_speed(ui, size);
    ImGui::SameLine(0, 12);
    draw_switches(ui);
  } else if (ui.state.screen.embed || ui.state.sheet != Sheet::closed) {
    if (!leaves) ImGui::NewLine();
    draw_speed(ui, size);
    ImGui::SameLine(0, 8);
    draw_switches(ui);
  } else if (!leaves) {
    ImGui::NewLine();
  }
  ImGui::PopStyleVar();
}

}  // namespace evenlift::view
