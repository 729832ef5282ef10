// A curve is halved until an upper bound of the distance of its points from its chord, a segment,
// is within the tolerance:
//   conic  a point is s of the way from a point of the chord to the control point; s is at most
//          w / (1 + w), where the chord's point is its middle
//   cubic  B(t) - L(t) = 3 t (1 - t)^2 d1 + 3 t^2 (1 - t) d2, where L moves uniformly along the
//          chord, and d1, d2 are the control points' offsets from L(1/3), L(2/3); so at most 3/4
//          of the longer offset
// If all control points lie beside the chord, not beyond its ends, the components of these
// distances along the chord do not count.
#include <cmath>

#include "curves/outline.h"

namespace evenlift {
namespace {

// 2^20 parts: the maximum number of vertices of a polygon.
constexpr int most_halvings = 20;

double square(const Vec2& a) { return dot(a, a); }

class Flattener {
 public:
  Flattener(const Vec2& start, double tolerance, std::size_t most)
      : points_{start}, square_(tolerance * tolerance), most_(most) {}

  void add(const CurvePiece& piece) {
    from_ = points_.back();
    if (piece.kind == CurvePiece::Kind::cubic)
      cubic(from_, piece.first, piece.second, piece.end, 0);
    else if (piece.kind == CurvePiece::Kind::conic)
      conic(from_, piece.first, piece.weight, piece.end, 0);
    else
      take(piece.end);
  }
  bool full() const { return full_; }
  Points take_points() { return std::move(points_); }

 private:
  void take(const Vec2& point) {
    if (point == points_.back()) return;
    if (points_.size() >= most_)
      full_ = true;
    else
      points_.push_back(point);
  }

  // The square of the distance of c from the chord, if c lies beside it.
  struct Beside {
    bool beside;
    double square;
  };
  static Beside from_chord(const Vec2& a, const Vec2& b, const Vec2& c) {
    const Vec2 chord = b - a;
    const double length_square = square(chord), along = dot(c - a, chord);
    if (!(along >= 0 && along <= length_square) || length_square == 0) return {false, 0};
    const double across = cross(chord, c - a);
    return {true, across * across / length_square};
  }

  bool conic_is_near(const Vec2& a, const Vec2& c, double w, const Vec2& b) const {
    const Beside normal = from_chord(a, b, c);
    const double distance = normal.beside ? normal.square : square(c - (a + (b - a) / 2));
    const double part = w / (1 + w);
    return part * part * distance <= square_;
  }

  bool cubic_is_near(const Vec2& a, const Vec2& c, const Vec2& d, const Vec2& b) const {
    const Beside first = from_chord(a, b, c), second = from_chord(a, b, d);
    double distance;
    if (first.beside && second.beside)
      distance = std::max(first.square, second.square);
    else
      distance = std::max(square(c - (a + (b - a) / 3)), square(d - (b + (a - b) / 3)));
    return 9 * distance <= 16 * square_;
  }

  void conic(const Vec2& a, const Vec2& c, double w, const Vec2& b, int depth) {
    if (full_) return;
    if (depth == most_halvings || conic_is_near(a, c, w, b)) return take(b);
    const Vec2 left = (a + w * c) / (1 + w), right = (w * c + b) / (1 + w);
    const Vec2 split = left + (right - left) / 2;
    const double half = std::sqrt((1 + w) / 2);
    conic(a, left, half, split, depth + 1);
    conic(split, right, half, b, depth + 1);
  }

  void cubic(const Vec2& a, const Vec2& c, const Vec2& d, const Vec2& b, int depth) {
    if (full_) return;
    if (depth == most_halvings || cubic_is_near(a, c, d, b)) return take(b);
    const Vec2 ac = (a + c) / 2, cd = (c + d) / 2, db = (d + b) / 2;
    const Vec2 left = (ac + cd) / 2, right = (cd + db) / 2, split = (left + right) / 2;
    cubic(a, ac, left, split, depth + 1);
    cubic(split, right, db, b, depth + 1);
  }

  Points points_;
  Vec2 from_;
  double square_;
  std::size_t most_;
  bool full_ = false;
};

}  // namespace

std::optional<Points> flatten(const Outline& outline, double tolerance, std::size_t most) {
  Flattener flattener(outline.start, tolerance, most);
  for (const CurvePiece& piece : outline.pieces) {
    flattener.add(piece);
    if (flattener.full()) return std::nullopt;
  }
  return flattener.take_points();
}

}  // namespace evenlift
