// The same object elsewhere, turned, mirrored, in other units or listed in another order has the
// same placement but for coordinates. Every change here is exact in doubles: where the rules leave
// no choice, all bits must stay.
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "evenlift/hull.h"
#include "evenlift/placement.h"
#include "evenlift/polygon.h"
#include "evenlift/selection.h"
#include "kit/catch.h"
#include "kit/solid.h"
#include "shapes/problem_document.h"
#include "shapes/small_polygons.h"

using namespace evenlift;

namespace {

double reach_of(const Points& points) {
  double reach = 0;
  for (const Vec2& v : points) reach = std::max(reach, max_norm(v));
  return reach;
}

// With coordinates of at most 40 bits, so that moving loses nothing, and its own centre of mass,
// because a centroid is rounded at its absolute place. Empty if rounding makes it invalid.
std::optional<Document> on_a_grid(const Document& document, double& step) {
  step = std::ldexp(1.0, std::ilogb(reach_of(document.vertices)) - 38);
  Document result = document;
  for (Vec2& v : result.vertices)
    v = {step * std::round(v.x / step), step * std::round(v.y / step)};
  const auto polygon = Polygon::create(result.vertices);
  if (!polygon) return std::nullopt;
  Vec2 centre = document.centre_of_mass.value_or(polygon->centroid());
  centre = {step * std::round(centre.x / step), step * std::round(centre.y / step)};
  if (!check_centre_of_mass(*polygon, centre)) return std::nullopt;
  result.centre_of_mass = centre;
  return result;
}

// An exact change of coordinates.
struct Change {
  double xx = 1, xy = 0, yx = 0, yy = 1;
  Vec2 shift;
  double scale = 1;

  Vec2 operator()(const Vec2& p) const {
    // In each sum one term is 0.
    return Vec2(scale * (xx * p.x + xy * p.y), scale * (yx * p.x + yy * p.y)) + shift;
  }
  bool mirrors() const { return xx * yy - xy * yx < 0; }
  bool keeps_axes() const { return xx == 1 && yy == 1; }
};

Document changed(Document document, const Change& change) {
  for (Vec2& v : document.vertices) v = change(v);
  if (document.centre_of_mass) document.centre_of_mass = change(*document.centre_of_mass);
  return document;
}

std::string text(const Document& document) {
  std::ostringstream s;
  s << std::setprecision(17);
  if (document.centre_of_mass)
    s << "CoM:(" << document.centre_of_mass->x << "," << document.centre_of_mass->y << ")\n";
  for (const Vec2& v : document.vertices) s << "(" << v.x << "," << v.y << ")\n";
  s << name(document.settings.method) << ", teams " << document.settings.teams.value_or(0)
    << ", minimum load ratio " << document.settings.min_ratio;
  return s.str();
}

class Comparison {
 public:
  Comparison(Placement before, Placement after, const Change& change, bool exact)
      : a_(std::move(before)), b_(std::move(after)), change_(change), exact_(exact) {
    Vec2 low = a_.vertices().front(), high = low;
    for (const Vec2& v : a_.vertices()) {
      low = componentwise_min(low, v);
      high = componentwise_max(high, v);
    }
    size_ = change.scale * std::hypot(high.x - low.x, high.y - low.y);
    // Twice the tolerance for each end, which another merged chord may represent; and positions are
    // rounded at their absolute place.
    rounding_ = 1e-12 * size_ + 4 * 0x1p-52 * reach_of(b_.vertices());
    near_ = 4e-9 * size_ + rounding_;
    area_ = std::fabs(signed_area(b_.vertices()));
    out_ << std::setprecision(17);
  }

  // For changes that keep the order of candidates.
  void in_order() {
    number("candidates", a_.candidates.size(), b_.candidates.size());
    if (!same()) return;
    for (std::size_t i = 0; i < a_.candidates.size(); ++i) {
      candidate(i, a_.candidates[i], b_.candidates[i]);
      chord("candidate", i, a_.candidates[i].chord, b_.candidates[i].chord, false);
    }
    if (a_.team_candidates != b_.team_candidates) {
      out_ << "teams:";
      for (const auto i : a_.team_candidates) out_ << " " << i;
      out_ << " and now";
      for (const auto i : b_.team_candidates) out_ << " " << i;
      out_ << "\n";
    }
    if (same()) teams_and_verdicts();
  }

