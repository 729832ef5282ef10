// Errors are values: what is wrong, and where. No function of the core throws on bad input.
#pragma once

#include <cassert>
#include <cstddef>
#include <string>
#include <utility>
#include <variant>

namespace evenlift {

enum class ErrorCode {
  too_few_vertices,     // fewer than 3
  too_many_vertices,    // more than max_vertices
  bad_coordinate,       // not finite, or beyond max_coordinate in size
  repeated_vertex,      // two vertices at the same place
  no_area,              // all vertices on one line
  edges_cross,          // edges cross, touch or overlap
  object_too_small,     // the diagonal of the bounding box is below min_diagonal
  centre_outside_hull,  // C not strictly inside the convex hull of P
  bad_setting,          // a setting outside its range
  too_many_edge_pairs,  // more than max_edge_pairs
  bad_syntax,           // a text that is in none of the formats, or breaks off
  unsupported,          // a valid text of a kind that is not handled (holes, other geometries)
  text_too_long,        // more than max_text_bytes, or of a link more than max_link_bytes
  bad_link,             // a link with a character, length or value that no writer makes
  bad_checksum,         // a link that was cut off or altered
  unknown_version,      // a link of a newer version
};

// Where in the input. `index` counts from 0 for vertices and edges (edge i runs from vertex i to
// vertex i + 1), from 1 for lines, columns and the characters of a link (0: the link as a whole).
// `other` is the second vertex or edge of a pair (index < other), or the column of a line in
// characters, and equals `index` or 0 where there is none.
struct Place {
  enum class Kind { nowhere, line, vertex, edge, centre_of_mass, option, link };
  Kind kind = Kind::nowhere;
  std::size_t index = 0;
  std::size_t other = 0;
  std::string option;  // for Kind::option: the setting's name as in JSON ("min_ratio")
};

struct InputError {
  ErrorCode code;
  std::string message;  // one clear sentence without the place, no full stop
  Place place;
};

// The place in words for people ("vertex 3", "edges 2 and 7", "line 4, column 2", "centre of mass",
// "link, character 5"; of an option its name); empty for nowhere. Vertices and edges are counted
// from 1 here, as people do. O(1).
std::string describe(const Place& place);

// A value or the error that prevented it.
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
  T value() && {
    assert(ok());
    return std::move(*std::get_if<T>(&held_));
  }  // a copy: binds safely
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
