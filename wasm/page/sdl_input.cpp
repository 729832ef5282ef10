#include "page/sdl_input.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstddef>

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
          queue_.push_back({What::leave, Vec2(0, 0)});
        break;
      default:
        break;  // keys arrive through page_key()
    }
  }
}

void SdlInput::take_mouse(const SDL_Event& event) {
  if (event.type == SDL_MOUSEWHEEL) {
    Event wheel{What::wheel, Vec2(0, 0)};
    wheel.wheel = event.wheel.preciseY;
    queue_.push_back(wheel);
  } else if (event.type == SDL_MOUSEMOTION) {
    queue_.push_back({What::move, Vec2(event.motion.x, event.motion.y)});
  } else if (event.button.button == SDL_BUTTON_LEFT) {
    Event button{event.type == SDL_MOUSEBUTTONDOWN ? What::down : What::up,
                 Vec2(event.button.x, event.button.y)};
    button.clicks = event.button.clicks;
    queue_.push_back(button);
  }
}

void SdlInput::take_finger(const SDL_Event& event, const Screen& screen) {
  const SDL_TouchFingerEvent& touched = event.tfinger;
  const Vec2 at(static_cast<double>(touched.x) * screen.css_width,
                static_cast<double>(touched.y) * screen.css_height);
  const auto finger = std::find_if(fingers_.begin(), fingers_.end(),
                                   [&](const Finger& f) { return f.id == touched.fingerId; });
  if (event.type == SDL_FINGERDOWN) {
    if (finger == fingers_.end()) fingers_.push_back({touched.fingerId, at});
    if (fingers_.size() == 1) queue_.push_back({What::down, at, true, event.common.timestamp});
    if (fingers_.size() == 2) begin_pinch();
    return;
  }
  if (finger == fingers_.end()) return;
  finger->at = at;
  if (event.type == SDL_FINGERMOTION) {
    if (two_fingers_)
      follow_pinch();
    else
      queue_.push_back({What::move, at, true});
    return;
  }
  fingers_.erase(finger);
  if (!two_fingers_) {
    queue_.push_back({What::up, at, true});
    queue_.push_back({What::leave, at, true});  // a lifted finger hovers over nothing
  }
  if (fingers_.empty()) two_fingers_ = false;
}

void SdlInput::begin_pinch() {
  two_fingers_ = true;
  queue_.push_back({What::up, fingers_[0].at, true});
  queue_.push_back({What::leave, fingers_[0].at, true});
  pinch_middle_ = (fingers_[0].at + fingers_[1].at) / 2;
  pinch_spread_ = length(fingers_[0].at - fingers_[1].at);
}

void SdlInput::follow_pinch() {
  if (fingers_.size() < 2) return;
  const Vec2 middle = (fingers_[0].at + fingers_[1].at) / 2;
  const double spread = std::max(length(fingers_[0].at - fingers_[1].at), 1.0);
  Event pinch{What::pinch, middle, true};
  pinch.moved = middle - pinch_middle_;
  pinch.factor = spread / std::max(pinch_spread_, 1.0);
  queue_.push_back(pinch);
  pinch_middle_ = middle;
  pinch_spread_ = spread;
}

void SdlInput::pinch(const Vec2& at, double factor) {
  Event pinch{What::pinch, at, touch_};
  pinch.factor = factor;
  queue_.push_back(pinch);
}

// The browser counts clicks by the system's settings, but not a finger's taps.
bool SdlInput::is_second(const Event& press) const {
  if (!press.touch) return press.clicks > 0 && press.clicks % 2 == 0;
  return pressed_time_ && press.time - *pressed_time_ <= 450 &&
         length(press.at - pressed_at_) <= 24;
}

bool SdlInput::ends_pass(const Event& next, bool laid_out) const {
  if (ended_) return true;
  if (wheel_) return next.what != What::wheel;
  if (pinch_) return next.what != What::pinch;
  // Deliver the drag first.
  const bool turns = next.what == What::up || next.what == What::wheel || next.what == What::pinch;
  return (turns && dragged_) || (next.what == What::down && !laid_out);
}

void SdlInput::deal_with(const Event& event) {
  switch (event.what) {
    case What::wheel:
      if (wheel_)
        wheel_->wheel += event.wheel;
      else
        wheel_ = event;
      return;
    case What::pinch:
      if (pinch_) {
        pinch_->at = event.at;
        pinch_->moved += event.moved;
        pinch_->factor *= event.factor;
      } else {
        pinch_ = event;
      }
      return;
    case What::down:
      second_press_ = is_second(event);
      pressed_time_ = second_press_ ? std::nullopt : std::optional<Uint32>(event.time);
      pressed_at_ = event.at;
      break;
    case What::move:
      dragged_ = down_;
      break;
    default:
      break;
  }
  touch_ = event.touch;
  // Not at the release itself, which must press nothing.
  if (event.what == What::leave || event.what == What::down) asks_ = false;
  at_ = event.what == What::leave ? Vec2(-1e6, -1e6) : event.at;
  if (event.what == What::down || event.what == What::up) {
    down_ = event.what == What::down;
    ended_ = true;
  }
}

void SdlInput::feed(bool laid_out, double zoom) {
  dragged_ = ended_ = second_press_ = false;
  wheel_.reset();
  pinch_.reset();
  std::size_t dealt_with = 0;
  while (dealt_with < queue_.size() && !ends_pass(queue_[dealt_with], laid_out))
    deal_with(queue_[dealt_with++]);
  queue_.erase(queue_.begin(), queue_.begin() + static_cast<std::ptrdiff_t>(dealt_with));
  ImGuiIO& io = ImGui::GetIO();
  const bool gone = at_.x < -1e5;
  const ImVec2 at(gone ? -FLT_MAX : static_cast<float>(at_.x / zoom),
                  gone ? -FLT_MAX : static_cast<float>(at_.y / zoom));
  const float wheel = wheel_ ? wheel_->wheel : 0;
#if IMGUI_VERSION_NUM >= 18700
  io.ConfigInputTrickleEventQueue = false;  // feed() itself separates conflicting events
  io.AddMousePosEvent(at.x, at.y);
  io.AddMouseButtonEvent(0, down_);
  io.AddMouseWheelEvent(0, wheel);
#else
  io.MousePos = at;
  io.MouseDown[0] = down_;
  io.MouseWheel = wheel;
#endif
}

Pointer SdlInput::pointer(double zoom) {
  const ImGuiIO& io = ImGui::GetIO();
  Pointer p;
  p.at = at_ / zoom;
  p.present = at_.x > -1e5;
  p.touch = touch_;
  p.over_panel = io.WantCaptureMouse;
  p.pressed = ImGui::IsMouseClicked(0);
  p.double_pressed = p.pressed && second_press_;
  p.released = ImGui::IsMouseReleased(0);
  p.down = ImGui::IsMouseDown(0);
  const ImVec2 moved = ImGui::GetMouseDragDelta(0, 0);
  p.moved = std::max(length(Vec2(static_cast<double>(moved.x), static_cast<double>(moved.y))),
                     std::sqrt(static_cast<double>(io.MouseDragMaxDistanceSqr[0])));
  if (wheel_) p.wheel = static_cast<double>(wheel_->wheel);
  if (pinch_) {
    p.pinching = true;
    p.pinch_at = pinch_->at / zoom;
    p.pinch_moved = pinch_->moved / zoom;
    p.pinch_factor = pinch_->factor;
  }
  return p;
}

}  // namespace evenlift::view
