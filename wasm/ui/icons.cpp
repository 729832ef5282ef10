#include "ui/icons.h"

#include <initializer_list>

namespace evenlift::view {
namespace {

constexpr float pi = 3.14159265f;

// Draws in a box from (-1, -1) to (1, 1), y down.
class Pen {
 public:
  Pen(ImDrawList& list, ImVec2 middle, float size, Colour colour)
      : list_(list),
        middle_(middle),
        half_(size / 2),
        colour_(colour.packed()),
        width_(size / 20 * 1.7f) {}

  void line(std::initializer_list<ImVec2> points, bool closed = false) {
    for (const ImVec2& p : points) list_.PathLineTo(at(p));
    stroke(closed);
  }
  void arc(ImVec2 centre, float radius, float from_degrees, float to_degrees) {
    list_.PathArcTo(at(centre), radius * half_, from_degrees * pi / 180, to_degrees * pi / 180, 20);
    stroke(false);
  }
  void dot(ImVec2 centre, float radius) {
    list_.AddCircleFilled(at(centre), radius * half_, colour_, 16);
  }

 private:
  ImVec2 at(ImVec2 p) const { return {middle_.x + p.x * half_, middle_.y + p.y * half_}; }
  void stroke(bool closed) {
    list_.PathStroke(colour_, closed ? ImDrawFlags_Closed : ImDrawFlags_None, width_);
  }