  // The index in `after` of each candidate; empty without a match.
  std::vector<std::size_t> match() {
    number("candidates", a_.candidates.size(), b_.candidates.size());
    std::vector<std::size_t> became;
    std::vector<char> used(b_.candidates.size());
    for (std::size_t i = 0; i < a_.candidates.size(); ++i) {
      std::size_t best = 0;
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t j = 0; j < b_.candidates.size(); ++j) {
        const double gap = used[j] ? least : apart(a_.candidates[i].chord, b_.candidates[j].chord);
        if (gap < least) {
          least = gap;
          best = j;
        }
      }
      if (!(least <= near_)) {
        out_ << "candidate " << i << " has no like, the nearest is off by " << least / size_
             << " L\n";
        return {};
      }
      used[best] = 1;
      became.push_back(best);
      candidate(i, a_.candidates[i], b_.candidates[best]);
    }
    return became;
  }

  void teams_and_verdicts() {
    number("teams", a_.teams.size(), b_.teams.size());
    if (!same()) return;
    for (std::size_t k = 0; k < a_.teams.size(); ++k) {
      const bool swapped = chord("team", k, chord_of(a_.teams[k]), chord_of(b_.teams[k]), true);
      near("load of r1", a_.teams[k].robots[0].load, b_.teams[k].robots[swapped ? 1 : 0].load,
           1e-7);
    }
    verdicts();
  }

  void verdicts() {
    if (a_.loads && b_.loads) {
      near("least load", a_.loads->min, b_.loads->min, 1e-7);
      near("greatest load", a_.loads->max, b_.loads->max, 1e-7);
      near("mean load", a_.loads->mean, b_.loads->mean, 1e-7);
      near("greatest share", a_.loads->max_share, b_.loads->max_share, 1e-9);
    }
    number("a summary of loads", a_.loads.has_value(), b_.loads.has_value());
    hulls();
    // A small part of a thin object's size is a large part of its area.
    near("coverage", a_.coverage, b_.coverage, 1e-9 + near_ * size_ / area_);
    if (!same_contacts_) return;
    const Closure &p = a_.closure, &q = b_.closure;
    number("form closure", p.form_closure, q.form_closure);
    number("second order", p.second_order, q.second_order);
    number("free translation", p.translation_free, q.translation_free);
    number("a margin", p.margin.has_value(), q.margin.has_value());
    if (p.margin && q.margin) near("margin", *p.margin, *q.margin, 1e-7);
    region("clockwise", p.clockwise, change_.mirrors() ? q.counterclockwise : q.clockwise);
    region("counterclockwise", p.counterclockwise,
           change_.mirrors() ? q.clockwise : q.counterclockwise);
  }

  std::string differences() const { return out_.str(); }
  bool same() const { return out_.str().empty(); }

 private:
  void number(const char* what, std::size_t before, std::size_t after) {
    if (before != after) out_ << what << ": " << before << " and now " << after << "\n";
  }
  void near(const char* what, double before, double after, double tolerance) {
    if (exact_ ? before != after : !(std::fabs(before - after) <= tolerance))
      out_ << what << ": " << before << " and now " << after << "\n";
  }
  bool apart(const Vec2& p, const Vec2& q) const {
    return exact_ ? p != q : !(length(p - q) <= near_);
  }

  double apart(const Chord& before, const Chord& after) const {
    const auto gap = [](const Vec2& p, const Vec2& q) { return length(p - q); };
    const Vec2 r1 = change_(before.r1.position), r2 = change_(before.r2.position);
    const Vec2 &s1 = after.r1.position, &s2 = after.r2.position;
    return std::min(std::max(gap(r1, s1), gap(r2, s2)), std::max(gap(r1, s2), gap(r2, s1)));
  }

