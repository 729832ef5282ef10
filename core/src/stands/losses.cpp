#include "stands/losses.h"

#include <algorithm>
#include "exact/sorted_indices.h"

namespace evenlift {
namespace {

void unite(std::vector<Stretch>& stretches, double length) {
  for (Stretch& s : stretches) s = {std::clamp(s.from, 0.0, length), std::clamp(s.to, 0.0, length)};
  std::erase_if(stretches, [](const Stretch& s) { return !(s.from < s.to); });
  sort_items(stretches, [](const Stretch& a, const Stretch& b) {
    return a.from != b.from ? a.from < b.from : a.to < b.to;
  });
  std::size_t kept = 0;
  for (const Stretch& s : stretches) {
    if (kept > 0 && s.from <= stretches[kept - 1].to)
      stretches[kept - 1].to = std::max(stretches[kept - 1].to, s.to);
    else
      stretches[kept++] = s;
  }
  stretches.resize(kept);
}

bool contain(const std::vector<Stretch>& stretches, double t) {
  const auto after = std::upper_bound(stretches.begin(), stretches.end(), t,
                                      [](double x, const Stretch& s) { return x < s.from; });
  return after != stretches.begin() && t < (after - 1)->to;
}

}  // namespace

std::vector<Losses::Part> Losses::parts(double length) {
  std::vector<double> ends{0, length};
  for (std::vector<Stretch>& stretches : lost_) {
    unite(stretches, length);
    for (const Stretch& s : stretches) {
      ends.push_back(s.from);
      ends.push_back(s.to);
    }
  }
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  std::vector<Part> parts;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const double middle = ends[i] + (ends[i + 1] - ends[i]) / 2;
    std::optional<WhyUnusable> why;
    for (std::size_t reason = 0; reason < reasons_to_lose && !why; ++reason)
      if (contain(lost_[reason], middle)) why = static_cast<WhyUnusable>(reason);
    if (!parts.empty() && parts.back().why == why)
      parts.back().part.to = ends[i + 1];
    else
      parts.push_back({{ends[i], ends[i + 1]}, why});
  }
  return parts;
}

}  // namespace evenlift
