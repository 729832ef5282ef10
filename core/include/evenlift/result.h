// Errors are values that state what is wrong and where. The core never throws on bad input.
#pragma once

#include <cassert>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

namespace evenlift {

enum class ErrorCode {
  too_few_vertices,   // fewer than 3
  too_many_vertices,  // more than max_vertices, or more than max_holes holes
  bad_coordinate,     // not finite, beyond max_coordinate, or below min_coordinate and not 0
  repeated_vertex,
  no_area,              // all vertices on one line
  edges_cross,          // edges of one ring or of two rings cross, touch or overlap
  hole_outside,         // outside the polygon, or in another hole
  object_too_small,     // diagonal of the bounding box below min_diagonal
  centre_outside_hull,  // not strictly inside the convex hull of P
  bad_setting,          // outside its range, or not compatible with others
  too_many_edge_pairs,  // more than max_edge_pairs
  bad_syntax,           // a text in none of the formats, or one that breaks off
  unsupported,          // valid, but not supported, such as a geometry that is not a polygon
  text_too_long,        // more than max_text_bytes, or max_link_bytes for a link
  bad_link,             // a character, length or value that no writer produces
  bad_checksum,         // the link was cut off or altered
  unknown_version,      // written by a newer version
};

// A place in the input. For a vertex or an edge, `index` is its number, from 0 (edge i runs from
// vertex i to vertex i + 1). If only one is at fault, `other` is `index` or 0. If two are at fault,
// `other` is the number of the second; if both are in one ring, index < other. For a line, `index`
// is its number and `other` the column in characters, both from 1; an unknown column is 0. For a
// link, `index` is the character, from 1, or 0 for the whole link. `ring` and `other_ring` are the
// rings of `index` and `other`: 0 is the outline, and k is hole k, counted from 1. If the two rings
// differ, ring > other_ring, whatever the indices. For a hole, `ring` is its number.
struct Place {
  enum class Kind { nowhere, line, vertex, edge, hole, centre_of_mass, option, link };
  Kind kind = Kind::nowhere;
  std::size_t index = 0;
  std::size_t other = 0;
  std::string
      option;  // for Kind::option: its name or path in JSON ("min_ratio", "cargo[2].weight")
  std::size_t ring = 0, other_ring = 0;
};

struct InputError {
  ErrorCode code;
  std::string message;  // one sentence, without the place and without a full stop
  Place place = {};
};

// The error for an invalid setting or option. `name` is its name in JSON, and `why` is the message.
InputError bad_setting(std::string name, std::string why);

// The place in words: "vertex 3", "edges 2 and 7", "line 4, column 2", "centre of mass", "link,
// character 5", "hole 2, edge 3 and the outline's edge 5", "robot 4" for supports[3], "load 3" for
// cargo[2], or the name of an option. The text is empty for `nowhere`. Words count from 1. O(1).
std::string describe(const Place& place);

// path_of() returns the path in JSON of the member at fault, which counts from 0: "polygon[2]",
// "holes[0][3]", "centre_of_mass" or an option. It is empty for the other kinds. place_of_path()
// returns the place of such a path, which may lead farther into the member, or begin with "settings."
// or "document.", which does not count. O(1).
std::string path_of(const Place& place);
Place place_of_path(std::string_view path);

// A value, or the error that prevented it.
template <class T>
class Result {
 public:
  Result(T value) : held_(std::move(value)) {}
  Result(InputError error) : held_(std::move(error)) {}

  explicit operator bool() const { return std::holds_alternative<T>(held_); }
  bool ok() const { return std::holds_alternative<T>(held_); }

  const T& value() const& {
    assert(ok());
    return *std::get_if<T>(&held_);
  }
  T& value() & {
    assert(ok());
    return *std::get_if<T>(&held_);
  }
  // Returns by value, since a reference to the result of a temporary would dangle.
  T value() && {
    assert(ok());
    return std::move(*std::get_if<T>(&held_));
  }
  const T& operator*() const& { return value(); }
  T& operator*() & { return value(); }
  T operator*() && { return std::move(*this).value(); }
  const T* operator->() const { return &value(); }
  T* operator->() { return &value(); }

  const InputError& error() const {
    assert(!ok());
    return *std::get_if<InputError>(&held_);
  }

 private:
  std::variant<T, InputError> held_;
};

}  // namespace evenlift
