// Computes the placement of a document in one call.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "evenlift/candidates.h"
#include "evenlift/closure.h"
#include "evenlift/document.h"
#include "evenlift/loads.h"
#include "evenlift/polygon_with_holes.h"
#include "evenlift/result.h"
#include "evenlift/stability.h"
#include "evenlift/stands.h"
#include "evenlift/weighing.h"

namespace evenlift {

// A support or a hole that does not fit the object: the support is outside it or in a hole, or the
// hole is not strictly inside the outline and apart from the holes before it.
struct Misplaced {
  enum class Kind : std::uint8_t { support, hole };
  Kind kind = Kind::support;
  std::uint32_t index = 0;                    // from 0, in the document
  std::optional<std::uint32_t> in_hole = {};  // of a support: the hole it is in, from 0
  bool operator==(const Misplaced&) const = default;
};

// What place() does with supports and holes that do not fit: the document is refused, or they are
// left out. A support that is left out carries nothing and is no robot; its reading still counts
// (weighing.h), since it was taken before. In the same way, a C that is not inside the outline's
// hull is an error, or no robots are placed, and given ones let the object fall. Each hole that is
// left out costs O(n log n).
enum class Misfitting : std::uint8_t { refused, left_out };

struct Placement {
  explicit Placement(PolygonWithHoles placed) : object(std::move(placed)) {}
  const Polygon& polygon() const { return object.outline(); }
  const Points& vertices() const { return polygon().vertices(); }  // the outline, as given
  double weight() const { return total_weight(settings); }  // the weight that the robots share
  // The support at which a given robot stands, from 0: the robot's own number, unless supports are
  // left out. People know a robot by this number, counted from 1. O(1).
  std::uint32_t support_of(std::size_t robot) const {
    return robot < supports.size() ? supports[robot] : static_cast<std::uint32_t>(robot);
  }
  std::uint32_t number_of(std::size_t robot) const { return support_of(robot) + 1; }
  // Of the support at which a given robot stands (document.h). O(bytes).
  std::string_view name_of(std::size_t robot) const {
    return name_of_support(settings, support_of(robot));
  }
  std::string called(std::size_t robot) const {
    return support_called(settings, support_of(robot));
  }