  void candidate(std::size_t i, const Candidate& before, const Candidate& after) {
    if (before.kind != after.kind)
      out_ << "candidate " << i << " was " << name(before.kind) << ", is " << name(after.kind)
           << "\n";
    near("candidate's ratio", before.chord.ratio, after.chord.ratio, 1e-9);
    near("candidate's length", change_.scale * before.length, after.length, near_);
  }

  // Whether the ends have swapped, as only turning and mirroring may do.
  bool chord(const char* what, std::size_t i, const Chord& before, const Chord& after,
             bool may_swap) {
    const Vec2 r1 = change_(before.r1.position), r2 = change_(before.r2.position);
    const Vec2 &s1 = after.r1.position, &s2 = after.r2.position;
    const bool swapped =
        may_swap && !change_.keeps_axes() && squared_length(r1 - s1) > squared_length(r1 - s2);
    if (apart(r1, swapped ? s2 : s1) || apart(r2, swapped ? s1 : s2))
      out_ << what << " " << i << ": (" << r1.x << "," << r1.y << ")-(" << r2.x << "," << r2.y
           << ") and now (" << s1.x << "," << s1.y << ")-(" << s2.x << "," << s2.y << ")\n";
    // Another merged chord may touch a vertex where this one does not.
    const double moved =
        std::max(length(r1 - (swapped ? s2 : s1)), length(r2 - (swapped ? s1 : s2)));
    same_contacts_ = same_contacts_ && moved <= rounding_;
    near("arm", change_.scale * before.arm1, swapped ? after.arm2 : after.arm1, near_);
    near("arm", change_.scale * before.arm2, swapped ? after.arm1 : after.arm2, near_);
    return swapped;
  }

  // By area and bounds: a corner straight except for rounding may come or go.
  void hulls() {
    if (exact_) {
      bool equal = a_.lifting_base.size() == b_.lifting_base.size();
      for (std::size_t i = 0; equal && i < a_.lifting_base.size(); ++i)
        equal = change_(a_.lifting_base[i]) == b_.lifting_base[i];
      if (!equal) out_ << "the hull has changed\n";
      return;
    }
    number("a hull", a_.lifting_base.empty(), b_.lifting_base.empty());
    number("a hull with an area", a_.lifting_base.size() > 2, b_.lifting_base.size() > 2);
    for (const Vec2& p : a_.lifting_base) {
      double beyond = 0;
      for (std::size_t i = 0; b_.lifting_base.size() > 2 && i < b_.lifting_base.size(); ++i) {
        const Vec2 &u = b_.lifting_base[i], &v = b_.lifting_base[(i + 1) % b_.lifting_base.size()];
        beyond = std::max(beyond, -cross(v - u, change_(p) - u) / length(v - u));
      }
      if (beyond > near_) out_ << "a corner of the hull is now " << beyond << " outside\n";
    }
  }

  void region(const char* sense, const FreeRegion& before, const FreeRegion& after) {
    number(sense, before.exists, after.exists);
    number(sense, before.has_area, after.has_area);
    if (!exact_) return;
    bool equal = before.clipped.size() == after.clipped.size();
    for (std::size_t i = 0; equal && i < before.clipped.size(); ++i)
      equal = change_(before.clipped[i]) == after.clipped[i];
    if (!equal) out_ << "the " << sense << " region has changed\n";
  }

  const Placement a_, b_;
  const Change change_;
  const bool exact_;
  double size_ = 0, rounding_ = 0, near_ = 0, area_ = 0;
  bool same_contacts_ = true;
  std::ostringstream out_;
};

constexpr std::uint64_t number_of_cases = 2000;

template <class Visit>
void for_each_case(Visit visit) {
  for (std::uint64_t number = 0; number < number_of_cases; ++number) {
    const small_polygons::Case c = small_polygons::make_case(number);
    Document d = evenlift::testing::document_of(c.problem);
    d.settings.method = pair_methods[number / 9 % std::size(pair_methods)];
    d.settings.seed = number;
    visit(d, number);
  }
}

Placement placed(const Document& document) {
  auto placement = place(document);
  INFO(text(document));
  REQUIRE(placement.ok());
  return *std::move(placement);
}

