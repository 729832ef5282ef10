// The result of a reader so far: shapes within bounds, and the list of parts that are left out.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "curves/outline.h"
#include "evenlift/import.h"
#include "import/joining/joining.h"
#include "import/joining/nesting.h"

namespace evenlift {

// Drawings repeat points, and the ends that should meet differ by small errors. Points closer than
// this fraction of the larger side count as one.
inline constexpr double same_point = 1e-5;

double larger_side(const Box& box);

// A rounded number of at most four digits, such as 12.35 or 120.
std::string short_number(double value);

// "1 text", "2 texts".
std::string counted(std::size_t count, std::string_view one, std::string_view many);

// A text of the user between quotation marks, in which it is never translated.
std::string in_quotes(std::string_view text);

// A name for display: valid UTF-8 of at most 80 characters, on one line.
std::string clean_name(std::string_view name);

// Counts the objects that are left out, by their names.
class LeftOut {
 public:
  void add(std::string_view one, std::string_view many);
  bool empty() const { return counts_.empty(); }
  // "2 texts and 1 dimension", in the order of first appearance.
  std::string list() const;
  std::size_t total() const;

 private:
  struct Kind {
    std::string one, many;
    std::size_t count;
  };
  std::vector<Kind> counts_;
};

// A closed shape of a drawing, or a path of several closed parts.
struct DrawnShape {
  std::vector<Outline> parts;
  std::string_view name;
  std::string kind;
  Fill fill = Fill::none;
};

class Gathering {
 public:
  explicit Gathering(const ImportOptions& options) : options_(options) {}

  Import import;
  LeftOut left_out;

  // Adds the closed parts of a drawing: what a fill makes of them, or each as an outline, of which
  // finish() makes shapes and holes. A problem of a part leaves out only this part.
  void add(const DrawnShape& drawn);
  // Joins open pieces of a drawing and adds their outlines. A piece that meets no other is closed by
  // a straight edge if `closes_alone`. Notes what was joined, dropped and left open.
  void add_joined(const std::vector<DrawnPiece>& pieces, bool closes_alone);
  // Where two ends stayed open, as part of a sentence; empty if none did.
  const std::string& gap() const { return gap_; }
  // Adds vertices and holes unchanged.
  void add(Document document, std::string_view name, std::string_view kind);
  // Leaves out a shape because of an error in it.
  void add_problem(InputError error);
  // There is no room for more shapes or vertices, so a reader may stop.
  bool full() const { return full_.has_value(); }
  // The number of holes that a reader keeps for a shape; without a limit if they are left out later.
  std::size_t most_holes() const { return options_.holes ? max_holes : max_vertices; }
  // Degrees are converted once the text is read, so they need no note.
  bool projects() const { return options_.project; }
  // Adds the sentence in the reader's language.
  void note(std::string_view sentence);

  // Returns the import. Without a shape it returns the first problem, or else `nothing`.
  Result<Import> finish(InputError nothing);

 private:
  // How an outline of import.shapes was drawn.
  struct Drawn {
    bool filled;
    std::size_t path, part;  // numbers
  };
  struct Flattened;

  bool has_room(std::size_t vertices);
  std::optional<ImportedShape> flattened(const Outline& outline);
  void add_filled(const DrawnShape& drawn, std::vector<Flattened> rings);
  void name_parts(const std::vector<OutlineWithHoles>& shapes);
  void note_joining(const Joining& joining);
  void keep_open(const Outline& line);
  void nest_outlines();

  ImportOptions options_;
  std::size_t vertices_ = 0;
  std::string gap_;
  double left_open_ = 0;  // the greatest_open of the pieces (joining.h)
  std::size_t open_points_ = 0;
  std::vector<Drawn> drawn_;  // of each shape, if they are outlines of a drawing
  std::size_t paths_ = 0;
  std::size_t outlines_ = 0;  // the shapes, and the holes that came with an outline of a drawing
  std::size_t without_area_ = 0, problems_ = 0;
  std::optional<InputError> first_problem_, full_;
};

}  // namespace evenlift
