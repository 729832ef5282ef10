// What this visit of the page knows of itself: its screen, what it measured, and what it says.
#pragma once

#include <cstdint>
#include <string>

#include "state/camera.h"
#include "state/effects.h"

namespace evenlift::view {

// What the page tells the view about the screen.
struct Screen {
  // Of the canvas, as the browser tells: in CSS pixels, and device pixels per CSS pixel.
  double css_width = 1280, css_height = 800, css_ratio = 1;
  // Before a room everything is enlarged: everything else here and in the view is in pixels that
  // are `zoom` CSS pixels large.
  double zoom = 1;
  double width = 1280, height = 800;
  double ratio = 1;  // device pixels per pixel
  bool dark = false;
  bool reduced_motion = false;
  bool embed = false;   // the page is in an <iframe>, and shows no panels for editing
  bool finger = false;  // the main pointer is a finger, so controls are larger
  bool touch = false;   // the last pointer was a finger, which hovers over nothing
  double foot = 0;      // covered by a card of the page at the foot of the drawing, in pixels
  double card = 0;      // the height of that card
  // What a window of the page covers: at the left, at the right, or from below as wide as the
  // screen.
  double window_left = 0, window_right = 0, window_foot = 0;
  Rect area() const { return {0, 0, width, height}; }
};

struct Notice {
  enum class Kind : std::uint8_t { info, problem };
  Kind kind = Kind::info;
  std::string text;  // empty: no notice
};

struct Session {
  Screen screen;
  int opened = 0;                    // how many documents were opened since the start
  bool list_open = false;            // whether the last frame showed a list of choices
  bool close_list = false;           // the next frame closes it
  double closed_sheet_height = 172;  // in pixels, as measured in the last frame
  double notice_height = 0;          // likewise
  Notice notice;
  Effects effects;  // what the page has still to carry out
};

}  // namespace evenlift::view