void report(const Comparison& comparison, const Document& document, const std::string& what) {
  if (comparison.same()) return;
  INFO(what << "\n" << text(document));
  CHECK(comparison.differences() == "");
}

}  // namespace

TEST_CASE("other units, by a power of two, change no bit", "[invariance][thorough]") {
  int compared = 0;
  for_each_case([&](const Document& d, std::uint64_t number) {
    // From the smallest accepted object to the largest coordinates: 2^29 < 1e9.
    const double diagonal = Polygon::create(d.vertices)->diagonal();
    const int least = std::ilogb(min_diagonal) + 1 - std::ilogb(diagonal);
    const int most = 28 - std::ilogb(reach_of(d.vertices));
    const int between = least + static_cast<int>(number % 97) * (most - least) / 97;
    const Placement before = placed(d);
    for (const int exponent : {least, between, most}) {
      const Change change{.scale = std::ldexp(1.0, exponent)};
      Comparison comparison(before, placed(changed(d, change)), change, true);
      comparison.in_order();
      report(comparison, d, "scaled by 2^" + std::to_string(exponent));
      ++compared;
    }
  });
  CHECK(compared == 3 * static_cast<int>(number_of_cases));
}

namespace {

// From another first vertex, or in the other direction.
Document renumbered(Document d, std::size_t start, bool reversed) {
  std::rotate(d.vertices.begin(), d.vertices.begin() + static_cast<std::ptrdiff_t>(start),
              d.vertices.end());
  if (reversed) std::reverse(d.vertices.begin(), d.vertices.end());
  return d;
}

}  // namespace

TEST_CASE("the order in which vertices are listed changes nothing", "[invariance][thorough]") {
  for_each_case([&](Document d, std::uint64_t number) {
    // Random teams are drawn along the perimeter from the first vertex.
    if (d.settings.method == Method::random) d.settings.method = Method::area;
    const Placement before = placed(d);
    for (const bool reversed : {false, true}) {
      const Placement after = placed(renumbered(d, 1 + number % (d.vertices.size() - 1), reversed));
      Comparison comparison(before, after, {}, false);
      comparison.in_order();
      // Values of a chord alone keep their bits.
      std::ostringstream bits;
      if (before.centre_of_mass != after.centre_of_mass) bits << "centroid ";
      for (std::size_t i = 0; comparison.same() && i < before.candidates.size(); ++i) {
        const Chord &p = before.candidates[i].chord, &q = after.candidates[i].chord;
        if (p.r1.position != q.r1.position || p.r2.position != q.r2.position ||
            p.ratio != q.ratio || p.arm1 != q.arm1 || p.arm2 != q.arm2)
          bits << "candidate " << i << " ";
      }
      for (std::size_t k = 0; comparison.same() && k < before.teams.size(); ++k) {
        for (std::size_t end = 0; end < 2; ++end)
          if (before.teams[k].robots[end].load != after.teams[k].robots[end].load)
            bits << "loads of team " << k << " ";
      }
      // Where two edges end at the same distance along a ray, either may give its position.
      if (d.settings.method != Method::distributed && comparison.same() &&
          before.lifting_base != after.lifting_base)
        bits << "hull ";
      report(comparison, d, reversed ? "reversed" : "rotated");
      if (!bits.str().empty()) {
        INFO((reversed ? "reversed\n" : "rotated\n") << text(d));
        CHECK(bits.str() == "");
      }
    }
  });
}

TEST_CASE("moving the object moves its placement", "[invariance][thorough]") {
  int compared = 0;
  for_each_case([&](const Document& raw, std::uint64_t number) {
    double step = 0;
    const auto d = on_a_grid(raw, step);
    if (!d) return;
    const Placement before = placed(*d);
    // By up to some thousand times the coordinates.
    const double far = step * std::ldexp(1.0, 28 + static_cast<int>(number % 22));
    if (far > 2e8) return;
    const auto whole = [&](double part) { return step * std::round(part * far / step); };
    const Change change{.shift = {whole(0.71), whole(number % 2 ? -1.0 : 0.3)}};
    Comparison comparison(before, placed(changed(*d, change)), change, false);
    comparison.in_order();
    report(comparison, *d, "moved by " + std::to_string(far));
    ++compared;
  });
  CHECK(compared > 1700);
}

