// The state of this visit: its screen, measured sizes, and messages.
#pragma once

#include <cstdint>
#include <string>

#include "state/camera.h"
#include "state/effects.h"

namespace evenlift::view {

// The page reports these facts about the screen.
struct Screen {
  // The canvas in CSS pixels, and device pixels per CSS pixel, as the browser reports them.
  double css_width = 1280, css_height = 800, css_ratio = 1;
  // Presentation mode enlarges everything: all other pixels, here and in the view, are `zoom` CSS
  // pixels large.
  double zoom = 1;
  double width = 1280, height = 800;
  double ratio = 1;  // device pixels per pixel
  bool dark = false;
  bool reduced_motion = false;
  bool embed = false;   // the page is in an <iframe>, and shows no panels for editing
  bool finger = false;  // the main pointer is a finger, so controls are larger
  bool touch = false;   // the last pointer was a finger, which cannot hover
  bool asking = false;  // a finger rests on the screen, and asks what is under it: tips are shown
  double foot = 0;      // height that a card of the page covers at the drawing's foot, in pixels
  double card = 0;      // the height of that card
  // The part that a window of the page covers: at the left, at the right, or from below over the
  // whole width.
  double window_left = 0, window_right = 0, window_foot = 0;
  Rect area() const { return {0, 0, width, height}; }
};

struct Notice {
  enum class Kind : std::uint8_t { info, problem };
  Kind kind = Kind::info;
  std::string text;  // empty: no notice
  std::string undo;  // the label of a button that undoes the last edit, if there is one
};

struct Session {
  Screen screen;
  int opened = 0;                    // the number of documents opened since the start
  bool list_open = false;            // whether the last frame showed a list of choices
  bool close_list = false;           // the next frame closes it
  double closed_sheet_height = 172;  // in pixels, as measured in the last frame
  double notice_height = 0;          // in pixels, as measured in the last frame
  Notice notice;
  Effects effects;  // not carried out yet
};

}  // namespace evenlift::view
