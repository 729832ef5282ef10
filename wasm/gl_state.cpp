// Stands for glGetIntegerv in Dear ImGui's backend (cmake/Dependencies.cmake), which asks before
// each picture how things stand, to leave them so afterwards. Nobody but the backend draws here, so
// the answers are known; asking WebGL would wait for the graphics processor, several times a frame.
#include <GLES3/gl3.h>

#include <algorithm>

extern "C" void evenlift_gl_state(GLenum name, GLint* value);

extern "C" void evenlift_gl_state(GLenum name, GLint* value) {
  switch (name) {
    case GL_MAJOR_VERSION:
      *value = 3;
      break;
    case GL_ACTIVE_TEXTURE:
      *value = GL_TEXTURE0;
      break;
    case GL_BLEND_EQUATION_RGB:
    case GL_BLEND_EQUATION_ALPHA:
      *value = GL_FUNC_ADD;
      break;
    case GL_BLEND_SRC_RGB:
    case GL_BLEND_SRC_ALPHA:
      *value = GL_ONE;
      break;
    case GL_VIEWPORT:
    case GL_SCISSOR_BOX:
      std::fill_n(value, 4, 0);
      break;
    default:
      *value = 0;  // nothing bound
  }
}