  ImDrawList& list_;
  ImVec2 middle_;
  float half_;
  ImU32 colour_;
  float width_;
};

// An arrow that comes round; `side` is 1 for undo, -1 for redo.
void turn_back(Pen& pen, float side) {
  pen.line({{-0.25f * side, -0.85f}, {-0.75f * side, -0.4f}, {-0.25f * side, 0.05f}});
  pen.line({{-0.75f * side, -0.4f}, {0.25f * side, -0.4f}});
  if (side > 0)
    pen.arc({0.25f, 0.15f}, 0.55f, -90, 90);
  else
    pen.arc({-0.25f, 0.15f}, 0.55f, 90, 270);
  pen.line({{0.25f * side, 0.7f}, {-0.4f * side, 0.7f}});
}

// Points along x by its sign.
void chevron(Pen& pen, float x, float along) {
  pen.line({{x - 0.3f * along, -0.6f}, {x + 0.3f * along, 0}, {x - 0.3f * along, 0.6f}});
}

void corners(Pen& pen) {
  for (float x : {-1.0f, 1.0f}) {
    for (float y : {-1.0f, 1.0f}) {
      pen.line({{x * 0.3f, y * 0.8f}, {x * 0.8f, y * 0.8f}, {x * 0.8f, y * 0.3f}});
    }
  }
}

void chain(Pen& pen) {
  pen.arc({-0.4f, 0}, 0.42f, 90, 270);
  pen.arc({0.4f, 0}, 0.42f, -90, 90);
  pen.line({{-0.4f, -0.42f}, {-0.15f, -0.42f}});
  pen.line({{-0.4f, 0.42f}, {-0.15f, 0.42f}});
  pen.line({{0.4f, -0.42f}, {0.15f, -0.42f}});
  pen.line({{0.4f, 0.42f}, {0.15f, 0.42f}});
  pen.line({{-0.35f, 0}, {0.35f, 0}});
}

void folder(Pen& pen) {
  pen.line(
      {{-0.8f, 0.6f}, {-0.8f, -0.6f}, {-0.2f, -0.6f}, {0.05f, -0.3f}, {0.8f, -0.3f}, {0.8f, 0.6f}},
      true);
}

void arrow_into_tray(Pen& pen) {
  pen.line({{0, -0.75f}, {0, 0.3f}});
  pen.line({{-0.4f, -0.1f}, {0, 0.3f}, {0.4f, -0.1f}});
  pen.line({{-0.75f, 0.25f}, {-0.75f, 0.7f}, {0.75f, 0.7f}, {0.75f, 0.25f}});
}

void grid(Pen& pen) {
  pen.line({{-0.75f, -0.6f}, {0.75f, -0.6f}, {0.75f, 0.6f}, {-0.75f, 0.6f}}, true);
  pen.line({{-0.75f, -0.15f}, {0.75f, -0.15f}});
  pen.line({{0, -0.6f}, {0, 0.6f}});
}

void pencil(Pen& pen) {
  pen.line({{-0.75f, 0.75f}, {-0.6f, 0.2f}, {0.35f, -0.75f}, {0.75f, -0.35f}, {-0.2f, 0.6f}}, true);
}

void frame_with_grips(Pen& pen) {
  pen.line({{-0.6f, -0.6f}, {0.6f, -0.6f}, {0.6f, 0.6f}, {-0.6f, 0.6f}}, true);
  for (float x : {-0.6f, 0.6f}) {
    for (float y : {-0.6f, 0.6f}) pen.dot({x, y}, 0.2f);
  }
}

void two_sides(Pen& pen) {
  pen.line({{-0.8f, -0.6f}, {-0.2f, -0.6f}, {-0.2f, 0.6f}, {-0.8f, 0.6f}}, true);
  pen.line({{0.2f, -0.6f}, {0.8f, -0.6f}, {0.8f, 0.6f}, {0.2f, 0.6f}}, true);
}

void question(Pen& pen) {
  pen.arc({0, -0.35f}, 0.4f, -180, 40);
  pen.line({{0.3f, -0.09f}, {0, 0.18f}, {0, 0.36f}});
  pen.dot({0, 0.75f}, 0.13f);
}

}  // namespace

void draw_icon(ImDrawList& list, Icon icon, ImVec2 middle, float size, Colour colour) {
  Pen pen(list, middle, size, colour);
  switch (icon) {
    case Icon::none:
      break;
    case Icon::undo:
      turn_back(pen, 1);
      break;
    case Icon::redo:
      turn_back(pen, -1);
      break;
    case Icon::link:
      chain(pen);
      break;
    case Icon::plus:
      pen.line({{-0.65f, 0}, {0.65f, 0}});
      pen.line({{0, -0.65f}, {0, 0.65f}});
      break;
    case Icon::minus:
      pen.line({{-0.65f, 0}, {0.65f, 0}});
      break;
    case Icon::fit:
      corners(pen);
      break;
    case Icon::fold:
      pen.line({{-0.25f, -0.55f}, {0.3f, 0}, {-0.25f, 0.55f}});
      break;
    case Icon::unfold:
      pen.line({{0.25f, -0.55f}, {-0.3f, 0}, {0.25f, 0.55f}});
      break;
    case Icon::down:
      pen.line({{-0.5f, -0.22f}, {0, 0.28f}, {0.5f, -0.22f}});
      break;
    case Icon::up:
      pen.line({{-0.5f, 0.22f}, {0, -0.28f}, {0.5f, 0.22f}});
      break;
    case Icon::help:
      question(pen);
      break;
    case Icon::close:
      pen.line({{-0.5f, -0.5f}, {0.5f, 0.5f}});
      pen.line({{-0.5f, 0.5f}, {0.5f, -0.5f}});
      break;
    case Icon::check:
      pen.line({{-0.5f, 0.05f}, {-0.12f, 0.42f}, {0.55f, -0.4f}});
      break;
    case Icon::warning:
      pen.line({{0, -0.6f}, {0, 0.15f}});
      pen.dot({0, 0.55f}, 0.14f);
      break;
    case Icon::stop:
      pen.line({{-0.5f, 0}, {0.5f, 0}});
      break;
    case Icon::shapes:
      pen.line({{-0.8f, -0.1f}, {-0.25f, -0.8f}, {0.3f, -0.1f}}, true);
      pen.arc({0.3f, 0.4f}, 0.45f, -100, 170);
      break;
    case Icon::folder:
      folder(pen);
      break;
    case Icon::save:
      arrow_into_tray(pen);
      break;
    case Icon::table:
      grid(pen);
      break;
    case Icon::draw:
      pencil(pen);
      break;
    case Icon::transform:
      frame_with_grips(pen);
      break;
    case Icon::lesson:  // a board on its stand
      pen.line({{-0.85f, -0.7f}, {0.85f, -0.7f}, {0.85f, 0.35f}, {-0.85f, 0.35f}}, true);
      pen.line({{-0.35f, 0.35f}, {-0.55f, 0.85f}});
      pen.line({{0.35f, 0.35f}, {0.55f, 0.85f}});
      break;
    case Icon::play:
      pen.line({{-0.4f, -0.7f}, {0.7f, 0}, {-0.4f, 0.7f}}, true);
      break;
    case Icon::pause:
      pen.line({{-0.35f, -0.65f}, {-0.35f, 0.65f}});
      pen.line({{0.35f, -0.65f}, {0.35f, 0.65f}});
      break;
    case Icon::step_on:
      chevron(pen, 0, 1);
      break;
    case Icon::step_back:
      chevron(pen, 0, -1);
      break;
    case Icon::chapter_on:
      chevron(pen, -0.3f, 1);
      chevron(pen, 0.3f, 1);
      break;
    case Icon::chapter_back:
      chevron(pen, -0.3f, -1);
      chevron(pen, 0.3f, -1);
      break;
    case Icon::last:
      chevron(pen, -0.2f, 1);
      pen.line({{0.55f, -0.6f}, {0.55f, 0.6f}});
      break;
    case Icon::first:
      chevron(pen, 0.2f, -1);
      pen.line({{-0.55f, -0.6f}, {-0.55f, 0.6f}});
      break;
    case Icon::compare:
      two_sides(pen);
      break;
    case Icon::open_out:
      pen.line({{-0.6f, 0.6f}, {0.6f, -0.6f}});
      pen.line({{-0.1f, -0.65f}, {0.62f, -0.65f}, {0.62f, 0.1f}});
      break;
  }
}

void draw_centre_mark(ImDrawList& list, ImVec2 middle, float radius, Colour dark, Colour light) {
  list.AddCircleFilled(middle, radius, light.packed(), 32);
  for (float start : {0.0f, pi}) {
    list.PathLineTo(middle);
    list.PathArcTo(middle, radius, start, start + pi / 2, 10);
    list.PathFillConvex(dark.packed());
  }
  list.AddCircle(middle, radius, dark.packed(), 32, radius / 5);
}

}  // namespace evenlift::view
