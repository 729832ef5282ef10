// The browser: requests to it, and input from it.
#pragma once

#include <SDL.h>
#include <imgui.h>
#include <optional>
#include <string_view>
#include <vector>

#include "actions/pointer.h"
#include "state/session.h"

namespace evenlift::view::browser {

// --- Carries out the view's requests through web/page/bindings.js. Only the folder `page` calls the
// browser.

// Carries out the requests in order.
void carry_out(const Effects& effects);

void show_cursor(Cursor cursor);

// Tells the user that the canvas cannot show these characters.
void say_absent(std::string_view characters);

// Asks the browser to fetch the larger fonts and to call page_letters() with them.
void fetch_letters();

// Asks the browser to call page_resize() with the present size.
void measure_screen();

void request_frame();

// Asks the browser to call page_frame() at its next frame. Only schedule() in main.cpp uses this
// function.
void schedule_frame();

}  // namespace evenlift::view::browser

namespace evenlift::view {

// --- Converts SDL's events to the state of one pointer, a mouse or a finger, and to pinches. Only this
// file and main.cpp use SDL.

class SdlInput {
 public:
  void take(const Screen& screen);

  // Passes the pointer's next events to Dear ImGui in order, up to and including the next press,
  // release or turn of the wheel: in one pass, Dear ImGui would lose a second such event. A press
  // waits until the panels are `laid_out`. One Dear ImGui pixel is `zoom` CSS pixels wide. Call it
  // before ImGui::NewFrame().
  void feed(bool laid_out, double zoom);

  // Takes the pinch of a trackpad, which browsers report as a wheel.
  void pinch(const Vec2& at, double factor);

  // Notes that the finger on the screen, or the pointer that rests, now asks about the part beneath
  // it. The question ends when the finger is lifted, a second finger comes down or the pointer moves.
  void ask() { asks_ = touch_ ? down_ && !two_fingers_ : !down_; }

  // The pointer in this pass, in the same pixels as in feed(). Call it after ImGui::NewFrame().
  Pointer pointer(double zoom);

  bool waiting() const { return !queue_.empty(); }
  bool touch() const { return touch_; }
  bool asks() const { return asks_; }

 private:
  enum class What { move, down, up, leave, wheel, pinch };
  struct Event {
    What what;
    Vec2 at;
    bool touch = false;
    Uint32 time = 0;  // time of a finger's press, in milliseconds
    int clicks = 0;   // a mouse's presses in one place
    float wheel = 0;  // steps
    Vec2 moved;       // motion of a pinch's middle
    double factor = 1;
  };
  struct Finger {
    SDL_FingerID id;
    Vec2 at;
  };
  void take_mouse(const SDL_Event& event);
  void take_finger(const SDL_Event& event, const Screen& screen);
  bool is_second(const Event& press) const;
  void begin_pinch();
  void follow_pinch();
  bool ends_pass(const Event& next, bool laid_out) const;
  void deal_with(const Event& event);

  std::vector<Event> queue_;  // short: only events since the last frame
  std::vector<Finger> fingers_;
  // The places below are in CSS pixels.
  Vec2 at_ = Vec2(-1e6, -1e6);
  bool down_ = false, touch_ = false, asks_ = false;
  Vec2 pressed_at_;
  std::optional<Uint32> pressed_time_;  // nullopt if a finger's next press cannot be a second one
  bool two_fingers_ = false;  // stays true until all are lifted; the last finger drags nothing
  Vec2 pinch_middle_;
  double pinch_spread_ = 1;

  // The events of this pass.
  bool dragged_ = false, ended_ = false, second_press_ = false;
  std::optional<Event> wheel_, pinch_;  // several in a row count as one
};

}  // namespace evenlift::view
