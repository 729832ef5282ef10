// The text of share links: address, version, characters, checksum. payload.h explains the payload.
#include "evenlift/link.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "evenlift/numbers.h"
#include "evenlift/settings.h"
#include "link/payload.h"
#include "numbers/text_cursor.h"

namespace evenlift {
namespace {

constexpr std::string_view alphabet =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";
constexpr std::size_t checksum_digits = 4;

bool is_decimal_digit(char c) { return c >= '0' && c <= '9'; }
bool is_white_space(char c) { return is_space_in_line(c) || ends_line(c); }

// The value 0 .. 63 of a character of the alphabet.
std::optional<std::uint8_t> digit_of(char c) {
  const std::size_t at = alphabet.find(c);
  if (at == std::string_view::npos) return std::nullopt;
  return static_cast<std::uint8_t>(at);
}

// The CRC-24 of OpenPGP (RFC 4880, 6.1). It detects every change within 24 consecutive bits, which
// includes a changed character and two swapped neighbours. It misses one in 16 million other
// changes.
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

// The checksum of the text, as characters of the alphabet.
std::string checksum_text(std::string_view text) {
  std::uint32_t rest = checksum(text);
  std::string digits(checksum_digits, ' ');
  for (std::size_t i = checksum_digits; i-- > 0; rest >>= 6) digits[i] = alphabet[rest & 63];
  return digits;
}

// --- The permitted content of a link

std::optional<InputError> check_point(const Vec2& point, const Place& place) {
  if (!std::isfinite(point.x()) || !std::isfinite(point.y())) {
    return InputError{ErrorCode::bad_coordinate, "a coordinate is not a finite number", place};
  }
  if (std::fabs(point.x()) > max_coordinate || std::fabs(point.y()) > max_coordinate) {
    return InputError{ErrorCode::bad_coordinate, "a coordinate exceeds 1e9 in size", place};
  }
  return std::nullopt;
}

// Early links could contain any finite weight and distance, and all links stay readable. Values
// that are out of bounds today are refused when robots are placed.
std::optional<InputError> check_linked_settings(Settings settings, Shown shown) {
  const Settings usual;
  const auto is_positive = [](double value) { return value > 0 && std::isfinite(value); };
  if (is_positive(settings.weight)) settings.weight = usual.weight;
  if (is_positive(shown.com_radius)) shown.com_radius = 0;
  if (shown.capacity && is_positive(*shown.capacity)) shown.capacity.reset();
  if (settings.apart && is_positive(*settings.apart)) settings.apart.reset();
  return check_ranges(settings, shown);
}

std::optional<InputError> check_holes(const std::vector<Points>& holes) {
  for (std::size_t hole = 0; hole < holes.size(); ++hole) {
    Place place{Place::Kind::hole, 0, 0, {}};
    place.ring = place.other_ring = hole + 1;
    if (holes[hole].empty())
      return InputError{ErrorCode::too_few_vertices, "a link holds no hole without vertices",
                        place};
    for (std::size_t i = 0; i < holes[hole].size(); ++i) {
      place.kind = Place::Kind::vertex;
      place.index = place.other = i;
      if (auto error = check_point(holes[hole][i], place)) return error;
    }
  }
  return std::nullopt;
}

std::optional<InputError> check_linkable(const Document& document) {
  std::size_t vertices = document.vertices.size();
  for (const Points& hole : document.holes) vertices += hole.size();
  if (vertices > max_link_vertices || document.holes.size() > max_holes) {
    return InputError{
        ErrorCode::too_many_vertices, "a link holds at most 32768 vertices and 1000 holes", {}};
  }
  for (std::size_t i = 0; i < document.vertices.size(); ++i) {
    if (auto error = check_point(document.vertices[i], {Place::Kind::vertex, i, i, {}}))
      return error;
  }
  if (auto error = check_holes(document.holes)) return error;
  if (document.centre_of_mass) {
    const Place place{Place::Kind::centre_of_mass, 0, 0, {}};
    if (auto error = check_point(*document.centre_of_mass, place)) return error;
  }
  if (!is_moved(document.moved)) {
    return InputError{ErrorCode::bad_setting, "robots moved by hand stand where robots cannot", {}};
  }
  return check_linked_settings(document.settings, document.shown);
}

// --- A link within a text

InputError link_error(ErrorCode code, std::string message, std::size_t character = 0) {
  return {code, std::move(message), {Place::Kind::link, character, 0, {}}};
}

// The place of a link in a text that may have an address before it and white space around it.
struct Span {
  std::size_t
      address;  // the first character of the address, which ends with the '#' before `begin`
  std::size_t begin;
  std::size_t end;

