#include "evenlift/experiment/results.h"

#include <algorithm>
#include <tuple>

#include "evenlift/experiment/shard_list.h"
#include "evenlift/formats.h"
#include "evenlift/numbers.h"
#include "experiment/measure/csv.h"

namespace evenlift::experiment {
namespace {

// Increase it whenever the rows of a polygon or their format change: older parts are then measured
// again.
constexpr const char* part_format = "evenlift experiment 5";

// The last two only if failures are measured.
csv::Row measurement_columns(bool failures) {
  csv::Row columns = {"set", "polygon", "method", "teams", "robots", "samples"};
  for (const MeasuredValue& measured : measured_values) columns.emplace_back(measured.column);
  columns.emplace_back("chosen");
  if (failures) columns.insert(columns.end(), {"steady", "after_failure"});
  return columns;
}

csv::Row measurement_row(const PolygonResult& of, const Measurement& m) {
  csv::Row row = {of.set,
                  of.polygon,
                  std::string(name(m.method)),
                  std::to_string(teams_of(m.method, m.robots)),
                  std::to_string(m.robots),
                  std::to_string(m.samples)};
  for (const auto& [column, value] : measured_values) row.push_back(shortest(m.*value));
  row.push_back(m.chosen ? std::to_string(*m.chosen) : "");
  if (!m.steady) return row;
  row.push_back(shortest(*m.steady));
  row.push_back(m.after_failure ? shortest(*m.after_failure) : "");
  return row;
}

csv::Row polygon_row(const PolygonResult& r) {
  if (!r.problem.empty()) return {r.set, r.polygon, "", "", "", r.problem};
  return {r.set,
          r.polygon,
          std::to_string(r.vertices),
          r.convex ? "1" : "0",
          std::to_string(r.candidates),
          ""};
}

bool read_heading(const csv::Row& row, Part& part) {
  csv::Fields fields(row, 1);
  part.settings = csv::read_settings(fields);
  part.fingerprint = fields.text();
  return fields.done() && row[0] == part_format;
}

bool read_polygon_row(const csv::Row& row, PolygonResult& result) {
  if (row.size() != 7 || row[0] != "polygon") return false;
  result.set = row[1];
  result.polygon = row[2];
  result.problem = row[6];
  if (!result.problem.empty()) return row[3].empty() && row[4].empty() && row[5].empty();
  csv::Fields fields(row, 3);
  result.vertices = fields.whole();
  result.convex = fields.whole() == 1;
  result.candidates = fields.whole();
  return fields.text().empty() && fields.done();
}

// An empty field is no number.
template <class Number>
std::optional<Number> read_optional(csv::Fields& fields, Number (csv::Fields::*read)()) {
  if (!fields.is_empty()) return (fields.*read)();
  fields.text();
  return std::nullopt;
}

bool read_measurement(const csv::Row& row, bool failures, PolygonResult& result) {
  if (row.size() != measurement_columns(failures).size() + 1 || row[1] != result.set ||
      row[2] != result.polygon)
    return false;
  const std::optional<Method> method = method_from_name(row[3]);
  if (!method) return false;
  Measurement m;
  m.method = *method;
  csv::Fields fields(row, 4);
  const std::uint32_t teams = fields.whole();
  m.robots = fields.whole();
  if (teams != teams_of(m.method, m.robots)) return false;
  m.samples = fields.whole();
  for (const auto& [column, value] : measured_values) m.*value = fields.number();
  m.chosen = read_optional(fields, &csv::Fields::whole);
  if (failures) {
    m.steady = fields.number();
    m.after_failure = read_optional(fields, &csv::Fields::number);
  }
  if (!fields.done()) return false;
  result.measurements.push_back(m);
  return true;
}

bool read_time(const csv::Row& row, Times& times) {
  csv::Fields fields(row, 1);
  std::string stage = fields.text();
  const double seconds = fields.number();
  if (!fields.done()) return false;
  times.emplace_back(std::move(stage), seconds);
  return true;
}

csv::Row tagged(const char* tag, csv::Row row) {
  row.insert(row.begin(), tag);
  return row;
}

}  // namespace

std::string fingerprint(std::string_view bytes) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  std::string text;
  for (int shift = 60; shift >= 0; shift -= 4) text += "0123456789abcdef"[hash >> shift & 15];
  return text;
}

std::string fingerprint(const Document& document, const ExperimentSettings& settings) {
  // With cargo, C depends on the weight even if the loads are those of another.
  const bool counts = !settings.weight || !document.settings.cargo.empty();
  const std::string weight = counts ? shortest(document.settings.weight) + "\n" : "";
  return fingerprint(csv::line(csv::settings_fields(settings)) + weight + write_thesis(document));
}

PolygonResult result_of(const std::string& set, const std::string& polygon,
                        const Subject& subject) {
  PolygonResult result;
  result.set = set;
  result.polygon = polygon;
  result.vertices = static_cast<std::uint32_t>(subject.object.outline().size());
  result.convex = subject.object.outline().convex();
  result.candidates = static_cast<std::uint32_t>(subject.candidates.size());
  return result;
}

void sort_results(std::vector<PolygonResult>& results) {
  std::sort(results.begin(), results.end(), [](const PolygonResult& a, const PolygonResult& b) {
    return std::tie(a.set, a.polygon) < std::tie(b.set, b.polygon);
  });
}

std::vector<ResultSet> group_by_set(std::vector<PolygonResult> results) {
  std::vector<ResultSet> sets;
  for (PolygonResult& result : results) {
    if (sets.empty() || sets.back().name != result.set) sets.push_back({result.set, {}});
    sets.back().results.push_back(std::move(result));
  }
  return sets;
}

