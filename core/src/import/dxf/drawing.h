// DXF drawings: groups, objects, units, layers, blocks, letters and outlines.
#pragma once

#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "curves/outline.h"
#include "evenlift/angles.h"
#include "evenlift/document.h"
#include "evenlift/result.h"
#include "evenlift/vec.h"

namespace evenlift {

// --- The groups of a DXF text. A group is a pair of lines: a code and a value.

struct DxfGroup {
  int code;
  std::string_view value;
  std::size_t offset;  // the place of the value in the text
};

// Reads the groups of a text, which must outlive this reader.
class DxfGroups {
 public:
  explicit DxfGroups(std::string_view text, std::size_t from = 0) : text_(text), at_(from) {}

  // The next group, or nullopt at the end. If the code is not a whole number from -9999 to 9999,
  // also returns nullopt, and makes broken() true. O(bytes of the group).
  std::optional<DxfGroup> next();
  bool broken() const { return broken_; }
  // code_offset() is the place where the group last read begins, and offset() where the next one
  // begins.
  std::size_t code_offset() const { return code_at_; }
  std::size_t offset() const { return at_; }

 private:
  std::string_view line();

  std::string_view text_;
  std::size_t at_ = 0, code_at_ = 0;
  bool broken_ = false;
};

// --- The objects of a DXF drawing.

inline constexpr std::size_t max_dxf_groups = std::size_t{1} << 22;  // limit for a single object

struct DxfVertex {
  Vec2 point;
  double bulge = 0;  // the bulge of the edge that follows
  double height = 0;
  int flags = 0;
};

// An object of the drawing. Its texts are views of the drawing's text. If a group should be a
// number but is not, it counts as 0, and bad_number() returns the place of the first such group.
class DxfEntity {
 public:
  std::string_view type;
  std::vector<DxfGroup> groups;
  std::vector<DxfVertex> vertices;  // the VERTEX objects of a POLYLINE

  void begin(std::string_view new_type);
  double number(const DxfGroup& group);
  // The number in the first group with this code; `otherwise` if there is no such group. O(groups).
  double number_of(int code, double otherwise);
  std::string_view text_of(int code) const;
  Vec2 point_of(int code) { return {number_of(code, 0), number_of(code + 10, 0)}; }
  int flags();  // bits
  // Whether the object is seen from behind, so that the x axis of its own coordinates points left.
  bool seen_from_behind() { return number_of(230, 1) < 0; }
  // The tilt of the object's plane: the larger of |x| and |y| for its unit normal. It is 0 if the
  // plane is seen straight on, and at most 1.
  double tilt();
  const std::optional<std::size_t>& bad_number() const { return bad_number_; }
  void add_bad_number(std::size_t offset) {
    if (!bad_number_) bad_number_ = offset;
  }

 private:
  std::optional<std::size_t> bad_number_;
};

// Reads the objects of a section or block one after another. read_dxf_drawing() must already have
// accepted the text.
class DxfEntities {
 public:
  DxfEntities(std::string_view text, std::size_t from)
      : text_(text), from_(from), groups_(text, from) {}

  // The next object, valid until the next call; nullptr at the end or after an error. O(bytes of
  // the object).
  DxfEntity* next();
  std::size_t bytes_read() const { return groups_.offset() - from_; }  // so far
  std::optional<InputError> error() const;

 private:
  void advance();
  void read_groups(DxfEntity& entity);
  void read_vertices();
  bool has_room(std::size_t count);

  std::string_view text_;
  std::size_t from_;
  DxfGroups groups_;
  DxfEntity entity_, vertex_;
  std::optional<DxfGroup> pending_;  // the first group of the next object
  bool begun_ = false;
  std::optional<std::size_t> too_long_;  // where an object has too many groups or vertices
};

// --- The unit, layers and blocks of a DXF drawing.

// The unit that $INSUNITS gives: its label if evenlift has one, otherwise its name in `other`. Both
// are empty if the drawing gives no unit.
struct DxfUnit {
  LengthUnit label = LengthUnit::none;
  const char* other = "";
};

struct DxfLayer {
  bool off = false, frozen = false;
};

struct DxfBlock {
  std::string_view name;
  Vec2 base;
  std::size_t offset = 0;        // of its first object in the text
  bool in_another_file = false;  // an external reference
};

struct DxfDrawing {
  DxfUnit unit;
  std::vector<std::size_t> entities;  // of each ENTITIES section: the offset just after its name

  // The layer or block with this name; nullptr if there is none. The case of ASCII letters does not
  // matter. If two layers, or two blocks, have the same name, the first counts. O(log n).
  const DxfLayer* layer(std::string_view name) const;
  const DxfBlock* block(std::string_view name) const;

  std::map<std::string, DxfLayer> layers;  // the keys of both maps are names in lower case
  std::map<std::string, DxfBlock> blocks;
};

// Reads the unit, the layers and the blocks, but no objects, and checks that the text consists of
// pairs of lines up to EOF. The text must outlive the drawing, which refers to it. O(bytes log n)
// for n layers and blocks.
Result<DxfDrawing> read_dxf_drawing(std::string_view text);

// --- The letters of DXF drawings.

// A drawing's text as UTF-8. Before 2007 programs wrote the letters of the code page that
// $DWGCODEPAGE names: Windows 874, 932, 936, 949, 950 and 1250 to 1258.
struct DxfLetters {
  std::optional<std::string>
      text;             // if it had to be converted. Bytes without a letter become U+FFFD
  std::string unknown;  // the name of a code page that is not known here
};

// Converts a text that is not UTF-8 yet; lines keep their numbers. O(bytes).
DxfLetters in_utf8(std::string_view text);

// A name with the letters for which programs write \U+00DF, where their code page has none. O(bytes).
std::string with_letters(std::string_view name);

// --- Converts directions in degrees to vectors.

// The unit vector at this angle, counter-clockwise from the x axis. It is exact for multiples of 90
// degrees, so a block that is turned by such an angle keeps its right angles. O(1).
inline Vec2 direction_of(double degrees) {
  const double turn = std::fmod(degrees, 360);
  const double quarters = std::floor(turn / 90 + 0.5);
  const double rest = (turn - 90 * quarters) * (pi / 180);
  Vec2 direction = rest == 0 ? Vec2(1, 0) : Vec2(cosine(rest), sine(rest));
  for (int i = static_cast<int>(quarters) & 3; i > 0; --i) direction = left_normal(direction);
  return direction;
}

// --- Reads the outlines of DXF objects, in the coordinates of the drawing or block that contains them.

// The name of a kind of object that is left out, in the singular and in the plural.
struct DxfName {
  const char* one;
  const char* many;
};

// An outline, perhaps without pieces, or a reason why the object cannot be read.
struct DxfDrawn {
  Outline outline;
  const char* closed_kind = nullptr;  // such as "circle"; nullptr for an open outline
  const DxfName* reason = nullptr;
  bool made_periodic = false;  // a spline marked as periodic had the knots of an open one
};

// The outline of a LINE, ARC, CIRCLE, ELLIPSE, LWPOLYLINE, POLYLINE or SPLINE; nullopt for other
// objects. A spline is closed if its ends differ in x and in y by at most same_point (outline.h)
// times the larger side of the box around its control points. An ellipse is closed if its angle
// differs from a full turn by less than same_point radians. O(groups + vertices); for splines the
// cost is that of Outline::b_spline().
std::optional<DxfDrawn> draw(DxfEntity& entity);

}  // namespace evenlift
