// The objects of a DXF drawing.
#pragma once

#include <optional>
#include <vector>

#include "evenlift/result.h"
#include "evenlift/vec.h"
#include "import/dxf/groups.h"

namespace evenlift {

inline constexpr std::size_t max_dxf_groups = std::size_t{1} << 22;  // limit for a single object

struct DxfVertex {
  Vec2 point;
  double bulge = 0;  // the bulge of the edge that follows
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
  // The bits of the flags; most objects have them in group 70.
  int flags_of(int code = 70);
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

}  // namespace evenlift
