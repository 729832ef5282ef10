#include <algorithm>
#include <cmath>

#include "evenlift/link.h"
#include "evenlift/wording.h"
#include "import/readers.h"
#include "import/svg/svg_reader.h"
#include "numbers/text_cursor.h"

namespace evenlift {
namespace {

// A loop below this share of its shape is not intended.
constexpr double hair = 1.0 / 200;
// A curved part of a path is a speck if it is smaller than this share of the path: half of the
// greatest default tolerance.
constexpr double speck = 1.0 / 2000;
// A hair has few pieces; a full turn has four or five.
constexpr std::size_t most_pieces_of_a_hair = 8;

bool is_near(const Vec2& a, const Vec2& b, double distance) {
  return std::abs(a.x - b.x) <= distance && std::abs(a.y - b.y) <= distance;
}

bool is_same(const Affine& a, const Affine& b) {
  return a.a == b.a && a.b == b.b && a.c == b.c && a.d == b.d && a.e == b.e && a.f == b.f;
}

bool stays_near(const CurvePiece& piece, const Vec2& start, double reach) {
  using Kind = CurvePiece::Kind;
  return is_near(piece.end, start, reach) &&
         (piece.kind == Kind::line || is_near(piece.first, start, reach)) &&
         (piece.kind != Kind::cubic || is_near(piece.second, start, reach));
}

// The end of the hair that begins at `first`, else `first`. A curve without length is not a hair: a
// half-turn arc may end with one.
std::size_t end_of_hair(const Outline& outline, std::size_t first, const Vec2& start, double reach,
                        double meet) {
  std::size_t end = first;
  bool curved = false, leaves = false;
  const std::size_t last = std::min(outline.pieces.size(), first + most_pieces_of_a_hair);
  for (std::size_t i = first; i < last && stays_near(outline.pieces[i], start, reach); ++i) {
    curved = curved || outline.pieces[i].kind != CurvePiece::Kind::line;
    leaves = leaves || !stays_near(outline.pieces[i], start, meet);
    if (curved && leaves && is_near(outline.pieces[i].end, start, meet)) end = i + 1;
  }
  return end;
}

// Drops closed parts of a path that vanish when curves are flattened. Returns their number.
std::size_t drop_specks(std::vector<SvgOutline>& outlines) {
  double side = 0;
  for (const SvgOutline& each : outlines)
    side = std::max(side, larger_side(control_box(each.outline)));
  const auto is_speck = [&](const SvgOutline& each) {
    const double most = (each.outline.curved() ? speck : same_point) * side;
    return each.closed && !each.outline.pieces.empty() &&
           larger_side(control_box(each.outline)) < most;
  };
  const auto rest = std::remove_if(outlines.begin(), outlines.end(), is_speck);
  const auto dropped = static_cast<std::size_t>(outlines.end() - rest);
  outlines.erase(rest, outlines.end());
  return dropped;
}

}  // namespace

std::size_t drop_hairs(Outline& outline, double reach, double meet) {
  if (!outline.curved()) return 0;
  std::vector<CurvePiece> kept;
  std::size_t dropped = 0;
  Vec2 at = outline.start;
  for (std::size_t i = 0; i < outline.pieces.size();) {
    const std::size_t end = end_of_hair(outline, i, at, reach, meet);
    if (end > i) {
      ++dropped;
      i = end;
      continue;
    }
    kept.push_back(outline.pieces[i++]);
    at = kept.back().end;
  }
  outline.pieces = std::move(kept);
  return dropped;
}

std::string_view label_of(const pugi::xml_node& node) {
  // Inkscape, Illustrator and Affinity.
  for (const char* attribute : {"inkscape:label", "data-name", "serif:id"})
    if (const std::string_view label = value_of(node, attribute); !label.empty()) return label;
  return {};
}

std::string_view title_of(const pugi::xml_node& node) {
  int left = 8;  // the title is one of the first children
  for (pugi::xml_node child = node.first_child(); child && left > 0;
       child = child.next_sibling(), --left)
    if (local_name(child) == "title") return child.child_value();
  return {};
}

namespace {

std::string_view first_of(std::initializer_list<std::string_view> names) {
  for (const std::string_view name : names)
    if (!name.empty()) return name;
  return {};
}

}  // namespace

std::string_view own_name(const pugi::xml_node& node) {
  return first_of({label_of(node), title_of(node), value_of(node, "id")});
}

// A title that a person gave a group says more than an id.
std::string SvgReader::called(const pugi::xml_node& node, const Context& context) const {
  return clean_name(first_of({context.name_of_copy, label_of(node), title_of(node), context.title,
                              value_of(node, "id"), context.layer}));
}

std::optional<std::optional<double>> SvgReader::length(const pugi::xml_node& node,
                                                       const Context& context,
                                                       const char* attribute) {
  const auto& [width, height] = context.viewport;
  std::optional<double> whole;
  if ("x cx x1 x2 width rx"_words.has(attribute))
    whole = width;
  else if ("y cy y1 y2 height ry"_words.has(attribute))
    whole = height;
  else if (width && height)
    whole = std::sqrt((*width * *width + *height * *height) / 2);
  const std::string_view own = value_of(node, attribute);
  auto declared = svg_length(geometry_of(context.declared, attribute, own), whole);
  // A style that is not a length counts as none.
  if (std::holds_alternative<SvgProblem>(declared)) declared = svg_length(own, whole);
  return checked(node, attribute, std::move(declared));
}

// Without hairs, in the import's coordinates.
Outline SvgReader::placed(const Outline& outline, const Context& context) {
  Outline image = transformed(outline, context.matrix);
  const double side = larger_side(control_box(image));
  // At most a tenth, so that no tolerance makes the whole outline a hair.
  const double reach = std::clamp(options_.tolerance.value_or(0), hair * side, side / 10);
  hairs_ += drop_hairs(image, reach, same_point * side);
  return image;
}

Fill SvgReader::fill_of(const Context& context) {
  if (!context.look.is_filled()) return Fill::none;
  return context.look.nonzero ? Fill::nonzero : Fill::even_odd;
}

// Clip paths and masks are not applied.
void SvgReader::note_cut(const Box& box, const Context& context, const std::string& called) {
  const double near = 1e-3 * larger_side(box);
  const auto& window = context.window;
  const bool is_in_window =
      !window || (box.low.x >= window->low.x - near && box.low.y >= window->low.y - near &&
                  box.high.x <= window->high.x + near && box.high.y <= window->high.y + near);
  if (is_in_window && !context.is_cut) return;
  if (++cut_ == 1) first_cut_ = called;
}

void SvgReader::add(const Outline& outline, const Context& context, const std::string& called,
                    const char* kind) {
  Outline image = placed(outline, context);
  note_cut(control_box(image), context, called);
  gathering_.add(
      {{std::move(image)}, called, kind, fill_of(context), context.look.is_white_page()});
}

void SvgReader::add_open(const Outline& outline, const Context& context,
                         const std::string& called) {
  if (outline.pieces.empty()) return;
  piece_points_ += outline.pieces.size();
  pieces_.push_back(
      {placed(outline, context), clean_name(context.layer), context.look.is_filled(), 0, called});
}

void SvgReader::path(const pugi::xml_node& node, const Context& context,
                     const std::string& called) {
  auto outlines = checked(node, "path", svg_path(geometry_of(context.declared, "d")));
  if (!outlines) return;
  hairs_ += drop_specks(*outlines);
  DrawnShape drawn{{}, called, "path", fill_of(context), context.look.is_white_page()};
  for (const auto& [outline, closed] : *outlines) {
    const double meet = same_point * larger_side(control_box(outline));
    if (!closed && !is_near(outline.start, outline.end(), meet))
      add_open(outline, context, called);
    else if (closed || !outline.pieces.empty())  // otherwise a move alone
      drawn.parts.push_back(placed(outline, context));
  }
  Points ends;
  for (const Outline& part : drawn.parts)
    for (const Vec2& corner : {control_box(part).low, control_box(part).high})
      ends.push_back(corner);
  if (!ends.empty()) note_cut(bounding_box(ends), context, called);
  gathering_.add(drawn);
}

void SvgReader::points(const pugi::xml_node& node, const Context& context,
                       const std::string& called, bool closed) {
  const char* what = closed ? "polygon" : "polyline";
  const auto values = checked(node, what, svg_numbers(value_of(node, "points")));
  if (!values) return;
  if (values->size() % 2 != 0)
    return problem(node, say("the SVG's {part}: the last point has no y", {what}));
  if (values->empty()) return;
  Outline outline;
  outline.start = {(*values)[0], (*values)[1]};
  for (std::size_t i = 2; i < values->size(); i += 2)
    outline.line_to({(*values)[i], (*values)[i + 1]});
  const double meet = same_point * larger_side(control_box(outline));
  if (closed || is_near(outline.start, outline.end(), meet))
    add(outline, context, called, what);
  else
    add_open(outline, context, called);
}

void SvgReader::line(const pugi::xml_node& node, const Context& context,
                     const std::string& called) {
  const auto x1 = length(node, context, "x1"), y1 = length(node, context, "y1"),
             x2 = length(node, context, "x2"), y2 = length(node, context, "y2");
  if (!x1 || !y1 || !x2 || !y2) return;
  Outline outline;
  outline.start = {x1->value_or(0), y1->value_or(0)};
  const Vec2 end(x2->value_or(0), y2->value_or(0));
  if (end == outline.start) return;
  outline.line_to(end);
  add_open(outline, context, called);
}

void SvgReader::rectangle(const pugi::xml_node& node, const Context& context,
                          const std::string& called) {
  const auto x = length(node, context, "x"), y = length(node, context, "y"),
             width = length(node, context, "width"), height = length(node, context, "height"),
             rx = length(node, context, "rx"), ry = length(node, context, "ry");
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
  const auto x = length(node, context, "cx"), y = length(node, context, "cy"),
             rx = length(node, context, circle ? "r" : "rx"),
             ry = length(node, context, circle ? "r" : "ry");
  if (!x || !y || !rx || !ry) return;
  const double a = rx->value_or(ry->value_or(0)), b = ry->value_or(rx->value_or(0));
  if (!(a > 0) || !(b > 0)) return;
  add(Outline::ellipse({a, 0, 0, b, x->value_or(0), y->value_or(0)}), context, called,
      circle ? "circle" : "ellipse");
}

// Whether a path with only a stroke repeats the preceding path, which has only a fill, as
// LibreOffice writes shapes.
bool SvgReader::is_stroke_of_filled(const Context& context) {
  const std::string_view d = geometry_of(context.declared, "d");
  const bool strokes = context.look.is_stroked() && !context.look.is_filled();
  const bool same =
      strokes && is_same(filled_.matrix, context.matrix) && filled_.d == d && !d.empty();
  filled_ = {};
  if (context.look.is_filled() && !context.look.is_stroked()) filled_ = {d, context.matrix};
  return same;
}

void SvgReader::shape(const pugi::xml_node& node, const Context& context, std::string_view name) {
  if (is_stroke_of_filled(context)) return;
  const std::string name_of_it = called(node, context);
  if (name == "path")
    path(node, context, name_of_it);
  else if (name == "rect")
    rectangle(node, context, name_of_it);
  else if (name == "circle" || name == "ellipse")
    ellipse(node, context, name_of_it, name == "circle");
  else if (name == "line")
    line(node, context, name_of_it);
  else
    points(node, context, name_of_it, name == "polygon");
}

// --- Reads SVG 1.1, and the parts of SVG 2 that programs write: shapes with an area, with y upwards.
// pugixml reads the XML; it expands only character references and XML's five entities, and loads
// nothing. Entities that the file declares are replaced before (svg_entities.h).

namespace {

// A node costs pugixml up to 64 bytes.
constexpr std::size_t max_nodes = std::size_t{1} << 22;

// The document of the first link in the <metadata> of evenlift's own pictures.
std::optional<Document> document_of_metadata(const pugi::xml_node& svg) {
  std::optional<Document> found;
  const auto look = [&](std::string_view text) {
    if (text.size() > max_link_bytes || !looks_like_link(text)) return;
    Result<Document> document = decode_link(text);
    if (document) found = std::move(document).value();
  };
  for (const pugi::xml_node metadata : svg.children()) {
    if (local_name(metadata) != "metadata") continue;
    int left = 1000;  // metadata of other programs may be long
    metadata.find_node([&](const pugi::xml_node& node) {
      if (node.type() == pugi::node_pcdata || node.type() == pugi::node_cdata) look(node.value());
      for (const pugi::xml_attribute attribute : node.attributes()) look(attribute.value());
      return found || --left == 0;
    });
    if (found) break;
  }
  return found;
}

}  // namespace

InputError SvgReader::error_at(const pugi::xml_node& node, ErrorCode code,
                               std::string message) const {
  const auto offset = static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, node.offset_debug()));
  return text_error(code, std::move(message), text_, offset);
}

