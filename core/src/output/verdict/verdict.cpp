#include "evenlift/output/verdict.h"

#include "evenlift/capacity.h"
#include "evenlift/output/carrying_words.h"
#include "evenlift/output/words.h"

namespace evenlift {
namespace {

std::string misfit_sentence(const ShownPlacement& of, const Misfit& misfit) {
  const RobotSize& size = of.placement.settings.robot;
  const std::string robot = "Robot " + std::to_string(misfit.robot + 1);
  const auto text = [&](double value) { return with_length_unit(plain(value), of.shown.units); };
  switch (misfit.why) {
    case Misfit::Why::outside:
      return robot + " has no room for its body" +
             (size.radius > 0 ? " of radius " + text(size.radius) : std::string()) + ".";
    case Misfit::Why::arm:
      return "The arm of robot " + std::to_string(misfit.robot + 1) + " would cross the object.";
    case Misfit::Why::hand:
      return "The hand of robot " + std::to_string(misfit.robot + 1) +
             " would stick out of the object.";
    case Misfit::Why::no_go:
      return robot + " stands at a no-go part of the boundary.";
    case Misfit::Why::too_near:
      break;
  }
  return "Robots " + std::to_string(misfit.other + 1) + " and " + std::to_string(misfit.robot + 1) +
         " are too near to each other.";
}

}  // namespace

std::string_view name(VerdictKind kind) {
  switch (kind) {
    case VerdictKind::good:
      return "good";
    case VerdictKind::warning:
      return "warning";
    case VerdictKind::bad:
      return "bad";
  }
  return {};
}

std::vector<std::string> misfits_in_words(const ShownPlacement& of) {
  constexpr std::size_t most_listed = 3;
  const std::vector<Misfit> all = misfits(of.placement);
  std::vector<std::string> sentences;
  for (std::size_t i = 0; i < all.size() && i < most_listed; ++i)
    sentences.push_back(misfit_sentence(of, all[i]));
  if (all.size() > most_listed)
    sentences.push_back("The robots do not fit in " + std::to_string(all.size() - most_listed) +
                        " more ways.");
  return sentences;
}

Judgement judge(const ShownPlacement& of) {
  if (of.placement.teams.empty()) return judge(of, {}, {});
  return judge(of, robustness(of.placement), loads_when_disturbed(of));
}

Judgement judge(const ShownPlacement& of, const Robustness& robustness,
                const std::vector<LoadRange>& loads) {
  const Placement& placement = of.placement;
  Judgement judgement;
  std::vector<std::string>& reasons = judgement.reasons;
  const auto add = [&](std::string reason) {
    if (!reason.empty()) reasons.push_back(std::move(reason));
  };
  if (placement.teams.empty()) {
    judgement.kind = VerdictKind::bad;
    add(placement.search_ended ? shortage_in_words(placement) : loads_in_words(of));
    return judgement;
  }
  const bool stands = placement.loads.has_value();
  if (!stands) add(loads_in_words(of));
  std::vector<double> greatest;
  for (const LoadRange& range : loads) greatest.push_back(range.greatest);
  const std::vector<std::size_t> overloaded = overloaded_robots(of, greatest);
  if (stands && !overloaded.empty())
    add(capacity_in_words(of, nullptr, overloaded, LoadModel::plan));
  if (stands) add(tipping_in_words(robustness, of));
  for (std::string& misfit : misfits_in_words(of)) add(std::move(misfit));
  add(shortage_in_words(placement));
  if (placement.coverage < good_coverage) add(coverage_in_words(placement));
  if (!is_held(placement)) add(closure_in_words(of));
  judgement.kind = !stands           ? VerdictKind::bad
                   : reasons.empty() ? VerdictKind::good
                                     : VerdictKind::warning;
  return judgement;
}

}  // namespace evenlift
