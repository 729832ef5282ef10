#include "import/dxf/insert.h"

#include <algorithm>
#include <cmath>

#include "import/dxf/degrees.h"

namespace evenlift {
namespace {

double count_of(DxfEntity& entity, int code) {
  return std::floor(std::clamp(entity.number_of(code, 1), 1.0, 65535.0));
}

}  // namespace

Affine DxfInsert::copy(double column, double row, const Vec2& base) const {
  const Affine step{1, 0, 0, 1, column * column_step, row * row_step};
  const Affine scale{scale_x, 0, 0, scale_y, 0, 0};
  const Affine from_base{1, 0, 0, 1, -base.x, -base.y};
  return place * step * scale * from_base;
}

DxfInsert read_dxf_insert(DxfEntity& entity) {
  DxfInsert insert;
  insert.block = entity.text_of(2);
  insert.columns = count_of(entity, 70);
  insert.rows = count_of(entity, 71);
  insert.column_step = entity.number_of(44, 0);
  insert.row_step = entity.number_of(45, 0);
  insert.scale_x = entity.number_of(41, 1);
  insert.scale_y = entity.number_of(42, 1);
  const Vec2 at = entity.point_of(10), turn = direction_of(entity.number_of(50, 0));
  insert.place = {turn.x, turn.y, -turn.y, turn.x, at.x, at.y};
  if (entity.seen_from_behind()) insert.place = Affine{-1, 0, 0, 1, 0, 0} * insert.place;
  return insert;
}

}  // namespace evenlift
