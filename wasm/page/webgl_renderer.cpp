#include "page/webgl_renderer.h"

#include <cmath>
#include <cstddef>

namespace evenlift::view {
namespace {

// The attributes' locations in the shader.
enum : GLuint { position, texture_position, colour, to_clip_space };

// `to_clip_space` holds a scale (x, y) and an offset (z, w) for all vertices. It is an attribute
// without an array, because the location of a uniform must be queried.
constexpr const char* vertex_shader = R"(#version 300 es
precision highp float;
layout(location = 0) in vec2 position;
layout(location = 1) in vec2 texture_position;
layout(location = 2) in vec4 colour;
layout(location = 3) in vec4 to_clip_space;
out vec2 at;
out vec4 tint;
void main() {
  at = texture_position;
  tint = colour;
  gl_Position = vec4(position * to_clip_space.xy + to_clip_space.zw, 0.0, 1.0);
}
)";

// A sampler's texture unit is 0 by default.
constexpr const char* fragment_shader = R"(#version 300 es
precision highp float;
uniform sampler2D image;
in vec2 at;
in vec4 tint;
layout(location = 0) out vec4 pixel;
void main() { pixel = tint * texture(image, at); }
)";

GLuint compile(GLenum kind, const char* source) {
  const GLuint shader = glCreateShader(kind);
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  return shader;
}

GLuint link_program() {
  const GLuint program = glCreateProgram();
  for (const GLuint shader :
       {compile(GL_VERTEX_SHADER, vertex_shader), compile(GL_FRAGMENT_SHADER, fragment_shader)}) {
    glAttachShader(program, shader);
    glDeleteShader(shader);  // lives as long as the program
  }
  glLinkProgram(program);
  return program;
}

void set_attribute(GLuint location, GLint count, GLenum type, bool normalized, std::size_t offset) {
  glEnableVertexAttribArray(location);
  glVertexAttribPointer(location, count, type, normalized ? GL_TRUE : GL_FALSE, sizeof(ImDrawVert),
                        reinterpret_cast<const void*>(offset));
}

GLuint make_texture() {
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  return texture;
}

void upload(int width, int height, const void* pixels) {
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
}

#if IMGUI_VERSION_NUM >= 19200
void destroy(ImTextureData& texture) {
  const GLuint name = texture.TexID;
  glDeleteTextures(1, &name);
  texture.SetTexID(ImTextureID_Invalid);
  texture.SetStatus(ImTextureStatus_Destroyed);  // created again if Dear ImGui still needs it
}

void answer(ImTextureData& texture) {
  switch (texture.Status) {
    case ImTextureStatus_WantCreate:
      texture.SetTexID(make_texture());
      upload(texture.Width, texture.Height, texture.GetPixels());
      texture.SetStatus(ImTextureStatus_OK);
      break;
    case ImTextureStatus_WantUpdates:
      glBindTexture(GL_TEXTURE_2D, texture.TexID);
      glPixelStorei(GL_UNPACK_ROW_LENGTH, texture.Width);
      for (const ImTextureRect& part : texture.Updates)
        glTexSubImage2D(GL_TEXTURE_2D, 0, part.x, part.y, part.w, part.h, GL_RGBA, GL_UNSIGNED_BYTE,
                        texture.GetPixelsAt(part.x, part.y));
      glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
      texture.SetStatus(ImTextureStatus_OK);
      break;
    case ImTextureStatus_WantDestroy:
      if (texture.UnusedFrames > 0) destroy(texture);
      break;
    case ImTextureStatus_OK:
    case ImTextureStatus_Destroyed:
      break;
  }
}
#endif