namespace {

constexpr double tolerance = 1e-9;

bool same_direction(const Vec2& a, const Vec2& b) {
  return dot(a, b) > 0 && std::fabs(cross(a, b)) <= 2 * tolerance * length(a) * length(b);
}

// Whether the rules treat left and right differently here: a point in the direction of a corner of
// H belongs to one of its two edges, a vertex in that of a lifting point to one of two new ones.
bool is_one_sided(const Placement& placement) {
  const Vec2& centre = placement.centre_of_mass;
  double size = 0;
  for (const Vec2& v : placement.vertices()) size = std::max(size, length(v - centre));
  std::vector<Vec2> points;
  for (const Candidate& candidate : placement.candidates) {
    points.push_back(candidate.chord.r1.position - centre);
    points.push_back(candidate.chord.r2.position - centre);
  }
  const std::size_t ends = points.size();
  if (placement.settings.method == Method::distance)
    for (const Vec2& v : placement.vertices()) points.push_back(v - centre);
  for (std::size_t i = 0; i < ends; ++i) {
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      if (same_direction(points[i], points[j]) && length(points[i] - points[j]) > 1e-9 * size)
        return true;
    }
  }
  return false;
}

// The candidates that remain for a further team before candidate order decides.
std::vector<std::size_t> best_by_keys(const Placement& placement, std::size_t teams) {
  const auto polygon = Polygon::create(placement.vertices());
  std::vector<std::uint32_t> selected;
  std::vector<char> taken(placement.candidates.size());
  for (std::size_t k = 0; k < teams; ++k) {
    selected.push_back(placement.team_candidates[k]);
    taken[selected.back()] = 1;
  }
  std::vector<std::size_t> left;
  for (std::size_t i = 0; i < taken.size(); ++i)
    if (!taken[i]) left.push_back(i);
  const auto keep = [&](auto key, auto slack) {
    double best = -std::numeric_limits<double>::infinity();
    for (const std::size_t i : left) best = std::max(best, key(i));
    std::erase_if(left, [&](std::size_t i) { return !(key(i) >= best - slack(best)); });
  };
  const auto ratio = [&](std::size_t i) { return placement.candidates[i].chord.ratio; };
  const auto length_of = [&](std::size_t i) { return placement.candidates[i].length; };
  const auto absolute = [](double) { return 1.01 * tolerance; };
  const auto relative = [](double best) { return 1.01 * tolerance * best; };
  if (teams == 0) {
    const bool some_even = std::any_of(left.begin(), left.end(), [&](std::size_t i) {
      return is_even(placement.candidates[i].chord);
    });
    if (some_even) {
      std::erase_if(left, [&](std::size_t i) { return !is_even(placement.candidates[i].chord); });
      keep(length_of, relative);
      keep(ratio, absolute);
    } else {
      keep(ratio, absolute);
      keep(length_of, relative);
    }
    return left;
  }
  const std::vector<double> score =
      scores(solid(*polygon), placement.centre_of_mass, placement.candidates, selected,
             *metric_of(placement.settings.method));
  const double size = polygon->diameter();
  const double floor = 1e-12 * (placement.settings.method == Method::distance ? size : size * size);
  keep([&](std::size_t i) { return score[i]; },
       [&](double best) { return 1.01 * std::max(tolerance * std::fabs(best), floor); });
  keep(ratio, absolute);
  keep(length_of, relative);
  return left;
}