void SvgReader::problem(const pugi::xml_node& node, const std::string& what) {
  // Only the first problem has a place: finding a line number reads all the text before it.
  InputError error = has_problem_ ? InputError{ErrorCode::bad_syntax, what}
                                  : error_at(node, ErrorCode::bad_syntax, what);
  has_problem_ = true;
  gathering_.add_problem(std::move(error));
}

// The root of a well-formed drawing within the limits.
Result<pugi::xml_node> SvgReader::load() {
  const auto nodes = static_cast<std::size_t>(
      std::count_if(text_.begin(), text_.end(), [](char c) { return c == '<' || c == '='; }));
  if (nodes > max_nodes)
    return InputError{ErrorCode::unsupported, "the SVG has too many elements and attributes"};
  const pugi::xml_parse_result parsed =
      document_.load_buffer(text_.data(), text_.size(), pugi::parse_default, pugi::encoding_utf8);
  if (parsed.status == pugi::status_out_of_memory)
    return InputError{ErrorCode::unsupported, "there is not enough memory for this SVG"};
  if (!parsed && parsed.status != pugi::status_no_document_element)
    return text_error(ErrorCode::bad_syntax,
                      "the SVG is not well-formed XML: it may be cut off or altered", text_,
                      static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, parsed.offset)));
  const pugi::xml_node root = document_.document_element();
  if (!root)
    return InputError{ErrorCode::bad_syntax,
                      "the SVG is not well-formed XML: it has no root element"};
  for (pugi::xml_node next = root.next_sibling(); next; next = next.next_sibling())
    if (next.type() == pugi::node_element)
      return error_at(next, ErrorCode::bad_syntax,
                      "the SVG is not well-formed XML: a second drawing begins here");
  if (local_name(root) != "svg")
    return InputError{ErrorCode::unsupported,
                      say("this XML is not SVG: its root element is {element}",
                          {"<" + clean_name(root.name()) + ">"})};
  return root;
}

