// SVG drawings: elements, entities, attributes, styles, paper, and their reader.
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "curves/outline.h"
#include "evenlift/document.h"
#include "evenlift/result.h"
#include "evenlift/vec.h"
#include "evenlift/wording.h"
#include "import/gathering.h"

namespace evenlift {

// --- Names and attributes of SVG elements.

// The name without its prefix: "href" for "xlink:href".
inline std::string_view without_prefix(std::string_view name) {
  const std::size_t colon = name.rfind(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

inline std::string_view local_name(const pugi::xml_node& node) {
  return without_prefix(node.name());
}

// Whether the element's prefix, if it has one, stands for another namespace than SVG.
inline bool is_foreign(const pugi::xml_node& node) {
  const std::string_view name = node.name();
  const std::size_t colon = name.find(':');
  if (colon == std::string_view::npos) return false;
  const std::string declared = "xmlns:" + std::string(name.substr(0, colon));
  constexpr int most_looked_at = 100;  // of the attributes of an element
  for (pugi::xml_node each = node; each; each = each.parent()) {
    int looked_at = 0;
    for (const pugi::xml_attribute attribute : each.attributes()) {
      if (++looked_at > most_looked_at) break;
      if (declared == attribute.name())
        return std::string_view(attribute.value()) != "http://www.w3.org/2000/svg";
    }
  }
  return false;  // a prefix that nothing declares is taken for SVG's
}

inline std::string_view value_of(const pugi::xml_node& node, const char* attribute) {
  return node.attribute(attribute).value();
}

// --- Entities that an SVG declares for itself: <!ENTITY plate "<rect … />">.

// The text with the values of its own entities in their places; empty if it declares none. Entities
// of other files are left as they are. It is an error if entities contain each other more than eight
// deep, or if the text becomes longer than 64 MiB. O(the longer text).
Result<std::optional<std::string>> with_entities(std::string_view text);

// --- Parsers of SVG attributes.

// A problem, as part of a sentence, such as "character 7: not a number".
struct SvgProblem {
  std::string what;
};
template <class T>
using SvgResult = std::variant<T, SvgProblem>;

// Reads a list of numbers separated by white space and commas. O(bytes).
SvgResult<std::vector<double>> svg_numbers(std::string_view text);

// The text without white space and commas at its ends. O(bytes).
std::string_view svg_trimmed(std::string_view text);

// Returns a length in user units. The text is a number, perhaps with a unit such as mm or with %,
// which means per cent of `whole`. An inch is 96 user units. Empty text and "auto" give nullopt.
// O(bytes).
SvgResult<std::optional<double>> svg_length(std::string_view text,
                                            std::optional<double> whole = std::nullopt);

// Moves every point by (x, y).
Affine translation(double x, double y);

// Reads a transform in the syntax of the attribute, or of CSS, which also has units and more
// functions: translateX(1mm), rotate(90deg), skew(1rad). Empty text and "none" give the identity.
// O(bytes).
SvgResult<Affine> svg_transform(std::string_view text);

// Reads a point such as "center", "10px 20px" or "left 25%" in a box at the origin. A point that
// depends on an unknown width or height of the box is a problem. Empty text gives the origin.
// O(bytes).
SvgResult<Vec2> svg_transform_origin(std::string_view text, std::optional<double> width,
                                     std::optional<double> height);

// One part of a path.
struct SvgOutline {
  Outline outline;
  bool closed;
};
SvgResult<std::vector<SvgOutline>> svg_path(std::string_view text);

// --- Finds out how the elements of an SVG look, from attributes, style attributes, style sheets and
// inheritance.

// The properties that decide whether and where an element is seen. The last three may not be
// attributes, only styles.
inline constexpr std::string_view svg_properties[] = {"display",
                                                      "visibility",
                                                      "opacity",
                                                      "fill",
                                                      "fill-opacity",
                                                      "stroke",
                                                      "stroke-opacity",
                                                      "stroke-width",
                                                      "fill-rule",
                                                      "transform",
                                                      "transform-origin",
                                                      "transform-box",
                                                      "x",
                                                      "y",
                                                      "cx",
                                                      "cy",
                                                      "r",
                                                      "rx",
                                                      "ry",
                                                      "width",
                                                      "height",
                                                      "d",
                                                      "clip-path",
                                                      "mask",
                                                      "translate",
                                                      "rotate",
                                                      "scale"};
inline constexpr std::size_t svg_property_count = std::size(svg_properties);

// The place of the name in svg_properties, in upper or lower case; svg_property_count if it is none.
std::size_t svg_property(std::string_view name);

// The values declared for one element; the value of a property that is not declared is empty.
struct SvgDeclared {
  std::array<std::string_view, svg_property_count> values;
  // Of a property in svg_properties.
  std::string_view operator[](std::string_view property) const {
    return values.at(svg_property(property));
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
  // The first selector or condition that is not understood, whose rule was skipped; or empty.
  std::string_view skipped() const { return skipped_; }

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
    std::size_t property;  // in svg_properties
    bool important;
    std::uint32_t order;
    std::string_view value;
  };
  class Cascade;

  static std::optional<Selector> simple_selector(std::string_view text);
  bool read_rules(std::string_view css);
  bool read_at_rule(std::string_view heading, std::string_view block);
  bool read_rule(std::string_view selectors, std::string_view body);
  void skip(std::string_view what);
  void apply(const Selector& selector, Cascade& cascade) const;

  std::string text_;                       // without comments
  std::vector<Declaration> declarations_;  // sorted; one for each selector and property
  bool skipped_paint_ = false;
  std::string_view skipped_;
  int depth_ = 0;  // of blocks
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

// --- Gathers the visible shapes of one SVG.

class SvgReader {
 public:
  SvgReader(std::string_view text, const ImportOptions& options)
      : text_(text), options_(options), gathering_(options) {}
  Result<Import> read();

 private:
  // The properties that an element inherits from the elements around it.
  struct Context {
    Affine matrix;
    std::string_view layer;         // the nearest group's label, else the name of the copying <use>
    std::string_view name_of_copy;  // the name of the <use> that copies this element
    std::string_view title;         // of the nearest group that has one
    SvgViewport viewport;
    SvgLook look;
    SvgDeclared declared = {};  // for the element itself, if it is drawn
    bool in_copy = false;
    // What clip paths leave, if they are rectangles; `is_cut` if another one, or a mask, cuts.
    std::optional<Box> window = {};
    bool is_cut = false;
  };
  // The greatest number of bytes in all copies together. Without a limit, copies of copies could
  // multiply almost without end. An element counts as 64 bytes, plus its attributes' values.
  static constexpr std::size_t most_copied_bytes = std::size_t{1} << 26;

  // A path with a fill and without a stroke.
  struct FilledPath {
    std::string_view d;
    Affine matrix;
  };

  // svg.cpp defines these functions, which read the document.
  InputError error_at(const pugi::xml_node& node, ErrorCode code, std::string message) const;
  void problem(const pugi::xml_node& node, const std::string& what);
  // Returns the value, or reports the problem and returns nullopt; the caller then leaves out the
  // shape.
  template <class T>
  std::optional<T> checked(const pugi::xml_node& node, const char* what, SvgResult<T> result) {
    if (auto* wrong = std::get_if<SvgProblem>(&result)) {
      problem(node, say("the SVG's {part}, {problem}", {what, wrong->what}));
      return std::nullopt;
    }
    return std::get<0>(std::move(result));
  }
  Result<pugi::xml_node> load();
  void walk(const pugi::xml_node& root, const SvgPaper& paper);
  void start_again();
  void say_what_is_unseen();
  InputError nothing_found() const;

  // svg_tree.cpp defines these functions, for elements, groups and copies.
  void children(const pugi::xml_node& parent, const Context& context, int depth);
  void element(const pugi::xml_node& node, const Context& context, int depth);
  void name_layer(const pugi::xml_node& node, Context& inside);
  void copy(const pugi::xml_node& node, Context& inside, int depth);
  // Reads an element that has its own viewport. `sized` is the element whose width and height take
  // precedence: the <use> that copies `node`, or `node` itself.
  void nested(const pugi::xml_node& node, const pugi::xml_node& sized, Context& inside, int depth);
  bool enter(const pugi::xml_node& node, std::string_view name, Context& inside);
  bool transform(const pugi::xml_node& node, const SvgDeclared& declared, Context& inside);
  void take_cuts(const SvgDeclared& declared, Context& inside);
  std::optional<Box> window_of(std::string_view reference, const Context& inside);
  pugi::xml_node node_of(std::string_view id);
  void take_text(const pugi::xml_node& node, const SvgDeclared& declared, const Context& inside);
  bool leaves_out(const pugi::xml_node& node, std::string_view name, const Context& inside);
  void hide(const pugi::xml_node& node, const Context& context);
  bool has_room_to_copy(const pugi::xml_node& node);
  void index_ids();
  pugi::xml_node original_of(const pugi::xml_node& node);
  void too_deep(const pugi::xml_node& node);
  void stop(InputError error) {
    if (!error_) error_ = std::move(error);
  }
  bool full() const { return error_ || gathering_.full() || piece_points_ > max_vertices; }

  // svg_shapes.cpp defines these functions, for the drawn shapes.
  void shape(const pugi::xml_node& node, const Context& context, std::string_view name);
  bool is_stroke_of_filled(const Context& context);
  void path(const pugi::xml_node& node, const Context& context, const std::string& called);
  void points(const pugi::xml_node& node, const Context& context, const std::string& called,
              bool closed);
  void rectangle(const pugi::xml_node& node, const Context& context, const std::string& called);
  void ellipse(const pugi::xml_node& node, const Context& context, const std::string& called,
               bool circle);
  void line(const pugi::xml_node& node, const Context& context, const std::string& called);
  std::string called(const pugi::xml_node& node, const Context& context) const;
  // The length given by the attribute, in user units; percentages refer to the context's viewport.
  // The inner optional is empty if no length is given, the outer one if there is a problem.
  std::optional<std::optional<double>> length(const pugi::xml_node& node, const Context& context,
                                              const char* attribute);
  void add(const Outline& outline, const Context& context, const std::string& called,
           const char* kind);
  void add_open(const Outline& outline, const Context& context, const std::string& called);
  static Fill fill_of(const Context& context);
  Outline placed(const Outline& outline, const Context& context);
  void note_cut(const Box& box, const Context& context, const std::string& called);

  std::string_view text_;
  ImportOptions options_;
  pugi::xml_document document_;
  SvgStyles styles_;
  std::vector<std::pair<std::string_view, pugi::xml_node>> by_id_;  // sorted by id when needed
  bool has_ids_ = false;

  // A walk through the document fills the following members. If it finds only shapes without paint,
  // a second walk takes these.
  Gathering gathering_;
  std::vector<DrawnPiece> pieces_;
  std::size_t piece_points_ = 0;
  std::vector<pugi::xml_node> open_;  // the elements around the current one
  std::size_t copied_bytes_ = 0;
  std::size_t hidden_ = 0, unpainted_ = 0, hairs_ = 0, cut_ = 0;
  std::string first_cut_;  // its name
  std::vector<std::string> hidden_names_;
  std::optional<InputError> error_;  // ends the walk
  FilledPath filled_;                // the preceding shape, if it was such a path
  bool takes_unpainted_ = false, has_problem_ = false, has_texts_ = false;
};

// The label that a drawing program gave the element; may be empty.
std::string_view label_of(const pugi::xml_node& node);
std::string_view title_of(const pugi::xml_node& node);
// The element's name for people: its label, title or id.
std::string_view own_name(const pugi::xml_node& node);

// Drops hairs and returns their number. A hair is a part of the outline that ends within `meet` of
// its beginning. It has at most 8 pieces, at least one of them a curve. All its ends and control
// points are within `reach` of its beginning, but not all within `meet`. Some programs draw hairs
// at corners, where a hair would become a second vertex. O(pieces).
std::size_t drop_hairs(Outline& outline, double reach, double meet);

}  // namespace evenlift
