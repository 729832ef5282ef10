#include "evenlift/link.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <utility>

#include "evenlift/document.h"
#include "evenlift/lesson_link.h"
#include "evenlift/numbers.h"
#include "evenlift/settings.h"
#include "evenlift/wording.h"
#include "link/lesson_primer.h"
#include "link/payload.h"
#include "link/range_coder.h"
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

// --- The text of share links: address, version, characters, checksum. The payload is in payload.h.

namespace {

// --- The permitted content of a link

std::optional<InputError> check_point(const Vec2& point, const Place& place) {
  if (!std::isfinite(point.x) || !std::isfinite(point.y)) {
    return InputError{ErrorCode::bad_coordinate, "a coordinate is not a finite number", place};
  }
  if (std::fabs(point.x) > max_coordinate || std::fabs(point.y) > max_coordinate) {
    return InputError{ErrorCode::bad_coordinate, "a coordinate exceeds 1e9 in size", place};
  }
  return std::nullopt;
}

// Early links could contain any finite weight and distance, and stay readable. Placing robots
// refuses values out of bounds.
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
    return InputError{ErrorCode::too_many_vertices,
                      "a link holds at most 32768 vertices and 1000 holes"};
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
    return InputError{ErrorCode::bad_setting, "robots moved by hand stand where robots cannot"};
  }
  return check_linked_settings(document.settings, document.shown);
}

// --- A link within a text

// An address may precede a link, and white space may surround both.
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
  span.end = end_of_link(text, span.begin, span.end);
  return span;
}

struct Version {
  std::uint64_t number;  // 2^64 - 1 if it does not fit
  std::size_t payload;
};

Result<Version> read_version(std::string_view text, const Span& span) {
  std::size_t at = span.begin;
  if (has_lesson_link(text.substr(span.begin, span.end - span.begin)))
    return link_error(ErrorCode::bad_link, "this is the link of a lesson, which is no polygon");
  while (at < span.end && is_decimal_digit(text[at])) ++at;
  if (at < span.end && text[at] == '%') return bad_character(text, at);
  if (at == span.begin || text[span.begin] == '0' || at == span.end || text[at] != '.') {
    return link_error(ErrorCode::bad_link,
                      "a link must begin with its version number and a full stop", at + 1);
  }
  const std::optional<std::uint64_t> number = read_whole(text.substr(span.begin, at - span.begin));
  return Version{number.value_or(~std::uint64_t{0}), at + 1};
}

