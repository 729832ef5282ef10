// SDL's events as one pointer and two-finger gestures. With main.cpp the only file that knows SDL.
#pragma once

#include <SDL.h>
#include <imgui.h>

#include <vector>

#include "pointer.h"

namespace evenlift::view {

class SdlInput {
 public:
  // Takes all waiting events.
  void take(const Screen& screen);

  // Hands Dear ImGui the pointer's events up to the next press or release: two of them in one frame
  // would be lost. Call before ImGui::NewFrame().
  void feed();

  // Two fingers of a trackpad, which browsers report as a wheel.
  void pinch(const Vec2& at, double factor);

  // After ImGui::NewFrame(): the frame's pointer.
  Pointer pointer();

  bool waiting() const { return !queue_.empty(); }
  bool touch() const { return touch_; }

 private:
  enum class What { move, down, up, leave };
  struct Event {
    What what;
    Vec2 at;
    bool touch;
    Uint32 time;  // milliseconds, when it came: a slow frame must not part the two presses of a
                  // double one
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

  std::vector<Event> queue_;  // short: what came since the last frame
  std::vector<Finger> fingers_;
  Vec2 at_ = Vec2(-1e6, -1e6);
  bool down_ = false, touch_ = false;
  bool second_press_ = false;  // of a double press, in this frame
  Vec2 pressed_at_ = Vec2::Zero();
  Uint32 pressed_time_ = 0;  // 0: the next press is a first one
  float wheel_ = 0;
  bool two_fingers_ = false;  // until all are lifted: the last finger of a pinch drags nothing
  bool pinched_ = false;      // since the last frame
  Vec2 pinch_middle_ = Vec2::Zero(), pinch_moved_ = Vec2::Zero();
  double pinch_spread_ = 1, pinch_factor_ = 1;
};

}  // namespace evenlift::view
