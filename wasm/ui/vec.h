// Converts coordinates and points to Dear ImGui's points, which are stored as floats.
#pragma once

#include <imgui.h>

#include "evenlift/vec.h"

namespace evenlift::view {

inline ImVec2 vec(double x, double y) { return {static_cast<float>(x), static_cast<float>(y)}; }
inline ImVec2 vec(const Vec2& p) { return vec(p.x, p.y); }

}  // namespace evenlift::view
