// Starts the page and makes its frames: SDL2 provides the events, Emscripten provides WebGL 2, and
// Dear ImGui draws. A frame is drawn only on request. Dear ImGui's own backend for SDL2 is unused:
// it reads where the mouse is, not where it was pressed, draws at whole CSS pixels, and contains
// code for gamepads.
//
// All input is handled in order, however long a frame takes. The pointer's events wait in a queue
// (sdl_input.h) for passes: a pass lets the pointer act on the drawing and the panels, up to its
// next press or release. A frame makes as many passes as the input needs, and draws the last one. A
// key or a call first makes the waiting passes, without a picture (page_catch_up).
#include <SDL.h>
#include <emscripten/emscripten.h>
#include <emscripten/html5.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "evenlift/numbers.h"
#include "page/page_api.h"
#include "page/sdl_input.h"
#include "page/webgl_renderer.h"
#include "tools/pick.h"
#include "ui/controls.h"
#include "ui/theme.h"

namespace evenlift::view {
namespace {

// Dear ImGui needs three frames after an input: whatever a click opens is measured in the second,
// and the pointer hovers over it in the third.
constexpr int frames_after_input = 3;

struct Page {
  SDL_Window* window = nullptr;  // null without WebGL 2
  WebglRenderer renderer;
  SdlInput input;
  int canvas_width = 0, canvas_height = 0;  // device pixels
  bool letters_asked = false;
  int frames_due = 0;
  bool frame_scheduled = false;
  bool context_lost = false;
  bool passing = false;  // during a pass, which may call the page, and the page may call back
  int passes_due = 0;    // until the panels are laid out; no press is handled before
  double fonts_for_ratio = 0;
  double last_frame_at = 0;  // seconds
  double frames = 0;
  double press_time = 0;  // see page_press()
  int press_clicks = 0;
  Cursor cursor = Cursor::arrow;
};
Page page;

void schedule() {
  if (page.frame_scheduled || page.context_lost) return;
  page.frame_scheduled = true;
  browser::schedule_frame();
}

void ask_for_frames(int count) {
  page.frames_due = std::max(page.frames_due, count);
  schedule();
}

// SDL_PollEvent() itself queues a sentinel, which must not cause another frame. SDL gives an event
// the time of its receipt, which a slow frame delays, so a press keeps its original time and the
// browser's count of clicks.
int SDLCALL on_event(void*, SDL_Event* event) {
  if (event->type == SDL_MOUSEBUTTONDOWN)
    event->button.clicks = static_cast<Uint8>(std::clamp(page.press_clicks, 0, 255));
  if (event->type == SDL_FINGERDOWN)
    event->common.timestamp = static_cast<Uint32>(std::llround(page.press_time));
  if (event->type != SDL_POLLSENTINEL) ask_for_frames(frames_after_input);
  return 0;
}

void load_fonts_for(double ratio) {
  if (page.fonts_for_ratio == ratio) return;
  load_fonts(ratio);
  page.renderer.upload_fonts();
  page.fonts_for_ratio = ratio;
}

// For characters that the fonts lack: fetches larger fonts, once; or rasterises them before the
// next frame, and reports those that no font has.
void find_letters() {
  if (!letters_are_due()) return;
  if (letters_are_here()) {
    page.fonts_for_ratio = 0;
    load_fonts_for(app().state.session.screen.ratio);
    const std::string absent = absent_letters(*font(Face::text));
    if (!absent.empty()) browser::say_absent(absent);
    browser::request_frame();
  } else if (!page.letters_asked) {
    page.letters_asked = true;
    browser::fetch_letters();
  }
}

// SDL resizes the canvas to CSS pixels, or not at all; the page knows the device pixels.
void fit_canvas() {
  int width = 0, height = 0;
  emscripten_get_canvas_element_size("#canvas", &width, &height);
  if (width != page.canvas_width || height != page.canvas_height) {
    emscripten_set_canvas_element_size("#canvas", page.canvas_width, page.canvas_height);
  }
}

void begin_pass(const Screen& screen) {
  ImGuiIO& io = ImGui::GetIO();
  const double now = emscripten_get_now() / 1000;
  io.DeltaTime = page.last_frame_at > 0
                     ? static_cast<float>(std::max(now - page.last_frame_at, 1e-4))
                     : 1.0f / 60;
  page.last_frame_at = now;
  const auto width = static_cast<float>(screen.width), height = static_cast<float>(screen.height);
  io.DisplaySize = ImVec2(width, height);
  io.DisplayFramebufferScale = ImVec2(static_cast<float>(page.canvas_width) / width,
                                      static_cast<float>(page.canvas_height) / height);
  page.input.feed(page.passes_due == 0, screen.zoom);
  page.passes_due = std::max(0, page.passes_due - 1);
  ImGui::NewFrame();
}

void show_frame(const Colour& ground) {
  ImGui::Render();
  page.renderer.draw(*ImGui::GetDrawData(), ground);
}

void show_cursor() {
  const bool over_button = ImGui::GetMouseCursor() == ImGuiMouseCursor_Hand;
  const bool over_panel = ImGui::GetIO().WantCaptureMouse;
  const Cursor wanted = over_button  ? Cursor::press
                        : over_panel ? Cursor::arrow
                                     : cursor(app().state);
  if (wanted == page.cursor) return;
  page.cursor = wanted;
  browser::show_cursor(wanted);
}

// Whatever a press opens is measured in the next pass, and can be pressed in the one after.
constexpr int passes_after_change = 2;
void panels_change() { page.passes_due = passes_after_change; }

// If allowed, draws when no input is left. Returns whether it drew.
bool pass(bool may_draw) {
  App& a = app();
  page.passing = true;
  begin_pass(a.state.session.screen);
  const bool draws = may_draw && !page.input.waiting();
  const Pointer pointer = page.input.pointer(a.state.session.screen.zoom);
  if (pointer.pressed || pointer.released) panels_change();
  advance(a, pointer, ImGui::GetTime());
  const Commands asked = draw_frame(a, draws);
  a.commands.insert(a.commands.end(), asked.begin(), asked.end());
  if (draws)
    show_frame(theme(a.state).ground.at(a.state.work.backdrop ? 0 : 1));
  else
    ImGui::EndFrame();
  if (settle()) ask_for_frames(2);
  page.passing = false;
  return draws;
}

void take_input() {
  App& a = app();
  page.input.take(a.state.session.screen);
  const Screen& screen = a.state.session.screen;
  if (screen.touch == page.input.touch() && screen.asking == page.input.asks()) return;
  a.commands.push_back(SetTouch{page.input.touch(), page.input.asks()});
  settle();
}

void draw() {
  App& a = app();
  if (!page.window || page.passing || page.context_lost || page.canvas_width <= 0 ||
      !a.state.derived().placement)
    return;
  // Some browsers report late that the window is on another screen.
  if (emscripten_get_device_pixel_ratio() != a.state.session.screen.css_ratio)
    browser::measure_screen();
  take_input();
  fit_canvas();
  load_fonts_for(a.state.session.screen.ratio);
  while (!pass(true)) {
  }
  show_cursor();
  find_letters();
  page.frames += 1;
  if (page.frames_due > 0) schedule();
}

// Before the first frame there are no panels to press.
void catch_up() {
  if (page.passing || page.frames == 0) return;
  take_input();
  while (page.input.waiting()) pass(false);
}

// Omits the buffers that flat drawing does not need.
bool make_webgl_context() {
  EmscriptenWebGLContextAttributes attributes;
  emscripten_webgl_init_context_attributes(&attributes);
  attributes.majorVersion = 2;
  attributes.depth = attributes.antialias = false;
  attributes.enableExtensionsByDefault = false;
  const EMSCRIPTEN_WEBGL_CONTEXT_HANDLE context =
      emscripten_webgl_create_context("#canvas", &attributes);
  return context > 0 && emscripten_webgl_make_context_current(context) == EMSCRIPTEN_RESULT_SUCCESS;
}

// Returns whether there is a canvas to draw on. Without one, calls that do not concern it work.
bool start() {
  if (!make_webgl_context()) return false;
  SDL_SetHint(SDL_HINT_EMSCRIPTEN_KEYBOARD_ELEMENT, "#canvas");
  SDL_SetHint(SDL_HINT_TOUCH_MOUSE_EVENTS, "0");  // sdl_input.cpp distinguishes fingers itself
  if (SDL_Init(SDL_INIT_VIDEO) != 0) return false;
  page.window = SDL_CreateWindow("evenlift", 0, 0, 1280, 800, 0);
  if (!page.window) return false;
  ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.ConfigInputTextCursorBlink = false;  // a blinking cursor would draw for ever
  io.BackendFlags |= ImGuiBackendFlags_HasMouseCursors;
  page.renderer.start();
  return true;
}

}  // namespace

void browser::request_frame() {
  panels_change();
  ask_for_frames(2);
}

}  // namespace evenlift::view

