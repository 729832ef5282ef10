// Any bytes as a drawing, table or result: refused with a reason, or shapes within all bounds,
// equal when read again, which can be written and opened.
#include <string>

#include "evenlift/formats.h"
#include "evenlift/import.h"
#include "evenlift/settings.h"
#include "fuzz/fuzz.h"
#include "kit/random_documents.h"

namespace {

using namespace evenlift;

void require_good(const Import& import) {
  fuzz::require(!import.shapes.empty() && import.shapes.size() <= max_shapes);
  std::size_t vertices = 0;
  for (const ImportedShape& shape : import.shapes) {
    vertices += shape.document.vertices.size();
    for (const Vec2& vertex : shape.document.vertices) fuzz::require(is_finite(vertex));
    for (const Points& hole : shape.document.holes) {
      vertices += hole.size();
      fuzz::require(!hole.empty());
      for (const Vec2& vertex : hole) fuzz::require(is_finite(vertex));
    }
    fuzz::require(!shape.tolerance || *shape.tolerance > 0);
    fuzz::require(!shape.kind.empty() && !describe(shape).empty());
    for (const char c : shape.name) fuzz::require(static_cast<unsigned char>(c) >= ' ');
    fuzz::require(!check_ranges(shape.document.settings, shape.document.shown));
    if (shape.document.vertices.empty()) continue;
    if (shape.document.holes.size() > max_holes) continue;
    const Result<Document> back = read_polygon(write_thesis(shape.document));
    fuzz::require(back.ok() && testing::same_polygon(*back, shape.document));
  }
  fuzz::require(vertices <= max_vertices);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = fuzz::text_of(data, size);
  const Result<Import> import = read_shapes(text);
  const Result<Import> again = read_shapes(text);
  fuzz::require(import.ok() == again.ok());
  if (!import.ok()) {
    fuzz::require(!import.error().message.empty());
    return 0;
  }
  require_good(*import);
  for (std::size_t i = 0; i < import->shapes.size(); ++i)
    fuzz::require(testing::same_document(import->shapes[i].document, again->shapes[i].document));
  return 0;
}