  bool has_address() const { return begin > address; }
};

Span find_link(std::string_view text) {
  Span span{0, 0, text.size()};
  while (span.end > 0 && is_white_space(text[span.end - 1])) --span.end;
  while (span.address < span.end && is_white_space(text[span.address])) ++span.address;
  const std::size_t hash = text.substr(0, span.end).find('#', span.address);
  span.begin = hash == std::string_view::npos ? span.address : hash + 1;
  // Anything appended to an address after '&', such as parameters of visit counters, is not part of
  // the link.
  span.end = std::min(span.end, text.find('&', span.begin));
  // Nor is punctuation or a closing bracket of the surrounding text. The full stop after the
  // version stays.
  constexpr std::string_view punctuation = ".,;:!?)]}>\"'";
  const std::size_t version_end = std::min(text.find('.', span.begin), span.end);
  while (span.end > version_end + 1 &&
         punctuation.find(text[span.end - 1]) != std::string_view::npos)
    --span.end;
  return span;
}

// The error for the character at `at`, which a link cannot contain.
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
  return link_error(ErrorCode::bad_link, found_in_text(text, at) + " cannot be in a link", at + 1);
}

// The version of a link, and the offset of its payload.
struct Version {
  std::uint64_t number;  // 2^64 - 1 for a version that does not fit
  std::size_t payload;
};

Result<Version> read_version(std::string_view text, const Span& span) {
  std::size_t at = span.begin;
  while (at < span.end && is_decimal_digit(text[at])) ++at;
  if (at < span.end && text[at] == '%') return bad_character(text, at);
  if (at == span.begin || text[span.begin] == '0' || at == span.end || text[at] != '.') {
    return link_error(ErrorCode::bad_link,
                      "a link must begin with its version number and a full stop", at + 1);
  }
  const std::optional<std::uint64_t> number = read_whole(text.substr(span.begin, at - span.begin));
  return Version{number.value_or(~std::uint64_t{0}), at + 1};
}

Result<Digits> read_digits(std::string_view text, std::size_t begin, std::size_t end) {
  Digits digits;
  digits.reserve(end - begin);
  for (std::size_t at = begin; at < end; ++at) {
    const auto digit = digit_of(text[at]);
    if (!digit) return bad_character(text, at);
    digits.push_back(*digit);
  }
  return digits;
}

Result<Document> decode_version(LinkVersion version, std::size_t begin, std::string_view text,
                                const Span& span) {
  Result<Digits> digits = read_digits(text, begin, span.end);
  if (!digits) return digits.error();
  if (digits->size() < checksum_digits) {
    return link_error(ErrorCode::bad_checksum, "the link is cut off");
  }
  const std::size_t end = span.end - checksum_digits;
  if (text.substr(end, checksum_digits) !=
      checksum_text(text.substr(span.begin, end - span.begin))) {
    return link_error(ErrorCode::bad_checksum, "the link was cut off or altered on its way");
  }
  digits->resize(digits->size() - checksum_digits);
  Payload payload = decode_payload(version, *digits);
  if (const UnknownRecord* record = std::get_if<UnknownRecord>(&payload)) {
    return link_error(ErrorCode::unknown_version,
                      "the link was made by a newer evenlift: this one does not know its record " +
                          std::to_string(record->tag));
  }
  Document* document = std::get_if<Document>(&payload);
  if (!document || check_linkable(*document)) {
    return link_error(ErrorCode::bad_link, "the link contains data that evenlift never writes");
  }
  return std::move(*document);
}

}  // namespace

Result<std::string> encode_link(const Document& document) {
  if (auto error = check_linkable(document)) return *std::move(error);
  std::string link = std::to_string(static_cast<int>(version_for(document))) + '.';
  for (const std::uint8_t digit : encode_payload(document)) link += alphabet[digit];
  link += checksum_text(link);
  if (link.size() > max_link_bytes) {  // no known document has such a long link
    return InputError{ErrorCode::text_too_long, "the link would be longer than 1 MiB", {}};
  }
  return link;
}

Result<Document> decode_link(std::string_view text) {
  if (text.size() > max_link_bytes) {
    return link_error(ErrorCode::text_too_long, "the link is longer than 1 MiB");
  }
  const Span span = find_link(text);
  if (!span.has_address() && text.find("://") != std::string_view::npos) {
    return link_error(ErrorCode::bad_link, "the address has no '#' with a link after it");
  }
  if (span.begin == span.end) return link_error(ErrorCode::bad_link, "the link is empty");

  const Result<Version> version = read_version(text, span);
  if (!version) return version.error();
  constexpr auto newest = static_cast<std::uint64_t>(LinkVersion::two);
  if (version->number > newest) {
    return link_error(ErrorCode::unknown_version,
                      "the link was made by a newer evenlift: this one reads versions 1 and 2");
  }
  return decode_version(static_cast<LinkVersion>(version->number), version->payload, text, span);
}

bool looks_like_link(std::string_view text) {
  const Span span = find_link(text);
  for (std::size_t at = span.address; at < span.begin; ++at) {
    if (is_white_space(text[at])) return false;
  }
  std::size_t at = span.begin;
  while (at < span.end && is_decimal_digit(text[at])) ++at;
  if (at == span.begin || at == span.end || (text[at] != '.' && text[at] != '%')) return false;
  for (; at < span.end; ++at) {
    if (!digit_of(text[at]) && text[at] != '.' && text[at] != '%') return false;
  }
  return true;
}

}  // namespace evenlift
