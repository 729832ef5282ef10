// Finds out how the elements of an SVG look, from attributes, style attributes, style sheets and
// inheritance.
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "curves/outline.h"
#include "evenlift/document.h"
#include "evenlift/vec.h"

namespace evenlift {

// The properties that decide whether and where an element is seen.
enum class SvgProperty : std::uint8_t {
  display,
  visibility,
  opacity,
  fill,
  fill_opacity,
  stroke,
  stroke_opacity,
  stroke_width,
  fill_rule,
  transform,
  transform_origin,
  transform_box,
  translate,
  rotate,
  scale,
  x,
  y,
  cx,
  cy,
  r,
  rx,
  ry,
  width,
  height,
  d,
  count
};
inline constexpr auto svg_property_count = static_cast<std::size_t>(SvgProperty::count);

// The values declared for one element; the value of a property that is not declared is empty.
struct SvgDeclared {
  std::array<std::string_view, svg_property_count> values;
  std::string_view operator[](SvgProperty property) const {
    return values[static_cast<std::size_t>(property)];
  }
};

// The value declared for this attribute of a shape, such as its width, which may also be a style; of
// `d`, the path without path(""). `otherwise` if there is none.
std::string_view geometry_of(const SvgDeclared& declared, std::string_view attribute,
                             std::string_view otherwise = {});

// The look of an element, which the elements in it inherit.
struct SvgLook {
  bool visible = true;
  bool fill = true, fill_opaque = true;
  bool white = false;   // the fill is white
  bool nonzero = true;  // the fill-rule is nonzero, not evenodd
  bool stroke = false, stroke_opaque = true, stroke_wide = true;
  bool is_filled() const { return fill && fill_opaque; }
  bool is_white_page() const { return is_filled() && white && !is_stroked(); }
  bool is_stroked() const { return stroke && stroke_opaque && stroke_wide; }
};

// Whether the element and all elements in it are hidden, because display is none or opacity is 0.
bool hides_all(const SvgDeclared& declared);
SvgLook inherited(SvgLook look, const SvgDeclared& declared);

// A drawing's style sheets. The selectors `tag`, `.class`, `#id`, `tag.class`, `tag#id`, `*` and
// lists of these are read; other selectors and at-rules are skipped. A declaration with
// `!important` wins over all without it; otherwise the highest specificity wins, and then the last
// declaration. Style sheets cannot be copied, since they contain views of their own text.
class SvgStyles {
 public:
  SvgStyles() = default;
  SvgStyles(const SvgStyles&) = delete;
  SvgStyles& operator=(const SvgStyles&) = delete;

  // Reads all <style> elements below the root that apply to screens. Returns false if there are
  // more than most_declarations declarations. O(bytes log bytes).
  static constexpr std::size_t most_declarations = std::size_t{1} << 18;
  bool read(const pugi::xml_node& root);

  // The values declared for this element, as views of the document and of these sheets, which must
  // outlive the result. O(bytes of its attributes, times the logarithm of the number of
  // declarations).
  SvgDeclared of(const pugi::xml_node& node) const;

  // Whether a rule with a skipped selector sets a fill or stroke. If so, shapes that seem to have
  // no paint may have some.
  bool skipped_paint() const { return skipped_paint_; }

 private:
  struct Selector {
    std::string_view tag, id, name_of_class;
    bool operator==(const Selector&) const = default;
    bool operator<(const Selector& other) const {
      return std::tie(tag, id, name_of_class) < std::tie(other.tag, other.id, other.name_of_class);
    }
  };
  struct Declaration {
    Selector selector;
    SvgProperty property;
    bool important;
    std::uint32_t order;
    std::string_view value;
  };
  class Cascade;

  static std::optional<Selector> simple_selector(std::string_view text);
  bool read_rules(std::string_view css);
  bool read_rule(std::string_view selectors, std::string_view body);
  void apply(const Selector& selector, Cascade& cascade) const;

  std::string text_;                       // without comments
  std::vector<Declaration> declarations_;  // sorted; one for each selector and property
  bool skipped_paint_ = false;
};

// --- Reads the view box of an SVG and its size on paper.

// The width and height to which lengths in per cent refer; either may be unknown.
struct SvgViewport {
  std::optional<double> width, height;
};

// The rectangle that is drawn, in user units. svg_view_box() returns nullopt if the text is not
// four numbers.
struct SvgViewBox {
  Vec2 low, size;
};
std::optional<SvgViewBox> svg_view_box(std::string_view text);

// Returns the map from `box`, in user units, to a rectangle of this size with a corner at the
// origin. `aspect` is the value of preserveAspectRatio; if empty, it counts as "xMidYMid meet". The
// sizes of both must be above 0. O(bytes).
Affine fitted(const SvgViewBox& box, const Vec2& size, std::string_view aspect);

// The attributes of the root element that give the drawing's size.
struct SvgSize {
  std::string_view width, height, view_box, aspect;
};

// The unit of a drawing on paper, and the factors from its user units to this unit. Without a size
// on paper there is no unit, and the factors are 1. Without a view box, a user unit is 1/96 inch.
// If a user unit is a millimetre, centimetre, inch or metre, up to the rounding of programs, this
// is the unit, and the factors are 1. Otherwise the unit is that of the written size, or
// millimetres if the size is in pt, pc or Q. paper_of() takes O(bytes).
struct SvgPaper {
  LengthUnit unit = LengthUnit::none;
  double across = 1, down = 1;
  SvgViewport viewport;  // in user units
};
SvgPaper paper_of(const SvgSize& size);

}  // namespace evenlift
