// Reads DXF drawings by means of the folder dxf: inserts blocks, leaves out unseen objects, and
// joins lines and arcs.
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "evenlift/numbers.h"
#include "evenlift/wording.h"
#include "import/dxf/drawing.h"
#include "import/gathering.h"
#include "import/readers.h"
#include "numbers/text_cursor.h"

namespace evenlift {
namespace {

constexpr std::size_t max_depth = 32;  // of nested blocks
// The greatest number of bytes in all copies of blocks, plus copy_bytes for each copy: nested
// blocks multiply copies.
constexpr std::size_t max_inserted_bytes = std::size_t{128} << 20, copy_bytes = 64;

struct LeftOutKind {
  std::string_view type;
  DxfName name;
};
constexpr DxfName written{"text", "texts"}, dimension{"dimension", "dimensions"},
    leader{"leader", "leaders"}, hatching{"hatching", "hatchings"}, table{"table", "tables"},
    fill{"filled area", "filled areas"}, endless{"endless line", "endless lines"};
constexpr LeftOutKind left_out_kinds[] = {{"TEXT", written},
                                          {"MTEXT", written},
                                          {"ATTDEF", written},
                                          {"ATTRIB", written},
                                          {"DIMENSION", dimension},
                                          {"ARC_DIMENSION", dimension},
                                          {"LARGE_RADIAL_DIMENSION", dimension},
                                          {"TOLERANCE", {"tolerance", "tolerances"}},
                                          {"LEADER", leader},
                                          {"MULTILEADER", leader},
                                          {"POINT", {"point", "points"}},
                                          {"HATCH", hatching},
                                          {"SOLID", fill},
                                          {"TRACE", fill},
                                          {"XLINE", endless},
                                          {"RAY", endless},
                                          {"ACAD_TABLE", table},
                                          {"IMAGE", {"picture", "pictures"}},
                                          {"VIEWPORT", {"viewport", "viewports"}}};
// Blocks that programs make for objects that are left out, by the beginnings of their names.
constexpr LeftOutKind made_blocks[] = {{"*D", dimension}, {"*X", hatching}, {"*T", table}};

constexpr DxfName in_layout{"object of a layout", "objects of layouts"};
constexpr DxfName in_other_plane{"object in another plane", "objects in another plane"};
constexpr DxfName invisible{"invisible object", "invisible objects"};
constexpr DxfName on_defpoints{"object on the layer Defpoints", "objects on the layer Defpoints"};
constexpr DxfName on_hidden_layer{"object on a layer that is off or frozen",
                                  "objects on layers that are off or frozen"};
constexpr DxfName undefined_block{"block (INSERT) that the drawing does not define",
                                  "blocks (INSERT) that the drawing does not define"};
constexpr DxfName other_file{"block (INSERT) from another file",
                             "blocks (INSERT) from other files"};

// Coordinates that overflowed, to infinity or NaN, are out of bounds.
bool within_bounds(const Outline& outline) {
  const auto small = [](const Vec2& p) {
    return std::abs(p.x) <= max_coordinate && std::abs(p.y) <= max_coordinate;
  };
  const auto all_small = [&](const CurvePiece& piece) {
    return small(piece.end) && small(piece.first) && small(piece.second);
  };
  return small(outline.start) &&
         std::all_of(outline.pieces.begin(), outline.pieces.end(), all_small);
}

// Nothing for other objects, and for a text with a faulty place, which is left out like all texts.
std::optional<Vec2> place_of_text(const DxfEntity& entity) {
  if (entity.type != "TEXT" && entity.type != "MTEXT") return std::nullopt;
  std::optional<double> x, y;
  for (const DxfGroup& group : entity.groups) {
    if (group.code == 10) x = read_number(group.value);
    if (group.code == 20) y = read_number(group.value);
  }
  return x && y ? std::optional(Vec2(*x, *y)) : std::nullopt;
}

// A text without codes for its format, such as "{\\fArial;P 7}\\Psteel". A text that stands for a value,
// such as "%%d", keeps its code.
std::string words_of_text(const DxfEntity& entity) {
  std::string raw, words;
  for (const DxfGroup& group : entity.groups)
    if (group.code == 1 || group.code == 3) raw += group.value;
  if (entity.type == "TEXT") return raw;
  for (std::size_t i = 0; i < raw.size(); ++i) {
    const char c = raw[i];
    if (c == '{' || c == '}') continue;
    if (c != '\\' || i + 1 == raw.size()) {
      words += c;
      continue;
    }
    const char code = raw[++i];
    if (code == '\\' || code == '{' || code == '}') {
      words += code;
    } else if (std::string_view("PXN~").find(code) != std::string_view::npos) {
      words += ' ';  // a new line or column
    } else if (code != 'L' && code != 'l' && code != 'O' && code != 'o' && code != 'K' &&
               code != 'k') {
      i = std::min(raw.find(';', i), raw.size());  // the code has a value
    }
  }
  return words;
}

class DxfReader {
 public:
  DxfReader(std::string_view text, const ImportOptions& options)
      : text_(text), gathering_(options) {}
  Result<Import> read();

