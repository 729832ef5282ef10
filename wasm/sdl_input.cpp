#include "sdl_input.h"

#include <algorithm>
#include <cfloat>

namespace evenlift::view {

void SdlInput::take(const Screen& screen) {
  SDL_Event event;
  while (SDL_PollEvent(&event)) {
    switch (event.type) {
      case SDL_MOUSEMOTION:
      case SDL_MOUSEBUTTONDOWN:
      case SDL_MOUSEBUTTONUP:
      case SDL_MOUSEWHEEL:
        take_mouse(event);
        break;
      case SDL_FINGERDOWN:
      case SDL_FINGERMOTION:
      case SDL_FINGERUP:
        take_finger(event, screen);
        break;
      case SDL_WINDOWEVENT:
        if (event.window.event == SDL_WINDOWEVENT_LEAVE)
          queue_.push_back({What::leave, Vec2(0, 0), false, event.common.timestamp});
        break;
      default:
        break;  // keys come by way of page_key()
    }
  }
}

void SdlInput::take_mouse(const SDL_Event& event) {
  if (event.type == SDL_MOUSEWHEEL) {
    wheel_ += event.wheel.preciseY;
    return;
  }
  if (event.type == SDL_MOUSEMOTION) {
    queue_.push_back(
        {What::move, Vec2(event.motion.x, event.motion.y), false, event.common.timestamp});
    return;
  }
  if (event.button.button != SDL_BUTTON_LEFT) return;
  const What what = event.type == SDL_MOUSEBUTTONDOWN ? What::down : What::up;
  queue_.push_back({what, Vec2(event.button.x, event.button.y), false, event.common.timestamp});
}

void SdlInput::take_finger(const SDL_Event& event, const Screen& screen) {
  const SDL_TouchFingerEvent& touched = event.tfinger;
  const Vec2 at(static_cast<double>(touched.x) * screen.width,
                static_cast<double>(touched.y) * screen.height);
  const auto finger = std::find_if(fingers_.begin(), fingers_.end(),
                                   [&](const Finger& f) { return f.id == touched.fingerId; });
  if (event.type == SDL_FINGERDOWN) {
    if (finger == fingers_.end()) fingers_.push_back({touched.fingerId, at});
    if (fingers_.size() == 1) queue_.push_back({What::down, at, true, touched.timestamp});
    if (fingers_.size() == 2) begin_pinch();
    return;
  }
  if (finger == fingers_.end()) return;
  finger->at = at;
  if (event.type == SDL_FINGERMOTION) {
    if (two_fingers_)
      follow_pinch();
    else
      queue_.push_back({What::move, at, true, touched.timestamp});
    return;
  }
  fingers_.erase(finger);
  if (!two_fingers_) {
    queue_.push_back({What::up, at, true, touched.timestamp});
    queue_.push_back(
        {What::leave, at, true, touched.timestamp});  // nothing hovers where no finger is
  }
  if (fingers_.empty()) two_fingers_ = false;
}

void SdlInput::begin_pinch() {
  two_fingers_ = true;
  queue_.push_back({What::up, fingers_[0].at, true, 0});
  queue_.push_back({What::leave, fingers_[0].at, true, 0});
  pinch_middle_ = (fingers_[0].at + fingers_[1].at) / 2;
  pinch_spread_ = length(fingers_[0].at - fingers_[1].at);
}

void SdlInput::follow_pinch() {
  if (fingers_.size() < 2) return;
  const Vec2 middle = (fingers_[0].at + fingers_[1].at) / 2;
  const double spread = std::max(length(fingers_[0].at - fingers_[1].at), 1.0);
  pinch_moved_ += middle - pinch_middle_;
  pinch_factor_ *= spread / std::max(pinch_spread_, 1.0);
  pinch_middle_ = middle;
  pinch_spread_ = spread;
  pinched_ = true;
}

void SdlInput::pinch(const Vec2& at, double factor) {
  pinch_middle_ = at;
  pinch_factor_ *= factor;
  pinched_ = true;
}

bool SdlInput::is_second(const Event& press) const {
  const double reach = press.touch ? 24 : 8;
  return pressed_time_ != 0 && press.time - pressed_time_ <= 450 &&
         length(press.at - pressed_at_) <= reach;
}

void SdlInput::feed() {
  bool dragged = false;
  while (!queue_.empty()) {
    const Event event = queue_.front();
    if (event.what == What::up && dragged) break;  // what is held gets there first
    queue_.erase(queue_.begin());
    dragged = down_ && event.what == What::move;
    touch_ = event.touch;
    at_ = event.what == What::leave ? Vec2(-1e6, -1e6) : event.at;
    if (event.what == What::down) {
      second_press_ = is_second(event);
      pressed_time_ = second_press_ ? 0 : event.time;
      pressed_at_ = event.at;
    }
    if (event.what == What::down || event.what == What::up) {
      down_ = event.what == What::down;
      break;
    }
  }
  ImGuiIO& io = ImGui::GetIO();
  const bool gone = at_.x() < -1e5;
  const ImVec2 at(gone ? -FLT_MAX : static_cast<float>(at_.x()),
                  gone ? -FLT_MAX : static_cast<float>(at_.y()));
#if IMGUI_VERSION_NUM >= 18700
  io.AddMousePosEvent(at.x, at.y);
  io.AddMouseButtonEvent(0, down_);
  io.AddMouseWheelEvent(0, wheel_);
#else
  io.MousePos = at;
  io.MouseDown[0] = down_;
  io.MouseWheel = wheel_;
#endif
}

Pointer SdlInput::pointer() {
  const ImGuiIO& io = ImGui::GetIO();
  Pointer p;
  p.at = at_;
  p.present = at_.x() > -1e5;
  p.touch = touch_;
  p.over_panel = io.WantCaptureMouse;
  p.pressed = ImGui::IsMouseClicked(0);
  p.double_pressed = p.pressed && second_press_;
  p.released = ImGui::IsMouseReleased(0);
  p.down = ImGui::IsMouseDown(0);
  const ImVec2 moved = ImGui::GetMouseDragDelta(0, 0);
  p.moved = length(Vec2(static_cast<double>(moved.x), static_cast<double>(moved.y)));
  p.wheel = static_cast<double>(wheel_);
  p.pinching = pinched_;
  p.pinch_at = pinch_middle_;
  p.pinch_moved = pinch_moved_;
  p.pinch_factor = pinch_factor_;
  second_press_ = false;
  wheel_ = 0;
  pinched_ = false;
  pinch_moved_ = Vec2::Zero();
  pinch_factor_ = 1;
  return p;
}

}  // namespace evenlift::view
