// DXF as text: pairs of lines, a code and a value. The HEADER section gives the unit, and ENTITIES
// the drawing. Blocks are not expanded.
#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "evenlift/angles.h"
#include "evenlift/numbers.h"
#include "import/chains.h"
#include "import/gathering.h"
#include "import/readers.h"
#include "import/unit_words.h"
#include "numbers/text_cursor.h"

namespace evenlift {
namespace {

// A code and a value of an entity, which has at most max_groups of them.
struct Group {
  int code;
  std::string_view value;
  std::size_t offset;  // of the value in the text
};
constexpr std::size_t max_groups = std::size_t{1} << 22;

// Reads one pair of lines after another.
class Groups {
 public:
  explicit Groups(std::string_view text) : text_(text) {}

  // The next pair; nullopt at the end, or if the code is not an integer.
  std::optional<Group> next() {
    if (at_ >= text_.size()) return std::nullopt;
    code_at_ = at_;
    const std::optional<int> code = code_of(line());
    if (!code) {
      broken_ = true;
      return std::nullopt;
    }
    const std::size_t offset = at_;
    return Group{*code, line(), offset};
  }
  bool broken() const { return broken_; }
  std::size_t code_offset() const { return code_at_; }

 private:
  std::string_view line() {
    const std::size_t end = std::min(text_.find_first_of("\r\n", at_), text_.size());
    const std::string_view found = text_.substr(at_, end - at_);
    at_ = end;
    if (at_ < text_.size() && text_[at_] == '\r') ++at_;
    if (at_ < text_.size() && text_[at_] == '\n' && (at_ == end || text_[at_ - 1] == '\r')) ++at_;
    return trimmed(found);
  }
  static std::optional<int> code_of(std::string_view line) {
    const bool negative = !line.empty() && line[0] == '-';
    const auto size = read_whole(negative ? line.substr(1) : line);
    if (!size || *size > 9999) return std::nullopt;
    return negative ? -static_cast<int>(*size) : static_cast<int>(*size);
  }

  std::string_view text_;
  std::size_t at_ = 0, code_at_ = 0;
  bool broken_ = false;
};

// A unit of $INSUNITS: evenlift's own, or the name of a unit for which evenlift has no label. Empty
// if the drawing has no unit.
struct DrawingUnit {
  LengthUnit label = LengthUnit::none;
  const char* other = "";
  const char* name() const { return label == LengthUnit::none ? other : in_full(label); }
};

DrawingUnit unit_of(double number) {
  constexpr LengthUnit none = LengthUnit::none;
  static constexpr DrawingUnit units[] = {{},
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
                                          {none, "gigametres"}};
  const auto count = static_cast<double>(std::size(units));
  if (!(number >= 0) || number >= count || number != std::floor(number)) return {};
  return units[static_cast<std::size_t>(number)];
}

double sine_of(double degrees) { return sine(std::fmod(degrees, 360) * (pi / 180)); }
double cosine_of(double degrees) { return cosine(std::fmod(degrees, 360) * (pi / 180)); }

// The name of an entity that is left out.
struct Other {
  std::string_view type, one, many;
};
constexpr Other others[] = {
    {"TEXT", "text", "texts"},          {"MTEXT", "text", "texts"},
    {"ATTDEF", "text", "texts"},        {"DIMENSION", "dimension", "dimensions"},
    {"LEADER", "leader", "leaders"},    {"POINT", "point", "points"},
    {"HATCH", "hatching", "hatchings"}, {"INSERT", "block (INSERT)", "blocks (INSERT)"},
    {"IMAGE", "picture", "pictures"},   {"VIEWPORT", "viewport", "viewports"}};

class DxfReader {
 public:
  DxfReader(std::string_view text, const ImportOptions& options)
      : text_(text), groups_(text), gathering_(options) {}
  Result<Import> read();

 private:
  // The groups of an entity.
  struct Entity {
    std::string_view type;
    std::vector<Group> groups;
    std::size_t offset = 0;
  };
  struct Vertex {
    Vec2 point = Vec2::Zero();
    double bulge = 0;
  };

  double number(const Group& group);
  double number_of(const Entity& entity, int code, double otherwise);
  std::string_view text_of(const Entity& entity, int code) const;
  int flags_of(const Entity& entity) {
    return static_cast<int>(std::clamp(number_of(entity, 70, 0), 0.0, 255.0));
  }
  bool mirrored(const Entity& entity);
  // Empty for layer 0, the default layer: its name carries no meaning.
  std::string_view layer_of(const Entity& entity) const {
    const std::string_view layer = text_of(entity, 8);
    return layer == "0" ? std::string_view() : layer;
  }

