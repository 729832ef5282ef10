// Immobilization (algorithm.md): contacts, free motions, margin, second order.
#include "oracle/exact.h"

#include <algorithm>
#include <functional>
#include <limits>

namespace oracle {
namespace {

struct Contact {
  RealVec at;
  ExactVec
      edge;  // along the edge, counter-clockwise about P: the inward normal is to its left, exactly
  RealVec normal;  // inward, of unit length
  std::size_t edge_number;
  std::optional<Real> to_corner;  // along the outline; empty if there is none before a notch
  bool in_notch = false;
};

Contact contact_on(const ExactShape& shape, const RealVec& at, std::size_t edge) {
  const ExactVec along = shape.vertices[(edge + 1) % shape.vertices.size()] - shape.vertices[edge];
  const RealVec left{Real(-along.y), Real(along.x)};
  return {at, along, left * (1 / length(left)), edge, {}};
}

std::optional<std::size_t> vertex_at(const ExactShape& shape, const RealVec& p, Calls& calls) {
  std::size_t nearest = 0;
  Real least = -1;
  for (std::size_t i = 0; i < shape.real_vertices.size(); ++i) {
    const Real d = length(p - shape.real_vertices[i]);
    if (least < 0 || d < least) {
      least = d;
      nearest = i;
    }
  }
  if (calls.within(least, tau * shape.size, "lifting point at a vertex")) return nearest;
  return std::nullopt;
}

std::size_t nearest_edge(const ExactShape& shape, const RealVec& p) {
  const std::size_t n = shape.real_vertices.size();
  std::size_t nearest = 0;
  Real least = -1;
  for (std::size_t i = 0; i < n; ++i) {
    const Real d = distance_to_segment(p, shape.real_vertices[i], shape.real_vertices[(i + 1) % n]);
    if (least < 0 || d < least) {
      least = d;
      nearest = i;
    }
  }
  return nearest;
}

/// Where two edges of different directions are folded within the tolerance of a robot, rounding
/// decides which one it touches.
void note_folds(const ExactShape& shape, const RealVec& p, std::optional<std::size_t> vertex,
                Calls& calls) {
  const std::size_t n = shape.vertices.size(), touched = vertex ? *vertex : nearest_edge(shape, p);
  const auto along = [&](std::size_t edge) {
    const RealVec u = shape.real_vertices[(edge + 1) % n] - shape.real_vertices[edge];
    return u * (1 / length(u));
  };
  for (std::size_t edge = 0; edge < n; ++edge) {
    if (edge == touched || (vertex && (edge + 1) % n == *vertex)) continue;
    const RealVec u = along(edge), v = along(touched);
    if (dot(u, v) > 0 && abs(cross(u, v)) <= tau) continue;
    if (distance_to_segment(p, shape.real_vertices[edge], shape.real_vertices[(edge + 1) % n]) <=
        tau * shape.size)
      calls.either_is_right("edges nearer to each other than tau L");
  }
}

/// Positive at a convex vertex, 0 at one straight within the tolerance.
int turn_at(const ExactShape& shape, std::size_t vertex, Calls& calls) {
  const std::size_t n = shape.vertices.size();
  const ExactVec before = shape.vertices[vertex] - shape.vertices[(vertex + n - 1) % n];
  const ExactVec after = shape.vertices[(vertex + 1) % n] - shape.vertices[vertex];
  const RealVec u = real(before), v = real(after);
  if (dot(u, v) > 0 &&
      calls.within(abs(cross(u, v)) / (length(u) * length(v)), tau, "straight vertex"))
    return 0;
  return sign(cross(before, after));
}

/// By more than 15 degrees.
bool turns_sharply(const ExactShape& shape, std::size_t vertex, bool& unsure) {
  const std::size_t n = shape.vertices.size();
  const RealVec u = real(shape.vertices[vertex] - shape.vertices[(vertex + n - 1) % n]);
  const RealVec v = real(shape.vertices[(vertex + 1) % n] - shape.vertices[vertex]);
  const Real cosine = dot(u, v) / (length(u) * length(v));
  const Real of_15_degrees = (sqrt(Real(6)) + sqrt(Real(2))) / 4;
  if (abs(cosine - of_15_degrees) < 10 * tau) unsure = true;
  return cosine < of_15_degrees - tau;
}

/// Along the outline in both directions, to a corner, a notch or once round.
void set_distance(const ExactShape& shape, Calls& calls, bool& unsure, Contact& contact) {
  const std::size_t n = shape.vertices.size();
  for (const bool on : {true, false}) {
    RealVec at = contact.at;
    Real way = 0;
    std::size_t vertex = on ? (contact.edge_number + 1) % n : contact.edge_number;
    for (std::size_t passed = 0; passed < n; ++passed) {
      way += length(shape.real_vertices[vertex] - at);
      const int turn = turn_at(shape, vertex, calls);
      if (turn != 0 && turns_sharply(shape, vertex, unsure)) {
        if (turn > 0 && (!contact.to_corner || way < *contact.to_corner)) contact.to_corner = way;
        break;
      }
      at = shape.real_vertices[vertex];
      vertex = (vertex + (on ? 1 : n - 1)) % n;
    }
  }
}

std::vector<Contact> contacts_of(const ExactShape& shape, const std::vector<RealVec>& points,
                                 Calls& calls, bool& corners_are_unsure) {
  const std::size_t n = shape.vertices.size();
  std::vector<Contact> contacts;
  const auto add = [&](const Contact& c) {
    // Two robots at one place push as one.
    for (const Contact& o : contacts)
      if (o.at == c.at && o.edge == c.edge) return;
    contacts.push_back(c);
  };
  const auto add_on = [&](const RealVec& at, std::size_t edge, bool in_notch) {
    Contact contact = contact_on(shape, at, edge);
    contact.in_notch = in_notch;
    if (!in_notch) set_distance(shape, calls, corners_are_unsure, contact);
    add(contact);
  };
  for (const RealVec& p : points) {
    const auto vertex = vertex_at(shape, p, calls);
    note_folds(shape, p, vertex, calls);
    if (!vertex) {
      add_on(p, nearest_edge(shape, p), false);
      continue;
    }
    const std::size_t before = (*vertex + n - 1) % n;
    const int turn = turn_at(shape, *vertex, calls);
    const bool in_notch = turn < 0 && turns_sharply(shape, *vertex, corners_are_unsure);
    if (turn <= 0) add_on(shape.real_vertices[*vertex], *vertex, in_notch);
    if (turn < 0) add_on(shape.real_vertices[*vertex], before, in_notch);
  }
  return contacts;
}

/// Some direction makes no obtuse angle with any normal: the normals leave a gap of at least 180
/// degrees. The free directions form a closed cone. Unless it is everything, it has a side
/// perpendicular to a normal beside the gap, along that contact's edge. The tolerance is for the
/// normal on the other side, nearly opposite.
bool translation_is_free(const std::vector<Contact>& contacts, Calls& calls) {
  if (contacts.empty()) return true;
  for (const Contact& c : contacts) {
    for (const ExactVec& way : {c.edge, -c.edge}) {
      const auto allowed = [&](const Contact& o) {
        const Exact side = cross(o.edge, way);  // has the sign of normal . way
        if (side >= 0) return true;
        return dot(o.edge, c.edge) < 0 &&
               calls.within(-Real(side) / (length(real(o.edge)) * length(real(way))), tau,
                            "free translation");
      };
      if (std::all_of(contacts.begin(), contacts.end(), allowed)) return true;
    }
  }
  return false;
}

/// The point's signed distance to the left of c's normal line, directed inward.
Real left_of_normal(const Contact& c, const RealVec& point) {
  return cross(c.normal, point - c.at);
}

/// Weights with sum 1 that balance a few contacts' normals.
struct Balance {
  std::vector<std::size_t> contacts;
  std::vector<Real> weights;
};
/// The balances that others cannot combine: opposite pairs, and triples that span the plane
/// positively. Exact; with `loose`, pairs opposite within the tolerance also count.
std::vector<Balance> balances(const std::vector<Contact>& c, bool loose, Calls& calls) {
  std::vector<Balance> result;
  const std::size_t m = c.size();
  for (std::size_t i = 0; i < m; ++i) {
    for (std::size_t j = i + 1; j < m; ++j) {
      const Exact turn = cross(c[i].edge, c[j].edge);
      const bool opposite =
          dot(c[i].edge, c[j].edge) < 0 &&
          (turn == 0 ||
           (loose && calls.within(abs(cross(c[i].normal, c[j].normal)), tau, "opposite normals")));
      if (opposite) result.push_back({{i, j}, {Real(1) / 2, Real(1) / 2}});
      for (std::size_t k = j + 1; k < m && turn != 0; ++k) {
        const int s = sign(turn);
        if (sign(cross(c[j].edge, c[k].edge)) != s || sign(cross(c[k].edge, c[i].edge)) != s)
          continue;
        const Real wi = cross(c[j].normal, c[k].normal), wj = cross(c[k].normal, c[i].normal),
                   wk = cross(c[i].normal, c[j].normal);
        const Real sum = wi + wj + wk;
        result.push_back({{i, j, k}, {wi / sum, wj / sum, wk / sum}});
      }
    }
  }
  return result;
}

/// The points to the left (side = 1) or right (side = -1) of every normal.
struct Region {
  int side;
  std::optional<Real> widening;  // the least that makes it non-empty; nothing if no narrowing
                                 // empties it
};

/// The contacts, then four for the plane's border: rotation centres count up to L / tau from C
/// along an axis, or L / sqrt(tau) if a translation is free.
std::vector<Contact> with_border(std::vector<Contact> contacts) {
  for (const auto& [x, y] : {std::pair(1, 0), {-1, 0}, {0, 1}, {0, -1}})
    contacts.push_back({{0, 0}, {x, y}, {Real(-y), Real(x)}});
  return contacts;
}

/// By Farkas's lemma, the half-planes side * (n x c) >= side * (n x p) - w of the contacts and side
/// * (n x c) >= -reach of the border have no common point exactly if some balance has a positive
/// sum of weight * (side * n x p - w) and of weight * -reach.
Region region(const std::vector<Contact>& contacts, const std::vector<Balance>& exact_balances,
              const Real& reach, int side) {
  Region r{side, std::nullopt};
  for (const Balance& b : exact_balances) {
    Real sum = 0, of_contacts = 0;
    for (std::size_t k = 0; k < b.contacts.size(); ++k) {
      if (b.contacts[k] >= contacts.size()) {
        sum -= b.weights[k] * reach;
        continue;
      }
      const Contact& c = contacts[b.contacts[k]];
      sum += b.weights[k] * cross(c.normal, c.at) * side;
      of_contacts += b.weights[k];
    }
    if (of_contacts == 0) continue;
    sum /= of_contacts;
    if (!r.widening || sum > *r.widening) r.widening = sum;
  }
  return r;
}

/// The points from + s way, s in [first, last], in the region widened by w; an unbounded end is
/// absent.
struct Stretch {
  std::optional<Real> first, last;
  bool endless() const { return !first || !last; }
  bool longer_than(const Real& least) const { return endless() || *last - *first > least; }
};
Stretch stretch_on_line(const std::vector<Contact>& contacts, const Region& r, const RealVec& from,
                        const RealVec& way, const Real& w) {
  Stretch s;
  for (const Contact& c : contacts) {
    const Real slope = r.side * cross(c.normal, way);
    if (abs(slope) <= tau) continue;  // along the line, within the tolerance
    const Real at = -(r.side * left_of_normal(c, from) + w) / slope;
    if (slope > 0 && (!s.first || at > *s.first)) s.first = at;
    if (slope < 0 && (!s.last || at < *s.last)) s.last = at;
  }
  return s;
}

/// Two normals opposite and on one line within the tolerance: there the region is a segment.
struct Segment {
  RealVec from, way;
  Stretch stretch;
};
std::optional<Segment> segment_of(const std::vector<Contact>& contacts, const Region& r,
                                  const Real& size, Calls& calls) {
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    for (std::size_t j = i + 1; j < contacts.size(); ++j) {
      const Contact &a = contacts[i], &b = contacts[j];
      if (dot(a.normal, b.normal) >= 0) continue;
      if (!calls.within(abs(cross(a.normal, b.normal)), tau, "opposite normals")) continue;
      const RealVec way = (a.normal - b.normal) * (1 / length(a.normal - b.normal));
      const RealVec from = (a.at + b.at) * (Real(1) / 2);
      // Half the distance between the lines, measured at `from`, to be near both.
      if (!calls.within(abs(left_of_normal(a, from)), tau * size, "normals on one line")) continue;
      const Segment s{from, way, stretch_on_line(contacts, r, from, way, tau * size)};
      if (s.stretch.longer_than(tau * size)) return s;
    }
  }
  return std::nullopt;
}

/// Where a region without area is most nearly non-empty: the corner in which it vanishes as the
/// widening shrinks.
std::optional<RealVec> last_point(const std::vector<Contact>& contacts, const Region& r,
                                  const Real& size) {
  const Real w = *r.widening + size * Real("1e-50");
  std::optional<RealVec> best;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    for (std::size_t j = i + 1; j < contacts.size(); ++j) {
      if (cross(contacts[i].edge, contacts[j].edge) == 0) continue;
      // n x point = n x at - side * w on both borders.
      const auto &ni = contacts[i].normal, &nj = contacts[j].normal;
      const Real bi = cross(ni, contacts[i].at) - r.side * w;
      const Real bj = cross(nj, contacts[j].at) - r.side * w;
      const Real det = cross(ni, nj);
      const RealVec corner{(bi * nj.x - bj * ni.x) / det, (bi * nj.y - bj * ni.y) / det};
      const Real slip = (size + length(corner)) * Real("1e-60");
      const auto inside = [&](const Contact& c) {
        return r.side * left_of_normal(c, corner) >= -w - slip;
      };
      if (std::all_of(contacts.begin(), contacts.end(), inside)) best = corner;
    }
  }
  return best;
}

