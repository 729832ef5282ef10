// Judges sets of robots by definition, in doubles and by brute force, without the core.
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

// Inside the convex hull, not only within tolerance.
bool inside_hull(const Object& object, const Point& p);

double away_from_outline(const Object& object, const Point& p);

// Of the robots' centroid from C.
double imbalance(const Object& object, const std::vector<Point>& robots);

// The part of the object in the robots' hull.
double coverage(const Object& object, const std::vector<Point>& robots);

// The least distance of the origin from a facet of the contacts' wrenches: the margin, or negative
// if the origin is outside; nothing if they have no volume. Contacts nearer than `clear` to a
// corner do not count.
std::optional<double> margin(const Object& object, const std::vector<Point>& robots,
                             double clear = 0);

double least_distance(const std::vector<Point>& robots);

// The object has at most 1,000 vertices.
std::vector<Point> stands(const Object& object);

// The chords with midpoint M, one for each pair of edges that has any.
std::vector<std::array<Point, 2>> even_chords(const Object& object, const Point& m);

}  // namespace set_oracle
