// Reads SVG 1.1, and the parts of SVG 2 that programs write: shapes with an area, with y upwards.
// pugixml reads the XML; it expands only character references and XML's five entities, and loads
// nothing. Entities that the file declares are replaced before (svg_entities.h).
#include <algorithm>
#include <cmath>

#include "evenlift/link.h"
#include "evenlift/wording.h"
#include "import/readers.h"
#include "import/svg/svg_element.h"
#include "import/svg/svg_entities.h"
#include "import/svg/svg_reader.h"
#include "import/unit_words.h"
#include "numbers/text_cursor.h"

namespace evenlift {
namespace {

// A node costs pugixml up to 64 bytes.
constexpr std::size_t max_nodes = std::size_t{1} << 22;

// The document of the first link in the <metadata> of evenlift's own pictures.
std::optional<Document> document_of_metadata(const pugi::xml_node& svg) {
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

}  // namespace

InputError SvgReader::error_at(const pugi::xml_node& node, ErrorCode code,
                               std::string message) const {
  const auto offset = static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, node.offset_debug()));
  return text_error(code, std::move(message), text_, offset);
}

void SvgReader::problem(const pugi::xml_node& node, const std::string& what) {
  // Only the first problem has a place: finding a line number reads all the text before it.
  InputError error = has_problem_ ? InputError{ErrorCode::bad_syntax, what, {}}
                                  : error_at(node, ErrorCode::bad_syntax, what);
  has_problem_ = true;
  gathering_.add_problem(std::move(error));
}

// The root of a well-formed drawing within the limits.
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
                      say("this XML is not SVG: its root element is {element}",
                          {"<" + clean_name(root.name()) + ">"}),
                      {}};
  return root;
}

std::optional<InputError> SvgReader::walk(const pugi::xml_node& root, const SvgPaper& paper) {
  Context whole;
  whole.matrix = {paper.across, 0, 0, -paper.down, 0, 0};  // in SVG y points down
  whole.viewport = paper.viewport;
  const SvgDeclared declared = styles_.of(root);
  if (hides_all(declared)) {
    hide(root, whole);
    return std::nullopt;
  }
  whole.look = inherited(whole.look, declared);
  if (std::optional<InputError> error = children(root, whole, 1)) return error;
  if (copied_bytes_ > most_copied_bytes)
    return InputError{
        ErrorCode::unsupported, "the SVG's copies (<use>) have more than 64 MiB together", {}};
  if (piece_points_ > max_vertices)
    return InputError{
        ErrorCode::too_many_vertices, "the shapes have more than 1048576 vertices together", {}};
  return std::nullopt;
}

void SvgReader::start_again() {
  gathering_ = Gathering(options_);
  pieces_.clear();
  hidden_names_.clear();
  piece_points_ = copied_bytes_ = hidden_ = unpainted_ = hairs_ = 0;
  has_problem_ = has_texts_ = false;
  filled_ = {};
}

void SvgReader::say_what_is_unseen() {
  std::string names;
  for (std::size_t i = 0; i < hidden_names_.size(); ++i) {
    const std::string name = hidden_names_[i].empty() ? "others" : in_quotes(hidden_names_[i]);
    names = i == 0                         ? name
            : i + 1 < hidden_names_.size() ? names + ", " + name
                                           : say("{first} and {last}", {names, name});
  }
  LeftOut& left_out = gathering_.left_out;
  const bool named = !names.empty();
  const std::string one = named ? say("hidden element ({names})", {names}) : "hidden element",
                    many = named ? say("hidden elements ({names})", {names}) : "hidden elements";
  for (std::size_t i = 0; i < hidden_; ++i) left_out.add(one, many);
  for (std::size_t i = 0; i < hairs_; ++i) left_out.add("loop of a hair", "loops of a hair");
  if (takes_unpainted_ && unpainted_ > 0)
    gathering_.note(
        "nothing in the drawing has a fill or a stroke, so programs show none of its shapes");
  else
    for (std::size_t i = 0; i < unpainted_; ++i)
      left_out.add("shape without fill and stroke", "shapes without fill and stroke");
}

InputError SvgReader::nothing_found() const {
  const std::string found = gathering_.left_out.list();
  std::string message = found.empty() ? say("this SVG has no closed shape")
                                      : say("this SVG has no closed shape, only {things}", {found});
  if (has_texts_)
    message += " " + say("(in Inkscape: Path, Object to Path turns texts into outlines)");
  return {ErrorCode::unsupported, message, {}};
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
    return InputError{
        ErrorCode::unsupported, "the SVG's style sheets have more than 262144 declarations", {}};
  const SvgPaper paper =
      paper_of({value_of(root, "width"), value_of(root, "height"), value_of(root, "viewBox"),
                value_of(root, "preserveAspectRatio")});
  if (std::optional<InputError> error = walk(root, paper)) return *std::move(error);
  if (gathering_.import.shapes.empty() && pieces_.empty() && unpainted_ > 0) {
    start_again();
    takes_unpainted_ = true;
    if (std::optional<InputError> error = walk(root, paper)) return *std::move(error);
  }
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
