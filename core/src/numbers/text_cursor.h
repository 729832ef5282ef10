// A place in a text that is being read, and errors that say where it is.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "evenlift/result.h"

namespace evenlift {

// Line and column of the byte at `offset` (the end of the text, if beyond). A line ends with LF, CR
// LF or CR; columns count the characters of UTF-8. O(offset).
Place place_in_text(std::string_view text, std::size_t offset);

// The error at the byte at `offset`. O(offset).
InputError text_error(ErrorCode code, std::string message, std::string_view text,
                      std::size_t offset);

// What stands at `offset`, for messages: "'x'", "the end of the line", "the end of the text". O(1).
std::string found_in_text(std::string_view text, std::size_t offset);

bool is_letter(char c);         // of ASCII, whatever the locale
char lower_case(char c);        // of ASCII
bool ends_line(char c);         // LF or CR
bool is_space_in_line(char c);  // space or tab

// Reads from front to back. The text outlives the cursor.
class TextCursor {
 public:
  explicit TextCursor(std::string_view text) : text_(text) {}

  std::size_t offset() const { return at_; }
  bool at_end() const { return at_ == text_.size(); }
  bool at_line_end() const { return at_end() || ends_line(text_[at_]); }
  bool sees(char c) const { return !at_end() && text_[at_] == c; }
  bool sees_letter() const { return !at_end() && is_letter(text_[at_]); }
  bool sees_number() const;

  // Skips one character if it is the one given.
  bool take(char c);
  void skip_spaces_in_line();
  void skip_white_space();
  // The letters here, a view of the text, perhaps empty; take_word() skips them.
  std::string_view word() const;
  std::string_view take_word();

  // Skips a number into `value`; otherwise the error. `what` completes "expected ...".
  std::optional<InputError> take_number(double& value, const char* what);

  // "expected WHAT but found ..." here.
  InputError expected(const std::string& what) const;
  InputError error(ErrorCode code, std::string message) const;
  InputError error_at(std::size_t offset, ErrorCode code, std::string message) const;

 private:
  std::string_view text_;
  std::size_t at_ = 0;
};

// Whether the word is `lower` but for case. O(length).
bool same_word(std::string_view word, std::string_view lower);

}  // namespace evenlift
