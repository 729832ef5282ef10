#include "selection/growing_base.h"

#include <algorithm>
#include <utility>

#include "evenlift/hull.h"
#include "evenlift/plane.h"
#include "evenlift/predicates.h"
#include "polygon/straight_corner.h"

namespace evenlift {
namespace {

// From here on it pays to change only a few edges.
constexpr std::size_t many_corners = 64;

}  // namespace

Points GrowingBase::positions() const {
  Points positions;
  positions.reserve(size_);
  for (Corner corner = first_; positions.size() < size_; corner = next(corner))
    positions.push_back(position(corner));
  return positions;
}

bool GrowingBase::is_near(const Vec2& p, double distance) const {
  Corner corner = first_;
  for (std::size_t i = 0; i < size_; ++i, corner = next(corner))
    if (distance_to_segment(position(corner), position(next(corner)), p) <= distance) return true;
  return false;
}

std::vector<GrowingBase::Corner> GrowingBase::add(const Added& p, const Added& q) {
  if (size_ >= many_corners)
    if (auto starts = add_locally(p, q)) return *std::move(starts);
  return replace(widen_hull(positions(), p.position, q.position, flat_));
}

double GrowingBase::side(Corner edge, const Vec2& p) const {
  return orient(position(edge), position(next(edge)), p);
}

bool GrowingBase::is_straight(const Vec2& before, Corner corner, const Vec2& after) const {
  return is_straight_corner(before, position(corner), after, flat_);
}

// nullopt if neither an edge that p is beyond nor a triangle from C to an edge with p in it is
// found, or if rounding may be what makes a corner next to p: then the whole hull matters.
std::optional<GrowingBase::Gap> GrowingBase::gap_for(const Added& added) const {
  if (!added.edge || !has(*added.edge)) return std::nullopt;
  const Vec2& p = added.position;
  const Corner edge = *added.edge;
  const Corner edges[] = {edge, next(edge), corners_[edge].previous};
  for (const Corner e : edges)
    if (side(e, p) < 0) return widest_gap(e, p);
  const auto is_seen_in = [&](Corner e) {
    const Vec2 &h1 = position(e), &h2 = position(next(e)), centre{};
    return orient(h1, h2, centre) > 0 && orient(centre, h1, p) >= 0 && orient(centre, h2, p) <= 0;
  };
  if (std::any_of(std::begin(edges), std::end(edges), is_seen_in)) return Gap{true};
  return std::nullopt;
}

std::optional<GrowingBase::Gap> GrowingBase::widest_gap(Corner visible, const Vec2& p) const {
  if (is_straight_corner(position(visible), p, position(next(visible)), flat_)) return Gap{true};
  // The edges that p is beyond or in line with.
  std::size_t number = 1;
  Corner before = visible, after = next(visible);
  const auto previous = [&](Corner corner) { return corners_[corner].previous; };
  for (; number < size_ && side(previous(before), p) <= 0; ++number) before = previous(before);
  for (; number < size_ && side(after, p) <= 0; ++number) after = next(after);
  if (number + 2 > size_) return std::nullopt;
  // Rounding alone may now explain one corner on either side. Only the whole hull shows whether
  // several such corners are one run.
  if (is_straight(p, after, position(next(after)))) after = next(after);
  if (is_straight(position(previous(before)), before, p)) before = previous(before);
  if (is_straight(p, after, position(next(after))) ||
      is_straight(position(previous(before)), before, p) ||
      is_straight_corner(position(before), p, position(after), flat_))
    return std::nullopt;
  return Gap{false, before, after};
}

void GrowingBase::link(Corner from, Corner to) {
  corners_[from].next = to;
  corners_[to].previous = from;
}

// Puts p in its gap, in place of the corners there.
GrowingBase::Put GrowingBase::put(const Vec2& p, const Gap& gap) {
  const Put done{gap, next(gap.before), corners_[gap.after].previous, first_, size_};
  const auto corner = static_cast<Corner>(corners_.size());
  for (Corner out = done.next; out != gap.after; out = next(out), --size_)
    corners_[out].in_ring = false;
  corners_.push_back({p});
  ++size_;
  link(gap.before, corner);
  link(corner, gap.after);
  if (!has(first_)) first_ = corner;  // a straight corner, which is beside p
  for (const Corner other : {gap.before, corner, gap.after})
    if (lexicographically_before(position(other), position(first_))) first_ = other;
  return done;
}

void GrowingBase::take_out(const Put& put) {
  corners_.pop_back();
  corners_[put.gap.before].next = put.next;
  corners_[put.gap.after].previous = put.previous;
  for (Corner back = put.next; back != put.gap.after; back = next(back))
    corners_[back].in_ring = true;
  first_ = put.first;
  size_ = put.size;
}

std::optional<std::vector<GrowingBase::Corner>> GrowingBase::add_locally(const Added& p,
                                                                         const Added& q) {
  std::vector<Corner> starts;
  std::optional<Put> undo;
  for (const Added& added : {p, q}) {
    const auto gap = gap_for(added);
    if (!gap) {
      if (undo) take_out(*undo);
      return std::nullopt;
    }
    if (gap->inside) continue;
    starts.insert(starts.end(), {gap->before, static_cast<Corner>(corners_.size())});
    undo = put(added.position, *gap);
  }
  std::erase_if(starts, [&](Corner corner) { return !has(corner); });
  std::sort(starts.begin(), starts.end(), [&](Corner a, Corner b) {
    if (a == first_ || b == first_) return a == first_ && b != first_;
    return orient(position(first_), position(a), position(b)) > 0;
  });
  starts.erase(std::unique(starts.begin(), starts.end()), starts.end());
  return starts;
}

// Corners that stay have the same order in both hulls, and at most two are new. Each search starts
// at the last corner found: O(h) in all.
std::vector<GrowingBase::Corner> GrowingBase::replace(const Points& positions) {
  if (positions == this->positions()) return {};
  std::vector<Corner> old, now;
  std::vector<std::optional<Corner>> next_before;  // of each corner now, if it stays
  for (Corner corner = first_; old.size() < size_; corner = next(corner)) old.push_back(corner);
  for (const Corner corner : old) corners_[corner].in_ring = false;
  std::size_t found = 0;
  for (const Vec2& position : positions) {
    std::size_t steps = 0;
    const auto at = [&](std::size_t i) { return old[(found + i) % old.size()]; };
    while (steps < old.size() && this->position(at(steps)) != position) ++steps;
    if (steps == old.size()) {
      now.push_back(static_cast<Corner>(corners_.size()));
      next_before.push_back(std::nullopt);
      corners_.push_back({position});
      continue;
    }
    found = (found + steps) % old.size();
    now.push_back(old[found]);
    next_before.push_back(next(old[found]));
    corners_[old[found]].in_ring = true;
  }
  first_ = now.front();
  size_ = now.size();
  std::vector<Corner> starts;
  for (std::size_t i = 0; i < now.size(); ++i) {
    const Corner following = now[(i + 1) % now.size()];
    // The sides of a segment never stay, since points on its line follow a special rule.
    if (old.size() <= 2 || next_before[i] != following) starts.push_back(now[i]);
    link(now[i], following);
  }
  return starts;
}

}  // namespace evenlift
