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

}  // namespace evenlift
