// SVG 1.1: shapes that have an area, as outlines in user units with y turned upwards. pugixml reads
// the XML. It expands no entities except character references and XML's own five, and loads
// nothing.
#include <algorithm>
#include <cmath>
#include <pugixml.hpp>

#include "evenlift/link.h"
#include "import/gathering.h"
#include "import/readers.h"
#include "import/svg_values.h"
#include "import/unit_words.h"
#include "numbers/text_cursor.h"

namespace evenlift {
namespace {

// The greatest depth of nested elements. The reader recurses to this depth.
constexpr int max_depth = 256;
// A node costs pugixml up to 64 bytes, however short its text.
constexpr std::size_t max_nodes = std::size_t{1} << 22;

std::string_view local_name(const pugi::xml_node& node) {
  const std::string_view name = node.name();
  const std::size_t colon = name.rfind(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

std::string_view value_of(const pugi::xml_node& node, const char* attribute) {
  return node.attribute(attribute).value();
}

// The value of a property, from an attribute or the style.
std::string_view property(const pugi::xml_node& node, std::string_view name) {
  const std::string_view style = value_of(node, "style");
  for (std::size_t at = 0; at < style.size();) {
    const std::size_t end = std::min(style.find(';', at), style.size());
    const std::string_view declaration = style.substr(at, end - at);
    at = end + 1;
    const std::size_t colon = declaration.find(':');
    if (colon == std::string_view::npos) continue;
    const auto trimmed = [](std::string_view text) {
      const std::size_t first = text.find_first_not_of(" \t\r\n");
      if (first == std::string_view::npos) return std::string_view();
      return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
    };
    if (trimmed(declaration.substr(0, colon)) == name)
      return trimmed(declaration.substr(colon + 1));
  }
  return value_of(node, std::string(name).c_str());
}

bool moves_shapes(std::string_view css) {
  for (const std::string_view word : {"transform", "translate:", "scale:", "rotate:"})
    if (css.find(word) != std::string_view::npos) return true;
  return false;
}

template <std::size_t size>
bool is_one_of(std::string_view name, const std::string_view (&names)[size]) {
  return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

// Elements that are not drawn in their own place.
constexpr std::string_view unseen[] = {"defs",           "clipPath", "mask",     "pattern",
                                       "marker",         "symbol",   "metadata", "linearGradient",
                                       "title",          "desc",     "style",    "script",
                                       "radialGradient", "filter",   "namedview"};
constexpr std::string_view drawn[] = {"path", "polygon", "polyline", "rect", "circle", "ellipse"};

// Lengths in these units are sizes on paper; pixels are not.
constexpr std::string_view paper_units[] = {"mm", "cm", "in", "pt", "pc"};

struct Other {
  std::string_view name, one, many;
};
constexpr Other others[] = {
    {"text", "text", "texts"},
    {"image", "picture", "pictures"},
    {"use", "copy (<use>)", "copies (<use>)"},
    {"line", "line", "lines"},
    {"foreignObject", "foreign object", "foreign objects"},
    {"svg", "drawing inside the drawing (<svg>)", "drawings inside the drawing (<svg>)"}};

class SvgReader {
 public:
  SvgReader(std::string_view text, const ImportOptions& options)
      : text_(text), gathering_(options) {}
  Result<Import> read();

 private:
  // The properties that an element inherits.
  struct Context {
    Affine matrix;
    std::string_view layer;
  };

  InputError error_at(const pugi::xml_node& node, ErrorCode code, std::string message) const {
    const auto offset = static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, node.offset_debug()));
    return text_error(code, std::move(message), text_, offset);
  }
  void problem(const pugi::xml_node& node, const std::string& what) {
    // Finding the line number costs as much as the text before it: once is enough.
    InputError error = has_problem_ ? InputError{ErrorCode::bad_syntax, what, {}}
                                    : error_at(node, ErrorCode::bad_syntax, what);
    has_problem_ = true;
    gathering_.add_problem(std::move(error));
  }
  // The value; or nullopt, and the shape is left out.
  template <class T>
  std::optional<T> checked(const pugi::xml_node& node, const char* what, SvgResult<T> result) {
    if (auto* wrong = std::get_if<SvgProblem>(&result)) {
      problem(node, joined({"the SVG's ", what, ", ", wrong->what}));
      return std::nullopt;
    }
    return std::get<0>(std::move(result));
  }
  std::optional<std::optional<double>> length(const pugi::xml_node& node, const char* attribute);

  Result<pugi::xml_node> load();
  std::optional<Document> document_of_metadata(const pugi::xml_node& svg) const;
  std::optional<InputError> children(const pugi::xml_node& parent, const Context& context,
                                     int depth);
  std::optional<InputError> element(const pugi::xml_node& node, const Context& context, int depth);
  void shape(const pugi::xml_node& node, const Context& context, std::string_view name);
  void path(const pugi::xml_node& node, const Context& context, const std::string& called);
  void points(const pugi::xml_node& node, const Context& context, const std::string& called,
              bool closed);
  void rectangle(const pugi::xml_node& node, const Context& context, const std::string& called);
  void ellipse(const pugi::xml_node& node, const Context& context, const std::string& called,
               bool circle);
  std::string called(const pugi::xml_node& node, const Context& context) const;
  void add(const Outline& outline, const Context& context, const std::string& called,
           const char* kind) {
    gathering_.add(transformed(outline, context.matrix), called, kind);
  }
  InputError nothing_found() const;

  std::string_view text_;
  pugi::xml_document document_;
  Gathering gathering_;
  bool has_problem_ = false;
};

// Inkscape's label, else the title, else the id, else the layer's label.
std::string SvgReader::called(const pugi::xml_node& node, const Context& context) const {
  std::string_view name = value_of(node, "inkscape:label");
  if (name.empty())
    for (const pugi::xml_node child : node.children())
      if (local_name(child) == "title") name = child.child_value();
  if (name.empty()) name = value_of(node, "id");
  return std::string(name.empty() ? context.layer : name);
}

std::optional<std::optional<double>> SvgReader::length(const pugi::xml_node& node,
                                                       const char* attribute) {
  return checked(node, attribute, svg_length(value_of(node, attribute)));
}

// Whether a later outline lies in the box of the largest.
bool has_outlines_inside(const std::vector<SvgOutline>& outlines) {
  if (outlines.size() < 2) return false;
  std::vector<Box> boxes;
  std::size_t largest = 0;
  for (const SvgOutline& outline : outlines) {
    boxes.push_back(control_box(outline.outline));
    if (boxes.back().diagonal() > boxes[largest].diagonal()) largest = boxes.size() - 1;
  }
  for (std::size_t i = 0; i < boxes.size(); ++i)
    if (i != largest && (boxes[i].low.array() >= boxes[largest].low.array()).all() &&
        (boxes[i].high.array() <= boxes[largest].high.array()).all())
      return true;
  return false;
}

void SvgReader::path(const pugi::xml_node& node, const Context& context,
                     const std::string& called) {
  const auto outlines = checked(node, "path", svg_path(value_of(node, "d")));
  if (!outlines) return;
  if (has_outlines_inside(*outlines))
    gathering_.note(
        "outlines inside another are separate shapes, since holes are not supported: the shape "
        "around them and, unless one is given, its centre of mass ignore them");
  for (std::size_t i = 0; i < outlines->size(); ++i) {
    const auto& [outline, closed] = (*outlines)[i];
    std::string name = called;
    if (outlines->size() > 1) name += (name.empty() ? "part " : ", part ") + std::to_string(i + 1);
    add(outline, context, name, closed ? "path" : "open path, closed by a straight edge");
  }
}

void SvgReader::points(const pugi::xml_node& node, const Context& context,
                       const std::string& called, bool closed) {
  const char* what = closed ? "polygon" : "polyline";
  const auto values = checked(node, what, svg_numbers(value_of(node, "points")));
  if (!values) return;
  if (values->size() % 2 != 0)
    return problem(node, joined({"the SVG's ", what, ": the last point has no y"}));
  if (values->empty()) return;
  Outline outline;
  outline.start = {(*values)[0], (*values)[1]};
  for (std::size_t i = 2; i < values->size(); i += 2)
    outline.line_to({(*values)[i], (*values)[i + 1]});
  const bool open = !closed && outline.end() != outline.start;
  add(outline, context, called, open ? "polyline, closed by a straight edge" : what);
}

void SvgReader::rectangle(const pugi::xml_node& node, const Context& context,
                          const std::string& called) {
  const auto x = length(node, "x"), y = length(node, "y"), width = length(node, "width"),
             height = length(node, "height"), rx = length(node, "rx"), ry = length(node, "ry");
  if (!x || !y || !width || !height || !rx || !ry) return;
  const double left = x->value_or(0), bottom = y->value_or(0), w = width->value_or(0),
               h = height->value_or(0);
  if (!(w > 0) || !(h > 0)) return;
  // A missing radius equals the other one.
  double a = std::min(rx->value_or(ry->value_or(0)), w / 2);
  double b = std::min(ry->value_or(rx->value_or(0)), h / 2);
  if (!(a > 0) || !(b > 0)) a = b = 0;
  const double right = left + w, top = bottom + h;
  Outline outline;
  outline.start = {left + a, bottom};
  outline.line_to({right - a, bottom});
  if (a > 0) outline.quarter_to({right, bottom}, {right, bottom + b});
  outline.line_to({right, top - b});
  if (a > 0) outline.quarter_to({right, top}, {right - a, top});
  outline.line_to({left + a, top});
  if (a > 0) outline.quarter_to({left, top}, {left, top - b});
  outline.line_to({left, bottom + b});
  if (a > 0) outline.quarter_to({left, bottom}, outline.start);
  add(outline, context, called, a > 0 ? "rectangle with round corners" : "rectangle");
}

void SvgReader::ellipse(const pugi::xml_node& node, const Context& context,
                        const std::string& called, bool circle) {
  const auto x = length(node, "cx"), y = length(node, "cy"), rx = length(node, circle ? "r" : "rx"),
             ry = length(node, circle ? "r" : "ry");
  if (!x || !y || !rx || !ry) return;
  const double a = rx->value_or(ry->value_or(0)), b = ry->value_or(rx->value_or(0));
  if (!(a > 0) || !(b > 0)) return;
  add(Outline::ellipse({a, 0, 0, b, x->value_or(0), y->value_or(0)}), context, called,
      circle ? "circle" : "ellipse");
}

void SvgReader::shape(const pugi::xml_node& node, const Context& context, std::string_view name) {
  const std::string name_of_it = called(node, context);
  if (name == "path")
    path(node, context, name_of_it);
  else if (name == "rect")
    rectangle(node, context, name_of_it);
  else if (name == "circle" || name == "ellipse")
    ellipse(node, context, name_of_it, name == "circle");
  else
    points(node, context, name_of_it, name == "polygon");
}

std::optional<InputError> SvgReader::element(const pugi::xml_node& node, const Context& context,
                                             int depth) {
  const std::string_view name = local_name(node);
  if (is_one_of(name, unseen)) return std::nullopt;
  if (property(node, "display") == "none" || property(node, "visibility") == "hidden") {
    gathering_.left_out.add("hidden element", "hidden elements");
    return std::nullopt;
  }
  for (const Other& other : others)
    if (name == other.name) {
      gathering_.left_out.add(other.one, other.many);
      return std::nullopt;
    }
  Context inside = context;
  if (moves_shapes(value_of(node, "style"))) {
    problem(node,
            "the SVG moves a shape by a style, which is not supported; use a transform attribute "
            "(in Inkscape: Extensions, Modify Path, Apply Transform, or save as Plain SVG)");
    return std::nullopt;
  }
  if (const std::string_view transform = value_of(node, "transform"); !transform.empty()) {
    const auto matrix = checked(node, "drawing", svg_transform(transform));
    if (!matrix) return std::nullopt;
    inside.matrix = context.matrix * *matrix;
  }
  if (is_one_of(name, drawn)) {
    shape(node, inside, name);
    return std::nullopt;
  }
  if (const std::string_view label = value_of(node, "inkscape:label"); !label.empty())
    inside.layer = label;
  return children(node, inside, depth + 1);
}

std::optional<InputError> SvgReader::children(const pugi::xml_node& parent, const Context& context,
                                              int depth) {
  if (depth > max_depth)
    return error_at(parent, ErrorCode::unsupported, "the SVG's elements are nested too deeply");
  for (const pugi::xml_node node : parent.children()) {
    if (node.type() != pugi::node_element) continue;
    if (gathering_.full()) return std::nullopt;
    if (auto error = element(node, context, depth)) return error;
  }
  return std::nullopt;
}

// For a picture that evenlift saved: the document of the first link in its <metadata>.
std::optional<Document> SvgReader::document_of_metadata(const pugi::xml_node& svg) const {
  struct Finder final : pugi::xml_tree_walker {
    std::optional<Document> found;
    int left = 1000;  // metadata of other programs may be long
    bool for_each(pugi::xml_node& node) override {
      if (node.type() == pugi::node_pcdata || node.type() == pugi::node_cdata) look(node.value());
      for (const pugi::xml_attribute attribute : node.attributes()) look(attribute.value());
      return !found && --left > 0;
    }
    void look(std::string_view text) {
      if (text.size() > max_link_bytes || !looks_like_link(text)) return;
      Result<Document> document = decode_link(text);
      if (document) found = std::move(document).value();
    }
  };
  for (pugi::xml_node node : svg.children()) {
    if (local_name(node) != "metadata") continue;
    Finder finder;
    node.traverse(finder);
    if (finder.found) return std::move(finder.found);
  }
  return std::nullopt;
}

// Looks for <style> in its usual places: at the top and in <defs>.
bool style_sheet_moves(const pugi::xml_node& parent) {
  for (const pugi::xml_node node : parent.children()) {
    if (local_name(node) == "defs" && local_name(parent) == "svg" && style_sheet_moves(node))
      return true;
    if (local_name(node) != "style") continue;
    for (const pugi::xml_node css : node.children())
      if (moves_shapes(css.value())) return true;
  }
  return false;
}

InputError SvgReader::nothing_found() const {
  const std::string found = gathering_.left_out.list();
  std::string message = "this SVG has no closed shape";
  if (!found.empty())
    message +=
        ", only " + found +
        " (in Inkscape: Path, Object to Path turns texts into outlines, and Edit, Clone, Unlink "
        "Clone does the same for copies)";
  return {ErrorCode::unsupported, message, {}};
}

// The root element of a drawing that is well-formed and within the limits.
Result<pugi::xml_node> SvgReader::load() {
  const auto nodes = static_cast<std::size_t>(
      std::count_if(text_.begin(), text_.end(), [](char c) { return c == '<' || c == '='; }));
  if (nodes > max_nodes)
    return InputError{ErrorCode::unsupported, "the SVG has too many elements and attributes", {}};
  const pugi::xml_parse_result parsed =
      document_.load_buffer(text_.data(), text_.size(), pugi::parse_default, pugi::encoding_utf8);
  if (parsed.status == pugi::status_out_of_memory)
    return InputError{ErrorCode::unsupported, "there is not enough memory for this SVG", {}};
  if (!parsed && parsed.status != pugi::status_no_document_element)
    return text_error(ErrorCode::bad_syntax,
                      "the SVG is not well-formed XML: it may be cut off or altered", text_,
                      static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, parsed.offset)));
  const pugi::xml_node root = document_.document_element();
  if (!root)
    return InputError{
        ErrorCode::bad_syntax, "the SVG is not well-formed XML: it has no root element", {}};
  for (pugi::xml_node next = root.next_sibling(); next; next = next.next_sibling())
    if (next.type() == pugi::node_element)
      return error_at(next, ErrorCode::bad_syntax,
                      "the SVG is not well-formed XML: a second drawing begins here");
  if (local_name(root) != "svg")
    return InputError{ErrorCode::unsupported,
                      "this XML is not SVG: its root element is <" + clean_name(root.name()) + ">",
                      {}};
  return root;
}

// The number of CSS pixels in a user unit along a side of the drawing; nullopt if the drawing has
// no size on paper.
std::optional<double> user_unit(const pugi::xml_node& svg, const char* side, std::size_t in_box) {
  const std::string_view size = value_of(svg, side);
  const bool on_paper = std::any_of(std::begin(paper_units), std::end(paper_units),
                                    [&](std::string_view unit) { return size.ends_with(unit); });
  if (!on_paper) return std::nullopt;
  const SvgResult<std::optional<double>> length = svg_length(size);
  const SvgResult<std::vector<double>> box = svg_numbers(value_of(svg, "viewBox"));
  const auto* pixels = std::get_if<std::optional<double>>(&length);
  const auto* numbers = std::get_if<std::vector<double>>(&box);
  if (!pixels || !*pixels || !numbers || numbers->size() != 4 || !((*numbers)[in_box] > 0))
    return std::nullopt;
  return **pixels / (*numbers)[in_box];
}

// The unit of length that a user unit equals, according to the drawing's size on paper, as in <svg
// width="210mm" height="297mm" viewBox="0 0 210 297">; none if evenlift has no such unit. Programs
// round such sizes.
LengthUnit unit_of(const pugi::xml_node& svg) {
  constexpr double rounding = 1e-4;
  const std::optional<double> across = user_unit(svg, "width", 2),
                              down = user_unit(svg, "height", 3);
  if (!across || !down) return LengthUnit::none;
  const auto is = [&](double pixels) {
    return std::abs(*across - pixels) < rounding * pixels &&
           std::abs(*down - pixels) < rounding * pixels;
  };
  constexpr double inch = 96;
  if (is(inch / 25.4)) return LengthUnit::mm;
  if (is(inch / 2.54)) return LengthUnit::cm;
  if (is(inch / 0.0254)) return LengthUnit::m;
  return is(inch) ? LengthUnit::in : LengthUnit::none;
}

Result<Import> SvgReader::read() {
  const Result<pugi::xml_node> loaded = load();
  if (!loaded) return loaded.error();
  const pugi::xml_node& root = *loaded;
  if (std::optional<Document> saved = document_of_metadata(root)) {
    gathering_.import.format = "picture saved by evenlift";
    gathering_.import.has_settings = true;
    gathering_.add(*std::move(saved), "", "polygon");
    return gathering_.finish(nothing_found());
  }
  gathering_.import.format = "SVG";
  if (style_sheet_moves(root))
    return InputError{ErrorCode::unsupported,
                      "the SVG's style sheet moves shapes, which is not supported; use transform "
                      "attributes (in Inkscape: save as Plain SVG)",
                      {}};
  const Context whole{{1, 0, 0, -1, 0, 0}, {}};  // in SVG y points down
  if (std::optional<InputError> error = children(root, whole, 1)) return *std::move(error);
  const LengthUnit unit = unit_of(root);
  gathering_.import.unit = in_full(unit);
  for (ImportedShape& shape : gathering_.import.shapes) shape.document.shown.units.length = unit;
  return gathering_.finish(nothing_found());
}

}  // namespace

Result<Import> read_svg(std::string_view text, const ImportOptions& options) {
  return SvgReader(text, options).read();
}

}  // namespace evenlift
