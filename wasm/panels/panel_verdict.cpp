// A large sentence, and an icon with the same meaning.
#include <algorithm>
#include <string>

#include "evenlift/output/words.h"
#include "panels/panels.h"
#include "panels/summary.h"
#include "widgets/buttons.h"
#include "widgets/text.h"

namespace evenlift::view {

namespace {

struct Sign {
  Icon icon;
  Colour disc;
};

Sign sign_of(const Theme& theme, Mood mood) {
  switch (mood) {
    case Mood::good:
      return {Icon::check, theme.hull_outline};
    case Mood::not_quite:
      return {Icon::warning, theme.amber};
    case Mood::falls:
      return {Icon::close, theme.red};
    case Mood::refused:
      return {Icon::stop, theme.amber};
    case Mood::drawing:
      break;
  }
  return {Icon::draw, theme.accent};
}

// The verdict has three lines, whatever the result: its headline, which is what matters most, and as
// much as fits of what follows; and all of it at a press.
constexpr float after_sign = 32, below_headline = 4;
constexpr std::size_t lines_of_verdict = 3, lines_of_headline = 2;

float line_of_verdict() { return line_height(Face::text); }

void draw_sign(const Ui& ui, Mood mood, ImVec2 middle) {
  const Sign sign = sign_of(ui.theme, mood);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddCircleFilled(middle, 10, sign.disc.packed(), 32);
  // A tick means that the goal is reached. While a robot fails, a good mood is a plain disc, as in
  // the row below.
  if (!failing(ui.state) || mood != Mood::good)
    draw_icon(list, sign.icon, middle, 15, ui.theme.panel);
}

// The button's foot is at the cursor.
void draw_offer(const Ui& ui) {
  const std::optional<Offer>& offer = ui.state.derived().offer;
  const ImVec2 below = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos(ImVec2(below.x, below.y - ui.control()));
  if (flat_button(ui, "offer", offer->label.c_str(), ImGui::GetContentRegionAvail().x))
    ui.push(offer->shown ? Command(SetShown{*offer->shown})
                         : Command(SetSettings{offer->settings}));
  ImGui::SetCursorScreenPos(below);
}

void draw_mood(const Ui& ui, const Verdict& v) {
  const ImVec2 at = ImGui::GetCursorScreenPos(), middle(at.x + 11, at.y + 11);
  draw_sign(ui, v.mood, middle);
  if (v.searching)
    ImGui::GetWindowDrawList()->AddCircle(middle, 14, ui.theme.accent.packed(), 32, 1.5f);
}

// The tip of the verdict between these corners.
void draw_presumed(const Ui& ui, ImVec2 low, ImVec2 high) {
  if (!ImGui::IsWindowHovered() || !ImGui::IsMouseHoveringRect(low, high)) return;
  const std::string text = presumed_in_words(ui.state);
  if (!text.empty()) tip(ui, text.c_str());
}

// Draws this many lines, or all if there are more and `whole`. Returns whether some are left out.
bool draw_in(const Ui& ui, const Verdict& v, const std::string& rest, std::size_t lines,
             bool whole) {
  draw_mood(ui, v);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  // Right of the headline is the side panel's fold button.
  const float beside = width - after_sign - (ui.layout.wide ? ui.control() - 8 : 0);
  const std::size_t headline = broken_lines(Face::strong, v.headline, beside).size(),
                    of_headline = whole ? headline : std::min(headline, lines),
                    of_rest = broken_lines(Face::text, rest, width).size(),
                    room = whole ? of_rest : std::min(of_rest, lines - of_headline);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
  ImGui::SetCursorScreenPos(ImVec2(at.x + after_sign, at.y));
  text_block_of(Face::strong, ui.theme.text, v.headline, beside, of_headline);
  ImGui::SetCursorScreenPos(
      ImVec2(at.x, at.y + line_of_verdict() * static_cast<float>(of_headline) + below_headline));
  text_block_of(Face::text, ui.theme.second_text, rest, width, room);
  const float height =
      line_of_verdict() * static_cast<float>(std::max(of_headline + room, lines)) + below_headline;
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + height));
  ImGui::Dummy(ImVec2(width, 0));
  ImGui::PopStyleVar();
  draw_presumed(ui, at, ImVec2(at.x + after_sign + beside, at.y + height));
  return of_rest > room || headline > of_headline;
}