// Teams are the same until candidate order decides a tie; then both choices must tie.
void compare_teams(const Placement& before, const Placement& after,
                   const std::vector<std::size_t>& became, Comparison& comparison,
                   std::string& differences, bool& all_same) {
  all_same = true;
  for (std::size_t k = 0; k < before.team_candidates.size(); ++k) {
    const std::size_t expected = became[before.team_candidates[k]];
    const std::size_t chosen = after.team_candidates[k];
    if (expected == chosen) continue;
    all_same = false;
    const std::vector<std::size_t> best = best_by_keys(after, k);
    const auto among_them = [&](std::size_t i) {
      return std::find(best.begin(), best.end(), i) != best.end();
    };
    if (!among_them(expected) || !among_them(chosen))
      differences += "team " + std::to_string(k) + " took " + std::to_string(chosen) +
                     " instead of " + std::to_string(expected) + ", which is no tie\n";
    return;
  }
  comparison.teams_and_verdicts();
}

void turn_or_mirror(const Change& change, const char* what) {
  int same_teams = 0, compared = 0;
  for_each_case([&](Document d, std::uint64_t number) {
    if (d.settings.method == Method::distributed || (d.settings.method == Method::random))
      d.settings.method = pair_methods[number % 3];
    const Document after_document = changed(d, change);
    const Placement before = placed(d), after = placed(after_document);
    Comparison comparison(before, after, change, false);
    const std::vector<std::size_t> became = comparison.match();
    std::string differences;
    if (comparison.same() && !(change.mirrors() && is_one_sided(before))) {
      bool all_same = false;
      compare_teams(before, after, became, comparison, differences, all_same);
      same_teams += all_same;
      ++compared;
    }
    report(comparison, d, what);
    if (!differences.empty()) {
      INFO(what << "\n" << text(d));
      CHECK(differences == "");
    }
  });
  CHECK(compared > 500);
  CHECK(same_teams > compared / 2);
}

}  // namespace

TEST_CASE("turning the object by 90 degrees turns its placement", "[invariance][thorough]") {
  turn_or_mirror({.xx = 0, .xy = -1, .yx = 1, .yy = 0}, "turned by 90 degrees");
}

TEST_CASE("turning the object by 180 degrees turns its placement", "[invariance][thorough]") {
  turn_or_mirror({.xx = -1, .xy = 0, .yx = 0, .yy = -1}, "turned by 180 degrees");
}

TEST_CASE("mirroring the object mirrors its placement", "[invariance][thorough]") {
  turn_or_mirror({.xx = -1, .xy = 0, .yx = 0, .yy = 1}, "mirrored left to right");
  turn_or_mirror({.xx = 0, .xy = 1, .yx = 1, .yy = 0}, "mirrored at the diagonal");
}

TEST_CASE("random teams turn with the object", "[invariance][thorough]") {
  std::size_t teams = 0;
  const Change change{.xx = 0, .xy = -1, .yx = 1, .yy = 0};
  for_each_case([&](Document d, std::uint64_t number) {
    if (number % 4) return;
    d.settings.method = Method::random;
    const Placement before = placed(d), after = placed(changed(d, change));
    Comparison comparison(before, after, change, false);
    comparison.teams_and_verdicts();
    report(comparison, d, "turned by 90 degrees");
    teams += before.teams.size();
  });
  CHECK(teams > 1000);
}

TEST_CASE("distributed teams of a convex object are mirrored with it", "[invariance][thorough]") {
  int compared = 0;
  const Change change{.xx = -1, .xy = 0, .yx = 0, .yy = 1};
  for_each_case([&](Document d, std::uint64_t) {
    const auto polygon = Polygon::create(d.vertices);
    REQUIRE(polygon.ok());
    if (!polygon->convex()) return;
    // Hardly any line along an edge meets both sides; rounding decides whether one does.
    const auto centre = check_centre_of_mass(*polygon, d.centre_of_mass);
    const std::vector<bool> radial = radial_edges(*polygon, *centre);
    if (std::find(radial.begin(), radial.end(), true) != radial.end()) return;
    d.settings.method = Method::distributed;
    const Placement before = placed(d);
    Placement after = placed(changed(d, change));
    // Counted upward from the right before, from the left now.
    std::reverse(after.teams.begin(), after.teams.end());
    Comparison comparison(before, after, change, false);
    comparison.teams_and_verdicts();
    report(comparison, d, "mirrored left to right");
    ++compared;
  });
  CHECK(compared > 100);
}
