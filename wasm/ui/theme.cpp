#include "ui/theme.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

#include "evenlift/wording.h"

namespace evenlift::view {
namespace {

// The page gives the files that its HTML also uses (page_fonts()); natively they are embedded.
#ifdef __EMSCRIPTEN__
constexpr unsigned char regular[] = {0}, semibold[] = {0};
#else
constexpr unsigned char regular[] = {
#include "Inter-Regular.otf.inc"
};
constexpr unsigned char semibold[] = {
#include "Inter-SemiBold.otf.inc"
};
#endif

// Kept for as long as Dear ImGui may read them.
std::vector<unsigned char> given_regular, given_semibold;

FontData data_of(const std::vector<unsigned char>& bytes) {
  return {bytes.data(), static_cast<int>(bytes.size())};
}

}  // namespace

FontData regular_font() {
  return given_regular.empty() ? FontData{regular, sizeof regular} : data_of(given_regular);
}
FontData semibold_font() {
  return given_semibold.empty() ? FontData{semibold, sizeof semibold} : data_of(given_semibold);
}

void give_fonts(std::vector<unsigned char> regular_bytes,
                std::vector<unsigned char> semibold_bytes) {
  given_regular = std::move(regular_bytes);
  given_semibold = std::move(semibold_bytes);
}

namespace {

// At least the characters of assets/fonts/subset.py that the page itself writes; those that a font
// lacks take no room.
constexpr ImWchar always[] = {0x20, 0xFF, 0x2009, 0x203A, 0x2192, 0x2192, 0x2212, 0x2265};

// Rasterised together, since a text seldom needs one character alone.
constexpr unsigned block = 0x80;
constexpr unsigned beyond = 0x10000;  // Dear ImGui's characters have 16 bits

struct Letters {
  std::set<unsigned> wanted, sought;  // characters
  std::vector<ImWchar> ranges;
  bool here = false;
};
Letters letters;

struct Decoded {
  unsigned character;
  std::size_t bytes;
};

// Of a non-empty UTF-8 text; stray and truncated bytes are decoded singly.
Decoded decode(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned first = byte(0);
  const std::size_t bytes = first < 0xC0 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
  if (bytes == 1 || bytes > text.size()) return {first, 1};
  unsigned character = first & (0x7Fu >> bytes);
  for (std::size_t i = 1; i < bytes; ++i) character = character << 6 | (byte(i) & 0x3Fu);
  return {character, bytes};
}

std::string encode(unsigned c) {
  std::string text;
  if (c < 0x800) {
    text += static_cast<char>(0xC0 | c >> 6);
  } else {
    if (c < beyond) {
      text += static_cast<char>(0xE0 | c >> 12);
    } else {
      text += static_cast<char>(0xF0 | c >> 18);
      text += static_cast<char>(0x80 | (c >> 12 & 0x3F));
    }
    text += static_cast<char>(0x80 | (c >> 6 & 0x3F));
  }
  text += static_cast<char>(0x80 | (c & 0x3F));
  return text;
}

bool has(const ImFont& font, unsigned c) {
  return c < beyond && font.FindGlyphNoFallback(static_cast<ImWchar>(c)) != nullptr;
}

}  // namespace

void note_letters(const ImFont& font, std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const auto [c, bytes] = decode(text.substr(at));
    at += bytes;
    if (c >= 0x80 && !has(font, c) && !letters.sought.contains(c)) letters.wanted.insert(c);
  }
}

bool letters_are_due() { return !letters.wanted.empty(); }
bool letters_are_here() { return letters.here; }
void have_letters() { letters.here = true; }

const ImWchar* letter_ranges() {
  if (letters.here) letters.sought.merge(letters.wanted);
  letters.wanted.clear();
  std::set<unsigned> blocks;
  for (const unsigned c : letters.sought)
    if (c < beyond) blocks.insert(c / block);
  letters.ranges.assign(std::begin(always), std::end(always));
  for (const unsigned b : blocks) {
    letters.ranges.push_back(static_cast<ImWchar>(std::max(b * block, 0x20u)));
    letters.ranges.push_back(static_cast<ImWchar>(b * block + block - 1));
  }
  letters.ranges.push_back(0);
  return letters.ranges.data();
}

std::string absent_letters(const ImFont& font) {
  static std::set<unsigned> told;
  std::string text;
  for (const unsigned c : letters.sought)
    if (!has(font, c) && told.insert(c).second) text += encode(c);
  return text;
}

namespace {

std::vector<DrawnText>* recorded = nullptr;

}  // namespace

void record_texts(std::vector<DrawnText>* record) { recorded = record; }

void note_drawn(std::string_view text) {
  if (recorded) recorded->push_back({std::string(text), true});
}

void note_room(std::string_view text, float width, float room) {
  constexpr float rounding = 0.5f;
  if (recorded && width > room + rounding)
    recorded->push_back({std::string(translated(text)), false});
}

