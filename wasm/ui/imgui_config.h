// Dear ImGui's configuration. Every file that includes imgui.h includes this file through
// IMGUI_USER_CONFIG.
#pragma once

// Only current names, so that the view also builds with future versions.
#define IMGUI_DISABLE_OBSOLETE_FUNCTIONS
#define IMGUI_DISABLE_OBSOLETE_KEYIO

// The page shows neither the demo nor the debugging windows; it is smaller without them.
#define IMGUI_DISABLE_DEMO_WINDOWS
#define IMGUI_DISABLE_DEBUG_TOOLS

// A comb of 1,000 vertices has 45,000 candidates: more corners than 16 bits can count.
#define ImDrawIdx unsigned int

// The type of OpenGL's texture names.
#define ImTextureID unsigned int

// The browser handles files, and a page has no file system.
#define IMGUI_DISABLE_FILE_FUNCTIONS

// wasm/ui/fonts.cpp always provides fonts. From 1.92 on this omits Dear ImGui's default font;
// earlier versions have no switch for it.
#define IMGUI_DISABLE_DEFAULT_FONT

// IM_ASSERT stays assert(): active where assertions are, absent in the released page.
