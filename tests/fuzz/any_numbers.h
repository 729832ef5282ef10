// Documents with arbitrary doubles wherever users give numbers. Each is refused with its setting or
// place, or placed and written with finite numbers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>

#include "evenlift/capacity.h"
#include "evenlift/link.h"
#include "evenlift/output/json.h"
#include "evenlift/output/poses.h"
#include "evenlift/output/svg.h"
#include "evenlift/placement.h"

namespace evenlift::testing {

// Choices and doubles from bytes, then zeros.
class AnyNumbers {
 public:
  AnyNumbers(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}

  std::uint8_t byte() {
    if (at_ == size_) return 0;
    return data_[at_++];
  }
  std::uint32_t below(std::uint32_t n) { return byte() % n; }

  // Mostly the usual number, else one with arbitrary bits.
  double number(double usual) {
    if (byte() % 4 != 0) return usual;
    std::uint8_t bytes[8] = {};
    for (std::uint8_t& b : bytes) b = byte();
    double value = 0;
    std::memcpy(&value, bytes, sizeof value);
    return value;
  }

 private:
  const std::uint8_t* data_;
  std::size_t size_;
  std::size_t at_ = 0;
};

inline Document document_with(AnyNumbers& any) {
  Document document;
  for (const Vec2& corner : Points{{0, 0}, {4, 0}, {4, 1.5}, {1.5, 1.5}, {1.5, 3}, {0, 3}}) {
    const double x = any.byte() % 8 == 0 ? any.number(corner.x) : corner.x;
    const double y = any.byte() % 8 == 0 ? any.number(corner.y) : corner.y;
    document.vertices.emplace_back(x, y);
  }
  if (any.byte() % 8 == 0) {
    const double x = any.number(1);
    document.centre_of_mass = Vec2(x, any.number(1));
  }
  Settings& settings = document.settings;
  Shown& shown = document.shown;
  settings.method = named_methods[any.below(7)];
  const std::uint32_t supports = any.below(6);
  for (std::uint32_t i = 0; i < supports; ++i) {
    const double x = any.number(0.5 * i);
    settings.supports.emplace_back(x, any.number(0.5));
  }
  if (any.below(4) == 0) settings.snap = any.number(1e-3);
  if (any.below(3) == 0) shown.support_capacities.assign(supports, any.number(30));
  if (any.below(8) == 7) {
    Weighed& weighed = settings.weighed;
    for (std::uint32_t i = 0; i < supports; ++i) weighed.readings.push_back(any.number(25));
    if (any.below(2) == 0) weighed.error.percent = any.number(1);
    weighed.level_error = any.number(0);
    if (any.below(2) == 0) {
      weighed.tilted_readings = weighed.readings;
      weighed.tilted = any.number(0.1);
      weighed.heading = Vec2(any.number(1), any.number(0));
    }
  }
  if (any.below(8) == 7) shown.carrying.dynamic = any.number(1.2);
  if (any.below(8) == 7) shown.carrying.weight_doubt = any.number(0.1);
  settings.teams = 1 + any.below(4);
  settings.robots = 2 + any.below(5);
  settings.positions = any.below(2) == 0 ? Positions::best : Positions::range;
  if (any.below(3) == 0) settings.goal = any.below(2) == 0 ? Goal::cover : Goal::hold;
  settings.min_ratio = any.number(0.8);
  if (settings.weighed.readings.empty()) settings.weight = any.number(100);
  settings.min_margin = any.number(0.05);
  shown.com_radius = any.number(0);
  if (any.below(2) == 0) settings.apart = any.number(0.1);
  if (any.below(2) == 0) settings.clear = any.number(0.1);
  if (any.below(2) == 0) shown.capacity = any.number(40);
  shown.units.length = all_length_units[any.below(5)];
  if (any.below(2) == 0) {
    const double usual = any.below(2) == 0 ? 0 : 0.05;
    for (double RobotSize::*part : {&RobotSize::radius, &RobotSize::reach, &RobotSize::depth,
                                    &RobotSize::width, &RobotSize::gap})
      settings.robot.*part = any.number(usual);
  }
  if (any.below(3) == 0) {
    const double from = any.number(0.25);
    settings.no_go.push_back({any.below(6), from, any.number(0.5)});
  }
  return document;
}

// Whether neither inf nor nan appears as a word.
inline bool is_finite_text(const std::string& text) {
  const auto is_letter = [&](std::size_t at) {
    return at < text.size() && ((text[at] >= 'a' && text[at] <= 'z') || text[at] == '_');
  };
  for (const std::string word : {"inf", "nan"})
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
      if (!is_letter(at - 1) && !is_letter(at + word.size())) return false;
  return true;
}

// `placed` counts the documents with a placement.
inline bool keeps_its_word(const Document& document, int& placed) {
  const auto placement = place(document);
  if (!placement) return !placement.error().message.empty();
  ++placed;
  const ShownPlacement shown(*placement, document.shown);
  Report report = report_of(shown, {.models = true, .failures = true});
  if (const auto& limit = document.shown.capacity) report.plan = plan_capacity(*placement, *limit);
  report.known.plans = true;
  return is_finite_text(placement_json({shown, report}, true, true)) &&
         is_finite_text(poses_text(shown, PoseFormat::csv)) &&
         is_finite_text(poses_text(shown, PoseFormat::yaml)) && !placement_svg(shown).empty() &&
         encode_link(document).ok();
}

}  // namespace evenlift::testing
