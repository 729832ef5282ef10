#include "evenlift/lesson_link.h"

#include <cstdint>
#include <unordered_map>

#include "evenlift/document.h"
#include "link/lesson_primer.h"
#include "link/link_text.h"
#include "link/range_coder.h"

namespace evenlift {
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
    return InputError{ErrorCode::text_too_long, "a lesson has at most 65536 bytes", {}};
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
