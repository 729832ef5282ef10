// Draws what Dear ImGui made of a frame, with WebGL 2.
//
// Nothing else draws on the canvas. So the state that never changes is set once, nothing is put
// back after a frame, and WebGL is asked nothing: an answer would have to wait for the graphics
// processor.
#pragma once

#include <GLES3/gl3.h>
#include <imgui.h>

#include "ui/theme.h"

namespace evenlift::view {

class WebglRenderer {
 public:
  // Makes what drawing needs in the current WebGL context, and tells Dear ImGui what the renderer
  // can do. Call it after ImGui::CreateContext(), and again when a lost WebGL context is back.
  void start();

  // Gives up everything that the WebGL context held. Call it when the context is lost.
  void stop();

  // Hands the font atlas to the graphics processor. Call it after start() and after every change
  // of the atlas, before ImGui::NewFrame(). From 1.92 on Dear ImGui itself asks for its textures.
  void upload_fonts();

  // Draws a whole frame on the given ground. In time proportional to the vertices and indices.
  void draw(ImDrawData& frame, const Colour& ground);

 private:
  GLuint program_ = 0, vertex_array_ = 0, vertices_ = 0, indices_ = 0, fonts_ = 0;
};

}  // namespace evenlift::view