void SvgReader::walk(const pugi::xml_node& root, const SvgPaper& paper) {
  Context whole;
  whole.matrix = {paper.across, 0, 0, -paper.down, 0, 0};  // in SVG y points down
  whole.viewport = paper.viewport;
  const SvgDeclared declared = styles_.of(root);
  if (hides_all(declared)) return hide(root, whole);
  whole.look = inherited(whole.look, declared);
  children(root, whole, 1);
  if (copied_bytes_ > most_copied_bytes)
    stop({ErrorCode::unsupported, "the SVG's copies (<use>) have more than 64 MiB together"});
  if (piece_points_ > max_vertices)
    stop({ErrorCode::too_many_vertices, "the shapes have more than 1048576 vertices together"});
}

void SvgReader::start_again() {
  gathering_ = Gathering(options_);
  pieces_.clear();
  hidden_names_.clear();
  piece_points_ = copied_bytes_ = hidden_ = unpainted_ = hairs_ = cut_ = 0;
  has_problem_ = has_texts_ = false;
  filled_ = {};
}

void SvgReader::say_what_is_unseen() {
  std::vector<std::string> all;
  for (const std::string& name : hidden_names_)
    all.push_back(name.empty() ? say("others") : in_quotes(name));
  const std::string names = listed(all);
  LeftOut& left_out = gathering_.left_out;
  const bool named = !names.empty();
  const std::string one = named ? say("hidden element ({names})", {names}) : "hidden element",
                    many = named ? say("hidden elements ({names})", {names}) : "hidden elements";
  left_out.add(one, many, hidden_);
  left_out.add("loop of a hair", "loops of a hair", hairs_);
  if (cut_ > 0) {
    std::string note =
        say(cut_ == 1 ? "{count} shape is cut by a clip path or a mask, which is not applied"
                      : "{count} shapes are cut by clip paths or masks, which are not applied",
            {cut_});
    if (!first_cut_.empty())
      note += ": " + in_quotes(clean_name(first_cut_)) + (cut_ > 1 ? ", …" : "");
    gathering_.note(note);
  }
  if (!styles_.skipped().empty())
    gathering_.note(say("the style of {selector} was left out: it is not understood",
                        {in_quotes(clean_name(styles_.skipped()))}));
  if (takes_unpainted_ && unpainted_ > 0)
    gathering_.note(
        "nothing in the drawing has a fill or a stroke, so programs show none of its shapes");
  else
    left_out.add("shape without fill and stroke", "shapes without fill and stroke", unpainted_);
}

