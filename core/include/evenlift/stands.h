// Where robots with a size can stand (docs/stands.md): a round body of radius r outside the object,
// an arm that reaches to the contact c on an edge, and a hand that goes beneath the object by its
// depth d. With n the outward normal of the edge, the middle of the body is s = c + (r + reach) n,
// the hand is the rectangle of its width from c to c - d n, and the lifting point is p = c - d n.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "evenlift/chords.h"
#include "evenlift/document.h"
#include "evenlift/polygon.h"
#include "evenlift/result.h"

namespace evenlift {

// Why a part of an edge cannot be used.
enum class WhyUnusable : std::uint8_t {
  no_go,       // the user says so
  body,        // the body would meet another part of the boundary
  arm,         // the arm would cross the object
  corner,      // the hand would stick out beyond a corner (Polygon::is_corner)
  hand,        // the object is not deep enough for the hand, or not wide enough
  near_no_go,  // the hand would reach sideways onto a part that the user marked
  narrow,  // what is left between two other parts is shorter than the tolerance; it stays the last
};

inline constexpr std::size_t why_unusable_count = static_cast<std::size_t>(WhyUnusable::narrow) + 1;

// "no_go", "body" and so on, as in JSON. O(1).
std::string_view name(WhyUnusable why);

// A part of an edge from its first vertex, in units of length.
struct Stretch {
  double from = 0, to = 0;
};

struct UnusablePart {
  std::uint32_t edge = 0;
  Stretch part;  // from < to
  WhyUnusable why = WhyUnusable::no_go;
};

// An edge as a robot at it sees it.
struct EdgeFrame {
  Vec2 start, along, outward;  // its first vertex, and two directions of unit length
  double length;
};

// The boundary as robots of one size can use it. At t along an edge a robot can stand if
//   1. every other edge is at least r - tau L away from the middle of its body,
//   2. the segment from the body's middle to the contact meets the object at the contact only (if the
//      reach is above 0),
//   3. [t - w / 2, t + w / 2] x [w / 10, d], the hand's rectangle without the tenth of its width that
//      is next to the edge, lies within the object, to tau L; and the corners (Polygon::is_corner) at
//      which the edge ends, where edges that straight vertices join are one, are w / 2 away,
//   4. no part of the hand's width, from t - w / 2 to t + w / 2, is in a part of the edge that must
//      not be touched.
// A robot of which only the gap is above 0 may stand at a vertex, unless an edge there must not be
// touched at it. Any other robot stands at no vertex: the stretches end 2 tau L before it, where a
// contact is one inside the edge.
class Stands {
 public:
  // The size and the parts must be in their ranges, and the edges must exist. For each edge the
  // others near it are found in a tree of boxes. O(n log n + k log k) for k pairs of edges so near
  // to each other that one may be in the way of a robot at the other, if the outline does not wind
  // much.
  Stands(const Polygon& polygon, const RobotSize& robot, const std::vector<EdgePart>& no_go);

  const RobotSize& robot() const { return robot_; }
  // Whether a robot is more than a point.
  bool has_body() const { return robot_.has_body(); }
  // Whether robots can stand anywhere at all.
  bool any() const { return !usable_.empty(); }

  // Where an edge can be used: disjoint closed stretches in ascending order, none shorter than tau
  // L.
  struct Stretches {
    const Stretch* first;
    const Stretch* last;
    const Stretch* begin() const { return first; }
    const Stretch* end() const { return last; }
    bool empty() const { return first == last; }
  };
  Stretches usable(std::uint32_t edge) const {
    return {usable_.data() + begins_[edge], usable_.data() + begins_[edge + std::size_t{1}]};
  }
  // What cannot be used, edge after edge, in ascending order. If there are several reasons, it is
  // the first of them in the order of WhyUnusable. The bits of 2 tau L at vertices are not listed.
  const std::vector<UnusablePart>& unusable() const { return unusable_; }
  // Why nobody can stand at t along an edge; nothing where somebody can, to tau L. O(log n) and the
  // edge's stretches.
  std::optional<WhyUnusable> why_not(std::uint32_t edge, double t) const;

  // The contact of a lifting point, and the middle of the body of a robot that lifts there. At a
  // vertex, where only points can stand, both are the lifting point itself. O(1).
  Vec2 contact(const LiftingPoint& point) const;
  Vec2 stand(const LiftingPoint& point) const;
  // The lifting point of a contact on an edge. O(1).
  LiftingPoint lifting_point(const LiftingPoint& contact) const;
  // The way along its edge from the first vertex to a lifting point or contact. O(1).
  double along(const LiftingPoint& point) const;
  // Whether a robot can lift there, within tau L along the edge. The cost is that of why_not().
  bool can_lift(const LiftingPoint& point) const;

  // Whether two robots get into each other's way. Their bodies' middles must be 2 r + gap apart,
  // and the middle lines of their hands the hand's width. With a reach, the arm of each, the
  // segment from its contact to the middle of its body, must be r + gap from the middle of the
  // other's body, and the arms must not cross. All of that is to tau L. O(1).
  bool collide(const LiftingPoint& a, const LiftingPoint& b) const;
  // Whether any two do. O(m^2).
  bool any_collide(const std::vector<LiftingPoint>& points) const;

 private:
  bool bodies_collide(const LiftingPoint& a, const LiftingPoint& b) const;
  bool arms_collide(const LiftingPoint& a, const LiftingPoint& b) const;
  bool hands_collide(const LiftingPoint& a, const LiftingPoint& b) const;

  RobotSize robot_;
  double near_ = 0;
  std::vector<EdgeFrame> frames_;  // of the edges
  std::vector<Stretch> usable_;
  std::vector<std::uint32_t> begins_;  // into usable_, by edge, and one more
  std::vector<UnusablePart> unusable_;
};

// The contacts of lifting points; without `stands` the points themselves. O(points).
std::vector<LiftingPoint> contact_points(const Stands* stands, std::vector<LiftingPoint> points);

// Whether robots are points that may stand anywhere. Then nothing is asked of Stands. O(1).
bool stands_anywhere(const Settings& settings);

// The stands that the settings ask for; nothing if robots are points that may stand anywhere. It is
// an error if an edge of no_go does not exist, or if nobody could stand anywhere. The cost is that
// of Stands.
Result<std::shared_ptr<const Stands>> make_stands(const Polygon& polygon, const Settings& settings);

// The parts that must not be touched, when somebody marks or edits the outline by hand. Results are
// in order and without overlaps; `at` is a place on an edge as a part of its length. O(parts log
// parts).

// With one part more, and without what lies in a part.
std::vector<EdgePart> with_part(std::vector<EdgePart> no_go, const EdgePart& part);
std::vector<EdgePart> without_part(std::vector<EdgePart> no_go, const EdgePart& part);

// Whether a place is marked. O(parts).
bool is_marked(const std::vector<EdgePart>& no_go, std::uint32_t edge, double at);

// The marks after a vertex was put on an edge; and after one of n > 3 vertices was removed, whose
// two edges become one with the marks of both.
std::vector<EdgePart> after_split(const std::vector<EdgePart>& no_go, std::uint32_t edge,
                                  double at);
std::vector<EdgePart> after_removal(const std::vector<EdgePart>& no_go, const Points& vertices,
                                    std::uint32_t vertex);

}  // namespace evenlift
