// What libraries would bring into the page although nothing there uses it. Defined here, the linker
// leaves theirs out.
extern "C" {

// OpenGL's functions by name: SDL2 asks for this one, nothing calls it (Dear ImGui calls WebGL
// directly). EGL's own would make every function of OpenGL part of the page, 15 KB after
// compression.
void* eglGetProcAddress(const char* name);
void* eglGetProcAddress(const char*) { return nullptr; }

// Stands for sscanf in Dear ImGui, which reads its settings file with it
// (cmake/Dependencies.cmake).
int evenlift_reads_no_settings(const char* text, const char* format, ...);
int evenlift_reads_no_settings(const char*, const char*, ...) { return 0; }

}  // extern "C"
