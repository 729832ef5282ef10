#include "link/payload.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "link/encodings.h"
#include "link/settings.h"
#include "link/vertices.h"

namespace evenlift {
namespace {

// The bounding box of the quantized vertices, without those coordinates that are escaped.
struct NumberBox {
  std::int64_t low[2] = {std::numeric_limits<std::int64_t>::max(),
                         std::numeric_limits<std::int64_t>::max()};
  std::int64_t high[2] = {std::numeric_limits<std::int64_t>::min(),
                          std::numeric_limits<std::int64_t>::min()};

  explicit NumberBox(const QuantizedVertices& quantized) {
    for (const auto& vertex : quantized) {
      for (std::size_t axis = 0; axis < 2; ++axis) {
        if (vertex[axis].escaped) continue;
        low[axis] = std::min(low[axis], vertex[axis].number);
        high[axis] = std::max(high[axis], vertex[axis].number);
      }
    }
  }
  bool empty() const { return low[0] > high[0] || low[1] > high[1]; }
  std::uint64_t offset(std::size_t axis, std::int64_t number) const {
    return static_cast<std::uint64_t>(number) - static_cast<std::uint64_t>(low[axis]);
  }
  bool holds(std::size_t axis, std::int64_t number) const {
    return low[axis] <= number && number <= high[axis];
  }
};

// Codes the centre of mass. Usually it is on the scale of the vertices and within their bounding
// box; otherwise its coordinates are numbers of their own.
template <class Coder>
Vec2 code_centre(Coder& coder, Vec2 centre, const Scale& scale,
                 const QuantizedVertices& quantized) {
  const NumberBox box(quantized);
  std::int64_t numbers[2] = {0, 0};
  bool in_box = !box.empty();
  if constexpr (!Coder::decoding) {
    for (std::size_t axis = 0; axis < 2 && in_box; ++axis) {
      const auto number = scale.number_of(centre[static_cast<Eigen::Index>(axis)]);
      in_box = number && box.holds(axis, *number);
      numbers[axis] = number.value_or(0);
    }
  }
  BitModel model{{3, 1}};
  in_box = !box.empty() && !coder.code_bit(!in_box, model);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    double& value = centre[static_cast<Eigen::Index>(axis)];
    if (in_box) {
      const std::uint64_t offset =
          code_up_to(coder, box.offset(axis, numbers[axis]), box.offset(axis, box.high[axis]));
      value = scale.value_of(
          static_cast<std::int64_t>(static_cast<std::uint64_t>(box.low[axis]) + offset));
    } else {
      value = code_number(coder, value);
    }
  }
  return centre;
}

// The content of a link.
struct Content {
  Settings settings = defaults_of_link_1();
  QuantizedVertices quantized;  // the vertices, by the scale of the encoding
  std::optional<Vec2> centre_of_mass;
};

// An encoder writes the content, with the vertices in the given encoding. A decoder reads all of
// it. Returns the encoding of the vertices.
template <class Coder>
Encoding code_content(Coder& coder, Content& content, Encoding encoding) {
  constexpr int widest_count = 16;
  static_assert(max_link_vertices < (std::size_t{1} << widest_count));

  code_settings(coder, content.settings);
  const std::uint64_t count = code_integer(coder, content.quantized.size(), widest_count);
  if (count > max_link_vertices) coder.fail();
  if (coder.failed()) return encoding;
  if (count > 0)
    encoding = code_vertices(coder, encoding, content.quantized, static_cast<std::size_t>(count));

  std::optional<Vec2>& centre = content.centre_of_mass;
  const bool has_centre = coder.code_uniform(centre ? 1 : 0, 2) != 0;
  if (has_centre && !coder.failed()) {
    centre = code_centre(coder, centre.value_or(Vec2::Zero()), encoding.scale, content.quantized);
  }
  return encoding;
}

Digits encode_in(const Encoding& encoding, Content& content) {
  Encoder encoder;
  code_content(encoder, content, encoding);
  return encoder.finish();
}

}  // namespace

Digits encode_payload_1(const Document& document) {
  Digits best;
  bool first = true;
  for (QuantizedPolygon& candidate : likely_encodings(document.vertices)) {
    Content content{document.settings, std::move(candidate.quantized), document.centre_of_mass};
    Digits digits = encode_in(candidate.encoding, content);
    if (first || digits.size() < best.size()) best = std::move(digits);
    first = false;
  }
  return best;
}

std::optional<Document> decode_payload_1(std::span<const std::uint8_t> digits) {
  Decoder decoder(digits);
  Content content;
  const Encoding encoding = code_content(decoder, content, Encoding{});
  if (decoder.failed()) return std::nullopt;

  Document document;
  document.settings = content.settings;
  document.centre_of_mass = content.centre_of_mass;
  document.vertices.reserve(content.quantized.size());
  for (const auto& vertex : content.quantized) {
    document.vertices.emplace_back(vertex[0].value, vertex[1].value);
    if (!document.vertices.back().allFinite()) return std::nullopt;
  }
  if (document.centre_of_mass && !document.centre_of_mass->allFinite()) return std::nullopt;
  if (!std::isfinite(document.settings.weight) || !std::isfinite(document.settings.min_ratio)) {
    return std::nullopt;
  }
  // In each encoding a document has one link only. So no two links mean the same, and nothing can
  // hide in a link.
  content.quantized = quantize(encoding.scale, document.vertices);
  const Digits again = encode_in(encoding, content);
  if (!std::equal(again.begin(), again.end(), digits.begin(), digits.end())) return std::nullopt;
  return document;
}

}  // namespace evenlift
