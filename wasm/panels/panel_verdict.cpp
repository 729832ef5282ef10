// A large sentence, and an icon with the same meaning.
#include <algorithm>
#include <iterator>
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

// For the headline and the rest, the largest pair that fits.
struct Sizes {
  Face headline, rest;
};
constexpr Sizes sizes[] = {{Face::verdict, Face::text},
                           {Face::verdict, Face::label},
                           {Face::strong, Face::text},
                           {Face::strong, Face::label}};

// The height is the same for all results: three lines each for headline and rest beside the
// drawing, two and three in a sheet, two for the headline alone.
constexpr float after_sign = 32, below_headline = 4;
constexpr float beside_drawing = 152, in_sheet = 124, headline_alone = 64;

void draw_sign(const Ui& ui, Mood mood, ImVec2 middle) {
  const Sign sign = sign_of(ui.theme, mood);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddCircleFilled(middle, 11, sign.disc.packed(), 32);
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
  const ImVec2 at = ImGui::GetCursorScreenPos(), middle(at.x + 11, at.y + 14);
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

void draw_in(const Ui& ui, float height, const Verdict& v, const std::string& rest) {
  draw_mood(ui, v);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  // Right of the headline is the side panel's fold button.
  const float beside = width - after_sign - (ui.layout.wide ? ui.control() - 8 : 0);
  const auto height_of_headline = [&](Face face) {
    return height_of(face, broken_lines(face, v.headline, beside)) + below_headline;
  };
  const auto fits = [&](const Sizes& s) {
    return height_of_headline(s.headline) + height_of(s.rest, broken_lines(s.rest, rest, width)) <=
           height;
  };
  const auto* const found = std::find_if(std::begin(sizes), std::end(sizes), fits);
  const Sizes& s = found == std::end(sizes) ? *std::prev(found) : *found;
  const auto lines = [](float room, Face face) {
    return static_cast<std::size_t>(std::max(room, 0.0f) / line_height(face));
  };

  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
  ImGui::SetCursorScreenPos(ImVec2(at.x + after_sign, at.y));
  const float high = std::min(height_of_headline(s.headline), height);
  text_block_of(s.headline, ui.theme.text, v.headline, beside, lines(high, s.headline));
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + high));
  text_block_of(s.rest, ui.theme.second_text, rest, width, lines(height - high, s.rest));
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + height));
  ImGui::Dummy(ImVec2(width, 0));
  ImGui::PopStyleVar();
  draw_presumed(ui, at, ImVec2(at.x + after_sign + beside, at.y + height));
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

}  // namespace

void draw_headline(const Ui& ui) { draw_in(ui, headline_alone, verdict(ui.state), {}); }

void draw_verdict_words(const Ui& ui) {
  const Verdict v = verdict(ui.state);
  const float height = ui.layout.wide ? beside_drawing : in_sheet;
  const bool offers = has_offer(ui, v);
  const float words = height - (offers ? ui.control() + 4 : 0);
  draw_in(ui, words, v, v.detail);
  if (!offers) return;
  ImGui::SetCursorPosY(ImGui::GetCursorPosY() + height - words);
  draw_offer(ui);
}

void draw_verdict_details(const Ui& ui) {
  constexpr std::size_t usual = 3;  // lines
  const Verdict v = verdict(ui.state);
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
