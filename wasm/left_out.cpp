// What libraries would bring into the page although nothing there uses it. Defined here, the linker
// leaves theirs out.
#include <SDL_surface.h>

#include <cstdarg>
#include <cstdlib>
#include <string_view>

extern "C" {

// OpenGL's functions by name: SDL2 asks for this one, nothing calls it (Dear ImGui calls WebGL
// directly). EGL's own would make every function of OpenGL part of the page, 15 KB after
// compression.
void* eglGetProcAddress(const char* name);
void* eglGetProcAddress(const char*) { return nullptr; }

// Stands for sscanf in Dear ImGui (cmake/Dependencies.cmake), of whose calls the page needs one:
// the backend's, for the number in "#version 300 es".
int evenlift_scan(const char* text, const char* format, ...);
int evenlift_scan(const char* text, const char* format, ...) {
  const std::string_view version = "#version ";
  if (!std::string_view(format).starts_with(version) ||
      !std::string_view(text).starts_with(version))
    return 0;
  std::va_list arguments;
  va_start(arguments, format);
  *va_arg(arguments, int*) = std::atoi(text + version.size());
  va_end(arguments);
  return 1;
}

// SDL2's software surfaces: pictures for icons, cursors and windows without OpenGL, 6 KB after
// compression. Weak, so that SDL2's own win where they come along for another reason.
#define LEFT_OUT __attribute__((weak))
LEFT_OUT SDL_Surface* SDL_CreateRGBSurface(Uint32, int, int, int, Uint32, Uint32, Uint32, Uint32) {
  return nullptr;
}
LEFT_OUT SDL_Surface* SDL_CreateRGBSurfaceFrom(void*, int, int, int, int, Uint32, Uint32, Uint32,
                                               Uint32) {
  return nullptr;
}
LEFT_OUT SDL_Surface* SDL_ConvertSurfaceFormat(SDL_Surface*, Uint32, Uint32) { return nullptr; }
LEFT_OUT void SDL_FreeSurface(SDL_Surface*) {}
LEFT_OUT int SDL_LockSurface(SDL_Surface*) { return -1; }
LEFT_OUT void SDL_UnlockSurface(SDL_Surface*) {}

}  // extern "C"
