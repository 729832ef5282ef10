#include "comparisons/against_oracle.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>

#include "evenlift/chords.h"
#include "evenlift/placement.h"
#include "evenlift/polygon.h"
#include "shapes/problem_document.h"

namespace against_oracle {
namespace {

using evenlift::testing::document_of;
using oracle::Point;

Point point(const evenlift::Vec2& v) { return {v.x, v.y}; }

double distance(const Point& p, const Point& q) { return std::hypot(p[0] - q[0], p[1] - q[1]); }

double length(const std::array<Point, 2>& ends) { return distance(ends[0], ends[1]); }

/// The greater gap between the ends of two chords, matched the better way.
double apart(const std::array<Point, 2>& a, const std::array<Point, 2>& b) {
  return std::min(std::max(distance(a[0], b[0]), distance(a[1], b[1])),
                  std::max(distance(a[0], b[1]), distance(a[1], b[0])));
}

std::array<Point, 2> ends(const evenlift::Chord& chord) {
  return {point(chord.r1.position), point(chord.r2.position)};
}

oracle::Kind kind(evenlift::CandidateKind k) {
  return k == evenlift::CandidateKind::bisecting  ? oracle::Kind::bisecting
         : k == evenlift::CandidateKind::midpoint ? oracle::Kind::midpoint
                                                  : oracle::Kind::vertex;
}

class Differences {
 public:
  template <class A, class B>
  void same(const char* what, const A& core, const B& exact) {
    if (!(core == exact)) add(what) << "core " << core << ", oracle " << exact << "\n";
  }
  void near(const char* what, double core, double exact, double tolerance) {
    if (!(std::fabs(core - exact) <= tolerance))
      add(what) << "core " << core << ", oracle " << exact << "\n";
  }
  std::ostream& add(const char* what) {
    out_ << "  " << what << ": ";
    return out_;
  }
  bool none() const { return out_.str().empty(); }
  std::string text() const { return out_.str(); }

 private:
  std::ostringstream out_ = [] {
    std::ostringstream s;
    s << std::setprecision(17);
    return s;
  }();
};

double size_of(const std::vector<Point>& v) {
  Point low = v[0], high = v[0];
  for (const Point& p : v)
    for (std::size_t k : {0u, 1u}) {
      low[k] = std::min(low[k], p[k]);
      high[k] = std::max(high[k], p[k]);
    }
  return distance(low, high);
}

/// The distance of p from the convex hull of these corners, in units of `size`; 0 inside.
double outside(const Point& p, const std::vector<Point>& hull, double size) {
  const auto seen_from_p = [&](const Point& q) {
    return Point{(q[0] - p[0]) / size, (q[1] - p[1]) / size};
  };
  double least = std::numeric_limits<double>::infinity();
  bool inside = hull.size() >= 3;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Point a = seen_from_p(hull[i]), b = seen_from_p(hull[(i + 1) % hull.size()]);
    const double ux = b[0] - a[0], uy = b[1] - a[1], squared = ux * ux + uy * uy;
    const double s = squared > 0 ? std::clamp(-(a[0] * ux + a[1] * uy) / squared, 0.0, 1.0) : 0;
    least = std::min(least, std::hypot(a[0] + s * ux, a[1] + s * uy));
    inside = inside && uy * a[0] - ux * a[1] >= 0;
  }
  return inside ? 0 : least;
}

double farthest_from_origin(const oracle::Problem& problem) {
  double largest = 0;
  for (const Point& p : problem.vertices)
    largest = std::max({largest, std::fabs(p[0]), std::fabs(p[1])});
  return largest;
}

class Comparison {
 public:
  Comparison(const Case& c, const evenlift::Placement& core)
      : case_(c), core_(core), size_(size_of(c.problem.vertices)) {}

  /// Everything is computed from the polygon.
  oracle::ClosestCall whole_way(Differences& d) const {
    const oracle::CandidateList list = oracle::find_candidates(case_.problem);
    oracle::ClosestCall closest = list.closest_call;
    // Rounding chooses between duplicates of one ratio; this counts if they are not quite the same.
    for (const oracle::Candidate& c : list.candidates)
      if (c.ends_slack > 1e-12 * size_) closest.merge({0, "duplicates less than tau L apart"});
    candidates(d, list);
    const oracle::Selection selection = oracle::select(case_.problem, list);
    closest.merge(selection.closest_call);
    teams(d, selection);
    // Verdicts on different teams would only repeat the difference.
    if (d.none()) closest.merge(verdicts(d, list, selection.teams, 0));
    return closest;
  }