namespace {

// Style sheets and pictures repeat some of these (tests/view/check_palette.py).
constexpr Theme light = {
    .ground = {0xEEF1F4},
    .dots = {0xD0D7DE},
    .object = {0xFFFFFF},
    .object_outline = {0x2B3540},
    .panel = {0xFFFFFF},
    .panel_line = {0xD5DBE1},
    .well = {0xEEF1F4},
    .text = {0x1B232B},
    .second_text = {0x55616D},
    .quiet = {0x8592A0},
    .hull = {0x2FA36B, 0.24f},
    .hull_outline = {0x1F7A4E},
    .hull_text = {0x14603B},
    .heat = {{0xA63A00}, {0xC75A12}, {0xDE7F33}, {0xEDA565}, {0xF6C898}, {0xFBE3C8}, {0xD3EDDF}},
    .clockwise = {0xD1495B, 0.16f},
    .clockwise_line = {0xD1495B},
    .counter = {0x2D6CDF, 0.16f},
    .counter_line = {0x2D6CDF},
    .robot = {0x1B232B},
    .robot_ring = {0x1B232B},
    .robot_track = {0xFFFFFF},
    .robot_text = {0xFFFFFF},
    .chord = {0x55616D},
    .candidate = {0x66727E},
    .accent = {0x5B4BDB},
    .on_accent = {0xFFFFFF},
    .amber = {0x9A5B00},
    .amber_ground = {0xFFF4E0},
    .red = {0xC62F43},
    .accent_on_object = {0x5B4BDB},
    .amber_on_object = {0x8F5400},
    .shadow = {0x1B232B, 0.10f},
};

constexpr Theme dark = {
    .ground = {0x14181D},
    .dots = {0x2A323B},
    .object = {0xE6EBF0},
    .object_outline = {0xFFFFFF},
    .panel = {0x1D232A},
    .panel_line = {0x2D3640},
    .well = {0x14181D},
    .text = {0xE8EDF2},
    .second_text = {0x9AA7B4},
    .quiet = {0x6B7885},
    .hull = {0x3BBF80, 0.30f},
    .hull_outline = {0x1C8A56},
    .hull_text = {0x0E5433},
    .heat = {{0xB0480A}, {0xCC6A24}, {0xDF8C48}, {0xEBAE78}, {0xF1CBA6}, {0xF3E0CD}, {0xBFE3D0}},
    .clockwise = {0xF0697B, 0.20f},
    .clockwise_line = {0xD1495B},
    .counter = {0x5B93FF, 0.20f},
    .counter_line = {0x2D6CDF},
    .robot = {0x0B0E11},
    .robot_ring = {0xFFFFFF},
    .robot_track = {0x0B0E11},
    .robot_text = {0xFFFFFF},
    .chord = {0x6A7683},
    .candidate = {0x66727E},
    .accent = {0x9C90FF},
    .on_accent = {0x14181D},
    .amber = {0xF2B04A},
    .amber_ground = {0x33291A},
    .red = {0xFF8A96},
    .accent_on_object = {0x5B4BDB},
    .amber_on_object = {0x8F5400},
    .shadow = {0x000000, 0.35f},
};

// In pixels. Dear ImGui counts a font's whole line, which is higher.
struct FaceSpec {
  bool semibold;
  float letters;
};
constexpr FaceSpec faces[] = {{true, 11}, {false, 13}, {true, 13}, {false, 15},
                              {true, 15}, {true, 20},  {false, 20}};
static_assert(std::size(faces) == static_cast<std::size_t>(Face::end_of_faces));
constexpr float line_of_inter = 1.21f, line_of_text = 1.4f;

ImFont* loaded[std::size(faces)];

const FaceSpec& spec(Face face) { return faces[static_cast<int>(face)]; }

}  // namespace

ImU32 Colour::packed() const {
  return (rgb >> 16 & 0xFF) << IM_COL32_R_SHIFT | (rgb >> 8 & 0xFF) << IM_COL32_G_SHIFT |
         (rgb & 0xFF) << IM_COL32_B_SHIFT |
         static_cast<ImU32>(std::lround(opacity * 255)) << IM_COL32_A_SHIFT;
}

ImVec4 Colour::vec() const {
  return {static_cast<float>(rgb >> 16 & 0xFF) / 255, static_cast<float>(rgb >> 8 & 0xFF) / 255,
          static_cast<float>(rgb & 0xFF) / 255, opacity};
}

Colour heat_colour(const Theme& theme, double share) {
  std::size_t band = 0;
  while (band < std::size(heat_levels) && share >= heat_levels[band]) ++band;
  if (share > heat_levels[std::size(heat_levels) - 1]) ++band;
  return theme.heat[band];
}

const Theme& theme(const AppState& state) { return state.session.screen.dark ? dark : light; }

