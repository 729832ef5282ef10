// libFuzzer's entry: any bytes as a polygon in one of the three formats.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "../random_documents.h"
#include "evenlift/formats.h"

namespace {

void require(bool condition) {
  if (!condition) __builtin_trap();
}

void require_same(const evenlift::Document& document, const std::string& text) {
  const evenlift::Result<evenlift::Document> back = evenlift::read_polygon(text);
  require(back.ok() && evenlift::testing::same_polygon(*back, document));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace evenlift;
  Result<Document> document =
      read_polygon(std::string_view(reinterpret_cast<const char*>(data), size));
  if (!document.ok()) {
    require(!document.error().message.empty());
    return 0;
  }
  for (const Vec2& vertex : document->vertices) require(vertex.allFinite());
  require_same(*document, write_thesis(*document));
  require_same(*document, write_geojson(*document));
  document->centre_of_mass.reset();
  require_same(*document, write_wkt(*document));
  return 0;
}
