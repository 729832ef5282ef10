#include "import/dxf/entity.h"

#include <algorithm>
#include <cmath>

#include "evenlift/numbers.h"
#include "numbers/text_cursor.h"

namespace evenlift {

void DxfEntity::begin(std::string_view new_type) {
  type = new_type;
  groups.clear();
  vertices.clear();
  bad_number_.reset();
}

double DxfEntity::number(const DxfGroup& group) {
  const std::optional<double> value = read_number(group.value);
  if (value) return *value;
  add_bad_number(group.offset);
  return 0;
}

double DxfEntity::number_of(int code, double otherwise) {
  for (const DxfGroup& group : groups)
    if (group.code == code) return number(group);
  return otherwise;
}

std::string_view DxfEntity::text_of(int code) const {
  for (const DxfGroup& group : groups)
    if (group.code == code) return group.value;
  return {};
}

int DxfEntity::flags_of(int code) {
  return static_cast<int>(std::clamp(number_of(code, 0), 0.0, 65535.0));
}

double DxfEntity::tilt() {
  return std::max(std::abs(number_of(210, 0)), std::abs(number_of(220, 0)));
}

DxfEntity* DxfEntities::next() {
  if (!begun_) advance();
  begun_ = true;
  if (too_long_ || !pending_) return nullptr;
  for (const std::string_view end : {"ENDBLK", "BLOCK", "ENDSEC", "SECTION", "EOF"})
    if (pending_->value == end) return nullptr;
  entity_.begin(pending_->value);
  read_groups(entity_);
  if (entity_.type == "POLYLINE") read_vertices();
  return too_long_ ? nullptr : &entity_;
}

std::optional<InputError> DxfEntities::error() const {
  if (!too_long_) return std::nullopt;
  return text_error(ErrorCode::too_many_vertices, "an object has too many vertices", text_,
                    *too_long_);
}

// To the first group of the next object.
void DxfEntities::advance() {
  do {
    pending_ = groups_.next();
  } while (pending_ && pending_->code != 0);
}

bool DxfEntities::has_room(std::size_t count) {
  if (count == max_dxf_groups && !too_long_) too_long_ = groups_.code_offset();
  return !too_long_;
}

void DxfEntities::read_groups(DxfEntity& entity) {
  while ((pending_ = groups_.next()) && pending_->code != 0) {
    if (!has_room(entity.groups.size())) return;
    entity.groups.push_back(*pending_);
  }
}

void DxfEntities::read_vertices() {
  while (pending_ && pending_->value == "VERTEX" && has_room(entity_.vertices.size())) {
    vertex_.begin(pending_->value);
    read_groups(vertex_);
    entity_.vertices.push_back(
        {vertex_.point_of(10), vertex_.number_of(42, 0), vertex_.flags_of()});
    if (vertex_.bad_number()) entity_.add_bad_number(*vertex_.bad_number());
  }
}

}  // namespace evenlift
