// Judges sets of robots by their definition, in plain doubles and by brute force. It shares no code
// with the core.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace set_oracle {

using Point = std::array<double, 2>;

struct Object {
  std::vector<Point> vertices;  // in either orientation
  Point centre;
};

// L and R.
double diameter(const Object& object);
double radius(const Object& object);

// Whether a point is inside the convex hull, not only within tolerance.
bool inside_hull(const Object& object, const Point& p);

// The distance of a point from the outline.
double away_from_outline(const Object& object, const Point& p);

// The distance of the robots' centroid from C.
double imbalance(const Object& object, const std::vector<Point>& robots);

// The part of the object in the robots' convex hull.
double coverage(const Object& object, const std::vector<Point>& robots);

// The least distance of the origin from a facet of the contacts' wrenches, negative if it is
// outside; nothing if they have no volume. If it is not negative, it is the margin. Contacts nearer
// than `clear` to a corner do not count.
std::optional<double> margin(const Object& object, const std::vector<Point>& robots,
                             double clear = 0);

// The least distance between two robots.
double least_distance(const std::vector<Point>& robots);

// The stands of an object with at most 1,000 vertices.
std::vector<Point> stands(const Object& object);

// The chords with their midpoint at M, one for each pair of edges that has any, by their ends.
std::vector<std::array<Point, 2>> even_chords(const Object& object, const Point& m);

}  // namespace set_oracle