Result<Document> decode_version(LinkVersion version, std::size_t begin, std::string_view text,
                                const Span& span) {
  const Result<Digits> digits = read_digits(text, span.begin, begin, span.end);
  if (!digits) return digits.error();
  Payload payload = decode_payload(version, *digits);
  if (const UnknownRecord* record = std::get_if<UnknownRecord>(&payload)) {
    return link_error(
        ErrorCode::unknown_version,
        say("the link was made by a newer evenlift: this one does not know its record "
            "{number}",
            {record->tag}));
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
  append_digits(link, encode_payload(document));
  if (link.size() > max_link_bytes) {  // no known document is this long
    return InputError{ErrorCode::text_too_long, "the link would be longer than 1 MiB"};
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

namespace {

constexpr std::string_view head = "L1.";
constexpr int length_bits = 17;  // of max_lesson_bytes

// Predicts a text bit by bit from what earlier followed the same last three bytes or, if these are
// new, the same last byte. Nothing iterates over the models, so their order does not matter.
class TextPredictor {
 public:
  // O(1) on average.
  template <class Coder>
  std::uint8_t code_byte(Coder& coder, std::uint8_t byte) {
    std::uint32_t node = 1;  // the bits so far, after a leading 1
    for (int bit = 7; bit >= 0; --bit) {
      BitModel& near = model(last_three_ & 0xff, node, 1);
      BitModel& far = model(last_three_, node, 3);
      BitModel chosen = is_new(far) ? near : far;
      const bool value = coder.code_bit(((byte >> bit) & 1) != 0, chosen);
      learn(near, value);
      learn(far, value);
      node = 2 * node + (value ? 1 : 0);
    }
    last_three_ = ((last_three_ << 8) | (node & 0xff)) & 0xffffff;
    return static_cast<std::uint8_t>(node & 0xff);
  }

 private:
  static bool is_new(const BitModel& model) { return model.count[0] + model.count[1] == 2; }

  // A decision counts as eight, since texts repeat themselves.
  static void learn(BitModel& model, bool value) {
    auto& count = model.count[value ? 1 : 0];
    count = static_cast<std::uint16_t>(count + 8);
    if (model.count[0] + model.count[1] <= 255) return;
    for (auto& each : model.count) each = static_cast<std::uint16_t>((each + 1) / 2);
  }

  BitModel& model(std::uint32_t before, std::uint32_t node, std::uint32_t bytes) {
    const std::uint64_t key = (std::uint64_t{before} << 16) | (node << 8) | bytes;
    return models_.try_emplace(key, BitModel{{1, 1}}).first->second;
  }

  std::unordered_map<std::uint64_t, BitModel> models_;
  std::uint32_t last_three_ = 0;
};

// Teaches the predictor a text that both ends know.
struct Learner {
  bool code_bit(bool value, BitModel&) const { return value; }
};

TextPredictor primed() {
  TextPredictor predictor;
  Learner learner;
  for (const char c : lesson_primer) predictor.code_byte(learner, static_cast<std::uint8_t>(c));
  return predictor;
}

std::size_t find_lesson_link(std::string_view text) {
  bool at_start = true;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (at_start && text[at] == 'L') {
      std::size_t end = at + 1;
      while (end < text.size() && is_decimal_digit(text[end])) ++end;
      if (end > at + 1 && end < text.size() && text[end] == '.') return at;
    }
    at_start = text[at] == '#' || text[at] == '&' || (at_start && is_white_space(text[at]));
  }
  return std::string_view::npos;
}

}  // namespace

Result<std::string> encode_lesson_link(std::string_view lesson) {
  if (lesson.size() > max_lesson_bytes)
    return InputError{ErrorCode::text_too_long, "a lesson has at most 65536 bytes"};
  Encoder encoder;
  code_integer(encoder, lesson.size(), length_bits);
  TextPredictor predictor = primed();
  for (const char c : lesson) predictor.code_byte(encoder, static_cast<std::uint8_t>(c));
  std::string link(head);
  append_digits(link, encoder.finish());
  return link;
}

Result<std::string> decode_lesson_link(std::string_view text) {
  if (text.size() > max_link_bytes)
    return link_error(ErrorCode::text_too_long, "the link is longer than 1 MiB");
  const std::size_t begin = find_lesson_link(text);
  if (begin == std::string_view::npos)
    return link_error(ErrorCode::bad_link, "a link to a lesson must begin with L1 and a full stop");
  std::size_t last = text.size();
  while (is_white_space(text[last - 1])) --last;
  const std::size_t end = end_of_link(text, begin, last);
  if (!text.substr(begin, end - begin).starts_with(head))
    return link_error(ErrorCode::unknown_version,
                      "the lesson was linked by a newer evenlift: this one reads version L1");
  const Result<Digits> digits = read_digits(text, begin, begin + head.size(), end);
  if (!digits) return digits.error();
  Decoder decoder(*digits);
  const std::uint64_t length = code_integer(decoder, 0, length_bits);
  std::string lesson;
  TextPredictor predictor = primed();
  while (lesson.size() < length && length <= max_lesson_bytes && !decoder.failed())
    lesson += static_cast<char>(predictor.code_byte(decoder, 0));
  // Each lesson has only one link, so that no other can hide data.
  const Result<std::string> link = encode_lesson_link(lesson);
  if (decoder.failed() || lesson.size() != length || *link != text.substr(begin, end - begin))
    return link_error(ErrorCode::bad_link, "the link contains data that evenlift never writes");
  return lesson;
}

bool has_lesson_link(std::string_view text) {
  return find_lesson_link(text) != std::string_view::npos;
}

}  // namespace evenlift
