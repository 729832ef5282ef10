// Where robots with a size can stand (docs/stands.md). A robot has a round body of radius r outside
// the object, an arm that reaches to the contact c on an edge, and a hand of depth d beneath the
// object. If n is the outward normal of the edge, the body's centre is s = c + (r + reach) n, the
// lifting point is p = c - d n, and the hand is a rectangle of width w from c to p.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "evenlift/chords.h"
#include "evenlift/document.h"
#include "evenlift/polygon_with_holes.h"
#include "evenlift/result.h"

namespace evenlift {

// Why a part of an edge is unusable.
enum class WhyUnusable : std::uint8_t {
  no_go,       // the robot would touch a no-go part
  body,        // the body would meet another part of the boundary
  arm,         // the arm would cross the object
  corner,      // the hand would stick out beyond a corner (Polygon::is_corner)
  hand,        // the object is too shallow or narrow for the hand
  hole,        // the hand would reach into a hole
  near_no_go,  // the hand would reach sideways onto a no-go part
  narrow,      // what the other reasons leave usable is shorter than tau L; keep this last
};

inline constexpr std::size_t why_unusable_count = static_cast<std::size_t>(WhyUnusable::narrow) + 1;

// The name in JSON: "no_go", "body" and so on. O(1).
std::string_view name(WhyUnusable why);

// A part of an edge, given by the distances of its ends from the edge's first vertex.
struct Stretch {
  double from = 0, to = 0;
};

struct UnusablePart {
  std::uint32_t edge = 0;
  Stretch part;  // from < to
  WhyUnusable why = WhyUnusable::no_go;
};

// The local frame of an edge.
struct EdgeFrame {
  Vec2 start, along, outward;  // the first vertex, and two unit vectors
  double length;
};

// The boundary that robots of one size can use: where the body, the arm and the hand have room, and
// the hand's width avoids all no-go parts. docs/stands.md (Where an edge can be used) states the
// conditions. If a robot has a body (has_body()), usable intervals stay 2 tau L away from the
// vertices, so that a contact counts as inside the edge. A robot without a body may stand at a
// vertex, unless a no-go part reaches the vertex; then intervals also stay 2 tau L away from it.
// What searches keep away from, beyond what robots need at their exact places (algorithm.md,
// Accuracy).
struct StandReserve {
  double accuracy = 0;     // robots may be off along the outline by this
  double from_corner = 0;  // the distance of contacts from corners, at least `accuracy`
  // For bodies: this part of the length of a robot's room, from its ends; and this length from its
  // ends and from bends, but no more than a quarter of the room between them.
  double part = 0, length = 0;
};

class Stands {
 public:
  // The size and the parts must be in their ranges, and the edges of the parts must exist. A tree
  // of boxes finds the other edges near each edge. O(n log n + k log k) if the outline does not
  // wind much; k is the number of pairs of edges in which one may obstruct robots at the other.
  Stands(const PolygonWithHoles& object, const RobotSize& robot, const std::vector<EdgePart>& no_go,
         const StandReserve& reserve = {});

  const RobotSize& robot() const { return robot_; }
  // Whether a robot is more than a point.
  bool has_body() const { return robot_.has_body(); }
  // Whether a robot can stand anywhere at all, and whether searches may use anything of that.
  bool any() const { return !room_.parts.empty(); }
  bool any_usable() const { return !usable_.parts.empty(); }

  // room() returns the intervals of an edge where robots can stand: disjoint, closed, in ascending
  // order, none shorter than tau L. usable() returns what of them searches use. Where an interval
  // ends, and does not go on beyond a vertex that turns little, robots keep away from the end as
  // the reserve says.
  struct Stretches {
    const Stretch* first;
    const Stretch* last;
    const Stretch* begin() const { return first; }
    const Stretch* end() const { return last; }
    bool empty() const { return first == last; }
  };
  Stretches room(std::uint32_t edge) const { return room_.of(edge); }

  // How far a robot at the distance t along an edge may go along the outline before its room ends,
  // towards the edge's end (`on`) or begin. Room goes on past vertices that turn little, or past all
  // of them (`past_corners`). Infinite if it does not end within `most`. O(the parts that it passes).
  struct Way {
    double length = 0;
    std::optional<std::size_t> vertex;  // the corner or notch where it ends
  };
  Way way_to_end(const Polygon& polygon, std::uint32_t edge, double t, bool on, bool past_corners,
                 double most = std::numeric_limits<double>::infinity()) const;

  Stretches usable(std::uint32_t edge) const { return usable_.of(edge); }
  // The unusable parts, edge after edge, in ascending order. If several reasons apply, a part has
  // the first in the order of WhyUnusable. The pieces of 2 tau L at vertices are not listed.
  const std::vector<UnusablePart>& unusable() const { return unusable_; }
  // Why a robot cannot stand at the distance t along an edge from its first vertex; empty if it
  // can, up to tau L. O(log n), plus the edge's number of usable intervals.
  std::optional<WhyUnusable> why_not(std::uint32_t edge, double t) const;

