// Reads a JSON text as a sequence of events, each with its place. It wraps the event reader of
// nlohmann-json, which neither recurses nor builds a tree.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "evenlift/result.h"

namespace evenlift {

struct JsonValue {
  enum class Kind : std::uint8_t { object, array, string, number, boolean, null };
  Kind kind;
  std::size_t offset;     // the first byte of an object or array, the last byte of other values
  double number;          // for a number: the nearest double, finite; for a boolean: 1 or 0
  std::string_view text;  // for a string
};

// Receives the events. Each function returns whether to continue. A sink that stops the reader
// stores the reason itself.
class JsonSink {
 public:
  virtual bool value(const JsonValue& value) = 0;
  virtual bool key(std::string_view name, std::size_t offset) = 0;  // the name of the next value
  virtual bool end() = 0;                                           // the end of an object or array

 protected:
  ~JsonSink() = default;
};

// Reads the text and calls the sink. Returns an error if the text is not valid JSON or nests arrays
// and objects more than 64 deep; nullopt if it is valid or the sink stopped first. O(bytes).
std::optional<InputError> read_json(std::string_view text, JsonSink& sink);

// --- A JSON text as a tree in two arrays: one of values, with 32 bytes each, and one of strings.

// Enough for 1,048,576 vertices: for each one an array, its two numbers, and one further value.
inline constexpr std::size_t max_json_values = std::size_t{1} << 22;

inline constexpr char half_a_character[] = "this text has half a character";

class JsonTree {
 public:
  using Kind = JsonValue::Kind;
  using Index = std::uint32_t;

  // The text must outlive the tree. The place of an error is a line, and its `option` the path of the
  // value that is at fault. O(bytes).
  static Result<JsonTree> read(std::string_view text);

  Index root() const { return 0; }
  Kind kind(Index i) const { return nodes_[i].kind; }
  std::size_t offset(Index i) const { return nodes_[i].offset; }
  double number(Index i) const { return nodes_[i].number; }
  bool is_true(Index i) const { return nodes_[i].number == 1; }
  // The text of a string, and the name of a member.
  std::string_view text(Index i) const { return strings_[nodes_[i].string]; }
  std::string_view name(Index i) const { return strings_[nodes_[i].name]; }

  // Loop over the contents with these: for (Index i = first(at); i != end(at); i = next(i)).
  Index first(Index i) const { return i + 1; }
  Index end(Index i) const { return nodes_[i].next; }
  Index next(Index i) const { return nodes_[i].next; }

  // The way to a value from the root: "cargo[2].weight", or "" for the root. O(values before it that
  // are not inside others).
  std::string path(Index i) const;

  // The last member with this name; nullopt if there is no such member. O(members).
  std::optional<Index> member(Index object, std::string_view wanted) const;
  bool is_string(std::optional<Index> i, std::string_view wanted) const;

 private:
  friend class TreeBuilder;
  void add_to_path(std::string& path, Index parent, std::size_t before,
                   std::string_view name) const;
  struct Node {
    double number;
    Index next;  // the node after this value and its contents
    std::uint32_t offset;
    std::uint32_t string, name;
    Kind kind;
  };
  std::vector<Node> nodes_;
  std::vector<std::string> strings_ = {""};
};

}  // namespace evenlift
