// Any bytes as a link, and as a payload with a valid checksum: refused, or written and read without
// loss.
#include <string>

#include "evenlift/lesson_link.h"
#include "evenlift/link.h"
#include "fuzz/fuzz.h"
#include "kit/link_checksum.h"
#include "kit/random_documents.h"

namespace {

using namespace evenlift;

void check(const std::string& text) {
  looks_like_link(text);
  const Result<Document> document = decode_link(text);
  if (!document.ok()) return;
  const Result<std::string> again = encode_link(*document);
  fuzz::require(again.ok());
  const Result<Document> back = decode_link(*again);
  fuzz::require(back.ok() && testing::same_document(*back, *document));
  fuzz::require(*encode_link(*back) == *again);
}

void check_lesson(const std::string& text) {
  const Result<std::string> lesson = decode_lesson_link(text);
  if (!lesson.ok()) return;
  fuzz::require(has_lesson_link(text));
  fuzz::require(*decode_lesson_link(*encode_lesson_link(*lesson)) == *lesson);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(fuzz::text_of(data, size));
  check(text);
  check_lesson(text);
  const Result<std::string> link = encode_lesson_link(text);
  fuzz::require(link.ok() && *decode_lesson_link(*link) == text);
  std::string lesson = "L1.";
  for (std::size_t i = 0; i < size; ++i) lesson += testing::link_characters[data[i] & 63];
  check_lesson(testing::with_checksum(lesson));
  for (std::string payload : {"1.", "2."}) {
    for (std::size_t i = 0; i < size; ++i) payload += testing::link_characters[data[i] & 63];
    check(testing::with_checksum(payload));
  }
  return 0;
}
