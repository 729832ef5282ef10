// SDL offers OpenGL's functions by name, which makes all of them part of the page's JavaScript: about 15 KB after
// compression for functions that nobody asks for. Dear ImGui calls the ones it needs directly.
extern "C" void* eglGetProcAddress(const char* name);
extern "C" void* eglGetProcAddress(const char*) { return nullptr; }
