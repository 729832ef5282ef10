// The state of this visit: its screen, measured sizes, and messages.
#pragma once

#include <cstdint>
#include <string>

#include "state/camera.h"
#include "state/effects.h"

namespace evenlift::view {

// The screen, as the page reports it.
struct Screen {
  // The canvas's size; the ratio is device pixels per CSS pixel.
  double css_width = 1280, css_height = 800, css_ratio = 1;
  // Everywhere else in the view, a pixel is `zoom` CSS pixels wide, since presentation mode
  // enlarges everything.
  double zoom = 1;
  double width = 1280, height = 800;
  double ratio = 1;  // device pixels per pixel
  bool dark = false;
  bool reduced_motion = false;
  bool embed = false;   // in an <iframe>, without panels for editing
  bool finger = false;  // the main pointer is a finger, so controls are larger
  bool touch = false;   // the last pointer was a finger, which cannot hover
  bool asking = false;  // a finger rests on a part to ask about it, so tips are shown
  double foot = 0;      // pixels from the top of the page's card to the drawing's foot, or 0
  double card = 0;      // the height of this card itself, in pixels, or 0
  // The pixels that a window of the page covers at the left, at the right, or at the foot over the
  // whole width.
  double window_left = 0, window_right = 0, window_foot = 0;
  Rect area() const { return {0, 0, width, height}; }
};

struct Notice {
  enum class Kind : std::uint8_t { info, problem };
  Kind kind = Kind::info;
  std::string text;  // empty if there is no notice
  std::string undo;  // label of a button that undoes the last edit; empty without a button
};

struct Session {
  Screen screen;
  int opened = 0;                    // the number of documents opened since the start
  bool list_open = false;            // the last frame showed a list of choices
  bool close_list = false;           // the next frame closes this list
  double closed_sheet_height = 172;  // pixels, measured in the last frame
  double notice_height = 0;          // pixels, measured in the last frame
  Notice notice;
  Effects effects;  // the effects not carried out yet
};

}  // namespace evenlift::view
