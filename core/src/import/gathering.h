// Gathers a reader's shapes, and what is left out.
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

// Points closer than this part of the larger side count as one: drawings repeat points, and ends
// that should meet differ a little.
inline constexpr double same_point = 1e-5;

double larger_side(const Box& box);

// Rounded to at most four digits, such as 12.35 or 120.
std::string short_number(double value);

std::string counted(std::size_t count, std::string_view one, std::string_view many);

// The user's text in quotation marks, where it is never translated.
std::string in_quotes(std::string_view text);

// Valid UTF-8 of at most 80 characters, on one line.
std::string clean_name(std::string_view name);

// Counts objects by name.
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

// A closed shape, or a path of several closed parts.
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

  // Adds what a fill makes of closed parts, or each as an outline, of which finish() makes shapes
  // and holes. A problem leaves out only its part.
  void add(const DrawnShape& drawn);
  // Joins open pieces. If `closes_alone`, a straight edge closes a piece that meets no other. Notes
  // what was joined, dropped and left open.
  void add_joined(const std::vector<DrawnPiece>& pieces, bool closes_alone);
  // Where two ends stayed open, as part of a sentence; or empty.
  const std::string& gap() const { return gap_; }
  // Adds vertices and holes unchanged.
  void add(Document document, std::string_view name, std::string_view kind);
  // Leaves out the shape with this error.
  void add_problem(InputError error);
  // No room for more shapes or vertices: a reader may stop.
  bool full() const { return full_.has_value(); }
  // The most holes kept for a shape; unlimited if they are left out later.
  std::size_t most_holes() const { return options_.holes ? max_holes : max_vertices; }
  // Degrees are converted after reading, so they need no note.
  bool projects() const { return options_.project; }
  // Adds the sentence, translated.
  void note(std::string_view sentence);

  // Without a shape, returns the first problem, or else `nothing`.
  Result<Import> finish(InputError nothing);

 private:
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
  std::size_t outlines_ = 0;  // shapes, and holes that came with an outline of a drawing
  std::size_t without_area_ = 0, problems_ = 0;
  std::optional<InputError> first_problem_, full_;
};

}  // namespace evenlift
