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

// The unit that $INSUNITS gives: its label if evenlift has one, otherwise its name in `other`. Both
// are empty if the drawing gives no unit.
struct DxfUnit {
  LengthUnit label = LengthUnit::none;
  const char* other = "";
};

struct DxfLayer {
  bool off = false, frozen = false;
};

struct DxfBlock {
  std::string_view name;
  Vec2 base;
  std::size_t offset = 0;        // of its first object in the text
  bool in_another_file = false;  // an external reference
};

struct DxfDrawing {
  DxfUnit unit;
  std::vector<std::size_t> entities;  // of each ENTITIES section: the offset just after its name

  // The layer or block with this name; nullptr if there is none. The case of ASCII letters does not
  // matter. If two layers, or two blocks, have the same name, the first counts. O(log n).
  const DxfLayer* layer(std::string_view name) const;
  const DxfBlock* block(std::string_view name) const;

  std::map<std::string, DxfLayer> layers;  // the keys of both maps are names in lower case
  std::map<std::string, DxfBlock> blocks;
};

// Reads the unit, the layers and the blocks, but no objects, and checks that the text consists of
// pairs of lines up to EOF. The text must outlive the drawing, which refers to it. O(bytes log n)
// for n layers and blocks.
Result<DxfDrawing> read_dxf_drawing(std::string_view text);

}  // namespace evenlift
