// Dear ImGui as evenlift uses it. Every file that includes imgui.h sees this one, by
// IMGUI_USER_CONFIG.
#pragma once

// Only today's names, so that the view builds with the versions to come as well.
#define IMGUI_DISABLE_OBSOLETE_FUNCTIONS
#define IMGUI_DISABLE_OBSOLETE_KEYIO

// The page shows neither the demo nor the debugging windows; without them it is smaller.
#define IMGUI_DISABLE_DEMO_WINDOWS
#define IMGUI_DISABLE_DEBUG_TOOLS

// A comb of 1,000 vertices has 45,000 candidates: more corners than 16 bits count.
#define ImDrawIdx unsigned int

// The name that OpenGL gives a texture.
#define ImTextureID unsigned int

// Files are the browser's business, and a page has no file system.
#define IMGUI_DISABLE_FILE_FUNCTIONS

// wasm/ui/fonts.cpp always gives fonts. From 1.92 on this leaves out the one that Dear ImGui would
// fall back to; earlier versions have no switch for it.
#define IMGUI_DISABLE_DEFAULT_FONT

// IM_ASSERT stays assert(): on where assertions are on, gone in the released page.