  void take(const Entity& entity);
  void take_vertices(const Entity& entity);
  void polyline(const std::vector<Vertex>& vertices, bool closed, std::string_view layer,
                bool mirror);
  void end_polyline();
  void line(const Entity& entity);
  void arc(const Entity& entity, bool mirror);
  void circle(const Entity& entity, bool mirror);
  void ellipse(const Entity& entity, bool mirror);
  void spline(const Entity& entity);
  void add_part(Outline part, std::string_view layer);
  void chain_parts();
  InputError nothing_found() const;
  std::optional<InputError> sections();

  std::string_view text_;
  Groups groups_;
  Gathering gathering_;
  std::map<std::string, std::vector<Outline>> parts_;  // open ones, by layer
  std::size_t part_count_ = 0;
  std::optional<InputError> error_;  // ends the reading

  // A POLYLINE whose VERTEX entities follow.
  bool in_polyline_ = false, polyline_closed_ = false, polyline_mirrored_ = false,
       polyline_is_mesh_ = false;
  std::string polyline_layer_;
  std::vector<Vertex> polyline_;
  std::size_t blocks_ = 0, splines_ = 0;
  DrawingUnit unit_;
  std::optional<std::string> gap_;  // where the first chain does not close
};

// Ignores a part without length.
void DxfReader::add_part(Outline part, std::string_view layer) {
  if (part.pieces.empty()) return;
  if (++part_count_ > max_vertices && !error_)
    error_ = InputError{
        ErrorCode::too_many_vertices, "the DXF drawing has more than 1048576 lines and arcs", {}};
  parts_[std::string(layer)].push_back(std::move(part));
}

double DxfReader::number(const Group& group) {
  const std::optional<double> value = read_number(group.value);
  if (value) return *value;
  if (!error_)
    error_ = text_error(ErrorCode::bad_syntax, "expected a number here, with a point for decimals",
                        text_, group.offset);
  return 0;
}

double DxfReader::number_of(const Entity& entity, int code, double otherwise) {
  for (const Group& group : entity.groups)
    if (group.code == code) return number(group);
  return otherwise;
}

std::string_view DxfReader::text_of(const Entity& entity, int code) const {
  for (const Group& group : entity.groups)
    if (group.code == code) return group.value;
  return {};
}

// A flat entity that is seen from behind has its x mirrored.
bool DxfReader::mirrored(const Entity& entity) { return number_of(entity, 230, 1) < 0; }

void DxfReader::polyline(const std::vector<Vertex>& vertices, bool closed, std::string_view layer,
                         bool mirror) {
  if (vertices.empty()) return;
  const auto at = [&](const Vertex& v) {
    return mirror ? Vec2(-v.point.x(), v.point.y()) : v.point;
  };
  const double side = mirror ? -1 : 1;
  Outline outline;
  outline.start = at(vertices.front());
  for (std::size_t i = 1; i < vertices.size(); ++i)
    outline.bulge_to(at(vertices[i]), side * vertices[i - 1].bulge);
  if (closed)
    outline.bulge_to(outline.start, side * vertices.back().bulge);
  else if (outline.end() == outline.start && vertices.size() > 2)
    closed = true;
  if (!closed) return add_part(std::move(outline), layer);
  gathering_.add(outline, layer,
                 outline.curved() ? "closed polyline with arcs" : "closed polyline");
}

void DxfReader::end_polyline() {
  if (!std::exchange(in_polyline_, false)) return;
  if (polyline_is_mesh_)
    gathering_.left_out.add("mesh", "meshes");
  else
    polyline(polyline_, polyline_closed_, polyline_layer_, polyline_mirrored_);
  polyline_.clear();
}

// The vertices of an LWPOLYLINE. Each begins with an x.
void DxfReader::take_vertices(const Entity& entity) {
  std::vector<Vertex> vertices;
  for (const Group& group : entity.groups) {
    if (group.code == 10) vertices.push_back({{number(group), 0}, 0});
    if (vertices.empty()) continue;
    if (group.code == 20) vertices.back().point.y() = number(group);
    if (group.code == 42) vertices.back().bulge = number(group);
  }
  const bool closed = (flags_of(entity) & 1) != 0;
  polyline(vertices, closed, layer_of(entity), mirrored(entity));
}

void DxfReader::line(const Entity& entity) {
  Outline part;
  part.start = {number_of(entity, 10, 0), number_of(entity, 20, 0)};
  const Vec2 end(number_of(entity, 11, 0), number_of(entity, 21, 0));
  if (end == part.start) return;
  part.line_to(end);
  add_part(std::move(part), layer_of(entity));
}

void DxfReader::arc(const Entity& entity, bool mirror) {
  const Vec2 centre(number_of(entity, 10, 0), number_of(entity, 20, 0));
  const double radius = number_of(entity, 40, 0), from = number_of(entity, 50, 0),
               to = number_of(entity, 51, 360);
  if (!(radius > 0)) return;
  double angle = std::fmod(to - from, 360);
  if (angle <= 0) angle += 360;
  if (!(angle < 360)) return circle(entity, mirror);
  const auto at = [&](double degrees) {
    const Vec2 p = centre + radius * Vec2(cosine_of(degrees), sine_of(degrees));
    return mirror ? Vec2(-p.x(), p.y()) : p;
  };
  Outline part;
  part.start = at(from);
  const double bulge = sine_of(angle / 4) / cosine_of(angle / 4);
  part.bulge_to(at(to), mirror ? -bulge : bulge);
  add_part(std::move(part), layer_of(entity));
}

void DxfReader::circle(const Entity& entity, bool mirror) {
  const double radius = number_of(entity, 40, 0), x = number_of(entity, 10, 0);
  if (!(radius > 0)) return;
  gathering_.add(
      Outline::ellipse({radius, 0, 0, radius, mirror ? -x : x, number_of(entity, 20, 0)}),
      layer_of(entity), "circle");
}

// Parameters are in radians. A difference of a whole turn gives a closed ellipse.
void DxfReader::ellipse(const Entity& entity, bool mirror) {
  const Vec2 centre(number_of(entity, 10, 0), number_of(entity, 20, 0));
  const Vec2 major(number_of(entity, 11, 0), number_of(entity, 21, 0));
  const double ratio = number_of(entity, 40, 1), from = number_of(entity, 41, 0),
               to = number_of(entity, 42, 2 * pi);
  // An ellipse lies in the world's plane. Seen from behind, its minor axis points the other way.
  const Vec2 minor = (mirror ? -ratio : ratio) * left_normal(major);
  const Affine frame{major.x(), major.y(), minor.x(), minor.y(), centre.x(), centre.y()};
  double angle = std::fmod(to - from, 2 * pi);
  if (angle <= 0) angle += 2 * pi;
  if (angle > 2 * pi - same_point)
    return gathering_.add(Outline::ellipse(frame), layer_of(entity), "ellipse");
  const auto at = [](double parameter) {
    const double turned = std::fmod(parameter, 2 * pi);
    return Vec2(cosine(turned), sine(turned));
  };
  Outline part;
  part.start = frame(at(from));
  part.arc_to(frame, at(from), at(to), true, angle > pi, frame(at(to)));
  add_part(std::move(part), layer_of(entity));
}

void DxfReader::spline(const Entity& entity) {
  Points control;
  std::vector<double> knots;
  bool weighted = false;
  for (const Group& group : entity.groups) {
    if (group.code == 10) control.push_back({number(group), 0});
    if (group.code == 20 && !control.empty()) control.back().y() = number(group);
    if (group.code == 40) knots.push_back(number(group));
    if (group.code == 41) weighted = weighted || number(group) != 1;
  }
  const double degree = std::clamp(number_of(entity, 71, 3), 0.0, 99.0);
  std::optional<Outline> curve;
  if (!weighted) curve = Outline::b_spline(control, knots, static_cast<std::size_t>(degree));
  if (!curve) {
    ++splines_;
    return gathering_.left_out.add("spline with weights or of a high degree",
                                   "splines with weights or of a high degree");
  }
  const double side = larger_side(control_box(*curve));
  if (larger_side(bounding_box({curve->start, curve->end()})) <= same_point * side)
    return gathering_.add(*curve, layer_of(entity), "closed spline");
  add_part(*std::move(curve), layer_of(entity));
}

void DxfReader::take(const Entity& entity) {
  const std::string_view type = entity.type;
  if (type == "VERTEX") {
    if (in_polyline_ && polyline_.size() <= max_vertices)
      polyline_.push_back(
          {{number_of(entity, 10, 0), number_of(entity, 20, 0)}, number_of(entity, 42, 0)});
    return;
  }
  end_polyline();
  if (type == "SEQEND" || type.empty()) return;
  if (number_of(entity, 67, 0) != 0)
    return gathering_.left_out.add("object of a layout", "objects of layouts");
  const double tilt =
      std::max(std::abs(number_of(entity, 210, 0)), std::abs(number_of(entity, 220, 0)));
  if (tilt > same_point)
    return gathering_.left_out.add("object in another plane", "objects in another plane");
  const bool mirror = mirrored(entity);
  if (type == "LWPOLYLINE") return take_vertices(entity);
  if (type == "LINE") return line(entity);
  if (type == "ARC") return arc(entity, mirror);
  if (type == "CIRCLE") return circle(entity, mirror);
  if (type == "ELLIPSE") return ellipse(entity, mirror);
  if (type == "SPLINE") return spline(entity);
  if (type == "POLYLINE") {
    const int flags = flags_of(entity);
    in_polyline_ = true;
    polyline_closed_ = (flags & 1) != 0;
    polyline_is_mesh_ = (flags & (16 | 64)) != 0;
    polyline_mirrored_ = mirror;
    polyline_layer_ = layer_of(entity);
    return;
  }
  blocks_ += type == "INSERT";
  for (const Other& other : others)
    if (type == other.type) return gathering_.left_out.add(other.one, other.many);
  const std::string clean = clean_name(type);
  gathering_.left_out.add(clean, clean);
}

void DxfReader::chain_parts() {
  Points corners;
  std::size_t open = 0;
  for (const auto& [layer, parts] : parts_)
    for (const Outline& part : parts) {
      const Box box = control_box(part);
      corners.push_back(box.low);
      corners.push_back(box.high);
    }
  const double near = same_point * larger_side(bounding_box(corners));
  for (const auto& [layer, parts] : parts_) {
    if (!(near > 0) || !std::isfinite(near)) {
      open += parts.size();
      continue;
    }
    for (const Chain& chain : chained(parts, near)) {
      if (chain.closed) {
        gathering_.add(chain.outline, layer,
                       chain.parts == 1 ? "closed line"
                                        : std::to_string(chain.parts) + " lines and arcs, joined");
        continue;
      }
      open += chain.parts;
      if (!gap_) {
        const auto point = [](const Vec2& p) {
          return "(" + short_number(p.x()) + ", " + short_number(p.y()) + ")";
        };
        gap_ = "the chain from " + point(chain.outline.start) + " ends at " +
               point(chain.outline.end());
      }
    }
  }
  if (open > 0)
    gathering_.note(counted(open, "line or arc does", "lines and arcs do") + " not close and " +
                    (open == 1 ? "was" : "were") + " left out" + (gap_ ? ": " + *gap_ : ""));
}

InputError DxfReader::nothing_found() const {
  std::string message = "this DXF drawing has no closed outline";
  if (gap_) message += ": " + *gap_;
  const std::string found = gathering_.left_out.list();
  if (!found.empty()) message += (gap_ ? "; it also has " : ", only ") + found;
  if (blocks_ > 0) message += "; blocks (INSERT) must be exploded first";
  if (splines_ > 0) message += "; such splines must be turned into polylines first";
  return {ErrorCode::unsupported, message, {}};
}

std::optional<InputError> DxfReader::sections() {
  Entity entity;
  std::string_view section, variable;
  bool names_section = false;
  while (const std::optional<Group> group = groups_.next()) {
    if (group->code == 0) {
      if (section == "ENTITIES") take(entity);
      if (gathering_.full()) return std::nullopt;
      entity.type = {};
      entity.groups.clear();
      if (group->value == "EOF") return std::nullopt;
      names_section = group->value == "SECTION";
      if (group->value == "ENDSEC" || names_section)
        section = {};
      else
        entity = {group->value, std::move(entity.groups), group->offset};
    } else if (names_section && group->code == 2) {
      section = group->value;
      names_section = false;
    } else if (section == "HEADER") {
      if (group->code == 9) variable = group->value;
      if (group->code == 70 && variable == "$INSUNITS")
        unit_ = unit_of(read_number(group->value).value_or(0));
    } else if (section == "ENTITIES") {
      if (entity.groups.size() == max_groups)
        return text_error(ErrorCode::too_many_vertices, "an object has too many vertices", text_,
                          group->offset);
      entity.groups.push_back(*group);
    }
    if (error_) return error_;
  }
  if (groups_.broken())
    return text_error(
        ErrorCode::bad_syntax,
        "the DXF drawing is damaged: expected a group code here, which is a whole number", text_,
        groups_.code_offset());
  return InputError{ErrorCode::bad_syntax, "the DXF drawing is cut off before its end (EOF)", {}};
}

Result<Import> DxfReader::read() {
  gathering_.import.format = "DXF";
  if (auto error = sections()) return *std::move(error);
  if (error_) return *std::move(error_);
  end_polyline();
  chain_parts();
  if (blocks_ > 0 && !gathering_.import.shapes.empty())
    gathering_.note(
        "blocks (INSERT) were left out: explode them in the CAD program to include them");
  gathering_.import.unit = unit_.name();
  for (ImportedShape& shape : gathering_.import.shapes)
    shape.document.shown.units.length = unit_.label;
  return gathering_.finish(nothing_found());
}

}  // namespace

Result<Import> read_dxf(std::string_view text, const ImportOptions& options) {
  return DxfReader(text, options).read();
}

bool looks_like_dxf(std::string_view text) {
  Groups groups(text);
  std::optional<Group> group = groups.next();
  while (group && group->code == 999) group = groups.next();
  return group && group->code == 0 && group->value == "SECTION";
}

}  // namespace evenlift
