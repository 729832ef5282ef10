// INSERT: copies of a block, perhaps in columns and rows.
#pragma once

#include <string_view>

#include "curves/outline.h"
#include "import/dxf/entity.h"

namespace evenlift {

struct DxfInsert {
  std::string_view block;        // its name
  double columns = 1, rows = 1;  // whole numbers from 1 to 65535
  double column_step = 0, row_step = 0;
  Affine place;  // maps the first copy to its place, without scale
  double scale_x = 1, scale_y = 1;

  // Returns the map from the block's coordinates to those of the block or drawing that contains the
  // INSERT, for the copy in this column and row, both counted from 0. `base` is the block's base
  // point. The steps between columns and rows turn with the block, but are not scaled. O(1).
  Affine copy(double column, double row, const Vec2& base) const;
};

DxfInsert read_dxf_insert(DxfEntity& entity);

}  // namespace evenlift
