// The page's start-up and its frames: SDL2 gives the canvas, WebGL 2 and events, Dear ImGui draws.
// A frame is drawn only when something asked for one. Dear ImGui's own backend for SDL2 is not
// used: it reads the mouse where it is now, not where it was pressed, draws at whole CSS pixels and
// brings gamepads along.
#include <GLES3/gl3.h>
#include <SDL.h>
#include <emscripten/emscripten.h>
#include <emscripten/html5.h>
#include <imgui.h>
#include <imgui_impl_opengl3.h>

#include <algorithm>
#include <cmath>

#include "browser.h"
#include "page_api.h"
#include "sdl_input.h"
#include "theme.h"

namespace evenlift::view {
namespace {

// Dear ImGui needs more than one frame to settle: what a click opens is measured in the next one
// and hovered in the one after.
constexpr int frames_after_input = 3;

struct Page {
  SDL_Window* window = nullptr;
  SDL_GLContext context = nullptr;
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
#if IMGUI_VERSION_NUM >= 19200
  if (page.fonts_for_ratio == 0)
    load_fonts(ratio);  // from then on it rasterises for whatever scale it finds
#else
  load_fonts(ratio);
  // Before the first frame there is nothing to replace; the backend makes the texture by itself.
  if (page.fonts_for_ratio != 0) {
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
  }
#endif
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
  ImGui_ImplOpenGL3_NewFrame();
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
  const ImVec4 clear = ground.vec();
  glViewport(0, 0, page.canvas_width, page.canvas_height);
  glClearColor(clear.x, clear.y, clear.z, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  SDL_GL_SwapWindow(page.window);
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

bool start_drawing() { return ImGui_ImplOpenGL3_Init("#version 300 es"); }

bool start() {
  SDL_SetHint(SDL_HINT_EMSCRIPTEN_KEYBOARD_ELEMENT, "#canvas");
  SDL_SetHint(SDL_HINT_TOUCH_MOUSE_EVENTS, "0");  // sdl_input.cpp tells fingers apart itself
  if (SDL_Init(SDL_INIT_VIDEO) != 0) return false;
  SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, SDL_GL_CONTEXT_PROFILE_ES);
  SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, 3);
  SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, 0);
  SDL_GL_SetAttribute(SDL_GL_ALPHA_SIZE, 0);
  SDL_GL_SetAttribute(SDL_GL_DEPTH_SIZE, 0);
  page.window = SDL_CreateWindow("evenlift", 0, 0, 1280, 800, SDL_WINDOW_OPENGL);
  if (!page.window) return false;
  page.context = SDL_GL_CreateContext(page.window);
  if (!page.context) return false;
  ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.ConfigInputTextCursorBlink = false;  // it would draw for ever
  io.BackendFlags |= ImGuiBackendFlags_HasMouseCursors;
  return start_drawing();
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

// Everything that was on a lost context is gone with it. The backend lets go while it is lost, when
// that does no harm, and starts afresh when it is back.
EMSCRIPTEN_KEEPALIVE void page_context(int lost) {
  if (page.context_lost == (lost != 0)) return;
  page.context_lost = lost != 0;
  page.frame_scheduled = false;
  if (page.context_lost) {
    ImGui_ImplOpenGL3_Shutdown();
  } else {
    start_drawing();
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
