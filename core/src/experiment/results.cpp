#include "evenlift/experiment/results.h"

#include "fields.h"

namespace evenlift {
namespace {

// Changes whenever the same polygon gives other rows, or rows look different: older parts are then
// measured anew.
constexpr const char* part_format = "evenlift experiment 1";

const csv::Row measurement_columns = {
    "polygon", "method",   "teams",     "robots",   "samples", "coverage",  "form_closure",
    "no_area", "load_min", "load_mean", "load_max", "spread",  "max_share", "chosen"};

csv::Row measurement_row(const std::string& polygon, const Measurement& m) {
  return {polygon,
          std::string(name(m.method)),
          std::to_string(m.teams),
          std::to_string(2 * std::uint64_t{m.teams}),
          std::to_string(m.samples),
          shortest(m.coverage),
          shortest(m.form_closure),
          shortest(m.no_area),
          shortest(m.load_min),
          shortest(m.load_mean),
          shortest(m.load_max),
          shortest(m.spread),
          shortest(m.max_share),
          m.chosen ? std::to_string(*m.chosen) : ""};
}

csv::Row polygon_row(const PolygonResult& r) {
  if (!r.problem.empty()) return {r.polygon, "", "", "", r.problem};
  return {r.polygon, std::to_string(r.vertices), r.convex ? "1" : "0", std::to_string(r.candidates),
          ""};
}

bool read_settings(const csv::Row& row, Part& part) {
  csv::Fields fields(row, 1);
  part.settings.min_ratio = fields.number();
  part.settings.samples = fields.whole();
  part.settings.most_teams = fields.whole();
  part.fingerprint = fields.text();
  return fields.done() && row[0] == part_format;
}

bool read_polygon_row(const csv::Row& row, PolygonResult& result) {
  if (row.size() != 6 || row[0] != "polygon") return false;
  result.polygon = row[1];
  result.problem = row[5];
  if (!result.problem.empty()) return row[2].empty() && row[3].empty() && row[4].empty();
  csv::Fields fields(row, 2);
  result.vertices = fields.whole();
  result.convex = fields.whole() == 1;
  result.candidates = fields.whole();
  return fields.text().empty() && fields.done();
}

bool read_measurement(const csv::Row& row, PolygonResult& result) {
  if (row.size() != measurement_columns.size() + 1 || row[1] != result.polygon) return false;
  const std::optional<Metric> method = metric_from_name(row[2]);
  if (!method) return false;
  Measurement m;
  m.method = *method;
  csv::Fields fields(row, 3);
  m.teams = fields.whole();
  if (fields.whole() != 2 * m.teams) return false;
  m.samples = fields.whole();
  for (double* value : {&m.coverage, &m.form_closure, &m.no_area, &m.load_min, &m.load_mean,
                        &m.load_max, &m.spread, &m.max_share})
    *value = fields.number();
  if (!row.back().empty()) {
    m.chosen = fields.whole();
  } else {
    fields.text();
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
  return fingerprint(shortest(settings.min_ratio) + "," + std::to_string(settings.samples) + "," +
                     std::to_string(settings.most_teams) + "\n" + write_thesis(document));
}

PolygonResult describe(const std::string& name, const Subject& subject) {
  PolygonResult result;
  result.polygon = name;
  result.vertices = static_cast<std::uint32_t>(subject.polygon.size());
  result.convex = subject.polygon.convex();
  result.candidates = static_cast<std::uint32_t>(subject.candidates.size());
  return result;
}

std::string write_part(const Part& part) {
  std::string text = csv::line({part_format, shortest(part.settings.min_ratio),
                                std::to_string(part.settings.samples),
                                std::to_string(part.settings.most_teams), part.fingerprint});
  text += csv::line(tagged("polygon", polygon_row(part.result)));
  for (const Measurement& m : part.result.measurements)
    text += csv::line(tagged("measured", measurement_row(part.result.polygon, m)));
  for (const auto& [stage, seconds] : part.times)
    text += csv::line({"time", stage, shortest(seconds)});
  return text + "end\n";
}

std::optional<Part> read_part(std::string_view text) {
  const auto rows = csv::read(text);
  if (!rows || rows->size() < 3 || rows->back() != csv::Row{"end"}) return std::nullopt;
  Part part;
  if (!read_settings((*rows)[0], part) || !read_polygon_row((*rows)[1], part.result))
    return std::nullopt;
  for (std::size_t i = 2; i + 1 < rows->size(); ++i) {
    const csv::Row& row = (*rows)[i];
    const bool read = row[0] == "measured" ? read_measurement(row, part.result)
                      : row[0] == "time"   ? read_time(row, part.times)
                                           : false;
    if (!read) return std::nullopt;
  }
  return part;
}

std::string measurements_csv(const std::vector<PolygonResult>& results) {
  std::string text = csv::line(measurement_columns);
  for (const PolygonResult& result : results)
    for (const Measurement& m : result.measurements)
      text += csv::line(measurement_row(result.polygon, m));
  return text;
}

std::string times_csv(const std::vector<Part>& parts) {
  std::string text = csv::line({"polygon", "stage", "seconds"});
  for (const Part& part : parts)
    for (const auto& [stage, seconds] : part.times)
      text += csv::line({part.result.polygon, stage, shortest(seconds)});
  return text;
}

std::string polygons_csv(const std::vector<PolygonResult>& results) {
  std::string text = csv::line({"polygon", "vertices", "convex", "candidates", "problem"});
  for (const PolygonResult& result : results) text += csv::line(polygon_row(result));
  return text;
}

}  // namespace evenlift
