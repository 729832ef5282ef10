#include "evenlift/output/verdict.h"

#include "evenlift/output/carrying_words.h"
#include "evenlift/output/robustness_words.h"
#include "evenlift/output/words.h"
#include "evenlift/wording.h"

namespace evenlift {
namespace {

std::string misfit_sentence(const ShownPlacement& of, const Misfit& misfit) {
  const RobotSize& size = of.placement.settings.robot;
  const std::uint32_t robot = misfit.robot + 1;
  switch (misfit.why) {
    case Misfit::Why::outside:
      return size.radius > 0 ? say("Robot {robot} has no room for its body of radius {radius}.",
                                   {robot, with_length_unit(plain(size.radius), of.shown.units)})
                             : say("Robot {robot} has no room for its body.", {robot});
    case Misfit::Why::arm:
      return say("The arm of robot {robot} would cross the object.", {robot});
    case Misfit::Why::hand:
      return say("The hand of robot {robot} would stick out of the object.", {robot});
    case Misfit::Why::hole:
      return say("The hand of robot {robot} would reach into a hole.", {robot});
    case Misfit::Why::no_go:
      return say("Robot {robot} stands at a no-go part of the boundary.", {robot});
    case Misfit::Why::too_near:
      break;
  }
  return say("Robots {other} and {robot} are too near to each other.", {misfit.other + 1, robot});
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

std::vector<std::string> misfits_in_words(const Reported& of) {
  constexpr std::size_t most_listed = 3;
  const std::vector<Misfit>& all = of.report.misfits;
  std::vector<std::string> sentences;
  for (std::size_t i = 0; i < all.size() && i < most_listed; ++i)
    sentences.push_back(misfit_sentence(of, all[i]));
  if (all.size() > most_listed)
    sentences.push_back(
        say("The robots do not fit in {number} more ways.", {all.size() - most_listed}));
  return sentences;
}

Judgement judge(const Reported& of) {
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
  if (stands) add(worst_news_in_words(of));
  const bool is_bad = !reasons.empty();
  for (std::string& misfit : misfits_in_words(of)) add(std::move(misfit));
  add(shortage_in_words(placement));
  add(upright_in_words(of));
  if (placement.coverage < good_coverage && !of.report.tips) add(coverage_in_words(placement));
  if (!of.report.held) add(closure_in_words(of));
  add(inaccuracy_in_words(of));
  judgement.kind = is_bad            ? VerdictKind::bad
                   : reasons.empty() ? VerdictKind::good
                                     : VerdictKind::warning;
  return judgement;
}

}  // namespace evenlift