InputError SvgReader::nothing_found() const {
  const std::string found = gathering_.left_out.list();
  std::string message = found.empty() ? say("this SVG has no closed shape")
                                      : say("this SVG has no closed shape, only {things}", {found});
  if (has_texts_)
    message += " " + say("(in Inkscape: Path, Object to Path turns texts into outlines)");
  return {ErrorCode::unsupported, message};
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
  if (!styles_.read(root))
    return InputError{ErrorCode::unsupported,
                      "the SVG's style sheets have more than 262144 declarations"};
  const SvgPaper paper =
      paper_of({value_of(root, "width"), value_of(root, "height"), value_of(root, "viewBox"),
                value_of(root, "preserveAspectRatio")});
  walk(root, paper);
  if (!error_ && gathering_.import.shapes.empty() && pieces_.empty() && unpainted_ > 0) {
    start_again();
    takes_unpainted_ = true;
    walk(root, paper);
  }
  if (error_) return *std::move(error_);
  if (paper.viewport.width && paper.viewport.height)
    gathering_.paper = {paper.across * *paper.viewport.width, paper.down * *paper.viewport.height};
  gathering_.add_joined(pieces_, true);
  gathering_.import.format = "SVG";
  gathering_.import.unit = in_full(paper.unit);
  for (ImportedShape& shape : gathering_.import.shapes)
    shape.document.shown.units.length = paper.unit;
  say_what_is_unseen();
  return gathering_.finish(nothing_found());
}

Result<Import> read_svg(std::string_view text, const ImportOptions& options) {
  const Result<std::optional<std::string>> expanded = with_entities(text);
  if (!expanded) return expanded.error();
  return SvgReader(*expanded ? **expanded : text, options).read();
}

}  // namespace evenlift