std::string write_part(const Part& part) {
  csv::Row heading = csv::settings_fields(part.settings);
  heading.insert(heading.begin(), part_format);
  heading.push_back(part.fingerprint);
  std::string text = csv::line(heading);
  text += csv::line(tagged("polygon", polygon_row(part.result)));
  for (const Measurement& m : part.result.measurements)
    text += csv::line(tagged("measured", measurement_row(part.result, m)));
  for (const auto& [stage, seconds] : part.times)
    text += csv::line({"time", stage, shortest(seconds)});
  return text + "end\n";
}

std::optional<Part> read_part(std::string_view text) {
  const auto rows = csv::read(text);
  if (!rows || rows->size() < 3 || rows->back() != csv::Row{"end"}) return std::nullopt;
  Part part;
  if (!read_heading((*rows)[0], part) || !read_polygon_row((*rows)[1], part.result))
    return std::nullopt;
  for (std::size_t i = 2; i + 1 < rows->size(); ++i) {
    const csv::Row& row = (*rows)[i];
    const bool read = row[0] == "measured"
                          ? read_measurement(row, part.settings.failures, part.result)
                      : row[0] == "time" ? read_time(row, part.times)
                                         : false;
    if (!read) return std::nullopt;
  }
  // Refuses numbers that write_part would write in another way.
  if (write_part(part) != text) return std::nullopt;
  return part;
}

std::string measurements_csv(const std::vector<ResultSet>& sets) {
  const bool failures = std::any_of(sets.begin(), sets.end(), [](const ResultSet& set) {
    return std::any_of(set.results.begin(), set.results.end(), [](const PolygonResult& result) {
      return !result.measurements.empty() && result.measurements.front().steady;
    });
  });
  std::string text = csv::line(measurement_columns(failures));
  for (const ResultSet& set : sets)
    for (const PolygonResult& result : set.results)
      for (const Measurement& m : result.measurements)
        text += csv::line(measurement_row(result, m));
  return text;
}

std::string times_csv(const std::vector<Part>& parts) {
  std::string text = csv::line({"set", "polygon", "stage", "seconds"});
  for (const Part& part : parts)
    for (const auto& [stage, seconds] : part.times)
      text += csv::line({part.result.set, part.result.polygon, stage, shortest(seconds)});
  return text;
}

std::string polygons_csv(const std::vector<ResultSet>& sets) {
  std::string text = csv::line({"set", "polygon", "vertices", "convex", "candidates", "problem"});
  for (const ResultSet& set : sets)
    for (const PolygonResult& result : set.results) text += csv::line(polygon_row(result));
  return text;
}

}  // namespace evenlift::experiment

namespace evenlift::experiment::csv {

std::string field(std::string_view text) {
  if (text.find_first_of(",\"\n\r") == std::string_view::npos) return std::string(text);
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"') out += '"';
    out += c;
  }
  return out + '"';
}

std::string line(const Row& row) {
  std::string out;
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (i > 0) out += ',';
    out += field(row[i]);
  }
  return out + '\n';
}

std::optional<std::vector<Row>> read(std::string_view text) {
  std::vector<Row> rows;
  Row row;
  for (std::size_t at = 0; at < text.size();) {
    std::string value;
    if (text[at] == '"') {
      for (++at;; ++at) {
        if (at >= text.size()) return std::nullopt;
        if (text[at] == '"' && text.substr(at + 1, 1) != "\"") break;
        if (text[at] == '"') ++at;
        value += text[at];
      }
      ++at;
    } else {
      const std::size_t end = text.find_first_of(",\n", at);
      if (end == std::string_view::npos) return std::nullopt;
      value = text.substr(at, end - at);
      at = end;
    }
    if (at >= text.size() || (text[at] != ',' && text[at] != '\n')) return std::nullopt;
    row.push_back(std::move(value));
    if (text[at++] == ',') {
      if (at == text.size()) return std::nullopt;
      continue;
    }
    rows.push_back(std::move(row));
    row.clear();
  }
  return rows;
}

}  // namespace evenlift::experiment::csv

namespace evenlift::experiment {

namespace {

constexpr const char* list_format = "evenlift experiment shard 4";

bool read_heading(const csv::Row& row, ShardList& list) {
  csv::Fields fields(row, 1);
  list.shard = {fields.whole(), 0};
  list.shard.n = fields.whole();
  list.settings = csv::read_settings(fields);
  return fields.done() && row[0] == list_format && list.shard.i >= 1 &&
         list.shard.i <= list.shard.n && list.shard.n <= max_shards;
}

}  // namespace

std::string write_shard_list(const ShardList& list) {
  csv::Row heading = csv::settings_fields(list.settings);
  heading.insert(heading.begin(),
                 {list_format, std::to_string(list.shard.i), std::to_string(list.shard.n)});
  std::string text = csv::line(heading);
  for (const ShardList::Entry& entry : list.entries)
    text += csv::line({entry.set, entry.polygon, entry.fingerprint});
  return text + "end\n";
}

std::optional<ShardList> read_shard_list(std::string_view text) {
  const auto rows = csv::read(text);
  if (!rows || rows->size() < 2 || rows->back() != csv::Row{"end"}) return std::nullopt;
  ShardList list;
  if (!read_heading(rows->front(), list)) return std::nullopt;
  for (std::size_t i = 1; i + 1 < rows->size(); ++i) {
    const csv::Row& row = (*rows)[i];
    if (row.size() != 3) return std::nullopt;
    list.entries.push_back({row[0], row[1], row[2]});
  }
  return list;
}

}  // namespace evenlift::experiment
