#include "widgets/cards.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/controls.h"
#include "ui/vec.h"

namespace evenlift::view {
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
  return pressed && !screen.asking && !(screen.touch && is_dragged());
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

}  // namespace evenlift::view
