// Writes and reads comma-separated values (RFC 4180) whose rows end in line feeds.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "evenlift/chords.h"
#include "evenlift/experiment/measure.h"
#include "evenlift/numbers.h"

namespace evenlift::experiment::csv {

using Row = std::vector<std::string>;

// The text of a field, in quotes if necessary. O(bytes).
std::string field(std::string_view text);

// The text of a row, with its line feed. O(bytes).
std::string line(const Row& row);

// The rows of a text. Returns nothing if a quotation mark is still open at the end, if text follows
// a closing one, or if the last row does not end in a line feed. O(bytes).
std::optional<std::vector<Row>> read(std::string_view text);

// --- Reads the fields of a row one after another. Part files (results.h) and shard lists
// (shard_list.h) contain the experiment's settings as fields.

class Fields {
 public:
  explicit Fields(const Row& row, std::size_t first = 0) : row_(row), at_(first) {}

  std::string text() { return at_ < row_.size() ? row_[at_++] : (good_ = false, std::string()); }

  bool is_empty() const { return at_ < row_.size() && row_[at_].empty(); }

  double number() {
    const std::optional<double> value = read_number(text());
    good_ = good_ && value;
    return value.value_or(0);
  }

  std::uint32_t whole() {
    const std::optional<std::uint64_t> value = read_whole(text());
    good_ = good_ && value && *value <= 0xFFFFFFFFu;
    return good_ ? static_cast<std::uint32_t>(*value) : 0;
  }

  // Whether all fields were read and were valid.
  bool done() const { return good_ && at_ == row_.size(); }

 private:
  const Row& row_;
  std::size_t at_;
  bool good_ = true;
};

inline Row settings_fields(const ExperimentSettings& settings) {
  const RobotSize& robot = settings.robot;
  Row row = {shortest(settings.min_ratio), std::to_string(settings.samples),
             std::to_string(settings.most_teams), std::to_string(settings.most_balanced),
             settings.weight ? shortest(*settings.weight) : "own"};
  for (const double size : {robot.radius, robot.reach, robot.depth, robot.width, robot.gap})
    row.push_back(shortest(size));
  row.push_back(settings.failures ? "1" : "0");
  return row;
}

inline ExperimentSettings read_settings(Fields& fields) {
  ExperimentSettings settings;
  settings.min_ratio = fields.number();
  settings.samples = fields.whole();
  settings.most_teams = fields.whole();
  settings.most_balanced = fields.whole();
  const std::string weight = fields.text();
  settings.weight = weight == "own" ? std::nullopt : read_number(weight);
  RobotSize& robot = settings.robot;
  for (double* size : {&robot.radius, &robot.reach, &robot.depth, &robot.width, &robot.gap})
    *size = fields.number();
  settings.failures = fields.whole() == 1;
  return settings;
}

}  // namespace evenlift::experiment::csv

namespace evenlift::experiment {

// --- The measurements of balanced robots (evenlift/experiment/measure.h), and tests of form closure
// for all methods.

// Whether robots at these points keep the object in form closure even without the contacts that are
// nearer to a corner (closure.h) than usual_clear times R, the default of the setting `clear`.
bool holds_clearly(const Polygon& polygon, const Vec2& centre,
                   const std::vector<LiftingPoint>& points);

// Sets the results of three tests in `m`: form closure (in_form_closure), the thesis's own test
// (no_region_has_area), and form closure by clear contacts (holds_clearly).
void test_closure(const Subject& subject, const std::vector<LiftingPoint>& points, Measurement& m);

// The result of measure() for Method::balanced.
std::vector<Measurement> measure_balanced(const Subject& subject,
                                          const ExperimentSettings& settings);

}  // namespace evenlift::experiment