/// Whether the contacts whose normals pass through c stop finite motions about it.
bool immobile_about(const std::vector<Contact>& contacts, const RealVec& c, const Real& size,
                    Calls& calls) {
  std::vector<Contact> through;
  for (const Contact& contact : contacts)
    if (calls.within(abs(left_of_normal(contact, c)), tau * size, "normal through the centre"))
      through.push_back(contact);
  for (const Balance& b : balances(through, true, calls)) {
    Real sum = 0, weights = 0;
    for (std::size_t k = 0; k < b.contacts.size(); ++k) {
      const Contact& contact = through[b.contacts[k]];
      sum += b.weights[k] * dot(contact.normal, c - contact.at);
      weights += b.weights[k];
    }
    if (abs(sum) <= tau * size * weights) calls.either_is_right("curvature of a motion");
    if (sum > 0) return true;
  }
  return false;
}

/// Whether the contacts stop motions about a region without area: about a segment's midpoint, or
/// the single point. An endless segment is a translation that only rounding keeps from being free.
bool immobile_in(const std::vector<Contact>& contacts, const Region& r, const Real& size,
                 Calls& calls) {
  if (const auto segment = segment_of(contacts, r, size, calls)) {
    const Stretch& s = segment->stretch;
    if (s.endless()) return false;
    return immobile_about(contacts, segment->from + segment->way * ((*s.first + *s.last) / 2), size,
                          calls);
  }
  const auto point = last_point(contacts, r, size);
  return point && immobile_about(contacts, *point, size, calls);
}

