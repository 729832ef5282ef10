// Reads texts, and finds the places of errors in them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "evenlift/result.h"

namespace evenlift {

// The place of the byte at `offset`, which may be the end of the text. A line ends with LF, CR LF
// or CR. Columns count UTF-8 characters. O(offset).
Place place_in_text(std::string_view text, std::size_t offset);

// Makes an error whose place is the byte at `offset`. O(offset).
InputError text_error(ErrorCode code, std::string message, std::string_view text,
                      std::size_t offset);

// Names the character at `offset`: "'x'", "a tab", "the byte 0xc3", "the end of the line" or "the
// end of the text". Use say() to put the name into a sentence. O(1).
std::string found_in_text(std::string_view text, std::size_t offset);

bool is_letter(char c);         // a letter of ASCII, in any locale
bool is_digit(char c);          // 0 to 9
char lower_case(char c);        // changes letters of ASCII only
bool ends_line(char c);         // LF or CR
bool is_space_in_line(char c);  // space or tab

// The text without spaces and tabs at its ends. O(length).
std::string_view trimmed(std::string_view text);

// A place in a text, which moves forward as the text is read. The text must outlive the cursor.
class TextCursor {
 public:
  explicit TextCursor(std::string_view text) : text_(text) {}

  std::size_t offset() const { return at_; }
  bool at_end() const { return at_ == text_.size(); }
  bool at_line_end() const { return at_end() || ends_line(text_[at_]); }
  bool sees(char c) const { return !at_end() && text_[at_] == c; }
  bool sees_letter() const { return !at_end() && is_letter(text_[at_]); }
  bool sees_number() const;

  // Skips the next character if it is `c`. Returns whether it was.
  bool take(char c);
  void skip_spaces_in_line();
  void skip_white_space();
  // The letters at the cursor, perhaps none, as a view of the text. take_word() also skips them.
  std::string_view word() const;
  std::string_view take_word();
  std::string_view take_rest_of_line();

  // Reads a number into `value` and skips it, or returns an error. `what` completes "expected ...".
  std::optional<InputError> take_number(double& value, const char* what);

  // Makes the error "expected WHAT but found ...".
  InputError expected(const std::string& what) const;
  InputError error(ErrorCode code, std::string message) const;
  InputError error_at(std::size_t offset, ErrorCode code, std::string message) const;

 private:
  std::string_view text_;
  std::size_t at_ = 0;
};

// Whether the words are equal apart from case; `lower` must be in lower case. O(length).
bool same_word(std::string_view word, std::string_view lower);

// Words with a space between them, as a literal: "max maximum rated"_words.
class WordList {
 public:
  constexpr explicit WordList(std::string_view words) : words_(words) {}
  bool has(std::string_view word) const;  // O(list)

 private:
  std::string_view words_;
};
constexpr WordList operator""_words(const char* words, std::size_t size) {
  return WordList({words, size});
}

}  // namespace evenlift
