// The records of share links of version 2. They hold what was added after version 1. A record
// consists of a tag, the number of bytes of its payload, and the payload, a text. For most tags,
// read_setting() reads the text. Instead, the tag of supports is followed by their number and their
// places, that of holes by their number, the number of vertices of each, and all these vertices.
// Points are coded like the polygon's vertices. Records are in order of tag, and tag 0 ends them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "evenlift/document.h"
#include "link/quantizer.h"
#include "link/range_coder.h"
#include "link/vertices.h"

namespace evenlift {

// The number of a kind of record, which never changes. The settings' numbers are in their rows
// (settings.h); the others are here. docs/link-format.md lists all of them and the reserved ones,
// so that no two later versions use a number differently.
using Tag = std::uint8_t;
namespace tag {

inline constexpr Tag end = 0;
inline constexpr Tag units = 11;  // the unit of lengths, a comma, and the unit of weights
inline constexpr Tag holes = 13;
inline constexpr Tag halo = 18;   // an overlay added after version 1, as are tilt and load
inline constexpr Tag moved = 19;  // robots moved by hand
inline constexpr Tag supports = 21;
inline constexpr Tag tilt = 28;
inline constexpr Tag load = 29;
}  // namespace tag

struct Record {
  Tag tag = tag::end;
  std::string payload;
};
using Records = std::vector<Record>;

struct CodedPoints {
  Encoding encoding;
  QuantizedVertices quantized;
};

// The supports, and the vertices of all holes, one hole after another.
struct CodedLists {
  CodedPoints supports, holes;
  std::vector<std::size_t> hole_sizes;
};

// The document's records; empty if version 1 can represent the document. O(bytes of the records).
Records records_of(const Document& document);

// Sets the document's settings from the records, whose tags must be known. Returns whether each
// value is valid for its setting. O(bytes).
bool take_records(const Records& records, Document& document);

// The greatest widths in bits of the numbers that code_records() codes.
inline constexpr int widest_tag = 8, widest_length = 20, widest_supports = 10, widest_holes = 10,
                     widest_hole = 16;
static_assert(most_supports < 1u << widest_supports && max_holes < 1u << widest_holes);
bool is_known(Tag number);

// The greatest number of bytes in the payload of this record. O(1).
std::size_t longest_value(Tag number);

template <class Coder>
void code_points(Coder& coder, CodedPoints& points, std::size_t count) {
  points.encoding = code_vertices(coder, points.encoding, points.quantized, count);
}

template <class Coder>
void code_supports(Coder& coder, CodedPoints& supports) {
  const std::uint64_t count = code_integer(coder, supports.quantized.size(), widest_supports);
  if (count == 0 || count > most_supports) return coder.fail();
  code_points(coder, supports, static_cast<std::size_t>(count));
}

template <class Coder>
void code_holes(Coder& coder, CodedPoints& holes, std::vector<std::size_t>& sizes) {
  const std::uint64_t count = code_integer(coder, sizes.size(), widest_holes);
  if (count == 0 || count > max_holes) return coder.fail();
  sizes.resize(static_cast<std::size_t>(count));
  std::size_t all = 0;
  for (std::size_t& size : sizes) {
    size = static_cast<std::size_t>(code_integer(coder, size, widest_hole));
    all += size;
    if (size == 0 || all > max_link_vertices) return coder.fail();
  }
  if (!coder.failed()) code_points(coder, holes, all);
}

// Codes the record if it consists of points, and returns whether it does. A decoder refuses a
// second record of the same kind, whose points would be added to those of the first.
template <class Coder>
bool code_points_of(Coder& coder, Tag number, CodedLists& lists) {
  if (number != tag::supports && number != tag::holes) return false;
  CodedPoints& points = number == tag::supports ? lists.supports : lists.holes;
  if (Coder::decoding && !points.quantized.empty())
    coder.fail();
  else if (number == tag::supports)
    code_supports(coder, points);
  else
    code_holes(coder, points, lists.hole_sizes);
  return true;
}

// Codes the records; a decoder fills `records` and `lists`. A decoder fails if a payload is longer
// than any value of its setting, and stops after an unknown tag, which is then the last record's.
// O(bytes).
template <class Coder>
void code_records(Coder& coder, Records& records, CodedLists& lists) {
  for (std::size_t i = 0; !coder.failed(); ++i) {
    const bool given = !Coder::decoding && i < records.size();
    const auto number = static_cast<Tag>(
        code_integer(coder, given ? static_cast<std::uint64_t>(records[i].tag) : 0, widest_tag));
    if (number == tag::end || coder.failed()) return;
    if constexpr (Coder::decoding) records.push_back({number, {}});
    if (!is_known(number)) return;
    if (code_points_of(coder, number, lists)) continue;
    std::string& payload = records[i].payload;
    const std::uint64_t length = code_integer(coder, payload.size(), widest_length);
    if (length > longest_value(number)) return coder.fail();
    payload.resize(static_cast<std::size_t>(length));
    for (char& byte : payload)
      byte = static_cast<char>(coder.code_uniform(static_cast<unsigned char>(byte), 256));
  }
}

}  // namespace evenlift
