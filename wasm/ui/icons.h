// Draws icons as lines, so that they are sharp at every size. The strokes come from
// web/kit/icons.js, which the page's windows use as well.
#pragma once

#include <imgui.h>

#include <cstddef>
#include <cstdint>

#include "ui/theme.h"

namespace evenlift::view {

enum class Icon : std::uint8_t {
  none,
  undo,
  redo,
  link,
  plus,
  minus,
  fit,
  fold,
  unfold,
  down,
  up,
  help,
  more,
  close,
  check,
  warning,
  stop,
  shapes,
  open_out,
  folder,
  save,
  table,
  draw,
  robot,
  transform,
  compare,
  board,
  present,
  charts,
  book,
  about,
  play,
  pause,
  step_on,
  step_back,
  chapter_on,
  chapter_back,
  last,
  first
};
inline constexpr std::size_t icon_count = 38;  // without `none`

// Draws the icon in a square of `size` pixels about `middle`.
void draw_icon(ImDrawList& list, Icon icon, ImVec2 middle, float size, Colour colour);

// Draws the mark of a centre of mass: a disc with two opposite quarters dark and two light.
void draw_centre_mark(ImDrawList& list, ImVec2 middle, float radius, Colour dark, Colour light);

}  // namespace evenlift::view
