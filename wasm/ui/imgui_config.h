// Dear ImGui's configuration. imgui.h includes it through IMGUI_USER_CONFIG.
#pragma once

// Allows only current names, since future versions of Dear ImGui may drop the old ones.
#define IMGUI_DISABLE_OBSOLETE_FUNCTIONS
#define IMGUI_DISABLE_OBSOLETE_KEYIO

// The page shows neither demo windows nor debug tools, and is smaller without them.
#define IMGUI_DISABLE_DEMO_WINDOWS
#define IMGUI_DISABLE_DEBUG_TOOLS

// A comb of 1,000 vertices has 45,000 candidates, and drawing them takes more corners than 16 bits
// can count.
#define ImDrawIdx unsigned int

// The type of OpenGL's texture names.
#define ImTextureID unsigned int

// The browser handles files; a page has no file system.
#define IMGUI_DISABLE_FILE_FUNCTIONS

// wasm/ui/theme.cpp always provides fonts, so Dear ImGui's default font is omitted. Versions before
// 1.92 have no such switch.
#define IMGUI_DISABLE_DEFAULT_FONT

// IM_ASSERT stays assert(), which is absent in the released page.
