// The verdict: a large sentence, and an icon that says the same without words.
#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "evenlift/output/words.h"
#include "panels/panels.h"
#include "panels/summary.h"
#include "state/browser.h"
#include "widgets/buttons.h"
#include "widgets/cards.h"
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

// A text in the first of the faces, from large to small, of which so many lines of the first hold it; or
// else in the last.
void draw_fitting(Colour colour, const std::string& text, float width, std::span<const Face> faces,
                  std::size_t lines) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float height = line_height(faces.front()) * static_cast<float>(lines);
  const auto room = [&](Face face) { return static_cast<std::size_t>(height / line_height(face)); };
  const auto fits = [&](Face face) { return broken_lines(face, text, width).size() <= room(face); };
  const auto found = std::find_if(faces.begin(), faces.end(), fits);
  const Face face = found == faces.end() ? faces.back() : *found;
  text_block_of(face, colour, text, width, room(face));
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + height));
}

void draw_sign(const Ui& ui, Mood mood, ImVec2 middle) {
  const Sign sign = sign_of(ui.theme, mood);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddCircleFilled(middle, 11, sign.disc.packed(), 32);
  // A tick says that all is as asked for. While a robot fails that is not the question: there the sign is that of the row below.
  if (!failing(ui.state) || mood != Mood::good)
    draw_icon(list, sign.icon, middle, 15, ui.theme.panel);
}

// Where no chord is even enough: a way to the best that there is, in the room that the verdict leaves.
void draw_lower_ratio(const Ui& ui, double best) {
  const ImVec2 below = ImGui::GetCursorScreenPos();
  const std::string label = "Lower the ratio to " + fixed(best, 2);
  ImGui::SetCursorScreenPos(ImVec2(below.x, below.y - ui.control()));
  if (flat_button(ui, "lower ratio", label.c_str(), ImGui::GetContentRegionAvail().x)) {
    Settings changed = settings(ui.state);
    changed.min_ratio = best;
    ui.push(SetSettings{changed});
  }
  ImGui::SetCursorScreenPos(below);
}

}  // namespace

void draw_headline(const Ui& ui) {
  const Verdict v = verdict(ui.state);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const ImVec2 middle(at.x + 11, at.y + 14);
  draw_sign(ui, v.mood, middle);
  if (v.searching)
    ImGui::GetWindowDrawList()->AddCircle(middle, 14, ui.theme.accent.packed(), 32, 1.5f);

  ImGui::SetCursorScreenPos(ImVec2(at.x + 32, at.y));
  // The fold button stands to the right of the headline.
  const float free = width - 32 - (ui.layout.wide ? ui.control() - 8 : 0);
  constexpr Face large[] = {Face::verdict, Face::strong, Face::strong_label};
  draw_fitting(ui.theme.text, v.headline, free, large, 2);
  ImGui::SetCursorScreenPos(ImVec2(at.x, ImGui::GetCursorScreenPos().y + 4));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
  ImGui::Dummy(ImVec2(width, 0));
  ImGui::PopStyleVar();
}

// Always as high, so that the controls below stay where they are when the result changes.
void draw_verdict(const Ui& ui) {
  draw_headline(ui);
  if (!ui.layout.brief) draw_verdict_details(ui);
}

void draw_verdict_words(const Ui& ui) {
  const Verdict v = verdict(ui.state);
  const float width = ImGui::GetContentRegionAvail().x;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
  constexpr Face small[] = {Face::text, Face::label};
  // What is wrong comes first.
  draw_fitting(ui.theme.second_text, overload_in_brief(ui.state) + v.detail, width, small,
               ui.layout.wide ? 4 : 3);
  ImGui::Dummy(ImVec2(width, 0));
  if (ui.state.best_ratio && v.mood != Mood::drawing) draw_lower_ratio(ui, *ui.state.best_ratio);
  ImGui::PopStyleVar();
}

void draw_verdict_details(const Ui& ui) {
  draw_verdict_words(ui);
  ImGui::SetCursorPosY(ImGui::GetCursorPosY() +
                       (ui.layout.wide ? 8 : 4));  // words may fill their room
  draw_failures(ui);
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
  // What is not as asked for is said, too.
  const std::string text =
      v.mood == Mood::good ? v.headline : v.headline + " " + overload_in_brief(ui.state) + v.detail;
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
  if (pressed) browser::open_page();
  end_card(ui);
}

}  // namespace evenlift::view
