// The page's start-up and its frames: SDL2 gives events, Emscripten WebGL 2, Dear ImGui draws.
// A frame is drawn only when something asked for one. Dear ImGui's own backend for SDL2 is not
// used: it reads the mouse where it is now, not where it was pressed, draws at whole CSS pixels and
// brings gamepads along.
#include <SDL.h>
#include <emscripten/emscripten.h>
#include <emscripten/html5.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "browser.h"
#include "page_api.h"
#include "sdl_input.h"
#include "theme.h"
#include "webgl_renderer.h"

namespace evenlift::view {
namespace {

// Dear ImGui needs more than one frame to settle: what a click opens is measured in the next one
// and hovered in the one after.
constexpr int frames_after_input = 3;

struct Page {
  SDL_Window* window = nullptr;
  WebglRenderer renderer;
  SdlInput input;
  int canvas_width = 0, canvas_height = 0;  // device pixels
  int frames_due = 0;
  bool frame_scheduled = false;
  bool context_lost = false;
  double fonts_for_ratio = 0;
  double last_frame_at = 0;  // seconds
  double frames = 0;
  long frame_after = 0;  // the timer of request_frame_after()
  ImGuiMouseCursor cursor = ImGuiMouseCursor_Arrow;
};
Page page;

void draw();

EM_BOOL on_frame(double, void*) {
  if (page.context_lost) return EM_FALSE;
  page.frame_scheduled = false;
  page.frames_due = std::max(0, page.frames_due - 1);
  draw();
  return EM_FALSE;
}

void schedule() {
  if (page.frame_scheduled || page.context_lost) return;
  page.frame_scheduled = true;
  emscripten_request_animation_frame(on_frame, nullptr);
}

void ask_for_frames(int count) {
  page.frames_due = std::max(page.frames_due, count);
  schedule();
}

// SDL_PollEvent() itself puts a sentinel into the queue: waking at that would never end.
int SDLCALL on_event(void*, SDL_Event* event) {
  if (event->type != SDL_POLLSENTINEL) ask_for_frames(frames_after_input);
  return 0;
}

void load_fonts_for(double ratio) {
  if (page.fonts_for_ratio == ratio) return;
  load_fonts(ratio);
  page.renderer.upload_fonts();
  page.fonts_for_ratio = ratio;
}

// SDL resizes the canvas to CSS pixels, or not at all; the page knows the exact device pixels.
void fit_canvas() {
  int width = 0, height = 0;
  emscripten_get_canvas_element_size("#canvas", &width, &height);
  if (width != page.canvas_width || height != page.canvas_height) {
    emscripten_set_canvas_element_size("#canvas", page.canvas_width, page.canvas_height);
  }
}

void begin_frame(const Screen& screen) {
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
  page.input.feed();
  ImGui::NewFrame();
}

void end_frame(const Colour& ground) {
  ImGui::Render();
  page.renderer.draw(*ImGui::GetDrawData(), ground);
}

void show_cursor() {
  const ImGuiMouseCursor wanted = ImGui::GetMouseCursor();
  if (wanted == page.cursor) return;
  page.cursor = wanted;
  SDL_SystemCursor shape = SDL_SYSTEM_CURSOR_ARROW;
  if (wanted == ImGuiMouseCursor_Hand) shape = SDL_SYSTEM_CURSOR_HAND;
  if (wanted == ImGuiMouseCursor_ResizeAll) shape = SDL_SYSTEM_CURSOR_SIZEALL;
  static SDL_Cursor* shown[SDL_NUM_SYSTEM_CURSORS];
  if (!shown[shape]) shown[shape] = SDL_CreateSystemCursor(shape);
  SDL_SetCursor(shown[shape]);
}

void draw() {
  App& a = app();
  if (page.context_lost || page.canvas_width <= 0 || !a.state.placement) return;
  // Not every browser tells at once that the window went to another screen.
  if (emscripten_get_device_pixel_ratio() != a.state.screen.ratio) browser::measure_screen();
  page.input.take(a.state.screen);
  a.state.screen.touch = page.input.touch();
  fit_canvas();
  load_fonts_for(a.state.screen.ratio);
  begin_frame(a.state.screen);
  draw_frame(a, page.input.pointer());
  end_frame(theme(a.state).ground);
  show_cursor();
  page.frames += 1;
  if (settle(a)) ask_for_frames(2);
  if (page.input.waiting()) ask_for_frames(frames_after_input);
  if (page.frames_due > 0) schedule();
}

// The canvas's WebGL 2 context, without the buffers that flat drawing does not need.
bool make_webgl_context() {
  EmscriptenWebGLContextAttributes attributes;
  emscripten_webgl_init_context_attributes(&attributes);
  attributes.majorVersion = 2;
  attributes.alpha = attributes.depth = attributes.antialias = false;
  attributes.enableExtensionsByDefault = false;
  const EMSCRIPTEN_WEBGL_CONTEXT_HANDLE context =
      emscripten_webgl_create_context("#canvas", &attributes);
  return context > 0 && emscripten_webgl_make_context_current(context) == EMSCRIPTEN_RESULT_SUCCESS;
}

bool start() {
  SDL_SetHint(SDL_HINT_EMSCRIPTEN_KEYBOARD_ELEMENT, "#canvas");
  SDL_SetHint(SDL_HINT_TOUCH_MOUSE_EVENTS, "0");  // sdl_input.cpp tells fingers apart itself
  if (SDL_Init(SDL_INIT_VIDEO) != 0) return false;
  page.window = SDL_CreateWindow("evenlift", 0, 0, 1280, 800, 0);
  if (!page.window || !make_webgl_context()) return false;
  ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.ConfigInputTextCursorBlink = false;  // it would draw for ever
  io.BackendFlags |= ImGuiBackendFlags_HasMouseCursors;
  page.renderer.start();
  return true;
}

}  // namespace

void browser::request_frame() { ask_for_frames(2); }
void browser::request_frame_after(double seconds) {
  drop_frame_after();
  page.frame_after =
      emscripten_set_timeout([](void*) { ask_for_frames(1); }, seconds * 1000 + 1, nullptr);
}
void browser::drop_frame_after() { emscripten_clear_timeout(page.frame_after); }

}  // namespace evenlift::view

using namespace evenlift::view;

extern "C" {

// The canvas measures `width` by `height` CSS pixels, and so many device pixels.
EMSCRIPTEN_KEEPALIVE void page_resize(double width, double height, double ratio, int device_width,
                                      int device_height) {
  Screen& screen = app().state.screen;
  screen.width = width;
  screen.height = height;
  screen.ratio = ratio;
  page.canvas_width = device_width;
  page.canvas_height = device_height;
  SDL_SetWindowSize(page.window, static_cast<int>(std::lround(width)),
                    static_cast<int>(std::lround(height)));
  // At once: between the resize and the next frame the browser would show the old frame stretched.
  if (page.frames > 0) draw();
  ask_for_frames(frames_after_input);
}

EMSCRIPTEN_KEEPALIVE void page_pinch(double x, double y, double factor) {
  page.input.pinch(evenlift::Vec2(x, y), factor);
  ask_for_frames(frames_after_input);
}

// The WebGL context is lost, or it is back. Everything that it held is gone; when it is back, the
// renderer begins anew and gets the fonts again.
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

EMSCRIPTEN_KEEPALIVE double page_frames() { return page.frames; }

}  // extern "C"

int main(int, char**) {
  if (!start()) return 1;
  SDL_AddEventWatch(on_event, nullptr);
  return 0;
}
