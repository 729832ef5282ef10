#include "import/dxf/drawing.h"

#include <iconv.h>
#include <cstdint>
#include <utility>

#include "numbers/number_text.h"

namespace evenlift {
namespace {

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t length = static_cast<unsigned char>(text[0]) < 0x80 ? 1 : utf8_length(text);
    if (length == 0) return false;
    text.remove_prefix(length);
  }
  return true;
}

// The value of $DWGCODEPAGE, such as ANSI_1252, near the beginning of the text.
std::string_view code_page_of(std::string_view text) {
  constexpr std::size_t longest_header = std::size_t{1} << 18;
  const std::size_t at = text.substr(0, longest_header).find("$DWGCODEPAGE");
  if (at == std::string_view::npos) return {};
  DxfGroups groups(text, text.find('\n', at) + 1);
  const auto value = groups.next();
  return value && value->code == 3 ? value->value : std::string_view();
}

struct CodePage {
  std::string_view ending;     // of its name
  const char *name, *synonym;  // in the libraries for natives and for WebAssembly
};
constexpr CodePage known_pages[] = {{"_874", "CP874", "TIS-620"},
                                    {"_932", "CP932", "SHIFT_JIS"},
                                    {"_936", "CP936", "GBK"},
                                    {"_949", "CP949", "EUC-KR"},
                                    {"_950", "CP950", "BIG5"},
                                    {"_1250", "CP1250", "WINDOWS-1250"},
                                    {"_1251", "CP1251", "WINDOWS-1251"},
                                    {"_1252", "CP1252", "WINDOWS-1252"},
                                    {"_1253", "CP1253", "WINDOWS-1253"},
                                    {"_1254", "CP1254", "WINDOWS-1254"},
                                    {"_1255", "CP1255", "WINDOWS-1255"},
                                    {"_1256", "CP1256", "WINDOWS-1256"},
                                    {"_1257", "CP1257", "WINDOWS-1257"},
                                    {"_1258", "CP1258", "WINDOWS-1258"}};

std::optional<std::string> decoded(const CodePage& page, std::string_view text) {
  const iconv_t unknown = reinterpret_cast<iconv_t>(-1);
  iconv_t converter = iconv_open("UTF-8", page.name);
  if (converter == unknown) converter = iconv_open("UTF-8", page.synonym);
  if (converter == unknown) return std::nullopt;
  std::string letters, bytes(text);
  char* from = bytes.data();
  std::size_t left = bytes.size();
  char buffer[4096];
  while (left > 0) {
    char* to = buffer;
    std::size_t room = sizeof buffer;
    const std::size_t before = left;
    iconv(converter, &from, &left, &to, &room);
    letters.append(buffer, to);
    if (left == 0 || left < before || to != buffer) continue;
    letters += "\uFFFD";  // for a byte without a letter
    ++from;
    --left;
  }
  iconv_close(converter);
  return letters;
}

void append_utf8(std::string& text, std::uint32_t letter) {
  const auto add = [&](std::uint32_t byte) { text += static_cast<char>(byte); };
  if (letter < 0x80) return add(letter);
  if (letter < 0x800) {
    add(0xC0 | letter >> 6);
  } else {
    add(0xE0 | letter >> 12);
    add(0x80 | (letter >> 6 & 0x3F));
  }
  add(0x80 | (letter & 0x3F));
}

// Of four hexadecimal digits; half of a pair (a surrogate) is no letter.
std::optional<std::uint32_t> letter_of(std::string_view digits) {
  std::uint32_t letter = 0;
  if (digits.size() < 4) return std::nullopt;
  for (const char c : digits.substr(0, 4)) {
    const int digit = c >= '0' && c <= '9'   ? c - '0'
                      : c >= 'A' && c <= 'F' ? c - 'A' + 10
                      : c >= 'a' && c <= 'f' ? c - 'a' + 10
                                             : -1;
    if (digit < 0) return std::nullopt;
    letter = 16 * letter + static_cast<std::uint32_t>(digit);
  }
  if (letter >= 0xD800 && letter < 0xE000) return std::nullopt;
  return letter;
}

}  // namespace

DxfLetters in_utf8(std::string_view text) {
  const std::string_view page = code_page_of(text);
  if (page.empty() || is_utf8(text)) return {};
  for (const CodePage& known : known_pages)
    if (page.ends_with(known.ending))
      if (auto letters = decoded(known, text)) return {std::move(letters), {}};
  return {std::nullopt, std::string(page)};
}

std::string with_letters(std::string_view name) {
  std::string text;
  while (!name.empty()) {
    const auto letter = name.starts_with("\\U+") ? letter_of(name.substr(3)) : std::nullopt;
    if (letter)
      append_utf8(text, *letter);
    else
      text += name[0];
    name.remove_prefix(letter ? 7 : 1);
  }
  return text;
}

}  // namespace evenlift