void draw_list(const ImDrawList& list, const ImDrawData& frame, int height) {
  static_assert(sizeof(ImDrawIdx) == 4 && sizeof(ImTextureID) == 4, "see imgui_config.h");
  glBufferData(GL_ARRAY_BUFFER, list.VtxBuffer.size_in_bytes(), list.VtxBuffer.Data,
               GL_STREAM_DRAW);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, list.IdxBuffer.size_in_bytes(), list.IdxBuffer.Data,
               GL_STREAM_DRAW);
  const ImVec2 origin = frame.DisplayPos, scale = frame.FramebufferScale;
  for (const ImDrawCmd& command : list.CmdBuffer) {
    IM_ASSERT(command.UserCallback == nullptr);  // evenlift adds no callbacks
    const ImVec4& clip = command.ClipRect;       // CSS pixels, y down
    const float left = (clip.x - origin.x) * scale.x, top = (clip.y - origin.y) * scale.y;
    const float right = (clip.z - origin.x) * scale.x, bottom = (clip.w - origin.y) * scale.y;
    if (right <= left || bottom <= top) continue;
    glScissor(static_cast<GLint>(left), static_cast<GLint>(static_cast<float>(height) - bottom),
              static_cast<GLsizei>(right - left), static_cast<GLsizei>(bottom - top));
    glBindTexture(GL_TEXTURE_2D, command.GetTexID());
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(command.ElemCount), GL_UNSIGNED_INT,
                   reinterpret_cast<const void*>(command.IdxOffset * sizeof(ImDrawIdx)));
  }
}

}  // namespace

void WebglRenderer::start() {
  program_ = link_program();
  glUseProgram(program_);
  glGenVertexArrays(1, &vertex_array_);
  glGenBuffers(1, &vertices_);
  glGenBuffers(1, &indices_);
  glBindVertexArray(vertex_array_);
  glBindBuffer(GL_ARRAY_BUFFER, vertices_);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_);
  set_attribute(position, 2, GL_FLOAT, false, offsetof(ImDrawVert, pos));
  set_attribute(texture_position, 2, GL_FLOAT, false, offsetof(ImDrawVert, uv));
  set_attribute(colour, 4, GL_UNSIGNED_BYTE, true, offsetof(ImDrawVert, col));
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
#if IMGUI_VERSION_NUM >= 19200
  ImGui::GetIO().BackendFlags |= ImGuiBackendFlags_RendererHasTextures;
  ImGuiPlatformIO& platform = ImGui::GetPlatformIO();
  platform.Renderer_TextureMaxWidth = platform.Renderer_TextureMaxHeight = 4096;  // the usual limit
#else
  fonts_ = make_texture();
#endif
}

void WebglRenderer::stop() {
#if IMGUI_VERSION_NUM >= 19200
  for (ImTextureData* texture : ImGui::GetPlatformIO().Textures)
    if (texture->TexID != ImTextureID_Invalid) destroy(*texture);
#endif
  glDeleteTextures(1, &fonts_);
  glDeleteBuffers(1, &indices_);
  glDeleteBuffers(1, &vertices_);
  glDeleteVertexArrays(1, &vertex_array_);
  glDeleteProgram(program_);
  *this = {};
}

void WebglRenderer::upload_fonts() {
#if IMGUI_VERSION_NUM < 19200
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  unsigned char* pixels = nullptr;
  int width = 0, height = 0;
  atlas.GetTexDataAsRGBA32(&pixels, &width, &height);
  glBindTexture(GL_TEXTURE_2D, fonts_);
  upload(width, height, pixels);
  atlas.SetTexID(fonts_);
#endif
}

void WebglRenderer::draw(ImDrawData& frame, const Colour& ground) {
#if IMGUI_VERSION_NUM >= 19200
  if (frame.Textures) {
    for (ImTextureData* texture : *frame.Textures) answer(*texture);
  }
#endif
  const auto pixels = [](float size, float scale) {
    return static_cast<int>(std::lround(size * scale));
  };
  const int width = pixels(frame.DisplaySize.x, frame.FramebufferScale.x);
  const int height = pixels(frame.DisplaySize.y, frame.FramebufferScale.y);
  const ImVec4 clear = ground.vec();
  glViewport(0, 0, width, height);
  glDisable(GL_SCISSOR_TEST);
  // The browser expects colours multiplied by their opacity.
  glClearColor(clear.x * clear.w, clear.y * clear.w, clear.z * clear.w, clear.w);
  glClear(GL_COLOR_BUFFER_BIT);
  glEnable(GL_SCISSOR_TEST);
  const float across = 2 / frame.DisplaySize.x, down = -2 / frame.DisplaySize.y;
  glVertexAttrib4f(to_clip_space, across, down, -1 - frame.DisplayPos.x * across,
                   1 - frame.DisplayPos.y * down);
  for (int i = 0; i < frame.CmdListsCount; ++i) draw_list(*frame.CmdLists[i], frame, height);
}

}  // namespace evenlift::view