using namespace evenlift::view;

extern "C" {

// `width` and `height` are CSS pixels.
EMSCRIPTEN_KEEPALIVE void page_resize(double width, double height, double ratio, int device_width,
                                      int device_height) {
  carry_out({SetCanvas{width, height, ratio}});
  page.canvas_width = device_width;
  page.canvas_height = device_height;
  SDL_SetWindowSize(page.window, static_cast<int>(std::lround(width)),
                    static_cast<int>(std::lround(height)));
  // At once, because the browser stretches the old frame until the next one.
  if (page.frames > 0) draw();
  ask_for_frames(frames_after_input);
}

EMSCRIPTEN_KEEPALIVE void page_pinch(double x, double y, double factor) {
  page.input.pinch(evenlift::Vec2(x, y), factor);
  ask_for_frames(frames_after_input);
}

// A returned context is empty, so the renderer restarts and receives the fonts again.
EMSCRIPTEN_KEEPALIVE void page_context(int lost) {
  if (page.context_lost == (lost != 0)) return;
  page.context_lost = lost != 0;
  page.frame_scheduled = false;
  if (page.context_lost) {
    page.renderer.stop();
  } else {
    page.renderer.start();
    page.fonts_for_ratio = 0;
    ask_for_frames(frames_after_input);
  }
}

// Without a canvas to draw on, the page shows page_svg() after each page_frame().
EMSCRIPTEN_KEEPALIVE int page_draws() { return page.window ? 1 : 0; }

EMSCRIPTEN_KEEPALIVE double page_frames() { return page.frames; }

// page_frame() draws the scheduled frame; page_wake() requests one when a delay ends.
EMSCRIPTEN_KEEPALIVE void page_frame() {
  if (page.context_lost) return;
  page.frame_scheduled = false;
  page.frames_due = std::max(0, page.frames_due - 1);
  draw();
}
EMSCRIPTEN_KEEPALIVE void page_wake() { ask_for_frames(1); }

// Handles all input so far. web/page/program.js calls it before each call but page_frame().
EMSCRIPTEN_KEEPALIVE void page_catch_up() { catch_up(); }

// The press that SDL will receive next: its time in milliseconds, and its number among the presses
// in one place (0 if the browser does not count them).
EMSCRIPTEN_KEEPALIVE void page_press(double time, int clicks) {
  page.press_time = time;
  page.press_clicks = clicks;
}

// A finger or the pointer has rested in one place.
EMSCRIPTEN_KEEPALIVE void page_ask() {
  catch_up();
  page.input.ask();
  if (!page.input.touch() && ImGui::GetIO().WantCaptureMouse) return;  // tips need no rest
  ask_for_frames(frames_after_input);
}

// Makes passes until no panel changes.
static void lay_out_panels() {
  if (page.passing || page.frames == 0) return;
  do pass(false);
  while (page.passes_due > 0);
}

// Carries out the requests to controls and lays all of them out, so that page_controls() has them
// before the next frame.
EMSCRIPTEN_KEEPALIVE void page_lay_out() {
  panels_change();
  lay_out_panels();
}

EMSCRIPTEN_KEEPALIVE const char* page_controls() {
  return hand_over(controls_json(app().state.session.screen.zoom));
}

// Takes the page's fonts, before the first frame.
EMSCRIPTEN_KEEPALIVE void page_fonts(const unsigned char* regular, int regular_size,
                                     const unsigned char* semibold, int semibold_size) {
  give_fonts({regular, regular + regular_size}, {semibold, semibold + semibold_size});
}

// Takes the larger fonts (letters.h).
EMSCRIPTEN_KEEPALIVE void page_letters(const unsigned char* regular, int regular_size,
                                       const unsigned char* semibold, int semibold_size) {
  give_fonts({regular, regular + regular_size}, {semibold, semibold + semibold_size});
  have_letters();
  browser::request_frame();
}

// The place of a control, as JSON, in CSS pixels; empty if no control with that name is shown.
EMSCRIPTEN_KEEPALIVE const char* page_control(const char* name) {
  lay_out_panels();
  const std::vector<Control>& all = controls();
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const Control& control) { return control.name == name; });
  return hand_over(found == all.end() ? std::string()
                                      : place_json(found->place, app().state.session.screen.zoom));
}

// Acts on a control as a pointer would. `what` is a ControlRequest.
EMSCRIPTEN_KEEPALIVE void page_ask_control(int what, const char* card, const char* name,
                                           double value) {
  if (what < 0 || what > static_cast<int>(ControlRequest::withdraw)) return;
  ask_control(static_cast<ControlRequest>(what), card, name, value);
  browser::request_frame();
}

}  // extern "C"

int main(int, char**) {
  if (start()) SDL_AddEventWatch(on_event, nullptr);
  return 0;
}
