#include "document/slope_setting.h"

#include "document/setting_values.h"
#include "evenlift/angles.h"

namespace evenlift {
namespace {

struct Notation {
  std::string_view ending;
  double (*ratio)(double number);
};
constexpr Notation notations[] = {
    {"%", [](double percent) { return percent / 100; }},
    {"deg",
     [](double degrees) { return degrees >= 0 && degrees < 90 ? slope_ratio(degrees) : -1; }},
    {"", [](double ratio) { return ratio; }},
};

}  // namespace

bool read_slope(std::string_view text, const SettingRange& range, double& slope) {
  for (const auto& [ending, ratio] : notations) {
    if (!text.ends_with(ending)) continue;
    const auto number = read_number(text.substr(0, text.size() - ending.size()));
    if (!number || !setting_value::is_within(ratio(*number), range)) return false;
    slope = ratio(*number);
    return true;
  }
  return false;
}

}  // namespace evenlift
