#include "link/link_text.h"

#include <algorithm>
#include <utility>

#include "evenlift/wording.h"
#include "numbers/text_cursor.h"

namespace evenlift {
namespace {

constexpr std::string_view alphabet =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";
constexpr std::size_t checksum_digits = 4;

// The CRC-24 of OpenPGP (RFC 4880, 6.1). It detects every change within 24 consecutive bits, such
// as a changed character or two swapped neighbours, and all but one in 16 million others.
std::uint32_t checksum(std::string_view text) {
  std::uint32_t crc = 0xb704ce;
  for (const char c : text) {
    crc ^= static_cast<std::uint32_t>(static_cast<unsigned char>(c)) << 16;
    for (int bit = 0; bit < 8; ++bit) {
      crc <<= 1;
      if ((crc & 0x1000000u) != 0) crc ^= 0x1864cfbu;
    }
  }
  return crc;
}

std::string checksum_text(std::string_view text) {
  std::uint32_t rest = checksum(text);
  std::string digits(checksum_digits, ' ');
  for (std::size_t i = checksum_digits; i-- > 0; rest >>= 6) digits[i] = alphabet[rest & 63];
  return digits;
}

}  // namespace

bool is_decimal_digit(char c) { return c >= '0' && c <= '9'; }
bool is_white_space(char c) { return is_space_in_line(c) || ends_line(c); }

std::size_t end_of_link(std::string_view text, std::size_t begin, std::size_t end) {
  constexpr std::string_view punctuation = ".,;:!?)]}>\"'";
  end = std::min(end, text.find('&', begin));
  const std::size_t version_end = std::min(text.find('.', begin), end);
  while (end > version_end + 1 && punctuation.find(text[end - 1]) != std::string_view::npos) --end;
  return end;
}

std::optional<std::uint8_t> digit_of(char c) {
  const std::size_t at = alphabet.find(c);
  if (at == std::string_view::npos) return std::nullopt;
  return static_cast<std::uint8_t>(at);
}

InputError link_error(ErrorCode code, std::string message, std::size_t character) {
  return {code, std::move(message), {Place::Kind::link, character, 0, {}}};
}

InputError bad_character(std::string_view text, std::size_t at) {
  if (text[at] == '%') {
    return link_error(ErrorCode::bad_link,
                      "the link was escaped on its way: it contains a '%', which no link does",
                      at + 1);
  }
  if (is_white_space(text[at])) {
    return link_error(ErrorCode::bad_link, "the link is broken by a space or the end of a line",
                      at + 1);
  }
  return link_error(ErrorCode::bad_link,
                    say("{character} cannot be in a link", {found_in_text(text, at)}), at + 1);
}

void append_digits(std::string& link, const Digits& digits) {
  for (const std::uint8_t digit : digits) link += alphabet[digit];
  link += checksum_text(link);
}

Result<Digits> read_digits(std::string_view text, std::size_t begin, std::size_t payload,
                           std::size_t end) {
  Digits digits;
  digits.reserve(end - payload);
  for (std::size_t at = payload; at < end; ++at) {
    const auto digit = digit_of(text[at]);
    if (!digit) return bad_character(text, at);
    digits.push_back(*digit);
  }
  if (digits.size() < checksum_digits) {
    return link_error(ErrorCode::bad_checksum, "the link is cut off");
  }
  const std::size_t sum = end - checksum_digits;
  if (text.substr(sum, checksum_digits) != checksum_text(text.substr(begin, sum - begin))) {
    return link_error(ErrorCode::bad_checksum, "the link was cut off or altered on its way");
  }
  digits.resize(digits.size() - checksum_digits);
  return digits;
}

}  // namespace evenlift