  /// From the core's own chords, so that their rounding does not count.
  oracle::ClosestCall from_the_cores_chords(Differences& d) const {
    std::vector<oracle::Candidate> given;
    for (const evenlift::Candidate& c : core_.candidates)
      given.push_back({.ends = ends(c.chord), .ratio = c.chord.ratio, .kind = kind(c.kind)});
    const oracle::CandidateList list = oracle::given_candidates(case_.problem, given);
    const oracle::Selection selection = oracle::select(case_.problem, list);
    oracle::ClosestCall closest = selection.closest_call;
    teams(d, selection);
    const double rounded = 0x1p-52 * farthest_from_origin(case_.problem);
    if (d.none()) closest.merge(verdicts(d, list, selection.teams, rounded));
    return closest;
  }

 private:
  void candidates(Differences& d, const oracle::CandidateList& list) const {
    d.same("number of candidates", core_.candidates.size(), list.candidates.size());
    for (std::size_t i = 0; i < std::min(core_.candidates.size(), list.candidates.size()); ++i) {
      const evenlift::Candidate& mine = core_.candidates[i];
      const oracle::Candidate& exact = list.candidates[i];
      const double gap = apart(ends(mine.chord), exact.ends);
      const bool differ = gap > 2e-9 * size_ || kind(mine.kind) != exact.kind ||
                          std::fabs(mine.chord.ratio - exact.ratio) > 1e-12 + exact.ratio_slack;
      if (!differ) continue;
      d.add("candidate") << i << "\n    core   "
                         << describe({.ends = ends(mine.chord),
                                      .ratio = mine.chord.ratio,
                                      .kind = kind(mine.kind)})
                         << "\n    oracle " << describe(exact) << "\n";
    }
    if (!d.none())
      d.add("how hard") << "thinnest range " << list.thinnest_range << ", nearest |g - 1| "
                        << list.nearest_unit_g << "\n";
  }

  static std::string describe(const oracle::Candidate& c) {
    std::ostringstream s;
    s << std::setprecision(17) << "(" << c.ends[0][0] << "," << c.ends[0][1] << ")-("
      << c.ends[1][0] << "," << c.ends[1][1] << ") ratio " << c.ratio << " kind "
      << static_cast<int>(c.kind);
    return s.str();
  }

  void teams(Differences& d, const oracle::Selection& selection) const {
    const std::vector<std::size_t> mine(core_.team_candidates.begin(), core_.team_candidates.end());
    if (mine == selection.teams) return;
    std::ostream& out = d.add("teams") << "core";
    for (std::size_t i : mine) out << " " << i;
    out << ", oracle";
    for (std::size_t k = 0; k < selection.teams.size(); ++k)
      out << " " << selection.teams[k] << " (" << selection.scores[k] << ")";
    out << "\n";
  }

  /// `rounded` is the greatest distance between the oracle's ends and the core's.
  oracle::ClosestCall verdicts(Differences& d, const oracle::CandidateList& list,
                               const std::vector<std::size_t>& teams, double rounded) const {
    const oracle::Judgement exact = oracle::judge(case_.problem, list, teams);
    // Of successive corners of H within tau L of the line of their neighbours, either may be left
    // out. In an object nearly as thin, this affects the coverage.
    const double area = core_.object.area(), square = size_ * size_;
    hull(d, exact.hull, 2e-9);
    d.near("coverage", core_.coverage, exact.coverage,
           area < 1e-4 * square ? 4e-9 * square / area : 1e-9);
    loads(d, list, teams, exact.loads, rounded);
    d.same("clockwise free", core_.closure.clockwise.exists, exact.closure.clockwise);
    d.same("counterclockwise free", core_.closure.counterclockwise.exists,
           exact.closure.counterclockwise);
    d.same("translation free", core_.closure.translation_free, exact.closure.translation);
    d.same("form closure", core_.closure.form_closure, exact.closure.form_closure);
    if (exact.closure.flattest_crossing > 1e-6)
      d.same("second order", core_.closure.second_order, exact.closure.second_order);
    d.same("a margin", core_.closure.margin.has_value(), exact.closure.margin.has_value());
    if (core_.closure.margin && exact.closure.margin)
      d.near("margin", *core_.closure.margin, *exact.closure.margin, 1e-7);
    if (!exact.closure.clearance_is_unsure) clearance(d, exact.closure);
    return exact.closure.closest_call;
  }

