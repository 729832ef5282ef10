#include "evenlift/document.h"

namespace evenlift {

std::string_view name(Metric metric) {
  switch (metric) {
    case Metric::area:
      return "area";
    case Metric::circle:
      return "circle";
    case Metric::distance:
      return "distance";
    case Metric::distributed:
      return "distributed";
    case Metric::random:
      return "random";
  }
  return {};
}

std::optional<Metric> metric_from_name(std::string_view text) {
  for (const Metric metric : all_metrics) {
    if (text == name(metric)) return metric;
  }
  return std::nullopt;
}

}  // namespace evenlift
