// The groups of a DXF text. A group is a pair of lines: a code and a value.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace evenlift {

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

}  // namespace evenlift