  void clearance(Differences& d, const oracle::Closure& exact) const {
    const evenlift::Clearance& mine = core_.closure.clearance;
    d.same("a clearance", std::isfinite(mine.distance), std::isfinite(exact.clearance));
    if (std::isfinite(mine.distance) && std::isfinite(exact.clearance))
      d.near("clearance", mine.distance / size_, exact.clearance / size_, 1e-7);
    if (!exact.hold_within) return d.near("tolerance", mine.tolerance, 0, 0);
    // Within rounding: where a corner or a bend ends the tolerance, it changes at once.
    constexpr double slack = 1e-6;
    if (mine.tolerance > 1e-8 * size_)
      d.same("holds within the tolerance", true,
             exact.hold_within((1 - slack) * std::min(mine.tolerance, size_) - 1e-9 * size_));
    if (std::isfinite(mine.tolerance))
      d.same("holds beyond the tolerance", false,
             exact.hold_within((1 + slack) * mine.tolerance + 1e-9 * size_));
  }

  void hull(Differences& d, const std::vector<Point>& exact, double tolerance) const {
    std::vector<Point> mine;
    for (const evenlift::Vec2& v : core_.lifting_base) mine.push_back(point(v));
    d.same("a hull", mine.empty(), exact.empty());
    for (const Point& p : mine)
      d.near("hull corner outside the oracle's", outside(p, exact, size_), 0, tolerance);
    for (const Point& p : exact)
      d.near("oracle's hull corner outside", outside(p, mine, size_), 0, tolerance);
  }

  void loads(Differences& d, const oracle::CandidateList& list,
             const std::vector<std::size_t>& teams, const std::optional<oracle::Loads>& exact,
             double rounded) const {
    d.same("loads", core_.loads.has_value(), exact.has_value());
    if (!core_.loads || !exact) return;
    // The core computes shares from arms, which are more precise than the ends of a chord hardly
    // longer than their rounding.
    double shortest = size_;
    for (const evenlift::Team& team : core_.teams)
      shortest = std::min(shortest, length(ends(chord_of(team))));
    const double share = 1e-9 + 2 * rounded / shortest, tolerance = share * case_.problem.weight;
    d.near("least load", core_.loads->min, exact->min, tolerance);
    d.near("mean load", core_.loads->mean, exact->mean, tolerance);
    d.near("greatest load", core_.loads->max, exact->max, tolerance);
    d.near("spread", core_.loads->spread, exact->spread, tolerance);
    d.near("greatest share", core_.loads->max_share, exact->max_share, share);
    for (std::size_t k = 0; k < teams.size(); ++k) {
      const evenlift::Team& team = core_.teams[k];
      const std::array<Point, 2> mine = ends(chord_of(team)),
                                 theirs = list.candidates[teams[k]].ends;
      const bool swapped = distance(mine[0], theirs[0]) > distance(mine[0], theirs[1]);
      d.near("load of r1", team.robots[0].load, exact->of_teams[k][swapped], tolerance);
      d.near("load of r2", team.robots[1].load, exact->of_teams[k][!swapped], tolerance);
    }
  }

  const Case& case_;
  const evenlift::Placement& core_;
  double size_;
};

/// So far from the origin that the spacing of coordinates is no longer far below tau L. Then ends
/// within tau L may be equal doubles.
bool coarse(const oracle::Problem& problem) {
  return farthest_from_origin(problem) * 0x1p-52 > 1e-11 * size_of(problem.vertices);
}

std::string refusal_of(const evenlift::InputError& error) {
  return "the core refuses it: " + error.message + "\n";
}

}  // namespace

std::string text(const Case& c) {
  std::ostringstream s;
  s << std::setprecision(17) << c.name << "; rho " << c.problem.min_ratio << ", teams "
    << c.problem.teams << ", metric " << static_cast<int>(c.problem.metric) << "\n";
  if (c.problem.centre_of_mass) {
    const Point& com = *c.problem.centre_of_mass;
    s << "CoM:(" << com[0] << "," << com[1] << ")\n";
  }
  for (const Point& p : c.problem.vertices) s << "(" << p[0] << "," << p[1] << ")\n";
  for (const oracle::Ring& hole : c.problem.holes) {
    s << "hole\n";
    for (const Point& p : hole) s << "(" << p[0] << "," << p[1] << ")\n";
  }
  return s.str();
}

Finding compare_placement(const Case& c) {
  Finding finding;
  const auto placed = evenlift::place(document_of(c.problem));
  if (!placed) {
    finding.differences = refusal_of(placed.error());
    return finding;
  }
  if (coarse(c.problem)) return finding;  // only that it does not crash
  const Comparison comparison(c, *placed);
  for (const bool whole : {true, false}) {
    Differences d;
    const oracle::ClosestCall closest =
        whole ? comparison.whole_way(d) : comparison.from_the_cores_chords(d);
    if (d.none()) continue;
    if (closest.distance < 1e-3) {
      ++finding.passed_over;
      continue;
    }
    std::ostringstream s;
    s << (whole ? "from the polygon" : "from the core's chords") << ", closest call "
      << closest.distance << " (" << closest.what << ")\n"
      << d.text();
    finding.differences += s.str();
  }
  return finding;
}

