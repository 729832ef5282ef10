#include "link/payload.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>

#include "evenlift/numbers.h"
#include "evenlift/settings.h"
#include "exact/sorted_indices.h"
#include "link/quantizer.h"
#include "link/records.h"
#include "link/settings.h"
#include "link/vertices.h"

namespace evenlift {
namespace {

// Each item has three numbers, and a name in quotes with characters of up to four bytes.
constexpr std::size_t most_bytes_of_cargo = max_cargo * (3 * 26 + 4 * max_name_characters + 4);
// A name of quotation marks takes two bytes for each, one of other characters at most four.
constexpr std::size_t most_bytes_of_names = most_supports * (4 * max_name_characters + 3);
static_assert(most_bytes_of_cargo < 1u << widest_length &&
              most_bytes_of_names < 1u << widest_length);

// Overlays added after version 1, and the payload of one that is shown.
struct OverlayRecord {
  Tag tag;
  bool Overlays::*overlay;
};
constexpr OverlayRecord overlay_records[] = {
    {tag::halo, &Overlays::halo}, {tag::tilt, &Overlays::tilt}, {tag::load, &Overlays::load}};
constexpr const char* shown = "shown";

const OverlayRecord* overlay_of_record(Tag number) {
  for (const OverlayRecord& record : overlay_records)
    if (record.tag == number) return &record;
  return nullptr;
}

const SettingRow* row_of_record(Tag number) {
  for (const SettingRow& row : all_settings())
    if (row.record == number && number != tag::end) return &row;
  return nullptr;
}

// A record of the number of robots means balanced robots, and one of supports given robots. The
// default goal of teams is `cover`.
bool is_needed(const SettingRow& row, const Document& document, const Document& defaults) {
  const Settings& settings = document.settings;
  if (!is_kept(row, settings)) return false;
  if (row.setting == Setting::robots || row.setting == Setting::supports) return true;
  if (row.setting == Setting::goal && settings.method != Method::balanced)
    return settings.goal == Goal::hold;
  return text_of(row.setting, document) != text_of(row.setting, defaults);
}

// "mm", ",lb" or "mm,lb"; empty for the default units, which need no record.
std::string units_text(const Units& units) {
  std::string text;
  if (units.length != LengthUnit::none) text += name(units.length);
  if (units.weight != WeightUnit::kg) text += "," + std::string(name(units.weight));
  return text;
}

// Returns whether units_text() could have written the text.
bool take_units(const std::string& text, Document& document) {
  document.shown.units = {};
  const std::size_t comma = text.find(',');
  if (comma != 0 && read_setting(Setting::unit, text.substr(0, comma), document)) return false;
  if (comma != std::string::npos &&
      read_setting(Setting::weight_unit, text.substr(comma + 1), document))
    return false;
  return !text.empty() && units_text(document.shown.units) == text;
}

// Counts only robots of the document's method.
bool has_moved(const Document& document) {
  const Moved& moved = document.moved;
  return document.settings.method == Method::balanced ? !moved.robots.empty()
                                                      : !moved.teams.empty();
}

// Early links had no bounds here: see check_linked_settings().
bool take_unbounded(Setting setting, const std::string& text, Document& document) {
  const std::optional<double> value = read_number(text);
  if (!value || *value < 0) return false;
  if (setting == Setting::apart)
    document.settings.apart = *value;
  else if (setting == Setting::capacity && *value > 0)
    document.shown.capacity = *value;
  else if (setting == Setting::com_radius)
    document.shown.com_radius = *value;
  else
    return false;
  return true;
}

bool take_moved(const std::string& text, Document& document) {
  auto moved = read_moved(text);
  if (!moved) return false;
  document.moved = *std::move(moved);
  return true;
}

}  // namespace

bool is_known(Tag number) {
  return number == tag::holes || number == tag::units || number == tag::moved ||
         overlay_of_record(number) || row_of_record(number);
}

std::size_t longest_value(Tag number) {
  if (number == tag::moved) return 64 * most_moved_teams;
  const SettingRow* row = row_of_record(number);
  if (row && row->setting == Setting::robot) return 5 * 32;
  if (row && (row->setting == Setting::support_capacities || row->setting == Setting::readings ||
              row->setting == Setting::readings_tilted))
    return 32 * most_supports;
  if (row && row->setting == Setting::heading) return 2 * 32;
  if (row && row->setting == Setting::cargo) return most_bytes_of_cargo;
  if (row && row->setting == Setting::support_names) return most_bytes_of_names;
  return row && row->setting == Setting::no_go ? 64 * most_no_go : 32;
}

Records records_of(const Document& document) {
  const Document defaults = defaults_of_links();
  Records records;
  for (const SettingRow& row : all_settings())
    if (row.record != tag::end && is_needed(row, document, defaults))
      records.push_back({row.record, row.record == tag::supports ? std::string()
                                                                 : text_of(row.setting, document)});
  const Shown& asked = document.shown;
  if (!document.holes.empty()) records.push_back({tag::holes, {}});
  if (!(asked.units == Units{})) records.push_back({tag::units, units_text(asked.units)});
  for (const auto& [number, overlay] : overlay_records)
    if (asked.overlays.*overlay) records.push_back({number, shown});
  if (has_moved(document)) records.push_back({tag::moved, moved_text(document.moved)});
  sort_items(records, [](const Record& a, const Record& b) { return a.tag < b.tag; });
  return records;
}

bool take_records(const Records& records, Document& document) {
  for (const auto& [number, payload] : records) {
    if (const OverlayRecord* record = overlay_of_record(number)) {
      if (payload != shown) return false;
      document.shown.overlays.*record->overlay = true;
    } else if (number == tag::units) {
      if (!take_units(payload, document)) return false;
    } else if (number == tag::moved) {
      if (!take_moved(payload, document)) return false;
    } else if (number == tag::supports) {
      document.settings.method = Method::given;
    } else if (number == tag::holes) {
      continue;  // coded like vertices
    } else {
      const Setting setting = row_of_record(number)->setting;
      if (setting == Setting::robots) document.settings.method = Method::balanced;
      if (take_unbounded(setting, payload, document)) continue;
      if (read_setting(setting, payload, document)) return false;
    }
  }
  return true;
}

namespace {

// The box of quantized vertices that are not escaped.
struct NumberBox {
  std::int64_t low[2] = {std::numeric_limits<std::int64_t>::max(),
                         std::numeric_limits<std::int64_t>::max()};
  std::int64_t high[2] = {std::numeric_limits<std::int64_t>::min(),
                          std::numeric_limits<std::int64_t>::min()};

