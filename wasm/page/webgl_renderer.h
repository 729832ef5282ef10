// Draws a frame of Dear ImGui with WebGL 2.
//
// Nothing else draws on the canvas. So constant state is set once, nothing is restored after a
// frame, and no WebGL state is queried: queries would wait for the graphics processor.
#pragma once

#include <GLES3/gl3.h>
#include <imgui.h>

#include "ui/theme.h"

namespace evenlift::view {

class WebglRenderer {
 public:
  // Creates the resources in the current WebGL context, and registers the renderer's features with
  // Dear ImGui. Call it after ImGui::CreateContext(), and again when a lost context returns.
  void start();

  // Drops all resources. Call it when the context is lost.
  void stop();

  // Uploads the font atlas. Call it after start() and after every change of the atlas, before
  // ImGui::NewFrame(). From version 1.92 on, Dear ImGui requests its textures itself, and this
  // function does nothing.
  void upload_fonts();

  // Draws a frame on this background. O(vertices + indices).
  void draw(ImDrawData& frame, const Colour& ground);

 private:
  GLuint program_ = 0, vertex_array_ = 0, vertices_ = 0, indices_ = 0, fonts_ = 0;
};

}  // namespace evenlift::view
