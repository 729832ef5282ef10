#include "numbers/text_cursor.h"

#include "evenlift/wording.h"
#include "numbers/number_text.h"

namespace evenlift {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
char lower_case(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }
bool ends_line(char c) { return c == '\n' || c == '\r'; }
bool is_space_in_line(char c) { return c == ' ' || c == '\t'; }

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_space_in_line(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space_in_line(text.back())) text.remove_suffix(1);
  return text;
}

bool same_word(std::string_view word, std::string_view lower) {
  if (word.size() != lower.size()) return false;
  for (std::size_t i = 0; i < word.size(); ++i) {
    if (lower_case(word[i]) != lower[i]) return false;
  }
  return true;
}

std::string csv_cell(std::string text) {
  if (!text.empty() && std::string_view("=+-@").find(text[0]) != std::string_view::npos)
    text.insert(0, "'");
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

Place place_in_text(std::string_view text, std::size_t offset) {
  if (offset > text.size()) offset = text.size();
  Place place{Place::Kind::line, 1, 1, {}};
  for (std::size_t i = 0; i < offset; ++i) {
    const char c = text[i];
    const bool first_of_pair = c == '\r' && i + 1 < text.size() && text[i + 1] == '\n';
    if (ends_line(c) && !first_of_pair) {
      ++place.index;
      place.other = 1;
    } else if ((static_cast<unsigned char>(c) & 0xc0) != 0x80) {  // not a continuation byte
      ++place.other;
    }
  }
  return place;
}

InputError text_error(ErrorCode code, std::string message, std::string_view text,
                      std::size_t offset) {
  return {code, std::move(message), place_in_text(text, offset)};
}

std::string found_in_text(std::string_view text, std::size_t offset) {
  if (offset >= text.size()) return "the end of the text";
  const char c = text[offset];
  if (ends_line(c)) return "the end of the line";
  if (c == '\t') return "a tab";
  if (c >= ' ' && c <= '~') return std::string("'") + c + "'";
  static constexpr char hex[] = "0123456789abcdef";
  const auto byte = static_cast<unsigned char>(c);
  return say("the byte 0x{digits}", {std::string{hex[byte >> 4], hex[byte & 15]}});
}

bool TextCursor::take(char c) {
  if (!sees(c)) return false;
  ++at_;
  return true;
}

void TextCursor::skip_spaces_in_line() {
  while (!at_end() && is_space_in_line(text_[at_])) ++at_;
}

void TextCursor::skip_white_space() {
  while (!at_end() && (is_space_in_line(text_[at_]) || ends_line(text_[at_]))) ++at_;
}

bool TextCursor::sees_number() const {
  return scan_number(text_.substr(at_)).kind != ScannedNumber::Kind::none;
}

std::string_view TextCursor::word() const {
  std::size_t end = at_;
  while (end < text_.size() && is_letter(text_[end])) ++end;
  return text_.substr(at_, end - at_);
}

std::string_view TextCursor::take_word() {
  const std::string_view taken = word();
  at_ += taken.size();
  return taken;
}

std::string_view TextCursor::take_rest_of_line() {
  const std::size_t start = at_;
  while (!at_line_end()) ++at_;
  return text_.substr(start, at_ - start);
}

std::optional<InputError> TextCursor::take_number(double& value, const char* what) {
  const ScannedNumber number = scan_number(text_.substr(at_));
  switch (number.kind) {
    case ScannedNumber::Kind::none:
      return expected(what);
    case ScannedNumber::Kind::too_large:
      return error(ErrorCode::bad_coordinate, "the number is too large");
    case ScannedNumber::Kind::finite:
      break;
  }
  value = number.value;
  at_ += number.length;
  return std::nullopt;
}

InputError TextCursor::expected(const std::string& what) const {
  return error(ErrorCode::bad_syntax,
               say("expected {what} but found {found}", {what, found_in_text(text_, at_)}));
}

InputError TextCursor::error(ErrorCode code, std::string message) const {
  return text_error(code, std::move(message), text_, at_);
}

InputError TextCursor::error_at(std::size_t offset, ErrorCode code, std::string message) const {
  return text_error(code, std::move(message), text_, offset);
}

bool WordList::has(std::string_view word) const {
  if (word.empty() || word.find(' ') != word.npos) return false;
  for (std::size_t at = words_.find(word); at != words_.npos; at = words_.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if ((at == 0 || words_[at - 1] == ' ') && (end == words_.size() || words_[end] == ' '))
      return true;
  }
  return false;
}

}  // namespace evenlift
