// The walkthrough's timeline, and the buttons that move along it.
#include <algorithm>
#include <string>

#include "evenlift/output/words.h"
#include "evenlift/wording.h"
#include "panels/panels.h"
#include "walkthrough/walkthrough.h"
#include "widgets/buttons.h"
#include "widgets/fields.h"
#include "widgets/text.h"

namespace evenlift::view {
namespace {

void button(const Ui& ui, ActionId id, float size) {
  action_button(ui, id, size);
  ImGui::SameLine(0, 0);
}

void draw_play(const Ui& ui, float size) {
  const bool playing = ui.state.view.walkthrough.playing;
  if (icon_button(ui, "play", playing ? Icon::pause : Icon::play, true,
                  playing ? "Pause (Space)" : "Play (Space)", size))
    ui.push(SetPlaying{!playing});
  ImGui::SameLine(0, 0);
}

// Marks on the track where chapters begin.
void draw_chapters(const Ui& ui, ImVec2 low, ImVec2 high, std::size_t parts) {
  const float knob = knob_radius(ui), from = low.x + knob, to = high.x - knob;
  const float y = (low.y + high.y) / 2;
  if (to - from < 16 * static_cast<float>(parts)) return;  // only marks would be visible
  for (std::size_t i = 1; i < parts; ++i) {
    const float x = from + (to - from) * static_cast<float>(i) / static_cast<float>(parts);
    ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(x - 1, y - 8), ImVec2(x + 1, y + 8),
                                              ui.theme.quiet.packed());
  }
}

// All chapters are equally wide; the knob moves within its own.
void draw_timeline(const Ui& ui, float width) {
  const Timeline now = timeline(ui.state);
  const std::vector<ChapterPart> parts = chapter_parts(ui.state);
  const Track track{
      [&](double value) { return share_of(parts, static_cast<std::uint32_t>(value)); },
      [&](double share) { return static_cast<double>(position_at(parts, share)); }};
  const double last = std::max(now.count, 2u) - 1;
  const SliderResult moved =
      slider(ui, "timeline", "Step of the walkthrough", now.at, 0, last, 1, width, track);
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  const bool hovered = ImGui::IsItemHovered();
  draw_chapters(ui, low, high, parts.size());
  if (hovered) {
    const float knob = knob_radius(ui);
    const double share = static_cast<double>((ImGui::GetIO().MousePos.x - low.x - knob) /
                                             (high.x - low.x - 2 * knob));
    const std::uint32_t at = std::min(position_at(parts, share), now.count - 1);
    const Step step = ui.state.view.walkthrough.trace->step(step_of(ui.state, at));
    tip(ui, say("Step {step}: {chapter}", {at + 1, title(step.chapter)}).c_str());
  }
  if (moved.changed && moved.value < now.count)
    ui.push(GoToStep{step_of(ui.state, static_cast<std::uint32_t>(moved.value))});
}

void draw_transport(const Ui& ui, float size) {
  button(ui, ActionId::first_step, size);
  button(ui, ActionId::previous_chapter, size);
  button(ui, ActionId::step_back, size);
  draw_play(ui, size);
  button(ui, ActionId::step_on, size);
  button(ui, ActionId::next_chapter, size);
  button(ui, ActionId::last_step, size);
}

constexpr float place_gap = 24;

std::string words_of_place(const Ui& ui) { return say("Step {place}", {place_in_words(ui.state)}); }

void draw_place(const Ui& ui, float size) {
  const std::string words = words_of_place(ui);
  const ImVec2 at = ImGui::GetCursorScreenPos(), text = text_size(Face::label, words);
  draw_text(*ImGui::GetWindowDrawList(), Face::label, ImVec2(at.x, at.y + (size - text.y) / 2),
            ui.theme.second_text, words);
  ImGui::Dummy(ImVec2(text.x + place_gap, size));
}

float speed_width(float size) { return 3 * size + 8; }

void draw_speed(const Ui& ui, float size) {
  const Walkthrough& walk = ui.state.view.walkthrough;
  const int by = stepper(ui, "speed", plain(walk.speed) + "×", speed_width(size),
                         {.can_lower = walk.speed > slowest_speed,
                          .can_raise = walk.speed < fastest_speed,
                          .label = "Speed"});
  if (by != 0) ui.push(SetSpeed{walk.speed * (by > 0 ? 2 : 0.5)});
}

bool shows_all(const Walkthrough& walk) { return walk.all_steps && !walk.script; }

void draw_switches(const Ui& ui) {
  const Walkthrough& walk = ui.state.view.walkthrough;
  if (switch_chip(ui, "Predict first", walk.predict)) ui.push(SetPredict{!walk.predict});
  ImGui::SameLine(0, 6);
  if (switch_chip(ui, "All steps", shows_all(walk))) ui.push(ShowAllSteps{!shows_all(walk)});
}

void draw_menu(const Ui& ui) {
  if (!begin_choices(ui, "player menu", ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), 0))
    return;
  const Walkthrough& walk = ui.state.view.walkthrough;
  if (choice(ui, "All steps", nullptr, shows_all(walk))) ui.push(ShowAllSteps{!shows_all(walk)});
  if (choice(ui, "Predict first", nullptr, walk.predict)) ui.push(SetPredict{!walk.predict});
  const std::string faster = say("Play faster (now {speed}×)", {plain(walk.speed)}),
                    slower = say("Play slower (now {speed}×)", {plain(walk.speed)});
  if (choice(ui, faster, nullptr, false, Icon::plus, walk.speed < fastest_speed))
    ui.push(SetSpeed{walk.speed * 2});
  if (choice(ui, slower, nullptr, false, Icon::minus, walk.speed > slowest_speed))
    ui.push(SetSpeed{walk.speed / 2});
  for (const ActionId id : {ActionId::first_step, ActionId::previous_chapter,
                            ActionId::next_chapter, ActionId::last_step})
    action_row(ui, id);
  if (!ui.state.session.screen.embed) action_row(ui, ActionId::present);
  end_choices(ui);
}