  explicit NumberBox(const QuantizedVertices& quantized) {
    for (const auto& vertex : quantized) {
      for (std::size_t axis = 0; axis < 2; ++axis) {
        if (vertex[axis].escaped) continue;
        low[axis] = std::min(low[axis], vertex[axis].number);
        high[axis] = std::max(high[axis], vertex[axis].number);
      }
    }
  }
  bool empty() const { return low[0] > high[0] || low[1] > high[1]; }
  std::uint64_t offset(std::size_t axis, std::int64_t number) const {
    return static_cast<std::uint64_t>(number) - static_cast<std::uint64_t>(low[axis]);
  }
  bool holds(std::size_t axis, std::int64_t number) const {
    return low[axis] <= number && number <= high[axis];
  }
};

// Usually C is on the scale of the vertices and in their bounding box. Otherwise its coordinates
// are separate numbers.
template <class Coder>
Vec2 code_centre(Coder& coder, Vec2 centre, const Scale& scale,
                 const QuantizedVertices& quantized) {
  const NumberBox box(quantized);
  std::int64_t numbers[2] = {0, 0};
  bool in_box = !box.empty();
  if constexpr (!Coder::decoding) {
    for (std::size_t axis = 0; axis < 2 && in_box; ++axis) {
      const auto number = scale.number_of(centre[axis]);
      in_box = number && box.holds(axis, *number);
      numbers[axis] = number.value_or(0);
    }
  }
  BitModel model{{3, 1}};
  in_box = !box.empty() && !coder.code_bit(!in_box, model);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    double& value = centre[axis];
    if (in_box) {
      const std::uint64_t offset =
          code_up_to(coder, box.offset(axis, numbers[axis]), box.offset(axis, box.high[axis]));
      value = scale.value_of(
          static_cast<std::int64_t>(static_cast<std::uint64_t>(box.low[axis]) + offset));
    } else {
      value = code_number(coder, value);
    }
  }
  return centre;
}

struct Content {
  Document settings = defaults_of_links();  // without vertices and centre of mass
  QuantizedVertices quantized;              // vertices, by the scale of the encoding
  std::optional<Vec2> centre_of_mass;
  LinkVersion version = LinkVersion::one;
  Records records;   // of version 2
  CodedLists lists;  // of records
};

// `encoding` is that of the vertices. A decoder returns the one that it reads.
template <class Coder>
Encoding code_content(Coder& coder, Content& content, Encoding encoding) {
  constexpr int widest_count = 16;
  static_assert(max_link_vertices < (std::size_t{1} << widest_count));

  code_settings(coder, content.settings);
  const std::uint64_t count = code_integer(coder, content.quantized.size(), widest_count);
  if (count > max_link_vertices) coder.fail();
  if (coder.failed()) return encoding;
  if (count > 0)
    encoding = code_vertices(coder, encoding, content.quantized, static_cast<std::size_t>(count));

  std::optional<Vec2>& centre = content.centre_of_mass;
  const bool has_centre = coder.code_uniform(centre ? 1 : 0, 2) != 0;
  if (has_centre && !coder.failed()) {
    centre = code_centre(coder, centre.value_or(Vec2{}), encoding.scale, content.quantized);
  }
  if (content.version == LinkVersion::two) code_records(coder, content.records, content.lists);
  return encoding;
}

Digits encode_in(const Encoding& encoding, Content& content) {
  Encoder encoder;
  code_content(encoder, content, encoding);
  return encoder.finish();
}

bool is_finite(const Document& document) {
  for (const Vec2& vertex : document.vertices)
    if (!is_finite(vertex)) return false;
  if (document.centre_of_mass && !is_finite(*document.centre_of_mass)) return false;
  for (const Vec2& support : document.settings.supports)
    if (!is_finite(support)) return false;
  for (const Points& hole : document.holes)
    for (const Vec2& vertex : hole)
      if (!is_finite(vertex)) return false;
  return std::isfinite(document.settings.weight) && std::isfinite(document.settings.min_ratio);
}

Points values_of(const QuantizedVertices& quantized) {
  Points points;
  points.reserve(quantized.size());
  for (const auto& point : quantized) points.emplace_back(point[0].value, point[1].value);
  return points;
}

Points vertices_of_all(const std::vector<Points>& holes) {
  Points all;
  for (const Points& hole : holes) all.insert(all.end(), hole.begin(), hole.end());
  return all;
}

// Without the settings in records.
Document document_of(const Content& content) {
  Document document = content.settings;
  document.centre_of_mass = content.centre_of_mass;
  document.vertices = values_of(content.quantized);
  document.settings.supports = values_of(content.lists.supports.quantized);
  const Points holes = values_of(content.lists.holes.quantized);
  auto begin = holes.begin();
  for (const std::size_t size : content.lists.hole_sizes) {
    document.holes.emplace_back(begin, begin + static_cast<std::ptrdiff_t>(size));
    begin += static_cast<std::ptrdiff_t>(size);
  }
  return document;
}

}  // namespace

