// Gathers the visible shapes of one SVG.
#pragma once

#include <cstddef>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "curves/outline.h"
#include "evenlift/wording.h"
#include "import/gathering.h"
#include "import/svg/svg_style.h"
#include "import/svg/svg_values.h"

namespace evenlift {

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
    SvgViewport viewport;
    SvgLook look;
    SvgDeclared declared = {};  // for the element itself, if it is drawn
    bool in_copy = false;
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
  std::optional<InputError> walk(const pugi::xml_node& root, const SvgPaper& paper);
  void start_again();
  void say_what_is_unseen();
  InputError nothing_found() const;

  // svg_tree.cpp defines these functions, for elements, groups and copies.
  std::optional<InputError> children(const pugi::xml_node& parent, const Context& context,
                                     int depth);
  std::optional<InputError> element(const pugi::xml_node& node, const Context& context, int depth);
  std::optional<InputError> inside_of(const pugi::xml_node& node, std::string_view name,
                                      Context& inside, int depth);
  std::optional<InputError> chosen_child(const pugi::xml_node& node, const Context& context,
                                         int depth);
  std::optional<InputError> copy(const pugi::xml_node& node, Context& inside, int depth);
  // Reads an element that has its own viewport. `sized` is the element whose width and height take
  // precedence: the <use> that copies `node`, or `node` itself.
  std::optional<InputError> nested(const pugi::xml_node& node, const pugi::xml_node& sized,
                                   Context& inside, int depth);
  bool enter(const pugi::xml_node& node, std::string_view name, Context& inside);
  bool transform(const pugi::xml_node& node, const SvgDeclared& declared, Context& inside);
  bool leaves_out(const pugi::xml_node& node, std::string_view name, const Context& inside);
  void hide(const pugi::xml_node& node, const Context& context);
  bool has_room_to_copy(const pugi::xml_node& node);
  void index_ids();
  pugi::xml_node original_of(const pugi::xml_node& node);
  InputError too_deep(const pugi::xml_node& node) const;
  bool full() const { return gathering_.full() || piece_points_ > max_vertices; }

  // svg_shapes.cpp defines these functions, for the drawn shapes.
  void shape(const pugi::xml_node& node, const Context& context, std::string_view name);
  bool is_stroke_of_filled(const Context& context);
  void path(const pugi::xml_node& node, const Context& context, const std::string& called);
  void points(const pugi::xml_node& node, const Context& context, const std::string& called,
              bool closed);
  void rectangle(const pugi::xml_node& node, const Context& context, const std::string& called);
  void ellipse(const pugi::xml_node& node, const Context& context, const std::string& called,
               bool circle);
  void line(const pugi::xml_node& node, const Context& context);
  std::string called(const pugi::xml_node& node, const Context& context) const;
  // The length given by the attribute, in user units; percentages refer to the context's viewport.
  // The inner optional is empty if no length is given, the outer one if there is a problem.
  std::optional<std::optional<double>> length(const pugi::xml_node& node, const Context& context,
                                              const char* attribute);
  void add(const Outline& outline, const Context& context, const std::string& called,
           const char* kind);
  void add_open(const Outline& outline, const Context& context);
  static Fill fill_of(const Context& context);
  Outline placed(const Outline& outline, const Context& context);

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
  std::size_t hidden_ = 0, unpainted_ = 0, hairs_ = 0;
  std::vector<std::string> hidden_names_;
  FilledPath filled_;  // the preceding shape, if it was such a path
  bool takes_unpainted_ = false, has_problem_ = false, has_texts_ = false;
};

// The label that a drawing program gave the element; may be empty.
std::string_view label_of(const pugi::xml_node& node);
// The element's name for people: its label, title or id.
std::string_view own_name(const pugi::xml_node& node);

// Drops hairs and returns their number. A hair is a part of the outline that ends within `meet` of
// its beginning. It has at most 8 pieces, at least one of them a curve. All its ends and control
// points are within `reach` of its beginning, but not all within `meet`. Some programs draw hairs
// at corners, where a hair would become a second vertex. O(pieces).
std::size_t drop_hairs(Outline& outline, double reach, double meet);

}  // namespace evenlift