using Vec3 = std::array<Real, 3>;
Vec3 minus(const Vec3& a, const Vec3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Real dot3(const Vec3& a, const Vec3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vec3 cross3(const Vec3& a, const Vec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// From the origin.
Real squared_to_segment(const Vec3& a, const Vec3& b) {
  const Vec3 along = minus(b, a);
  const Real squared = dot3(along, along);
  if (squared == 0) return dot3(a, a);
  const Real where = std::clamp<Real>(-dot3(a, along) / squared, 0, 1);
  const Vec3 p{a[0] + along[0] * where, a[1] + along[1] * where, a[2] + along[2] * where};
  return dot3(p, p);
}

/// From the origin, if the foot of the perpendicular is inside.
std::optional<Real> squared_to_triangle(const Vec3& a, const Vec3& b, const Vec3& c,
                                        const Vec3& normal) {
  const auto edge_keeps = [&](const Vec3& p,
                              const Vec3& q) {  // the foot is on the inner side of p q
    return dot3(cross3(minus(q, p), Vec3{-p[0], -p[1], -p[2]}), normal) >= 0;
  };
  if (!edge_keeps(a, b) || !edge_keeps(b, c) || !edge_keeps(c, a)) return std::nullopt;
  const Real height = dot3(normal, a);
  return height * height / dot3(normal, normal);
}

/// The radius of the largest ball about the origin in the hull, or minus its distance from the
/// hull.
Real margin(const std::vector<Vec3>& w) {
  // If the origin is outside, the hull's nearest point is in a triangle of wrenches.
  Real nearest = dot3(w[0], w[0]);
  for (std::size_t i = 0; i < w.size(); ++i)
    for (std::size_t j = i + 1; j < w.size(); ++j)
      nearest = std::min(nearest, squared_to_segment(w[i], w[j]));
  // A triangle with all wrenches on one side is (part of) a facet.
  bool inside = w.size() >= 4;
  bool any = false;
  Real least = 0;
  for (std::size_t i = 0; i < w.size(); ++i) {
    for (std::size_t j = i + 1; j < w.size(); ++j) {
      for (std::size_t k = j + 1; k < w.size(); ++k) {
        const Vec3 normal = cross3(minus(w[j], w[i]), minus(w[k], w[i]));
        const Real size = sqrt(dot3(normal, normal));
        if (size < Real("1e-60")) continue;  // collinear, or two coincide
        if (const auto d = squared_to_triangle(w[i], w[j], w[k], normal))
          nearest = std::min(nearest, *d);
        const Real height = dot3(normal, w[i]) / size;
        bool above = false, below = false;
        for (const Vec3& p : w) {
          const Real h = dot3(normal, p) / size - height;
          above = above || h > Real("1e-60");
          below = below || h < -Real("1e-60");
        }
        if (above && below) continue;
        if (!above && !below) inside = false;  // all in one plane: no room for a ball
        const Real room = above ? Real(-height) : height;
        if (!any || room < least) least = room;
        any = true;
      }
    }
  }
  inside = inside && any && least >= 0;
  return inside ? least : Real(-sqrt(nearest));
}

std::vector<Vec3> wrenches_of(const std::vector<Contact>& contacts, const Real& radius) {
  std::vector<Vec3> wrenches;
  for (const Contact& c : contacts)
    wrenches.push_back({c.normal.x, c.normal.y, cross(c.at, c.normal) / radius});
  return wrenches;
}

/// By definition.
void find_clearance(const std::vector<Contact>& contacts, const Real& radius, Closure& result) {
  std::optional<Real> clearance = Real(0);
  // Contacts equally far except for rounding give the same set.
  std::vector<Real> looked_at;
  const auto is_new = [&](const Real& far) {
    return std::none_of(looked_at.begin(), looked_at.end(), [&](const Real& other) {
      return abs(far - other) <= Real("1e-28") * abs(other);
    });
  };
  for (const Contact& nearest : contacts) {
    const std::optional<Real>& far = nearest.to_corner;
    const Real least = far ? Real(*far * (1 - Real("1e-29"))) : Real(-1);
    if (!is_new(least)) continue;
    looked_at.push_back(least);
    std::vector<Contact> counted;
    for (const Contact& c : contacts)
      if (!c.to_corner || (far && *c.to_corner >= least)) counted.push_back(c);
    const Real m = margin(wrenches_of(counted, radius));
    // The core decides within the tolerance.
    if (abs(m) < 100 * tau) result.clearance_is_unsure = true;
    if (m <= 0) continue;
    if (!far || !clearance)
      clearance.reset();
    else
      clearance = std::max(*clearance, *far);
  }
  result.clearance =
      clearance ? static_cast<double>(*clearance) : std::numeric_limits<double>::infinity();
}

/// The greatest distance of a wrench that the robot may have if it is off by up to `error` from
/// those that it may have on its own edge.
Real greatest_change(const std::vector<RealVec>& vertices, const Contact& contact,
                     const Real& radius, const Real& error) {
  const std::size_t n = vertices.size();
  const Vec3 own = wrenches_of({contact}, radius)[0];
  Real greatest = 0;
  const auto look_at = [&](const RealVec& at, std::size_t edge) {
    const RealVec along = vertices[(edge + 1) % n] - vertices[edge];
    const RealVec normal = RealVec{-along.y, along.x} * (1 / length(along));
    const Real turn = cross(at, normal) / radius - own[2];
    const Real beyond = std::max(Real(0), Real(abs(turn) - error / radius));
    const RealVec other = normal - RealVec{own[0], own[1]};
    greatest = std::max(greatest, Real(sqrt(dot(other, other) + beyond * beyond)));
  };
  for (const bool on : {true, false}) {
    RealVec at = contact.at;
    Real left = error;
    std::size_t edge = contact.edge_number;
    for (std::size_t passed = 0; passed < n && left >= 0; ++passed) {
      const RealVec end = vertices[on ? (edge + 1) % n : edge];
      const Real way = length(end - at);
      look_at(at, edge);
      look_at(way <= left ? end : RealVec(at + (end - at) * (left / way)), edge);
      left -= way;
      at = end;
      edge = (edge + (on ? 1 : n - 1)) % n;
    }
  }
  return greatest;
}

/// By definition: for some x the contacts that change by at most x have a margin above x, in both
/// senses.
bool hold_within(const std::vector<RealVec>& vertices, const std::vector<Contact>& contacts,
                 const Real& radius, const Real& error) {
  std::vector<std::pair<Real, Contact>> kept;
  for (const Contact& contact : contacts)
    if (!contact.to_corner || *contact.to_corner > error)
      kept.emplace_back(
          contact.in_notch ? Real(0) : greatest_change(vertices, contact, radius, error), contact);
  for (const auto& [change, nearest] : kept) {
    if (change >= 1) continue;  // no margin is greater
    Real least = 1;
    for (const int sense : {1, -1}) {
      std::vector<Vec3> moved;
      for (const auto& [other, contact] : kept) {
        if (other > change) continue;
        moved.push_back(wrenches_of({contact}, radius)[0]);
        if (!contact.in_notch) moved.back()[2] += sense * error / radius;
      }
      least = std::min(least, margin(moved));
      if (least <= change) break;
    }
    if (least > change) return true;
  }
  return false;
}

}  // namespace

Closure immobilization(const ExactShape& shape, const std::vector<RealVec>& lifting_points) {
  Closure result;
  Calls calls;
  const std::vector<Contact> contacts =
      contacts_of(shape, lifting_points, calls, result.clearance_is_unsure);
  result.contacts = contacts.size();
  if (contacts.empty()) {
    result.closest_call = calls.closest();
    return result;
  }
  const std::vector<Balance> exact_balances = balances(with_border(contacts), false, calls);
  const Real tolerance = tau * shape.size;
  result.translation = translation_is_free(contacts, calls);
  const Real reach = shape.size / (result.translation ? Real(sqrt(Real(tau))) : Real(tau));
  bool degenerate = true;  // no region has an area
  std::vector<Region> open;
  for (int side : {1, -1}) {
    const Region r = region(contacts, exact_balances, reach, side);
    const bool free = !r.widening || calls.within(*r.widening, tolerance, "free region is empty");
    if (free) {
      open.push_back(r);
      if (!r.widening || !calls.within(-*r.widening, tolerance, "free region has an area"))
        degenerate = false;
    }
    (side == 1 ? result.counterclockwise : result.clockwise) = free;
  }
  result.form_closure = !result.counterclockwise && !result.clockwise && !result.translation;

  if (!result.form_closure && !result.translation && degenerate) {
    result.second_order = true;
    for (const Region& r : open)
      result.second_order = result.second_order && immobile_in(contacts, r, shape.size, calls);
  }

  for (const Contact& a : contacts)
    for (const Contact& b : contacts)
      if (const Real sine = abs(cross(a.normal, b.normal));
          sine > tau && dot(a.normal, b.normal) < 0)
        result.flattest_crossing = std::min(result.flattest_crossing, static_cast<double>(sine));

  Real radius = 0;  // R
  for (const RealVec& v : shape.real_vertices) radius = std::max(radius, length(v));
  result.margin = static_cast<double>(margin(wrenches_of(contacts, radius)));
  if (result.form_closure) {
    find_clearance(contacts, radius, result);
    result.hold_within = [vertices = shape.real_vertices, contacts, radius](double error) {
      return hold_within(vertices, contacts, radius, error);
    };
  }
  result.closest_call = calls.closest();
  return result;
}

Closure immobilization(const Problem& problem, const std::vector<Point>& lifting_points) {
  const std::shared_ptr<const ExactShape> shape = exact_shape(problem);
  std::vector<RealVec> points;
  for (const Point& p : lifting_points) points.push_back(real(exact(p) - shape->centre));
  return immobilization(*shape, points);
}

}  // namespace oracle