  PolygonWithHoles object;
  Vec2 own_centre;                   // of the object without cargo: given, weighed, or the centroid
  Vec2 centre_of_mass;               // C: that of the object with its cargo
  Settings settings;                 // as given, but with the weight that was weighed
  std::optional<Weighing> weighing;  // what the supports' readings tell, if there are any
  std::shared_ptr<const Stands> stands;  // null if stands_anywhere()
  std::vector<Candidate> candidates;     // in candidate order, whatever the method
  std::uint32_t requested_teams = 0;     // with "max", the number of candidates; for balanced
                                         // robots and supports, 1
  std::vector<Team> teams;               // in the order of choice; perhaps fewer than requested.
                                         // Balanced robots and supports are one team
  std::vector<std::uint32_t> team_candidates;  // each team's candidate; empty if the method does
                                               // not choose among candidates
  Points lifting_base;  // corners of H, counter-clockwise; empty without teams
  double coverage = 0;  // of the object by H, in [0, 1] (stability.h)
  // Empty if there are no teams, or if the object falls (equilibrium.h).
  std::optional<LoadSummary> loads;
  Closure closure;
  bool goal_reached = false;  // there are robots and, with the goal `hold`, hold_firmly() is true
  Moved moved = {};           // the robots that the user moved by hand (moved.h)
  std::vector<Misplaced> left_out = {};      // in the document's order, holes first
  std::vector<std::uint32_t> supports = {};  // of each robot, if any support is left out
  bool search_ended = true;  // false while a search or swaps may still find better robots
  bool cut_short = false;  // whether a limit of work ended the search (most_work in balanced.h) or
                           // the swaps (most_swap_steps in swaps.h)
  // If robots that may be off by the setting `accuracy` have no room for as many as requested: a
  // smaller accuracy with which there is room. Empty if none is found.
  std::optional<double> accuracy_with_room = {};
};

// With `whole`, the search for balanced robots runs to its end. With `start`, only the set with
// which the search begins is computed (start_balanced() of balanced.h); if even this would not be
// quick, there are no teams, and search_ended is false. Other methods always run to their end.
enum class Effort : std::uint8_t { whole, start };

// Checks that settings are in their ranges (settings.h) and compatible. The methods `distributed`
// and `random` do not permit "max" teams, the goal `hold`, a robot's size or no-go edges. Surviving
// F > 0 failures takes at least 2 F + 3 balanced robots. The method `given` needs supports, and its
// support_capacities must be empty or have one entry per support. The error's place names the
// setting. O(parts of no_go, supports and items of cargo).
std::optional<InputError> check_settings(const Settings& settings, const Shown& shown = {});

// The contacts of the robots, in their order. A contact is the boundary point that a robot touches.
// It is the lifting point unless the robot has a hand that reaches beneath the object. A support
// beneath the object is listed with its lifting point. O(robots).
std::vector<LiftingPoint> contact_points(const Placement& placement);

// The margin and clearance that the settings require (closure.h). O(n).
HoldRequirements hold_requirements(const Placement& placement);

// Whether the robots hold the object in form closure, without relying on a contact nearer to a
// corner than the setting `clear`, and even if they are off by the tolerance that is required
// (closure.h). O(n).
bool hold_firmly(const Placement& placement);

// Whether the robots hold the object: in form closure, whether they hold it firmly; otherwise,
// whether it is held to second order. O(n).
bool is_held(const Placement& placement);

// Checks the document and computes its placement. With readings of supports (weighing.h), it is an
// error if C is given, or a weight other than the default. The same document gives the same bits on
// every platform. The errors are those of check_settings(), Polygon::create(),
// PolygonWithHoles::create(), centre_of_mass(), make_stands(), place_supports(), weigh(),
// find_candidates(), check_swaps() and, for moved robots, with_moved() (moved.h). O(n log n + K log K) for K edge
// pairs and O(n h) for the coverage, plus the cost of the stands (stands.h), the selection
// (selection.h), the swaps (swaps.h) or the search for balanced robots (balanced.h).
Result<Placement> place(const Document& document, Effort effort = Effort::whole,
                        Misfitting misfitting = Misfitting::refused);

// Computes the placement of an object that is already checked, for example after C or the settings
// have changed.
Result<Placement> place(PolygonWithHoles object, const std::optional<Vec2>& own_centre,
                        const Settings& settings, Effort effort = Effort::whole,
                        const Moved& moved = {}, Misfitting misfitting = Misfitting::refused);

// The candidates of an object, and the teams chosen among them. Finding both takes most of the time
// of place().
struct Choice {
  std::vector<Candidate> candidates;
  std::vector<std::uint32_t> teams;  // indices of candidates, in the order of choice
};

// Returns the placement that place() would return, with the same bits, without making the choice
// again. The choice was made elsewhere, for example in another thread, for the same object and
// settings. The method must choose among candidates, robots must be points that may stand anywhere,
// and the indices must be valid. The errors are those of check_settings() and centre_of_mass().
// O(n log n), plus O(n h) for the coverage.
Result<Placement> place_as_chosen(PolygonWithHoles object, const std::optional<Vec2>& own_centre,
                                  const Settings& settings, Choice choice);

// The document with its supports moved to the nearest places at which their loads by springs are
// equal (even_out() of supports.h). It is an error if there are no such places, if there are more
// than most_evened supports, if the method is not `given`, or if place() refuses the document.
Result<Document> with_even_supports(const Document& document,
                                    Misfitting misfitting = Misfitting::refused);

// What with_even_supports() moved: the supports, from 0, that stand elsewhere after it. O(supports).
struct SupportMove {
  std::size_t robot = 0;
  Vec2 from, to;
};
std::vector<SupportMove> support_moves(const Document& before, const Document& after);

// The candidates for the document's `positions`, `robot` and `no_go`, whatever its method.
// O(n log n + K log K) for K edge pairs; with a robot's size or no-go edges, also the cost of
// Stands and of standing_candidates() (candidates.h).
Result<std::vector<Candidate>> candidates_of(const Document& document);
// The same with the stands of make_stands().
Result<std::vector<Candidate>> candidates_of(const Polygon& polygon, const Vec2& centre,
                                             const Settings& settings, const Stands* stands);

// The placement with its balanced robots replaced by these robots, which a search or the user has
// chosen. The centroid of `robots` must be C. O(n log n) for up to most_robots.
Placement with_robots(Placement placement, const std::vector<LiftingPoint>& robots,
                      bool search_ended, bool cut_short = false);

// A placement and how to show it, for functions that write words, pictures or files. Without `how`,
// the defaults apply. A ShownPlacement refers to both arguments: pass it to functions, but do not
// store it. If the object was weighed, `shown` has the C uncertainty and the height of C that follow
// (as_weighed()).
class ShownPlacement {
 public:
  ShownPlacement(const Placement& of) : ShownPlacement(of, usual) {}
  ShownPlacement(const Placement& of, const Shown& how);

 private:
  static const Shown usual;
  std::shared_ptr<const Shown> weighed_;

 public:
  const Placement& placement;
  const Shown& shown;
};

}  // namespace evenlift