Finding compare_refusal(const Case& c) {
  Finding finding;
  const oracle::Refusal why = oracle::refusal(c.problem);
  const auto placed = evenlift::place(document_of(c.problem));
  if (placed.ok() == (why == oracle::Refusal::none) &&
      (why != oracle::Refusal::no_area || placed.error().code == evenlift::ErrorCode::no_area))
    return finding;
  finding.differences =
      "the oracle's refusal is " + std::to_string(static_cast<int>(why)) +
      (placed.ok() ? ", the core accepts it" : ", the core says: " + placed.error().message) + "\n";
  return finding;
}

Finding compare_vertex_chords(const Case& c) {
  Finding finding;
  const double size = size_of(c.problem.vertices);
  const std::vector<std::array<Point, 2>> exact = oracle::vertex_chords(c.problem);
  const evenlift::Document d = document_of(c.problem);
  const auto polygon = evenlift::Polygon::create(d.vertices);
  if (!polygon) {
    finding.differences = refusal_of(polygon.error());
    return finding;
  }
  const auto centre = evenlift::check_centre_of_mass(*polygon, d.centre_of_mass);
  if (!centre) {
    finding.differences = refusal_of(centre.error());
    return finding;
  }
  const auto chords = evenlift::vertex_chords(*polygon, *centre);
  if (!chords) {
    finding.differences = refusal_of(chords.error());
    return finding;
  }
  std::ostringstream s;
  if (chords->size() != exact.size())
    s << "vertex-chords: core " << chords->size() << ", oracle " << exact.size() << "\n";
  // Each chord of the oracle takes the core's nearest unused one, because the possible matches of
  // one chord need not be those of another.
  std::vector<bool> used(chords->size(), false);
  int missing = 0;
  for (const auto& want : exact) {
    std::size_t found = used.size();
    double nearest = 1e-9 * size + 0x1p-51 * farthest_from_origin(c.problem);
    for (std::size_t k = 0; k < used.size(); ++k) {
      const double gap = used[k] ? 2 * size : apart(ends((*chords)[k].chord), want);
      if (gap > nearest || (gap == nearest && found < used.size())) continue;
      nearest = gap;
      found = k;
    }
    if (found < used.size())
      used[found] = true;
    else
      ++missing;
  }
  if (missing > 0) s << "the core lacks " << missing << " of the oracle's vertex-chords\n";
  finding.differences = s.str();
  return finding;
}

Finding compare_distributed(const Case& c) {
  Finding finding;
  const oracle::DistributedTeams exact = oracle::distributed(c.problem);
  evenlift::Document d = document_of(c.problem);
  d.settings.method = evenlift::Method::distributed;
  const auto placed = evenlift::place(d);
  if (!placed) {
    finding.differences = refusal_of(placed.error());
    return finding;
  }
  // With C almost on an edge there may be no usable directions; the number of teams is noise.
  if (exact.measure < 1e-9 || coarse(c.problem)) return finding;
  std::ostringstream s;
  s << std::setprecision(17);
  if (placed->teams.size() != exact.chords.size()) {
    s << "distributed teams: core " << placed->teams.size() << ", oracle " << exact.chords.size()
      << "\n";
    finding.differences = s.str();
    return finding;
  }
  const double size = size_of(c.problem.vertices);
  for (std::size_t k = 0; k < exact.chords.size(); ++k) {
    const std::array<Point, 2> mine = ends(chord_of(placed->teams[k]));
    const double gap = apart(mine, exact.chords[k]) / size * exact.flattest_hit[k];
    ++finding.compared;
    // Within tau of a vertex's direction, the core may take the vertex.
    const double room = exact.nearest_vertex[k] < 1.001e-9 ? 1e-9 : 1e-12;
    if (gap <= room + 1e-15 * farthest_from_origin(c.problem) / size) continue;
    // There the farthest point may jump, to a side that rounding decides.
    if (exact.nearest_vertex[k] < 1e-12) {
      ++finding.passed_over;
      continue;
    }
    s << "distributed team " << k << ": core " << mine[0][0] << "," << mine[0][1] << " "
      << mine[1][0] << "," << mine[1][1] << ", oracle " << exact.chords[k][0][0] << ","
      << exact.chords[k][0][1] << " " << exact.chords[k][1][0] << "," << exact.chords[k][1][1]
      << "\n";
  }
  finding.differences = s.str();
  return finding;
}

}  // namespace against_oracle
