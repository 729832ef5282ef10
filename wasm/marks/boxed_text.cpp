#include "marks/boxed_text.h"

#include <algorithm>

#include "ui/vec.h"

namespace evenlift::view {

void draw_word(ImDrawList& list, const Vec2& spot, const Rect& window, const Theme& theme,
               Colour colour, const std::string& text) {
  const ImVec2 size = text_size(Face::strong_label, text);
  const double width = static_cast<double>(size.x) + 16, height = static_cast<double>(size.y) + 10;
  const double left =
      std::clamp(spot.x + 14, window.left + 4, std::max(window.left + 4, window.right - width - 4));
  double top = spot.y - height - 10;
  if (top < window.top + 4) top = std::max(spot.y + 18, window.top + 4);
  const ImVec2 low = vec(left, top), high = vec(left + width, top + height);
  list.AddRectFilled(low, high, theme.panel.at(0.95f).packed(), 6);
  list.AddRect(low, high, colour.at(0.5f).packed(), 6, 0, 1);
  draw_text(list, Face::strong_label, ImVec2(low.x + 8, low.y + 5), colour, text);
}

namespace {

Rect box_at(const Vec2& from, const Vec2& to, const Vec2& size, double share) {
  const Vec2 low = from + (to - from) * share - size / 2;
  return {low.x, low.y, low.x + size.x, low.y + size.y};
}

}  // namespace

std::optional<Rect> clear_box_on_line(const Vec2& from, const Vec2& to, const Vec2& size,
                                      const SharesOfLine& shares, std::vector<Rect>& before) {
  for (const double share : shares) {
    const Rect box = box_at(from, to, size, share);
    const auto covers = [&](const Rect& other) { return box.overlaps(other); };
    if (std::any_of(before.begin(), before.end(), covers)) continue;
    before.push_back(box);
    return box;
  }
  return std::nullopt;
}

Rect box_on_line(const Vec2& from, const Vec2& to, const Vec2& size, const SharesOfLine& shares,
                 std::vector<Rect>& before) {
  if (const auto box = clear_box_on_line(from, to, size, shares, before)) return *box;
  before.push_back(box_at(from, to, size, shares[0]));
  return before.back();
}

std::string capitalised(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z')
    text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return text;
}

}  // namespace evenlift::view
