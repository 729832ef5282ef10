// The numbers of each step, under the names that JSON gives them.
#include "evenlift/angles.h"
#include "evenlift/selection.h"
#include "evenlift/stability.h"
#include "evenlift/trace.h"

namespace evenlift {
namespace {

class Sheet {
 public:
  Sheet(const Trace& trace, const StepDetail& detail) : trace_(trace), detail_(detail) {}

  std::vector<Number> make() && {
    const Placement& placement = trace_.placement;
    const std::uint32_t item = detail_.step.item;
    switch (detail_.step.kind) {
      case StepKind::polygon:
        count("vertices", trace_.polygon.size());
        add("area", trace_.polygon.area());
        break;
      case StepKind::centroid:
        point("centroid_x", "centroid_y", trace_.polygon.centroid());
        break;
      case StepKind::centre:
        point("x", "y", trace_.centre);
        add("moved_by", length(trace_.centre - trace_.polygon.centroid()));
        break;
      case StepKind::radial:
        count("edges", trace_.radial_edges.size());
        break;
      case StepKind::ray:
        count("vertex", trace_.rays.vertices[item] + 1);
        count("chords", trace_.rays.begins[item + 1] - trace_.rays.begins[item]);
        break;
      case StepKind::slopes:
        count("chords", chords_by_slope(trace_).size());
        break;
      case StepKind::sections:
      case StepKind::outcome:
        pair(*detail_.pair, detail_.step.kind == StepKind::outcome);
        break;
      case StepKind::opposite:
        opposite(*detail_.opposite);
        break;
      case StepKind::duplicates:
        count("merged", with_candidate() - placement.candidates.size());
        count("candidates", placement.candidates.size());
        break;
      case StepKind::candidates:
        count("candidates", placement.candidates.size());
        count("even", even());
        break;
      case StepKind::directions:
        add("open_degrees", 180 / pi * open_directions_rad(trace_.polygon, trace_.centre));
        break;
      case StepKind::scores:
      case StepKind::team:
        count("team", item + 1);
        if (detail_.scores) choice(*detail_.scores);
        if (detail_.step.kind == StepKind::team) add("ratio", placement.teams[item].chord.ratio);
        break;
      case StepKind::base:
        count("team", item + 1);
        count("corners_before", detail_.base_before.size());
        count("corners", detail_.base.size());
        add("coverage_before", coverage(trace_.polygon, detail_.base_before));
        add("coverage", coverage(trace_.polygon, detail_.base));
        break;
      case StepKind::fewer:
        count("teams", placement.teams.size());
        count("requested_teams", placement.requested_teams);
        break;
      case StepKind::share:
        share(placement.teams[item], item);
        break;
      case StepKind::loads:
        add("min", placement.loads->min);
        add("mean", placement.loads->mean);
        add("max", placement.loads->max);
        add("spread", placement.loads->spread);
        add("max_share", placement.loads->max_share);
        break;
      case StepKind::coverage:
        add("coverage", placement.coverage);
        break;
      case StepKind::contacts:
        count("robots", 2 * placement.teams.size());
        count("contacts", trace_.contacts.size());
        break;
      case StepKind::cut:
        count("contact", item + 1);
        count("clockwise", detail_.clockwise.exists);
        count("counterclockwise", detail_.counterclockwise.exists);
        break;
      case StepKind::slide:
        count("translation", placement.closure.translation_free);
        if (const auto& way = placement.closure.translation) point("x", "y", *way);
        break;
      case StepKind::closure:
        count("form_closure", placement.closure.form_closure);
        if (placement.closure.margin) add("margin", *placement.closure.margin);
        break;
      case StepKind::second_order:
        count("second_order", placement.closure.second_order);
        break;
      case StepKind::result:
        count("teams", placement.teams.size());
        add("coverage", placement.coverage);
        count("form_closure", placement.closure.form_closure);
        break;
    }
    return std::move(out_);
  }

 private:
  void add(std::string_view name, double value) { out_.push_back({name, value}); }
  void count(std::string_view name, std::size_t value) { add(name, static_cast<double>(value)); }
  void point(std::string_view x, std::string_view y, const Vec2& p) {
    add(x, p.x());
    add(y, p.y());
  }

  void pair(const PairDetail& pair, bool decided) {
    count("pair", detail_.step.item + 1);
    count("edge_a", pair.pair.a + 1);
    count("edge_b", pair.pair.b + 1);
    add("g0", pair.verdict.g0);
    add("g1", pair.verdict.g1);
    if (!decided) return;
    add("ratio", pair.chosen.ratio);
    add("min_ratio", trace_.placement.settings.min_ratio);
    if (pair.candidate != no_index) count("candidate", pair.candidate + 1);
  }

  void opposite(const OppositeDetail& opposite) {
    count("vertex_v", opposite.vertices.v + std::size_t{1});
    count("vertex_w", opposite.vertices.w + std::size_t{1});
    add("ratio", opposite.chord.ratio);
    add("min_ratio", trace_.placement.settings.min_ratio);
    if (opposite.candidate != no_index) count("candidate", opposite.candidate + 1);
  }

  std::size_t with_candidate() const {
    std::size_t number = 0;
    for (const std::uint32_t candidate : trace_.candidate_of_source)
      number += candidate != no_index;
    return number;
  }
  std::size_t even() const {
    std::size_t number = 0;
    for (const Candidate& candidate : trace_.placement.candidates)
      number += is_even(candidate.chord);
    return number;
  }

  void choice(const TeamScores& scores) {
    const std::uint32_t winner = scores.ranking.front();
    count("choices", scores.ranking.size());
    count("winner", winner + 1);
    add("best", scores.of_candidate[winner].value);
    if (scores.ranking.size() < 2) return;
    count("second", scores.ranking[1] + 1);
    add("second_best", scores.of_candidate[scores.ranking[1]].value);
  }

  void share(const Team& team, std::uint32_t item) {
    count("team", item + 1);
    add("arm1", team.chord.arm1);
    add("arm2", team.chord.arm2);
    add("load1", team.loads[0]);
    add("load2", team.loads[1]);
  }

  const Trace& trace_;
  const StepDetail& detail_;
  std::vector<Number> out_;
};

}  // namespace

std::vector<Number> numbers(const Trace& trace, const StepDetail& detail) {
  return Sheet(trace, detail).make();
}

}  // namespace evenlift