 private:
  // Where a block's objects, or the drawing's own, lie in the drawing.
  struct Frame {
    Affine map;
    std::string_view layer = "0";     // replaces layer 0
    const DxfBlock* block = nullptr;  // nullptr for the drawing
    const Frame* outer = nullptr;     // contains the INSERT
    std::size_t depth = 0;
    std::size_t copy = 0;  // of the innermost block with a name of its own
  };

  void take_all(std::size_t offset, const Frame& frame);
  void count_inserted(std::size_t bytes);
  void take(DxfEntity& entity, const Frame& frame);
  void take_drawn(DxfDrawn drawn, const DxfEntity& entity, std::string_view layer,
                  const Frame& frame);
  void insert(DxfEntity& entity, std::string_view layer, const Frame& frame);
  const DxfName* reason_to_leave_out(std::string_view name, const DxfBlock* block) const;
  void check_depth(const DxfBlock& block, const DxfEntity& entity, const Frame& frame);
  const DxfName* hidden(DxfEntity& entity, std::string_view layer) const;
  void leave_out(const DxfName& name) { gathering_.left_out.add(name.one, name.many); }
  InputError nothing_found() const;
  bool stopped() const { return error_ || gathering_.full(); }
  void stop(InputError error) {
    if (!error_) error_ = std::move(error);
  }

