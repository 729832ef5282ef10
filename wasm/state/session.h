// The state of this visit: its screen, measured sizes, and messages.
#pragma once

#include <cstdint>
#include <string>

#include "state/camera.h"
#include "state/effects.h"

namespace evenlift::view {

// As the page reports it.
struct Screen {
  // Of the canvas; the ratio is device pixels per CSS pixel.
  double css_width = 1280, css_height = 800, css_ratio = 1;
  // All other pixels in the view are `zoom` CSS pixels large: presentation mode enlarges
  // everything.
  double zoom = 1;
  double width = 1280, height = 800;
  double ratio = 1;  // device pixels per pixel
  bool dark = false;
  bool reduced_motion = false;
  bool embed = false;   // in an <iframe>, without panels for editing
  bool finger = false;  // the main pointer is a finger, so controls are larger
  bool touch = false;   // the last pointer was a finger, which cannot hover
  bool asking = false;  // a finger rests, and asks what is under it: tips are shown
  double foot = 0;      // what a card of the page covers at the drawing's foot, in pixels
  double card = 0;      // that card's height, in pixels
  // Of a window of the page: at the left, at the right, or from below over the whole width.
  double window_left = 0, window_right = 0, window_foot = 0;
  Rect area() const { return {0, 0, width, height}; }
};

struct Notice {
  enum class Kind : std::uint8_t { info, problem };
  Kind kind = Kind::info;
  std::string text;  // empty: no notice
  std::string undo;  // label of a button that undoes the last edit, if any
};

struct Session {
  Screen screen;
  int opened = 0;                    // documents opened since the start
  bool list_open = false;            // the last frame showed a list of choices
  bool close_list = false;           // the next frame closes it
  double closed_sheet_height = 172;  // pixels, measured in the last frame
  double notice_height = 0;          // pixels, measured in the last frame
  Notice notice;
  Effects effects;  // not carried out yet
};

}  // namespace evenlift::view