void draw_leave(const Ui& ui, float size) {
  if (ui.state.session.screen.embed) {
    if (icon_button(ui, "out", Icon::open_out, true, "Open in evenlift", size)) ui.push(OpenPage{});
  } else if (ui.state.view.presenting) {
    if (icon_button(ui, "leave", Icon::close, true, "Stop presenting (Esc)", size))
      ui.push(SetPresenting{false});
  } else if (!ui.layout.wide) {
    if (icon_button(ui, "leave", Icon::close, true, "Leave the walkthrough (B)", size))
      ui.push(CloseWalkthrough{});
  }
}

}  // namespace

// For little room: the most used buttons, the timeline, and a menu with the other buttons.
void draw_player_row(const Ui& ui) {
  const float width = ImGui::GetContentRegionAvail().x;
  const bool leaves = ui.state.session.screen.embed || ui.state.view.presenting || !ui.layout.wide;
  const bool menu = !ui.state.view.presenting;
  const int buttons = 3 + (menu ? 1 : 0) + (leaves ? 1 : 0);
  const float size = std::clamp((width - 72) / static_cast<float>(buttons), 36.0f, ui.control());
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
  button(ui, ActionId::step_back, size);
  draw_play(ui, size);
  button(ui, ActionId::step_on, size);
  ImGui::SameLine(0, 6);
  draw_timeline(ui, width - static_cast<float>(buttons) * size - 12);
  ImGui::SameLine(0, 6);
  if (menu) {
    if (icon_button(ui, "player more", Icon::more, true, "Speed, all steps, chapters", size))
      ImGui::OpenPopup("player menu");
    draw_menu(ui);
    ImGui::SameLine(0, 0);
  }
  draw_leave(ui, size);
  ImGui::PopStyleVar();
}

// A menu has the buttons and switches that do not fit.
void draw_player(const Ui& ui) {
  const float width = ImGui::GetContentRegionAvail().x, size = ui.control();
  const float needed = 7 * size + 12 + text_size(Face::label, words_of_place(ui)).x + place_gap +
                       8 + speed_width(size) + 12 + switch_chip_width("Predict first") + 6 +
                       switch_chip_width("All steps");
  if (width < 8 * size || ui.layout.player.height() < 2 * static_cast<double>(size))
    return draw_player_row(ui);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(8, 4));
  draw_timeline(ui, width);
  draw_transport(ui, size);
  if (width >= needed) {
    ImGui::SameLine(0, 12);
    draw_place(ui, size);
    ImGui::SameLine(0, 8);
    draw_speed(ui, size);
    ImGui::SameLine(0, 12);
    draw_switches(ui);
  } else {
    if (icon_button(ui, "player more", Icon::more, true, "Speed, all steps", size))
      ImGui::OpenPopup("player menu");
    draw_menu(ui);
  }
  ImGui::PopStyleVar();
}

}  // namespace evenlift::view
