// Each function calls its namesake in web/page/bindings.js.
#include "page/sdl_input.h"

#include <emscripten/emscripten.h>
#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>
#include <variant>

EM_JS(void, evenlift_document_changed, (), { Module["bindings"]["documentChanged"](); })
EM_JS(void, evenlift_summary_changed, (), { Module["bindings"]["summaryChanged"](); })
EM_JS(void, evenlift_preferences_changed, (), { Module["bindings"]["preferencesChanged"](); })
EM_JS(void, evenlift_copy_address, (const char* link),
      { Module["bindings"]["copyAddress"](UTF8ToString(link)); })
EM_JS(void, evenlift_open_dialog, (const char* name),
      { Module["bindings"]["openDialog"](UTF8ToString(name)); })
EM_JS(void, evenlift_show_cursor, (const char* name),
      { Module["bindings"]["showCursor"](UTF8ToString(name)); })
EM_JS(void, evenlift_type_value, (const char* control),
      { Module["bindings"]["typeValue"](UTF8ToString(control)); })
EM_JS(void, evenlift_announce, (const char* text),
      { Module["bindings"]["announce"](UTF8ToString(text)); })
EM_JS(void, evenlift_show_full_screen, (int on),
      { Module["bindings"]["showFullScreen"](Boolean(on)); })
EM_JS(void, evenlift_open_page, (), { Module["bindings"]["openPage"](); })
EM_JS(void, evenlift_say_absent, (const char* characters),
      { Module["bindings"]["sayAbsent"](UTF8ToString(characters)); })
EM_JS(void, evenlift_fetch_letters, (), { Module["bindings"]["fetchLetters"](); })
EM_JS(void, evenlift_measure_screen, (), { Module["bindings"]["measureScreen"](); })
EM_JS(void, evenlift_schedule_frame, (), { Module["bindings"]["scheduleFrame"](); })
EM_JS(void, evenlift_frame_after, (double seconds), { Module["bindings"]["frameAfter"](seconds); })
EM_JS(void, evenlift_begin_search,
      (double number, const char* polygon, const char* settings, const char* robots), {
        Module["bindings"]["beginSearch"](number, UTF8ToString(polygon), UTF8ToString(settings),
                                          UTF8ToString(robots));
      })
EM_JS(void, evenlift_end_search, (), { Module["bindings"]["endSearch"](); })
EM_JS(void, evenlift_choose_elsewhere,
      (double number, const double* rings, std::size_t size, const char* settings), {
        const at = rings >>> 0;
        Module["bindings"]["chooseElsewhere"](number, HEAPU8.slice(at, at + 8 * size),
                                              UTF8ToString(settings));
      })
EM_JS(void, evenlift_end_notice_after, (double seconds),
      { Module["bindings"]["endNoticeAfter"](seconds); })
EM_JS(void, evenlift_drop_frame_after, (), { Module["bindings"]["dropFrameAfter"](); })

namespace evenlift::view::browser {
namespace {

const char* name_of(Dialog dialog) {
  constexpr const char* names[] = {"samples",    "open",    "save",     "table", "lessons",
                                   "experiment", "curves",  "keys",     "about", "glossary",
                                   "welcome",    "optimum", "language", "cases", "weigh"};
  static_assert(std::size(names) == static_cast<std::size_t>(Dialog::end_of_dialogs));
  return names[static_cast<std::size_t>(dialog)];
}

struct CarryOut {
  void operator()(const DocumentChanged&) const { evenlift_document_changed(); }
  void operator()(const SummaryChanged&) const { evenlift_summary_changed(); }
  void operator()(const PreferencesChanged&) const { evenlift_preferences_changed(); }
  void operator()(const Announce& e) const { evenlift_announce(e.text.c_str()); }
  void operator()(const CopyAddress& e) const { evenlift_copy_address(e.link.c_str()); }
  void operator()(const ShowDialog& e) const { evenlift_open_dialog(name_of(e.dialog)); }
  void operator()(const FocusField& e) const { evenlift_type_value(e.control.c_str()); }
  void operator()(const ShowFullScreen& e) const { evenlift_show_full_screen(e.on ? 1 : 0); }
  void operator()(const ShowPage&) const { evenlift_open_page(); }
  void operator()(const BeginSearch& e) const {
    evenlift_begin_search(static_cast<double>(e.number), e.polygon.c_str(), e.settings.c_str(),
                          e.robots.c_str());
  }
  void operator()(const EndSearch&) const { evenlift_end_search(); }
  void operator()(const ChooseElsewhere& e) const {
    evenlift_choose_elsewhere(static_cast<double>(e.number), e.rings.data(), e.rings.size(),
                              e.settings.c_str());
  }
  void operator()(const NextFrame&) const { request_frame(); }
  void operator()(const FrameAfter& e) const { evenlift_frame_after(e.seconds); }
  void operator()(const DropFrameAfter&) const { evenlift_drop_frame_after(); }
  void operator()(const EndNoticeAfter& e) const {
    evenlift_end_notice_after(e.seconds.value_or(-1));
  }
};

}  // namespace

void carry_out(const Effects& effects) {
  for (const Effect& effect : effects) std::visit(CarryOut{}, effect);
}

void show_cursor(Cursor cursor) {
  // As in CSS.
  constexpr const char* names[] = {"default",  "pointer", "crosshair",   "copy",       "grab",
                                   "grabbing", "move",    "nesw-resize", "nwse-resize"};
  static_assert(std::size(names) == static_cast<std::size_t>(Cursor::end_of_cursors));
  evenlift_show_cursor(names[static_cast<std::size_t>(cursor)]);
}
void say_absent(std::string_view characters) {
  evenlift_say_absent(std::string(characters).c_str());
}
void fetch_letters() { evenlift_fetch_letters(); }
void measure_screen() { evenlift_measure_screen(); }
void schedule_frame() { evenlift_schedule_frame(); }

}  // namespace evenlift::view::browser
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
  if (event.what == What::leave || event.what == What::down || !event.touch) asks_ = false;
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
