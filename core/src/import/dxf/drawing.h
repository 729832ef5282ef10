// The parts of a DXF drawing that its objects refer to: the unit, layers and blocks.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "evenlift/document.h"
#include "evenlift/result.h"
#include "evenlift/vec.h"

namespace evenlift {

// A unit of $INSUNITS: evenlift's own, or the name of a unit for which evenlift has no label. Empty
// if the drawing has no unit.
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

  // Names are compared without the case of ASCII letters. Of two with the same name, the first
  // counts. nullptr if there is none. O(log n).
  const DxfLayer* layer(std::string_view name) const;
  const DxfBlock* block(std::string_view name) const;

  std::map<std::string, DxfLayer> layers;  // both by their names in lower case
  std::map<std::string, DxfBlock> blocks;
};

// Reads all except the objects themselves, and checks that the text consists of pairs of lines up
// to its end, EOF. The views are of the text. O(bytes log n).
Result<DxfDrawing> read_dxf_drawing(std::string_view text);

}  // namespace evenlift
