// libFuzzer's entry: any bytes as a link, and as a payload whose checksum is good.
#include <cstddef>
#include <cstdint>
#include <string>

#include "../link_checksum.h"
#include "../random_documents.h"
#include "evenlift/link.h"

namespace {

void require(bool condition) {
  if (!condition) __builtin_trap();
}

void check(const std::string& text) {
  using namespace evenlift;
  looks_like_link(text);
  const Result<Document> document = decode_link(text);
  if (!document.ok()) return;
  const Result<std::string> again = encode_link(*document);
  require(again.ok());
  const Result<Document> back = decode_link(*again);
  require(back.ok() && evenlift::testing::same_document(*back, *document));
  require(*encode_link(*back) == *again);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  check(std::string(data, data + size));
  std::string payload = "1.";
  for (std::size_t i = 0; i < size; ++i) {
    payload += evenlift::testing::link_characters[data[i] & 63];
  }
  check(evenlift::testing::with_checksum(payload));
  return 0;
}