  // contact() returns the contact, and stand() the centre of the body, of the robot that lifts at
  // this point. Both are the point itself if the robot is a point or beneath the object. O(1).
  Vec2 contact(const LiftingPoint& point) const;
  Vec2 stand(const LiftingPoint& point) const;
  // The lifting point of the robot that has this contact on an edge. If the robot is beneath the
  // object, the lifting point is the contact itself. O(1).
  LiftingPoint lifting_point(const LiftingPoint& contact) const;
  // The nearest contact with room beside the same vertex, for the contact of a robot with a body at a
  // vertex that is no corner and no notch, such as one of a curve: intervals end 2 tau L before it.
  // Otherwise, or if there is no room either, the contact itself. Costs as much as why_not().
  LiftingPoint beside_vertex(const Polygon& polygon, const LiftingPoint& contact) const;
  // The distance of a lifting point or contact from the first vertex of its edge. O(1).
  double along(const LiftingPoint& point) const;
  // Whether a robot can have this lifting point, and whether searches may use it, within tau L along
  // the edge. Costs as much as why_not(), and O(the edge's usable intervals).
  bool can_lift(const LiftingPoint& point) const;
  bool can_use(const LiftingPoint& point) const;

  // Whether bodies, arms or hands of two robots collide (docs/stands.md), up to tau L, or may
  // collide if both are off by the accuracy. A robot beneath the object has neither arm nor hand.
  // O(1).
  bool collide(const LiftingPoint& a, const LiftingPoint& b) const;
  // By how much bodies, arms and hands of two robots are farther apart than they must be: the least
  // of the differences; negative if the robots collide, and infinite if nothing keeps them apart.
  // O(1).
  double room_between(const LiftingPoint& a, const LiftingPoint& b) const;
  // Whether any two of the m robots collide. O(m^2).
  bool any_collide(const std::vector<LiftingPoint>& points) const;

 private:
  bool bodies_collide(const LiftingPoint& a, const LiftingPoint& b) const;
  bool arms_collide(const LiftingPoint& a, const LiftingPoint& b) const;
  bool hands_collide(const LiftingPoint& a, const LiftingPoint& b) const;

  // By how much more than they need two robots must be apart, so that both may be off.
  double reserve_between(const LiftingPoint& a, const LiftingPoint& b) const;

  // Intervals of all edges.
  struct Parts {
    std::vector<Stretch> parts;
    std::vector<std::uint32_t> begins;  // where each edge begins in `parts`, and parts.size()
    Stretches of(std::uint32_t edge) const {
      return {parts.data() + begins[edge], parts.data() + begins[edge + std::size_t{1}]};
    }
  };
  Parts usable_parts(const Polygon& polygon, const StandReserve& reserve) const;
  std::vector<double> drifts(const Polygon& polygon, double accuracy) const;

  RobotSize robot_;
  double near_ = 0;
  std::vector<EdgeFrame> frames_;
  Parts room_, usable_;
  std::vector<double> drifts_;  // by edge: how far parts of a robot may move; empty if exact
  std::vector<UnusablePart> unusable_;
};

// The contacts of the robots that lift at these points. Without `stands` they are the points
// themselves. O(points).
std::vector<LiftingPoint> contact_points(const Stands* stands, std::vector<LiftingPoint> points);

// Whether robots are points that may stand anywhere, so that Stands is not needed. O(1).
bool stands_anywhere(const Settings& settings);

// The Stands for these settings; null if stands_anywhere(). It is an error if an edge of no_go does
// not exist, or if no place is usable and the method is not `given`. Costs as much as the
// constructor of Stands.
Result<std::shared_ptr<const Stands>> make_stands(const PolygonWithHoles& object,
                                                  const Vec2& centre, const Settings& settings);

// These functions update the no-go parts when the user changes them or edits the outline. The
// resulting parts are in order and do not overlap. `at` is a place on an edge as a fraction of its
// length. O(parts log parts).

// with_part() adds a part to the no-go parts; without_part() removes everything inside a part.
std::vector<EdgePart> with_part(std::vector<EdgePart> no_go, const EdgePart& part);
std::vector<EdgePart> without_part(std::vector<EdgePart> no_go, const EdgePart& part);

// Whether a place is in a no-go part. O(parts).
bool is_marked(const std::vector<EdgePart>& no_go, std::uint32_t edge, double at);

// after_split() returns the no-go parts after a vertex was added on an edge. after_removal()
// returns them after one of the n > 3 `vertices` was removed. The two edges at that vertex have
// become one edge, which has the no-go parts of both.
std::vector<EdgePart> after_split(const std::vector<EdgePart>& no_go, std::uint32_t edge,
                                  double at);
std::vector<EdgePart> after_removal(const std::vector<EdgePart>& no_go, const Points& vertices,
                                    std::uint32_t vertex);

}  // namespace evenlift
