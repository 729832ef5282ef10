// Any bytes as a polygon's text in three formats: refused with a reason, or written and read
// without loss.
#include <string>

#include "evenlift/formats.h"
#include "fuzz/fuzz.h"
#include "kit/random_documents.h"

namespace {

using namespace evenlift;

void require_same(const Document& document, const std::string& text) {
  const Result<Document> back = read_polygon(text);
  fuzz::require(back.ok() && testing::same_polygon(*back, document));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Result<Document> document = read_polygon(fuzz::text_of(data, size));
  if (!document.ok()) {
    fuzz::require(!document.error().message.empty());
    return 0;
  }
  for (const Vec2& vertex : document->vertices) fuzz::require(is_finite(vertex));
  require_same(*document, write_thesis(*document));
  fuzz::require(read_polygon(write_thesis(*document))->settings == document->settings);
  require_same(*document, write_geojson(*document));
  document->centre_of_mass.reset();
  require_same(*document, write_wkt(*document));
  return 0;
}
