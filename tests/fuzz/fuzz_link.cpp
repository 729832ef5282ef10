// Any bytes as a link, and as a payload with a valid checksum: refused, or written and read again
// without loss.
#include <string>

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

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  check(std::string(fuzz::text_of(data, size)));
  for (std::string payload : {"1.", "2."}) {
    for (std::size_t i = 0; i < size; ++i) payload += testing::link_characters[data[i] & 63];
    check(testing::with_checksum(payload));
  }
  return 0;
}
