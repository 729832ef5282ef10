#include "curves/outline.h"

#include <algorithm>
#include <cmath>

namespace evenlift {
namespace {

// The tangent of 22.5 degrees: the bulge of a quarter of a circle.
const double quarter_bulge = std::sqrt(2.0) - 1;
const double quarter_weight = std::sqrt(0.5);

Vec2 middle(const Vec2& a, const Vec2& b) { return a + (b - a) / 2; }

// An arc of at most 90 degrees.
void add_short_bulge(Outline& outline, const Vec2& end, double bulge) {
  const Vec2 chord = end - outline.end();
  const double square = bulge * bulge;
  // The tangents meet beside the middle of the chord, bulge / (1 - square) of its length away, on
  // the right of a counter-clockwise arc.
  const Vec2 corner = middle(outline.end(), end) - left_normal(chord) * (bulge / (1 - square));
  outline.pieces.push_back(
      {CurvePiece::Kind::conic, end, corner, Vec2{}, (1 - square) / (1 + square)});
}

void add_bulge(Outline& outline, const Vec2& end, double bulge) {
  if (std::abs(bulge) <= quarter_bulge) return add_short_bulge(outline, end, bulge);
  const Vec2 chord = end - outline.end();
  const Vec2 half_way = middle(outline.end(), end) - left_normal(chord) * (bulge / 2);
  // tan(t / 2) = 1 / (c + sqrt(1 + c^2)) with c = 1 / tan t, where no part can overflow. The first
  // step gives at most 1 and the second at most the bulge of a quarter.
  const double inverse = 1 / bulge;
  const double half = 1 / (inverse + std::copysign(std::sqrt(1 + inverse * inverse), bulge));
  add_bulge(outline, half_way, half);
  add_bulge(outline, end, half);
}

Vec2 quarter_turn(const Vec2& a, bool counterclockwise) {
  return counterclockwise ? left_normal(a) : -left_normal(a);
}

}  // namespace

Affine Affine::operator*(const Affine& inner) const {
  return {a * inner.a + c * inner.b, b * inner.a + d * inner.b,     a * inner.c + c * inner.d,
          b * inner.c + d * inner.d, a * inner.e + c * inner.f + e, b * inner.e + d * inner.f + f};
}

bool Outline::curved() const {
  return std::any_of(pieces.begin(), pieces.end(),
                     [](const CurvePiece& piece) { return piece.kind != CurvePiece::Kind::line; });
}

void Outline::line_to(const Vec2& to) { pieces.push_back({CurvePiece::Kind::line, to}); }

void Outline::quadratic_to(const Vec2& control, const Vec2& to) {
  pieces.push_back({CurvePiece::Kind::conic, to, control});
}

void Outline::cubic_to(const Vec2& first, const Vec2& second, const Vec2& to) {
  pieces.push_back({CurvePiece::Kind::cubic, to, first, second});
}

void Outline::quarter_to(const Vec2& corner, const Vec2& to) {
  pieces.push_back({CurvePiece::Kind::conic, to, corner, Vec2{}, quarter_weight});
}

void Outline::bulge_to(const Vec2& to, double bulge) {
  if (bulge == 0) return line_to(to);
  add_bulge(*this, to, bulge);
}

void Outline::arc_to(const Affine& frame, const Vec2& from, const Vec2& to, bool counterclockwise,
                     bool large, const Vec2& last) {
  // Full quarters first, then the rest. The flag and one sign determine the number of quarters, so
  // that rounding cannot turn a nearly empty arc into a full turn.
  Vec2 at = from;
  int quarters = large ? 2 : 0;
  const Vec2 rest_from = large ? Vec2(-from) : from;
  if (dot(rest_from, to) < 0) ++quarters;
  for (int i = 0; i < quarters; ++i) {
    const Vec2 next = quarter_turn(at, counterclockwise);
    quarter_to(frame(at + next), frame(next));
    at = next;
  }
  const double cosine = std::clamp(dot(at, to), 0.0, 1.0);
  pieces.push_back({CurvePiece::Kind::conic, last, frame((at + to) / (1 + cosine)), Vec2{},
                    std::sqrt((1 + cosine) / 2)});
}

Outline Outline::ellipse(const Affine& frame) {
  Outline outline;
  Vec2 at(1, 0);
  outline.start = frame(at);
  for (int i = 0; i < 4; ++i) {
    const Vec2 next = left_normal(at);
    outline.quarter_to(frame(at + next), i == 3 ? outline.start : frame(next));
    at = next;
  }
  return outline;
}

Outline reversed(const Outline& outline) {
  Outline turned;
  turned.start = outline.end();
  turned.pieces.reserve(outline.pieces.size());
  for (std::size_t i = outline.pieces.size(); i-- > 0;) {
    CurvePiece piece = outline.pieces[i];
    if (piece.kind == CurvePiece::Kind::cubic) std::swap(piece.first, piece.second);
    piece.end = i == 0 ? outline.start : outline.pieces[i - 1].end;
    turned.pieces.push_back(piece);
  }
  return turned;
}

Outline transformed(const Outline& outline, const Affine& map) {
  Outline image = outline;
  image.start = map(image.start);
  for (CurvePiece& piece : image.pieces) {
    piece.end = map(piece.end);
    piece.first = map(piece.first);
    piece.second = map(piece.second);
  }
  return image;
}

Box control_box(const Outline& outline) {
  Points points = {outline.start};
  for (const CurvePiece& piece : outline.pieces) {
    points.push_back(piece.end);
    if (piece.kind != CurvePiece::Kind::line) points.push_back(piece.first);
    if (piece.kind == CurvePiece::Kind::cubic) points.push_back(piece.second);
  }
  return bounding_box(points);
}

// --- A curve is halved until an upper bound of the distance of its points from its chord, a segment,
// is within the tolerance:
//   conic  a point is s of the way from a point of the chord to the control point; s is at most
//          w / (1 + w), where the chord's point is its middle
//   cubic  B(t) - L(t) = 3 t (1 - t)^2 d1 + 3 t^2 (1 - t) d2, where L moves uniformly along the
//          chord, and d1, d2 are the control points' offsets from L(1/3), L(2/3); so at most 3/4
//          of the longer offset
// If all control points lie beside the chord, not beyond its ends, the components of these
// distances along the chord do not count.

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
