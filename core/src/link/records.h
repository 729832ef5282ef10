// The records of share links of version 2: the settings added after version 1. Each record is a
// tag, the number of bytes of its payload, and the payload. The payload of a setting is its text in
// the syntax of read_setting(). The record of supports holds their number and, like the vertices,
// their coordinates instead. Records are in the order of their tags, and tag 0 ends them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "evenlift/document.h"
#include "link/quantized.h"
#include "link/range_coder.h"
#include "link/vertices.h"

namespace evenlift {

// The number of a record. Numbers never change. The numbers of settings are in their rows
// (settings.h), and the others here. docs/link-format.md lists all of them and the reserved ones,
// so that no two later versions give one number different meanings.
using Tag = std::uint8_t;
namespace tag {
inline constexpr Tag end = 0;
inline constexpr Tag units = 11;  // of lengths and of weights, with a comma before the latter
inline constexpr Tag halo = 18;   // an overlay without a setting of its own
inline constexpr Tag moved = 19;  // robots that were moved by hand
inline constexpr Tag supports = 21;
}  // namespace tag

struct Record {
  Tag tag = tag::end;
  std::string payload;
};
using Records = std::vector<Record>;

// The supports, by the scale of their encoding.
struct CodedSupports {
  Encoding encoding;
  QuantizedVertices quantized;
};

// The records that the document needs; none if version 1 can represent all of it. O(robots moved by
// hand).
Records records_of(const Document& document);

// Applies the records, whose tags must be known. Returns whether each value is valid for its
// setting. O(bytes).
bool take_records(const Records& records, Document& document);

// Codes the records. A decoder replaces them. It fails at a payload longer than any known setting,
// and stops at an unknown tag, which remains as the last record. O(bytes).
inline constexpr int widest_tag = 8, widest_length = 20, widest_supports = 10;
static_assert(most_supports < 1u << widest_supports);
bool is_known(Tag tag);

// The longest payload that a writer produces, in bytes: a number has at most 24. O(1).
std::size_t longest_value(Tag tag);

template <class Coder>
void code_supports(Coder& coder, CodedSupports& supports) {
  const std::uint64_t count = code_integer(coder, supports.quantized.size(), widest_supports);
  if (count == 0 || count > most_supports) return coder.fail();
  supports.encoding =
      code_vertices(coder, supports.encoding, supports.quantized, static_cast<std::size_t>(count));
}

template <class Coder>
void code_records(Coder& coder, Records& records, CodedSupports& supports) {
  for (std::size_t i = 0; !coder.failed(); ++i) {
    const bool given = !Coder::decoding && i < records.size();
    const auto number = static_cast<Tag>(
        code_integer(coder, given ? static_cast<std::uint64_t>(records[i].tag) : 0, widest_tag));
    if (number == tag::end || coder.failed()) return;
    if constexpr (Coder::decoding) records.push_back({number, {}});
    if (!is_known(number)) return;
    if (number == tag::supports) {
      // A repeated record would add to the supports.
      if (Coder::decoding && !supports.quantized.empty()) return coder.fail();
      code_supports(coder, supports);
      continue;
    }
    std::string& payload = records[i].payload;
    const std::uint64_t length = code_integer(coder, payload.size(), widest_length);
    if (length > longest_value(number)) return coder.fail();
    payload.resize(static_cast<std::size_t>(length));
    for (char& byte : payload)
      byte = static_cast<char>(coder.code_uniform(static_cast<unsigned char>(byte), 256));
  }
}

}  // namespace evenlift
