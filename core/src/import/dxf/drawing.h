// The unit, layers and blocks of a DXF drawing.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "evenlift/document.h"
#include "evenlift/result.h"
#include "evenlift/vec.h"

namespace evenlift {

// A unit of $INSUNITS: evenlift's own, or the name of one without a label. Empty if the drawing has
// none.
struct DxfUnit {
  LengthUnit label = LengthUnit::none;
  const char* other = "";
};

struct DxfLayer {
  bool off = false, frozen = false;
};

struct DxfBlock {
  std::string_view name;
  Vec2 base = Vec2::Zero();
  std::size_t offset = 0;        // of its first object in the text
  bool in_another_file = false;  // an external reference
};

struct DxfDrawing {
  DxfUnit unit;
  std::vector<std::size_t> entities;  // where the sections ENTITIES begin, after their names

  // The case of ASCII letters does not matter. Of two with one name the first counts. nullptr if
  // there is none. O(log n).
  const DxfLayer* layer(std::string_view name) const;
  const DxfBlock* block(std::string_view name) const;

  std::map<std::string, DxfLayer> layers;  // both by names in lower case
  std::map<std::string, DxfBlock> blocks;
};

// Reads all except the objects, and checks that the text is pairs of lines up to EOF. The views are
// of the text. O(bytes log n).
Result<DxfDrawing> read_dxf_drawing(std::string_view text);

}  // namespace evenlift
