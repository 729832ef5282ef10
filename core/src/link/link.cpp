// The text of share links: address, version, characters, checksum. The payload is in payload.h.
#include "evenlift/link.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "evenlift/lesson_link.h"
#include "evenlift/numbers.h"
#include "evenlift/settings.h"
#include "evenlift/wording.h"
#include "link/link_text.h"
#include "link/payload.h"

namespace evenlift {
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