  std::string_view text_;
  DxfDrawing drawing_;
  Gathering gathering_;
  std::vector<DrawnPiece> pieces_;  // open ones
  std::size_t piece_count_ = 0, inserted_bytes_ = 0;
  std::size_t made_periodic_ = 0;    // splines
  std::size_t splines_ = 0;          // left out
  std::size_t not_level_ = 0;        // polylines
  std::optional<InputError> error_;  // ends the reading
};

// Why an object is not seen; nullptr if it is. Programs do not plot the layer Defpoints, where they
// draw the points that dimensions measure.
const DxfName* DxfReader::hidden(DxfEntity& entity, std::string_view layer) const {
  if (entity.number_of(60, 0) != 0) return &invisible;
  if (same_word(layer, "defpoints")) return &on_defpoints;
  const DxfLayer* found = drawing_.layer(layer);
  // A layer that is off, unlike a frozen one, does not hide a block's objects on other layers.
  const bool off = found && found->off && entity.type != "INSERT";
  return off || (found && found->frozen) ? &on_hidden_layer : nullptr;
}

void DxfReader::take_drawn(DxfDrawn drawn, const DxfEntity& entity, std::string_view layer,
                           const Frame& frame) {
  if (drawn.reason) {
    splines_ += entity.type == "SPLINE";
    return leave_out(*drawn.reason);
  }
  made_periodic_ += drawn.made_periodic;
  piece_count_ += drawn.outline.pieces.size();
  if (piece_count_ > max_vertices)
    return stop(
        {ErrorCode::too_many_vertices, "the DXF drawing has more than 1048576 lines and arcs"});
  Outline outline = frame.block ? transformed(drawn.outline, frame.map) : std::move(drawn.outline);
  // Layer 0 is the default: its name carries no meaning.
  const std::string name = layer == "0" ? std::string() : with_letters(layer);
  const auto [low, high] = std::minmax_element(
      entity.vertices.begin(), entity.vertices.end(),
      [](const DxfVertex& a, const DxfVertex& b) { return a.height < b.height; });
  if (low != high && high->height - low->height > same_point * larger_side(control_box(outline)))
    ++not_level_;
  if (drawn.closed_kind)
    return gathering_.add({{outline}, name, drawn.closed_kind, Fill::none, false, frame.copy});
  if (!within_bounds(outline))
    return gathering_.add_problem(
        {ErrorCode::bad_coordinate, "a coordinate is beyond 1,000,000,000"});
  if (!outline.pieces.empty()) pieces_.push_back({std::move(outline), name, false, frame.copy});
}

const DxfName* DxfReader::reason_to_leave_out(std::string_view name, const DxfBlock* block) const {
  for (const LeftOutKind& made : made_blocks)
    if (name.starts_with(made.type)) return &made.name;
  if (!block) return &undefined_block;
  return block->in_another_file ? &other_file : nullptr;
}

void DxfReader::check_depth(const DxfBlock& block, const DxfEntity& entity, const Frame& frame) {
  const std::size_t offset = entity.groups.empty() ? 0 : entity.groups.front().offset;
  for (const Frame* outer = &frame; outer; outer = outer->outer)
    if (outer->block == &block)
      return stop(text_error(ErrorCode::bad_syntax,
                             say("the DXF drawing is damaged: the block {name} contains itself",
                                 {in_quotes(clean_name(block.name))}),
                             text_, offset));
  if (frame.depth == max_depth)
    stop(text_error(ErrorCode::unsupported,
                    "the DXF drawing has blocks that contain each other more than 32 deep", text_,
                    offset));
  static_assert(max_depth == 32, "the message names the number");
}

// Copies of a block, perhaps in columns and rows. The steps between these turn with the block, but are
// not scaled.
void DxfReader::insert(DxfEntity& entity, std::string_view layer, const Frame& frame) {
  const auto count_of = [&](int code) {
    return std::floor(std::clamp(entity.number_of(code, 1), 1.0, 65535.0));
  };
  const double columns = count_of(70), rows = count_of(71);
  const Vec2 step(entity.number_of(44, 0), entity.number_of(45, 0));
  const Vec2 scale(entity.number_of(41, 1), entity.number_of(42, 1));
  const Vec2 at = entity.point_of(10), turn = direction_of(entity.number_of(50, 0));
  const std::string_view name = entity.text_of(2);
  if (entity.bad_number()) return;
  Affine place{turn.x, turn.y, -turn.y, turn.x, at.x, at.y};
  if (entity.seen_from_behind()) place = Affine{-1, 0, 0, 1, 0, 0} * place;
  const DxfBlock* block = drawing_.block(name);
  if (const DxfName* reason = reason_to_leave_out(name, block)) return leave_out(*reason);
  check_depth(*block, entity, frame);
  std::optional<std::size_t> named;
  if (!block->name.starts_with('*'))  // programs make up these names
    named = gathering_.add_block(with_letters(block->name));
  const Affine from_base{1, 0, 0, 1, -block->base.x, -block->base.y};
  for (double row = 0; row < rows; ++row)
    for (double column = 0; column < columns; ++column) {
      count_inserted(copy_bytes);
      if (stopped()) return;
      const Affine map = frame.map * (place * Affine{1, 0, 0, 1, column * step.x, row * step.y} *
                                      Affine{scale.x, 0, 0, scale.y, 0, 0} * from_base);
      const std::size_t copy = named ? gathering_.add_copy(*named) : frame.copy;
      take_all(block->offset, {map, layer, block, &frame, frame.depth + 1, copy});
    }
}

void DxfReader::take(DxfEntity& entity, const Frame& frame) {
  const std::string_view type = entity.type;
  // These belong to a POLYLINE, or end an object's parts.
  if (type == "VERTEX" || type == "SEQEND" || type.empty()) return;
  std::string_view layer = entity.text_of(8);
  if (layer.empty() || layer == "0") layer = frame.layer;
  if (!frame.block && entity.number_of(67, 0) != 0) return leave_out(in_layout);
  if (const DxfName* reason = hidden(entity, layer)) return leave_out(*reason);
  if (entity.tilt() > same_point) return leave_out(in_other_plane);
  if (type == "INSERT") return insert(entity, layer, frame);
  if (auto drawn = draw(entity)) return take_drawn(*std::move(drawn), entity, layer, frame);
  if (const auto at = place_of_text(entity))
    gathering_.add_text(frame.map(*at), with_letters(words_of_text(entity)), written.one);
  for (const LeftOutKind& other : left_out_kinds)
    if (type == other.type) return leave_out(other.name);
  const std::string clean = clean_name(type);
  gathering_.left_out.add(clean, clean);
}

void DxfReader::count_inserted(std::size_t bytes) {
  inserted_bytes_ += bytes;
  static_assert(max_inserted_bytes >> 20 == 128, "the message names the number");
  if (inserted_bytes_ > max_inserted_bytes)
    stop(
        {ErrorCode::too_many_vertices,
         "the DXF drawing inserts its blocks too often: with all copies it is longer than 128 MiB"});
}

void DxfReader::take_all(std::size_t offset, const Frame& frame) {
  DxfEntities entities(text_, offset);
  std::size_t seen = 0;  // bytes
  while (DxfEntity* entity = entities.next()) {
    if (frame.block)
      count_inserted(entities.bytes_read() - std::exchange(seen, entities.bytes_read()));
    if (stopped()) return;
    take(*entity, frame);
    if (entity->bad_number())
      stop(text_error(ErrorCode::bad_syntax, "expected a number here, with a point for decimals",
                      text_, *entity->bad_number()));
    if (stopped()) return;
  }
  if (auto error = entities.error()) stop(*std::move(error));
}

InputError DxfReader::nothing_found() const {
  const std::string& gap = gathering_.gap();
  const std::string found = gathering_.left_out.list();
  std::string message;
  if (!gap.empty() && !found.empty())
    message =
        say("this DXF drawing has no closed outline: {gap}; it also has {things}", {gap, found});
  else if (!gap.empty())
    message = say("this DXF drawing has no closed outline: {gap}", {gap});
  else if (!found.empty())
    message = say("this DXF drawing has no closed outline, only {things}", {found});
  else
    message = say("this DXF drawing has no closed outline");
  if (splines_ > 0)
    message = say("{problem}; such splines must be turned into polylines first", {message});
  return {ErrorCode::unsupported, message};
}

Result<Import> DxfReader::read() {
  gathering_.import.format = "DXF";
  Result<DxfDrawing> drawing = read_dxf_drawing(text_);
  if (!drawing) return drawing.error();
  drawing_ = std::move(drawing).value();
  for (const std::size_t offset : drawing_.entities)
    if (!stopped()) take_all(offset, {});
  if (error_) return *std::move(error_);
  gathering_.add_joined(pieces_, false);
  gathering_.note_count(made_periodic_,
                        "{count} spline is marked as periodic but has the knots of an open "
                        "curve, and was read as periodic",
                        "{count} splines are marked as periodic but have the knots of an open "
                        "curve, and were read as periodic");
  gathering_.note_count(
      not_level_, "{count} polyline in space is not level, and was read as seen from above",
      "{count} polylines in space are not level, and were read as seen from above");
  const DxfUnit& unit = drawing_.unit;
  gathering_.import.unit = unit.label == LengthUnit::none ? unit.other : in_full(unit.label);
  for (ImportedShape& shape : gathering_.import.shapes)
    shape.document.shown.units.length = unit.label;
  return gathering_.finish(nothing_found());
}

}  // namespace

Result<Import> read_dxf(std::string_view text, const ImportOptions& options) {
  const DxfLetters letters = in_utf8(text);
  Result<Import> import = DxfReader(letters.text ? *letters.text : text, options).read();
  if (import && !letters.unknown.empty())
    import->notes.push_back(say("names are in the code page {page}, which is not known here",
                                {clean_name(letters.unknown)}));
  return import;
}

bool looks_like_dxf(std::string_view text) {
  DxfGroups groups(text);
  std::optional<DxfGroup> group = groups.next();
  while (group && group->code == 999) group = groups.next();
  return group && group->code == 0 && group->value == "SECTION";
}

}  // namespace evenlift
