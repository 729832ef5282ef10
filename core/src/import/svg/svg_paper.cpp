#include "import/svg/svg_paper.h"

#include <algorithm>
#include <cmath>

#include "import/svg/svg_values.h"
#include "numbers/text_cursor.h"

namespace evenlift {
namespace {

// In px, as in CSS.
constexpr double inch = 96;

struct Aspect {
  bool stretched = false, slice = false;
  double across = 0.5, down = 0.5;  // part of the free space before the drawing
};

double share(std::string_view word) { return word == "Min" ? 0 : word == "Max" ? 1 : 0.5; }

Aspect aspect_of(std::string_view text) {
  Aspect aspect;
  while (!(text = svg_trimmed(text)).empty()) {
    const std::size_t end = std::min(text.find_first_of(" \t\r\n,"), text.size());
    const std::string_view word = text.substr(0, end);
    text.remove_prefix(end);
    if (word == "none") aspect.stretched = true;
    if (word == "slice") aspect.slice = true;
    if (word.size() == 8 && word[0] == 'x' && word[4] == 'Y') {
      aspect.across = share(word.substr(1, 3));
      aspect.down = share(word.substr(5, 3));
    }
  }
  return aspect;
}

Vec2 scale_of(const Aspect& aspect, const Vec2& box, const Vec2& size) {
  const Vec2 scale(size.x / box.x, size.y / box.y);
  if (aspect.stretched) return scale;
  const double both = aspect.slice ? std::max(scale.x, scale.y) : std::min(scale.x, scale.y);
  return {both, both};
}

// In px; nullopt if invalid, in per cent or not above 0.
std::optional<double> side_in_pixels(std::string_view text) {
  const auto length = svg_length(text);
  const auto* pixels = std::get_if<std::optional<double>>(&length);
  if (pixels == nullptr || !*pixels || !(**pixels > 0)) return std::nullopt;
  return *pixels;
}

struct PaperUnit {
  std::string_view name;
  LengthUnit unit;
};
// Pixels are not a size on paper.
constexpr PaperUnit paper_units[] = {{"mm", LengthUnit::mm}, {"cm", LengthUnit::cm},
                                     {"in", LengthUnit::in}, {"pt", LengthUnit::mm},
                                     {"pc", LengthUnit::mm}, {"q", LengthUnit::mm}};

LengthUnit paper_unit(std::string_view length) {
  length = svg_trimmed(length);
  std::size_t letters = 0;
  while (letters < length.size() && is_letter(length[length.size() - letters - 1])) ++letters;
  for (const PaperUnit& unit : paper_units)
    if (same_word(length.substr(length.size() - letters), unit.name)) return unit.unit;
  return LengthUnit::none;
}

struct UnitSize {
  LengthUnit unit;
  double pixels;
};
constexpr UnitSize unit_sizes[] = {{LengthUnit::mm, inch / 25.4},
                                   {LengthUnit::cm, inch / 2.54},
                                   {LengthUnit::m, inch / 0.0254},
                                   {LengthUnit::in, inch}};

double pixels_of(LengthUnit unit) {
  for (const UnitSize& size : unit_sizes)
    if (size.unit == unit) return size.pixels;
  return 1;
}

// In px across and down; nullopt for a malformed view box.
std::optional<Vec2> user_unit(const SvgSize& size, const std::optional<SvgViewBox>& box,
                              std::optional<double> width, std::optional<double> height) {
  if (svg_trimmed(size.view_box).empty()) return Vec2(1, 1);
  if (!box || !(box->size.x > 0) || !(box->size.y > 0)) return std::nullopt;
  // A missing side follows from the other one.
  if (!width) width = *height * (box->size.x / box->size.y);
  if (!height) height = *width * (box->size.y / box->size.x);
  return scale_of(aspect_of(size.aspect), box->size, {*width, *height});
}

}  // namespace

std::optional<SvgViewBox> svg_view_box(std::string_view text) {
  const auto numbers = svg_numbers(text);
  const auto* values = std::get_if<std::vector<double>>(&numbers);
  if (values == nullptr || values->size() != 4) return std::nullopt;
  return SvgViewBox{{(*values)[0], (*values)[1]}, {(*values)[2], (*values)[3]}};
}

Affine fitted(const SvgViewBox& box, const Vec2& size, std::string_view aspect_text) {
  const Aspect aspect = aspect_of(aspect_text);
  const Vec2 scale = scale_of(aspect, box.size, size);
  const Vec2 room(size.x - scale.x * box.size.x, size.y - scale.y * box.size.y);
  const double across = aspect.stretched ? 0 : aspect.across * room.x;
  const double down = aspect.stretched ? 0 : aspect.down * room.y;
  return {scale.x, 0, 0, scale.y, across - scale.x * box.low.x, down - scale.y * box.low.y};
}

SvgPaper paper_of(const SvgSize& size) {
  SvgPaper paper;
  const std::optional<double> width = side_in_pixels(size.width),
                              height = side_in_pixels(size.height);
  const std::optional<SvgViewBox> box = svg_view_box(size.view_box);
  paper.viewport = {width, height};
  if (box) paper.viewport = {box->size.x, box->size.y};

  const LengthUnit of_width = width ? paper_unit(size.width) : LengthUnit::none;
  const LengthUnit of_height = height ? paper_unit(size.height) : LengthUnit::none;
  const LengthUnit written = of_width != LengthUnit::none ? of_width : of_height;
  if (written == LengthUnit::none) return paper;
  const std::optional<Vec2> pixels = user_unit(size, box, width, height);
  if (!pixels) return paper;

  constexpr double rounding = 1e-4;
  for (const UnitSize& unit : unit_sizes) {
    const Vec2 difference = *pixels - Vec2(unit.pixels, unit.pixels);
    if (!(max_norm(difference) < rounding * unit.pixels)) continue;
    paper.unit = unit.unit;
    return paper;
  }
  paper.unit = written;
  paper.across = pixels->x / pixels_of(written);
  paper.down = pixels->y / pixels_of(written);
  return paper;
}

}  // namespace evenlift
