// Gathers the shapes that a reader finds, and counts the objects that it leaves out.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "curves/outline.h"
#include "evenlift/document.h"
#include "evenlift/import.h"
#include "formats/readers.h"
#include "import/joining/joining.h"

namespace evenlift {

double larger_side(const Box& box);

// Writes the value, rounded to at most four significant digits, such as 12.35 or 120.
std::string short_number(double value);

std::string counted(std::size_t count, std::string_view one, std::string_view many);

// Puts the user's text in quotation marks. The text itself is never translated.
std::string in_quotes(std::string_view text);

// The name as valid UTF-8 of at most 80 characters, on one line.
std::string clean_name(std::string_view name);

// Counts objects by name. The 20th name and all further ones count as one.
class LeftOut {
 public:
  void add(std::string_view one, std::string_view many, std::size_t count = 1);
  bool empty() const { return counts_.empty(); }
  // The counts in words, such as "2 texts and 1 dimension", in the order of first appearance.
  std::string list() const;
  std::size_t total() const;
  // Takes back so many.
  void remove(std::string_view one, std::size_t count);

 private:
  struct Kind {
    std::string one, many;
    std::size_t count;
  };
  std::vector<Kind> counts_;
};

// A closed shape, or a path of several closed parts.
struct DrawnShape {
  std::vector<Outline> parts;
  std::string_view name;
  std::string kind;
  Fill fill = Fill::none;
  bool white = false;    // filled with white, without a stroke
  std::size_t copy = 0;  // of Gathering::add_copy()
};

class Gathering final : public ShapeSink {
 public:
  explicit Gathering(const ImportOptions& options) : options_(options) {}

  Import import;
  LeftOut left_out;
  std::optional<Vec2> paper;  // the size of the drawing's page, if it has one

  // Adds the shapes that the closed parts form when filled. Without a fill, each part is added as
  // an outline, and finish() decides which outlines are shapes and which are holes. A part with a
  // problem is left out; the other parts remain.
  void add(const DrawnShape& drawn);
  // Joins open pieces into outlines and adds these. If `closes_alone`, a straight edge closes a
  // piece that meets no other. Notes give the widest gap that was joined, and the numbers of pieces
  // that were dropped or do not close.
  void add_joined(const std::vector<DrawnPiece>& pieces, bool closes_alone);
  // A clause that names the two nearest of the ends that stayed open; empty if they are unknown.
  const std::string& gap() const { return gap_; }
  void add(Document document, std::string_view name, std::string_view kind) override;
  void add_problem(InputError error) override;
  void leave_out(std::string_view one, std::string_view many) override {
    left_out.add(clean_name(one), clean_name(many));
  }
  // A text of a drawing, which was counted in left_out as `kind`: it may name the part at its place.
  void add_text(const Vec2& at, std::string_view words, std::string_view kind);
  // Copies of a block of a drawing: the block's number, by its name, and that of a further copy of it,
  // which its outlines then have. Unless all parts are in one copy, a part without a text is called by
  // its block.
  std::size_t add_block(const std::string& name);
  std::size_t add_copy(std::size_t block);
  // The shapes that the rings of a path or polygon bound, as whoever drew them meant them.
  std::vector<OutlineWithHoles> shapes_meant(const std::vector<const Points*>& rings, Fill fill);
  bool full() const override { return full_.has_value(); }
  // If holes are left out later, there is in effect no limit.
  std::size_t most_holes() const override { return options_.holes ? max_holes : max_vertices; }
  // Adds the notes about rings; the import must already have all its shapes. O(vertices).
  void add_notes(const RingNotes& notes);
  // Adds the sentence to the notes, translated, unless there are already 20.
  void note(std::string_view sentence);
  // The sentence of these two that fits the number, which fills its {count}; none for 0.
  void note_count(std::size_t count, std::string_view one, std::string_view many);

  // Finishes and returns the import, or an error if a limit is exceeded. If there is no shape,
  // returns the first problem, or `nothing` if there were no problems.
  Result<Import> finish(InputError nothing);

 private:
  struct Drawn {
    bool filled, white;
    std::size_t path, part;  // counted from 1
    std::size_t copy;
  };
  struct Flattened;

  bool has_room(std::size_t vertices);
  std::optional<ImportedShape> flattened(const Outline& outline);
  void add_filled(const DrawnShape& drawn, std::vector<Flattened> rings);
  void name_parts(const std::vector<OutlineWithHoles>& shapes);
  const std::string& block_of(std::size_t copy) const { return blocks_[copies_[copy - 1]]; }
  void name_by_blocks(const Nesting& nesting);
  void note_joining(const Joining& joining);
  void name_by_texts();
  void unite_holes();
  void keep_open(const Outline& line);
  void nest_outlines();

  ImportOptions options_;
  std::size_t vertices_ = 0;
  std::string gap_;
  double left_open_ = 0;  // the greatest_open of the pieces (joining.h)
  std::size_t open_points_ = 0;
  struct Text {
    Vec2 at;
    std::string words, kind;
  };
  std::vector<Text> texts_;
  std::map<std::string, std::size_t> numbers_of_blocks_;
  std::vector<std::string> blocks_;  // their names
  std::vector<std::size_t> copies_;  // the block of each, from copy 1
  std::vector<Drawn> drawn_;         // by shape, if the shapes are outlines of a drawing
  std::size_t paths_ = 0;
  std::size_t same_way_ = 0;  // rings of paths that were read as holes
  std::size_t outlines_ = 0;  // all shapes and, in a drawing, all holes
  std::size_t without_area_ = 0, problems_ = 0, spikes_ = 0;
  std::optional<InputError> first_problem_, full_;
};

// The box around all vertices. O(vertices).
Box box_of(const std::vector<ImportedShape>& shapes);

}  // namespace evenlift
