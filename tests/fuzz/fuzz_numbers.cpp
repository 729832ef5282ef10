// Any bytes as doubles of a document: refused, or placed and written with finite numbers.
#include <cstdint>

#include "fuzz/any_numbers.h"
#include "fuzz/fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  evenlift::testing::AnyNumbers any(data, size);
  int placed = 0;
  fuzz::require(evenlift::testing::keeps_its_word(evenlift::testing::document_with(any), placed));
  return 0;
}
