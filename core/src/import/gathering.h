// What a reader has found so far: shapes within bounds, and what was left out.
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "curves/outline.h"
#include "evenlift/import.h"

namespace evenlift {

// Drawings repeat points, and draw ends that should meet, with errors of their own: what is closer
// than this part of the larger side counts as one point.
inline constexpr double same_point = 1e-5;

double larger_side(const Box& box);

// A number of at most four digits for people, such as 12.35 or 120.
std::string short_number(double value);

// The texts one after another.
std::string joined(std::initializer_list<std::string_view> texts);

// "1 text", "2 texts".
std::string counted(std::size_t count, std::string_view one, std::string_view many);

// A name for people: valid UTF-8 of at most 80 characters, in one line.
std::string clean_name(std::string_view name);

// Things that are left out, by what they are called.
class LeftOut {
 public:
  void add(std::string_view one, std::string_view many);
  bool empty() const { return counts_.empty(); }
  // "2 texts and 1 dimension", in the order in which each came first.
  std::string list() const;
  std::size_t total() const;

 private:
  struct Kind {
    std::string one, many;
    std::size_t count;
  };
  std::vector<Kind> counts_;
};

class Gathering {
 public:
  explicit Gathering(const ImportOptions& options) : options_(options) {}

  Import import;
  LeftOut left_out;

  // Adds an outline of a drawing as a closed shape. A problem of this shape alone leaves it out.
  void add(const Outline& outline, std::string_view name, std::string_view kind);
  // Adds vertices as they are.
  void add(Document document, std::string_view name, std::string_view kind);
  // Leaves a shape out because of an error in it.
  void add_problem(InputError error);
  // There is no room for more shapes or vertices: a reader may stop.
  bool full() const { return full_.has_value(); }
  void note(std::string sentence);

  // What was gathered. Without a shape it is the first problem, or else `nothing`.
  Result<Import> finish(InputError nothing);

 private:
  bool has_room(std::size_t vertices);

  ImportOptions options_;
  std::size_t vertices_ = 0;
  std::size_t without_area_ = 0, problems_ = 0;
  std::optional<InputError> first_problem_, full_;
};

}  // namespace evenlift
