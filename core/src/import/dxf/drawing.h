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

// The unit that $INSUNITS gives: evenlift's label, or the name of a unit without a label. Both are
// empty if the drawing gives no unit.
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
  std::size_t offset = 0;        // the place of its first object in the text
  bool in_another_file = false;  // an external reference
};

struct DxfDrawing {
  DxfUnit unit;
  std::vector<std::size_t> entities;  // the places where ENTITIES sections begin, after their names

  // The layer or block with this name; nullptr if there is none. The case of ASCII letters does not
  // matter. If two have the same name, the first counts. O(log n).
  const DxfLayer* layer(std::string_view name) const;
  const DxfBlock* block(std::string_view name) const;

  std::map<std::string, DxfLayer> layers;  // both maps have names in lower case
  std::map<std::string, DxfBlock> blocks;
};

// Reads the drawing without its objects, and checks that the text consists of pairs of lines up to
// EOF. The views are of the text. O(bytes log n).
Result<DxfDrawing> read_dxf_drawing(std::string_view text);

}  // namespace evenlift
