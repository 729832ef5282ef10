// Reads texts, and tells the places of errors.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "evenlift/result.h"

namespace evenlift {

// Of the byte at `offset`, at most the end of the text. A line ends with LF, CR LF or CR. Columns
// count UTF-8 characters. O(offset).
Place place_in_text(std::string_view text, std::size_t offset);

// The error's place is the byte at `offset`. O(offset).
InputError text_error(ErrorCode code, std::string message, std::string_view text,
                      std::size_t offset);

// "'x'", "the end of the line", "the end of the text". Put it into a sentence by say(). O(1).
std::string found_in_text(std::string_view text, std::size_t offset);

bool is_letter(char c);         // of ASCII, in any locale
char lower_case(char c);        // of ASCII
bool ends_line(char c);         // LF or CR
bool is_space_in_line(char c);  // space or tab

// Without spaces and tabs at the ends. O(length).
std::string_view trimmed(std::string_view text);

// The text must outlive the cursor.
class TextCursor {
 public:
  explicit TextCursor(std::string_view text) : text_(text) {}

  std::size_t offset() const { return at_; }
  bool at_end() const { return at_ == text_.size(); }
  bool at_line_end() const { return at_end() || ends_line(text_[at_]); }
  bool sees(char c) const { return !at_end() && text_[at_] == c; }
  bool sees_letter() const { return !at_end() && is_letter(text_[at_]); }
  bool sees_number() const;

  // Skips `c` if it is the next character. Returns whether it was.
  bool take(char c);
  void skip_spaces_in_line();
  void skip_white_space();
  // Perhaps no letters; a view of the text. take_word() also skips them.
  std::string_view word() const;
  std::string_view take_word();
  std::string_view take_rest_of_line();

  // Skips a number, or returns an error. `what` completes "expected ...".
  std::optional<InputError> take_number(double& value, const char* what);

  // "expected WHAT but found ...".
  InputError expected(const std::string& what) const;
  InputError error(ErrorCode code, std::string message) const;
  InputError error_at(std::size_t offset, ErrorCode code, std::string message) const;

 private:
  std::string_view text_;
  std::size_t at_ = 0;
};

// Ignores case; `lower` must be lower case. O(length).
bool same_word(std::string_view word, std::string_view lower);

}  // namespace evenlift