LinkVersion version_for(const Document& document) {
  return records_of(document).empty() ? LinkVersion::one : LinkVersion::two;
}

namespace {

void find_shortest(const Encoding& encoding, Content& content, CodedPoints& points,
                   const Points& values) {
  if (values.empty()) return;
  CodedPoints best;
  std::size_t least = 0;
  std::vector<QuantizedPolygon> all = likely_encodings(values);
  for (QuantizedPolygon& likely : all) {
    points = {likely.encoding, std::move(likely.quantized)};
    const std::size_t size = all.size() > 1 ? encode_in(encoding, content).size() : 0;
    if (!best.quantized.empty() && size >= least) continue;
    best = points;
    least = size;
  }
  points = std::move(best);
}

CodedLists shortest_lists(const Encoding& encoding, Content& content, const Document& document) {
  CodedLists& lists = content.lists;
  for (const Points& hole : document.holes) lists.hole_sizes.push_back(hole.size());
  const Points holes = vertices_of_all(document.holes);
  const bool given = document.settings.method == Method::given;
  const Points supports = given ? document.settings.supports : Points();
  lists.holes.quantized = quantize(lists.holes.encoding.scale, holes);
  find_shortest(encoding, content, lists.supports, supports);
  find_shortest(encoding, content, lists.holes, holes);
  return std::move(lists);
}

}  // namespace

Digits encode_payload(const Document& document) {
  Digits best;
  bool first = true;
  std::optional<CodedLists> lists;  // found with the first candidate
  for (QuantizedPolygon& candidate : likely_encodings(document.vertices)) {
    Content content{settings_of_link_1(document), std::move(candidate.quantized),
                    document.centre_of_mass,      version_for(document),
                    records_of(document),         {}};
    if (!lists) lists = shortest_lists(candidate.encoding, content, document);
    content.lists = *lists;
    Digits digits = encode_in(candidate.encoding, content);
    if (first || digits.size() < best.size()) best = std::move(digits);
    first = false;
  }
  return best;
}

Payload decode_payload(LinkVersion version, std::span<const std::uint8_t> digits) {
  Decoder decoder(digits);
  Content content;
  content.version = version;
  const Encoding encoding = code_content(decoder, content, Encoding{});
  if (decoder.failed()) return NoPayload{};
  if (!content.records.empty() && !is_known(content.records.back().tag))
    return UnknownRecord{static_cast<unsigned>(content.records.back().tag)};

  Document document = document_of(content);
  if (!is_finite(document) || !take_records(content.records, document)) return NoPayload{};
  // A document has exactly one link in each encoding, so no link can hide data.
  content.quantized = quantize(encoding.scale, document.vertices);
  content.records = records_of(document);
  for (const auto& [points, values] :
       {std::pair(&content.lists.supports, document.settings.supports),
        std::pair(&content.lists.holes, vertices_of_all(document.holes))})
    points->quantized = quantize(points->encoding.scale, values);
  if (version_for(document) != version) return NoPayload{};
  const Digits again = encode_in(encoding, content);
  if (!std::equal(again.begin(), again.end(), digits.begin(), digits.end())) return NoPayload{};
  return document;
}

}  // namespace evenlift