void draw_failures_below(const Ui& ui) {
  if (!is_about_failures(ui.state)) return;
  // The words may fill their area.
  ImGui::SetCursorPosY(ImGui::GetCursorPosY() + (ui.layout.wide ? 12 : 8));
  draw_failures(ui);
}

// There is no offer unless the verdict is about the placement.
bool has_offer(const Ui& ui, const Verdict& v) {
  return ui.state.derived().offer && !failing(ui.state) &&
         (v.mood == Mood::not_quite || v.mood == Mood::falls);
}

// A press on the words shows all of them: beside the drawing at their place, on a phone in the sheet.
void draw_more(const Ui& ui, ImVec2 low, bool whole) {
  const ImVec2 below = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x - (ui.layout.wide ? ui.control() : 0);
  ImGui::SetCursorScreenPos(low);
  const PressableRow row =
      pressable_row(ui, "whole verdict", whole ? "Less of the verdict" : "All of the verdict",
                    width, below.y - low.y);
  ImGui::SetCursorScreenPos(below);
  if (!row.pressed) return;
  if (ui.layout.wide)
    ui.push(SetSectionOpen{&View::whole_verdict, !whole});
  else
    ui.push(SetSheet{has_half_sheet(ui.state) ? Sheet::half : Sheet::full});
}

}  // namespace

void draw_headline(const Ui& ui) {
  draw_in(ui, verdict(ui.state, Words::in_panel), {}, lines_of_headline, !ui.layout.brief);
}

void draw_verdict_words(const Ui& ui) {
  const Verdict v = verdict(ui.state, Words::in_panel);
  const bool whole = ui.layout.wide && ui.state.view.whole_verdict;
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const bool is_cut = draw_in(ui, v, v.detail, lines_of_verdict, whole);
  if (is_cut || whole) draw_more(ui, low, whole);
  // Its place stays free, so that nothing below moves.
  ImGui::Dummy(ImVec2(1, ui.control() + 6));
  if (has_offer(ui, v)) draw_offer(ui);
}

void draw_verdict_details(const Ui& ui) {
  constexpr std::size_t usual = 3;  // lines
  const Verdict v = verdict(ui.state, Words::in_panel);
  const std::string& rest = v.detail;
  const float width = ImGui::GetContentRegionAvail().x;
  const std::size_t lines = broken_lines(Face::text, rest, width).size();
  text_block_of(Face::text, ui.theme.second_text, rest, width, std::max(lines, usual));
  if (has_offer(ui, v)) {
    ImGui::Dummy(ImVec2(1, ui.control()));
    draw_offer(ui);
  }
  draw_failures_below(ui);
}

void draw_verdict(const Ui& ui) {
  if (ui.layout.brief) return draw_headline(ui);
  draw_verdict_words(ui);
  draw_failures_below(ui);
}

void draw_embedded_verdict(const Ui& ui) {
  const float padding = static_cast<float>(ui.layout.bar_padding), size = ui.control();
  begin_card(ui, "bar", ui.layout.player,
             {.fixed_height = true, .padding = padding, .scrolls = false});
  const float width = ImGui::GetContentRegionAvail().x;
  const float height = static_cast<float>(ui.layout.player.height()) - 2 * padding;
  const bool named = ui.layout.wide;
  const float button = named ? text_button_width("Open in evenlift") : size;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const Verdict v = verdict(ui.state);
  draw_sign(ui, v.mood, ImVec2(at.x + 8 + 11, at.y + height / 2));
  const std::string text = v.mood == Mood::good ? v.headline : v.headline + " " + v.detail;
  const float left = 8 + 22 + 10, room = width - left - button - 8;
  const Face face = broken_lines(Face::text, text, room).size() == 1 ? Face::text : Face::label;
  const std::size_t lines = std::min<std::size_t>(broken_lines(face, text, room).size(), 2);
  const float high = line_height(face) * static_cast<float>(lines);
  ImGui::SetCursorScreenPos(ImVec2(at.x + left, at.y + (height - high) / 2));
  text_block_of(face, ui.theme.text, text, room, lines);
  ImGui::SetCursorScreenPos(ImVec2(at.x + width - button, at.y + (height - size) / 2));
  const bool pressed =
      named ? text_button(ui, "out", Icon::open_out, "Open in evenlift", nullptr, size)
            : icon_button(ui, "out", Icon::open_out, true, "Open in evenlift", size);
  if (pressed) ui.push(OpenPage{});
  end_card(ui);
}

}  // namespace evenlift::view
