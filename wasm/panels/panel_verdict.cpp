// The verdict: a large sentence, and an icon that says the same without words.
#include <algorithm>
#include <span>
#include <string>
#include <vector>

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
  const Sign sign = sign_of(ui.theme, v.mood);
  // A tick says that all is as asked for. While a robot fails that is not the question: there the sign is that of the row below.
  const bool plain_disc = failing(ui.state) && v.mood == Mood::good;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddCircleFilled(ImVec2(at.x + 11, at.y + 14), 11, sign.disc.packed(), 32);
  if (v.searching)
    list.AddCircle(ImVec2(at.x + 11, at.y + 14), 14, ui.theme.accent.packed(), 32, 1.5f);
  if (!plain_disc) draw_icon(list, sign.icon, ImVec2(at.x + 11, at.y + 14), 15, ui.theme.panel);

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

}  // namespace evenlift::view
