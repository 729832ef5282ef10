#include "import/dxf/drawing.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "evenlift/numbers.h"
#include "numbers/text_cursor.h"

namespace evenlift {
namespace {

std::optional<int> code_of(std::string_view line) {
  const bool negative = !line.empty() && line[0] == '-';
  const auto size = read_whole(negative ? line.substr(1) : line);
  if (!size || *size > 9999) return std::nullopt;
  return negative ? -static_cast<int>(*size) : static_cast<int>(*size);
}

}  // namespace

std::optional<DxfGroup> DxfGroups::next() {
  if (at_ >= text_.size()) return std::nullopt;
  code_at_ = at_;
  const std::optional<int> code = code_of(line());
  if (!code) {
    broken_ = true;
    return std::nullopt;
  }
  const std::size_t offset = at_;
  return DxfGroup{*code, line(), offset};
}

std::string_view DxfGroups::line() {
  const std::size_t end = std::min(text_.find_first_of("\r\n", at_), text_.size());
  const std::string_view found = text_.substr(at_, end - at_);
  at_ = end;
  if (at_ < text_.size() && text_[at_] == '\r') ++at_;
  if (at_ < text_.size() && text_[at_] == '\n' && (at_ == end || text_[at_ - 1] == '\r')) ++at_;
  return trimmed(found);
}

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

int DxfEntity::flags() { return static_cast<int>(std::clamp(number_of(70, 0), 0.0, 65535.0)); }

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
    entity_.vertices.push_back({vertex_.point_of(10), vertex_.number_of(42, 0),
                                vertex_.number_of(30, 0), vertex_.flags()});
    if (vertex_.bad_number()) entity_.add_bad_number(*vertex_.bad_number());
  }
}

namespace {

DxfUnit unit_of(double number) {
  constexpr LengthUnit none = LengthUnit::none;
  static constexpr DxfUnit units[] = {{},
                                      {LengthUnit::in},
                                      {none, "feet"},
                                      {none, "miles"},
                                      {LengthUnit::mm},
                                      {LengthUnit::cm},
                                      {LengthUnit::m},
                                      {none, "kilometres"},
                                      {none, "microinches"},
                                      {none, "mils"},
                                      {none, "yards"},
                                      {none, "angstroms"},
                                      {none, "nanometres"},
                                      {none, "micrometres"},
                                      {none, "decimetres"},
                                      {none, "decametres"},
                                      {none, "hectometres"},
                                      {none, "gigametres"},
                                      {none, "astronomical units"},
                                      {none, "light years"},
                                      {none, "parsecs"},
                                      {none, "US survey feet"},
                                      {none, "US survey inches"},
                                      {none, "US survey yards"},
                                      {none, "US survey miles"}};
  const auto count = static_cast<double>(std::size(units));
  if (!(number >= 0) || number >= count || number != std::floor(number)) return {};
  return units[static_cast<std::size_t>(number)];
}

std::string in_lower_case(std::string_view name) {
  std::string lower(name);
  for (char& c : lower) c = lower_case(c);
  return lower;
}

template <class Value>
const Value* found(const std::map<std::string, Value>& values, std::string_view name) {
  const auto at = values.find(in_lower_case(name));
  return at == values.end() ? nullptr : &at->second;
}

class DrawingReader {
 public:
  explicit DrawingReader(std::string_view text) : text_(text), groups_(text) {}
  Result<DxfDrawing> read();

 private:
  void begin_item(const DxfGroup& group);
  void end_item();
  void take(const DxfGroup& group);

  std::string_view text_;
  DxfGroups groups_;
  DxfDrawing drawing_;
  std::string_view section_, variable_;
  bool names_section_ = false;
  DxfEntity item_;  // a layer, or the head of a block
  std::optional<InputError> error_;
};

Result<DxfDrawing> DrawingReader::read() {
  while (const std::optional<DxfGroup> group = groups_.next()) {
    if (group->code == 0) {
      end_item();
      if (error_) return *std::move(error_);
      if (group->value == "EOF") return std::move(drawing_);
      begin_item(*group);
    } else {
      take(*group);
    }
  }
  if (groups_.broken())
    return text_error(
        ErrorCode::bad_syntax,
        "the DXF drawing is damaged: expected a group code here, which is a whole number", text_,
        groups_.code_offset());
  return InputError{ErrorCode::bad_syntax, "the DXF drawing is cut off before its end (EOF)"};
}

void DrawingReader::begin_item(const DxfGroup& group) {
  names_section_ = group.value == "SECTION";
  if (names_section_ || group.value == "ENDSEC") section_ = {};
  const bool counts = (section_ == "TABLES" && group.value == "LAYER") ||
                      (section_ == "BLOCKS" && group.value == "BLOCK");
  item_.begin(counts ? group.value : std::string_view());
}

void DrawingReader::take(const DxfGroup& group) {
  if (names_section_ && group.code == 2) {
    section_ = group.value;
    names_section_ = false;
    if (section_ == "ENTITIES") drawing_.entities.push_back(groups_.offset());
  } else if (section_ == "HEADER") {
    if (group.code == 9) variable_ = group.value;
    if (group.code == 70 && variable_ == "$INSUNITS")
      drawing_.unit = unit_of(read_number(group.value).value_or(0));
  } else if (!item_.type.empty() && item_.groups.size() < max_dxf_groups) {
    item_.groups.push_back(group);
  }
}

// A colour below 0 means that a layer is off; bit 1, that it is frozen; bit 4 or 8, that a block's
// content is in another file.
void DrawingReader::end_item() {
  if (item_.type.empty()) return;
  const std::string name = in_lower_case(item_.text_of(2));
  const int flags = item_.flags();
  if (item_.type == "LAYER") {
    drawing_.layers.emplace(name, DxfLayer{item_.number_of(62, 7) < 0, (flags & 1) != 0});
  } else {
    drawing_.blocks.emplace(name, DxfBlock{item_.text_of(2), item_.point_of(10),
                                           groups_.code_offset(), (flags & (4 | 8)) != 0});
  }
  if (item_.bad_number())
    error_ = text_error(ErrorCode::bad_syntax, "expected a number here, with a point for decimals",
                        text_, *item_.bad_number());
}

}  // namespace

const DxfLayer* DxfDrawing::layer(std::string_view name) const { return found(layers, name); }
const DxfBlock* DxfDrawing::block(std::string_view name) const { return found(blocks, name); }

Result<DxfDrawing> read_dxf_drawing(std::string_view text) { return DrawingReader(text).read(); }

}  // namespace evenlift