void load_fonts(double ratio) {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
#if IMGUI_VERSION_NUM >= 19200
  // From this version on Dear ImGui itself rasterises for the framebuffer's scale.
  static_cast<void>(ratio);
  if (!atlas.Fonts.empty()) return;
  const float density = 1;
#else
  // Higher density is not visible, and could need too large a texture.
  const float density = static_cast<float>(std::min(ratio, 4.0));
#endif
  atlas.Clear();
  const ImWchar* ranges = letter_ranges();
  for (std::size_t i = 0; i < std::size(faces); ++i) {
    ImFontConfig config;
    config.FontDataOwnedByAtlas = false;
    config.OversampleH = density > 1.5f ? 1 : 2;
    const FontData data = faces[i].semibold ? semibold_font() : regular_font();
    // The atlas only reads data that it does not own.
    loaded[i] = atlas.AddFontFromMemoryTTF(const_cast<unsigned char*>(data.bytes), data.size,
                                           size(static_cast<Face>(i)) * density, &config, ranges);
#if IMGUI_VERSION_NUM < 19200
    loaded[i]->Scale = 1 / density;
#endif
  }
}

void push_face(Face face) {
#if IMGUI_VERSION_NUM >= 19200
  ImGui::PushFont(font(face), size(face));
#else
  ImGui::PushFont(font(face));
#endif
}

void pop_face() { ImGui::PopFont(); }

ImFont* font(Face face) { return loaded[static_cast<int>(face)]; }
float size(Face face) { return spec(face).letters * line_of_inter; }
float line_height(Face face) { return std::round(spec(face).letters * line_of_text); }

ImVec2 text_size(Face face, std::string_view english, float wrap_width) {
  const std::string_view text = translated(english);
  return font(face)->CalcTextSizeA(size(face), 1e9f, wrap_width, text.data(),
                                   text.data() + text.size());
}

void draw_text(ImDrawList& list, Face face, ImVec2 at, Colour colour, std::string_view english,
               float wrap_width) {
  const std::string_view text = translated(english);
  note_letters(*font(face), text);
  note_drawn(text);
  list.AddText(font(face), size(face), at, colour.packed(), text.data(), text.data() + text.size(),
               wrap_width);
}

void apply_style(const AppState& state, double control_height) {
  const Theme& t = theme(state);
  ImGuiStyle& s = ImGui::GetStyle();
  s = ImGuiStyle();
  s.WindowPadding = {20, 20};
  s.WindowRounding = s.PopupRounding = 10;
  s.WindowBorderSize = s.PopupBorderSize = 1;
  s.FrameRounding = 7;
  s.FrameBorderSize = 0;
  s.FramePadding = {12, (static_cast<float>(control_height) - size(Face::text)) / 2};
  s.ItemSpacing = {8, 7};
  s.ItemInnerSpacing = {8, 4};
  s.ScrollbarSize = 10;
  s.ScrollbarRounding = 5;
  s.GrabRounding = 5;
  s.WindowMinSize = {8, 8};
  s.Colors[ImGuiCol_Text] = t.text.vec();
  s.Colors[ImGuiCol_TextDisabled] = t.second_text.vec();
  s.Colors[ImGuiCol_WindowBg] = t.panel.vec();
  s.Colors[ImGuiCol_ChildBg] = t.panel.at(0).vec();
  s.Colors[ImGuiCol_PopupBg] = t.panel.vec();
  s.Colors[ImGuiCol_Border] = t.panel_line.vec();
  s.Colors[ImGuiCol_BorderShadow] = t.panel.at(0).vec();
  s.Colors[ImGuiCol_FrameBg] = t.well.vec();
  s.Colors[ImGuiCol_FrameBgHovered] = t.panel_line.vec();
  s.Colors[ImGuiCol_FrameBgActive] = t.panel_line.vec();
  s.Colors[ImGuiCol_Button] = t.well.vec();
  s.Colors[ImGuiCol_ButtonHovered] = t.panel_line.vec();
  s.Colors[ImGuiCol_ButtonActive] = t.panel_line.vec();
  s.Colors[ImGuiCol_Header] = t.accent.at(0.14f).vec();
  s.Colors[ImGuiCol_HeaderHovered] = t.accent.at(0.10f).vec();
  s.Colors[ImGuiCol_HeaderActive] = t.accent.at(0.20f).vec();
  s.Colors[ImGuiCol_ScrollbarBg] = t.panel.at(0).vec();
  s.Colors[ImGuiCol_ScrollbarGrab] = t.panel_line.vec();
  s.Colors[ImGuiCol_ScrollbarGrabHovered] = t.quiet.vec();
  s.Colors[ImGuiCol_ScrollbarGrabActive] = t.quiet.vec();
  s.Colors[ImGuiCol_TextSelectedBg] = t.accent.at(0.30f).vec();
  s.Colors[ImGuiCol_Separator] = t.panel_line.vec();
}

void sharpen(ImDrawList& list, const AppState& state) {
  list._FringeScale = static_cast<float>(1 / state.session.screen.ratio);
}

}  // namespace evenlift::view
