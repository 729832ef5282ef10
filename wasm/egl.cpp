// OpenGL's functions by name: SDL2 asks for this one, nothing here calls it (Dear ImGui calls WebGL
// directly). EGL's own would make every function of OpenGL part of the page, 15 KB after
// compression; defined here, the linker leaves it out.
extern "C" {
void* eglGetProcAddress(const char* name);
void* eglGetProcAddress(const char*) { return nullptr; }
}
