#include "import/svg_values.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "evenlift/angles.h"
#include "evenlift/document.h"
#include "numbers/number_text.h"
#include "numbers/text_cursor.h"

namespace evenlift {
namespace {

bool is_separator(char c) { return is_space_in_line(c) || ends_line(c) || c == ',' || c == '\f'; }

std::string_view without_separators(std::string_view text) {
  while (!text.empty() && is_separator(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_separator(text.back())) text.remove_suffix(1);
  return text;
}

// Quarter turns are exact, because they are by far the most common.
double exact_or(double degrees, double at_0, double at_90, double at_180, double at_270,
                double (*function)(double)) {
  double turn = std::fmod(degrees, 360);
  if (turn < 0) turn += 360;
  if (turn == 0) return at_0;
  if (turn == 90) return at_90;
  if (turn == 180) return at_180;
  if (turn == 270) return at_270;
  return function(turn * (pi / 180));
}
double sine_of_degrees(double degrees) { return exact_or(degrees, 0, 1, 0, -1, sine); }
double cosine_of_degrees(double degrees) { return exact_or(degrees, 1, 0, -1, 0, cosine); }

Affine rotation(double degrees) {
  const double c = cosine_of_degrees(degrees), s = sine_of_degrees(degrees);
  return {c, s, -s, c, 0, 0};
}

std::optional<Affine> transform_of(std::string_view name, const std::vector<double>& v) {
  const std::size_t n = v.size();
  if (name == "matrix" && n == 6) return Affine{v[0], v[1], v[2], v[3], v[4], v[5]};
  if (name == "translate" && (n == 1 || n == 2)) return Affine{1, 0, 0, 1, v[0], n == 2 ? v[1] : 0};
  if (name == "scale" && (n == 1 || n == 2)) return Affine{v[0], 0, 0, v[n - 1], 0, 0};
  if (name == "rotate" && n == 1) return rotation(v[0]);
  if (name == "rotate" && n == 3)
    return Affine{1, 0, 0, 1, v[1], v[2]} * rotation(v[0]) * Affine{1, 0, 0, 1, -v[1], -v[2]};
  const bool skew_x = name == "skewX";
  if ((skew_x || name == "skewY") && n == 1) {
    const double tangent = sine_of_degrees(v[0]) / cosine_of_degrees(v[0]);
    return skew_x ? Affine{1, 0, tangent, 1, 0, 0} : Affine{1, tangent, 0, 1, 0, 0};
  }
  return std::nullopt;
}

std::string at_character(std::size_t offset, const char* what) {
  return "character " + std::to_string(offset + 1) + ": " + what;
}

// Reads a path from front to back, one command after another.
class PathReader {
 public:
  explicit PathReader(std::string_view text) : text_(text) {}
  SvgResult<std::vector<SvgOutline>> read();

 private:
  void skip_separators() {
    while (at_ < text_.size() && is_separator(text_[at_])) ++at_;
  }
  bool number(double& value);
  bool flag(bool& value);
  bool numbers(double* values, std::size_t count) {
    return std::all_of(values, values + count, [&](double& value) { return number(value); });
  }
  bool sees_more() {
    skip_separators();
    return at_ < text_.size() && scan_number(text_.substr(at_)).length > 0;
  }
  bool fail(const char* what) {
    problem_ = at_character(at_, what);
    return false;
  }

  // A path with more parts has more vertices than allowed.
  bool has_room() {
    return ++parts_ <= 2 * max_vertices || fail("the path has more than 1048576 vertices");
  }

  bool command(char letter);
  bool move(bool relative);
  bool piece(char lower, bool relative);
  bool segment(char lower, const Vec2& from, Vec2& control);
  bool line(char lower, const Vec2& from);
  bool cubic(char lower, const Vec2& from, Vec2& control);
  bool quadratic(char lower, const Vec2& from, Vec2& control);
  bool arc(const Vec2& from);
  Outline& outline() { return outlines_.back().outline; }
  Vec2 absolute(double x, double y) const { return origin_ + Vec2(x, y); }

  std::string_view text_;
  std::size_t at_ = 0;
  std::vector<SvgOutline> outlines_;
  Vec2 position_ = Vec2::Zero(), origin_ = Vec2::Zero();  // the origin of a command's coordinates
  bool open_ = false;                                     // an outline has begun
  char last_ = 0;                                         // the last command, in lower case
  Vec2 last_control_ = Vec2::Zero();
  std::size_t parts_ = 0;
  std::string problem_;
};

bool PathReader::number(double& value) {
  skip_separators();
  const ScannedNumber scanned = scan_number(text_.substr(at_));
  if (scanned.kind == ScannedNumber::Kind::none) return fail("expected a number here");
  if (scanned.kind == ScannedNumber::Kind::too_large) return fail("the number is too large");
  value = scanned.value;
  at_ += scanned.length;
  return true;
}

// One character: the next number may follow immediately.
bool PathReader::flag(bool& value) {
  skip_separators();
  if (at_ == text_.size() || (text_[at_] != '0' && text_[at_] != '1'))
    return fail("expected 0 or 1 here");
  value = text_[at_++] == '1';
  return true;
}

bool PathReader::move(bool relative) {
  double to[2];
  if (!numbers(to, 2) || !has_room()) return false;
  origin_ = relative ? position_ : Vec2(Vec2::Zero());
  position_ = absolute(to[0], to[1]);
  outlines_.push_back({{position_, {}}, false});
  open_ = true;
  return true;
}

bool PathReader::arc(const Vec2& from) {
  double v[3], to[2];
  bool large, sweep;
  if (!numbers(v, 3) || !flag(large) || !flag(sweep) || !numbers(to, 2)) return false;
  const Vec2 end = absolute(to[0], to[1]);
  double rx = std::abs(v[0]), ry = std::abs(v[1]);
  if (end == from) return true;  // as the standard says
  if (rx == 0 || ry == 0) {
    outline().line_to(end);
    return true;
  }
  // SVG 1.1, F.6.5, in coordinates in which the ellipse is the unit circle.
  const Affine turn = rotation(v[2]);
  const Vec2 half = (from - end) / 2;
  Vec2 h((turn.a * half.x() + turn.b * half.y()) / rx,
         (turn.c * half.x() + turn.d * half.y()) / ry);
  const double size = length(h);
  if (size > 1) {  // the ellipse is too small to reach both ends: it grows
    rx *= size;
    ry *= size;
    h /= size;
  }
  const double squared = dot(h, h);
  const double away = std::sqrt(std::max(0.0, (1 - squared) / squared));
  const Vec2 centre = (large == sweep ? -away : away) * Vec2(h.y(), -h.x());
  const Affine frame = Affine{1, 0, 0, 1, (from.x() + end.x()) / 2, (from.y() + end.y()) / 2} *
                       turn * Affine{rx, 0, 0, ry, rx * centre.x(), ry * centre.y()};
  outline().arc_to(frame, h - centre, -h - centre, sweep, large, end);
  return true;
}

// L, H or V.
bool PathReader::line(char lower, const Vec2& from) {
  double v[2] = {};
  if (!numbers(v, lower == 'l' ? 2 : 1)) return false;
  outline().line_to(lower == 'l'   ? absolute(v[0], v[1])
                    : lower == 'h' ? Vec2(origin_.x() + v[0], from.y())
                                   : Vec2(from.x(), origin_.y() + v[0]));
  return true;
}

// C, or S, whose first control point mirrors the last one.
bool PathReader::cubic(char lower, const Vec2& from, Vec2& control) {
  double v[6] = {};
  const std::size_t skipped = lower == 's' ? 2 : 0;
  if (!numbers(v + skipped, 6 - skipped)) return false;
  const bool follows = last_ == 'c' || last_ == 's';
  const Vec2 first = lower == 'c' ? absolute(v[0], v[1])
                     : follows    ? Vec2(2 * from - last_control_)
                                  : from;
  control = absolute(v[2], v[3]);
  outline().cubic_to(first, control, absolute(v[4], v[5]));
  return true;
}

// Q, or T, whose control point mirrors the last one.
bool PathReader::quadratic(char lower, const Vec2& from, Vec2& control) {
  double v[4] = {};
  const std::size_t skipped = lower == 't' ? 2 : 0;
  if (!numbers(v + skipped, 4 - skipped)) return false;
  if (lower == 'q')
    control = absolute(v[0], v[1]);
  else if (last_ == 'q' || last_ == 't')
    control = 2 * from - last_control_;
  outline().quadratic_to(control, absolute(v[2], v[3]));
  return true;
}

// `control` becomes the last control point if the segment has one.
bool PathReader::segment(char lower, const Vec2& from, Vec2& control) {
  switch (lower) {
    case 'l':
    case 'h':
    case 'v':
      return line(lower, from);
    case 'c':
    case 's':
      return cubic(lower, from, control);
    case 'q':
    case 't':
      return quadratic(lower, from, control);
    default:
      return arc(from);
  }
}

// One segment of a command, whose letter is in lower case.
bool PathReader::piece(char lower, bool relative) {
  if (!has_room()) return false;
  if (!open_) {  // after Z the next outline begins at the start of the last one
    outlines_.push_back({{position_, {}}, false});
    open_ = true;
  }
  const Vec2 from = position_;
  origin_ = relative ? from : Vec2(Vec2::Zero());
  Vec2 control = from;
  if (!segment(lower, from, control)) return false;
  position_ = outline().end();
  last_control_ = control;
  last_ = lower;
  return true;
}

bool PathReader::command(char letter) {
  const char lower = lower_case(letter);
  const bool relative = letter == lower;
  if (lower == 'z') {
    if (open_) {
      outlines_.back().closed = true;
      position_ = outline().start;
    }
    open_ = false;
    last_ = lower;
    return true;
  }
  if (lower == 'm') {
    if (!move(relative)) return false;
    last_ = lower;
    while (sees_more())
      if (!piece('l', relative)) return false;
    return true;
  }
  do {
    if (!piece(lower, relative)) return false;
  } while (sees_more());
  return true;
}

SvgResult<std::vector<SvgOutline>> PathReader::read() {
  for (skip_separators(); at_ < text_.size(); skip_separators()) {
    const char letter = text_[at_];
    constexpr std::string_view letters = "mzlhvcsqta";
    const bool known = letters.find(lower_case(letter)) != std::string_view::npos;
    if (!known || (outlines_.empty() && lower_case(letter) != 'm')) {
      fail(outlines_.empty() ? "a path must begin with M" : "expected a command here");
      return SvgProblem{problem_};
    }
    ++at_;
    if (!command(letter)) return SvgProblem{problem_};
  }
  return std::move(outlines_);
}

}  // namespace

SvgResult<std::vector<double>> svg_numbers(std::string_view text) {
  std::vector<double> values;
  for (std::size_t at = 0;;) {
    while (at < text.size() && is_separator(text[at])) ++at;
    if (at == text.size()) return values;
    const ScannedNumber number = scan_number(text.substr(at));
    if (number.kind != ScannedNumber::Kind::finite)
      return SvgProblem{
          at_character(at, number.length > 0 ? "the number is too large" : "not a number")};
    values.push_back(number.value);
    at += number.length;
  }
}

SvgResult<std::optional<double>> svg_length(std::string_view text) {
  text = without_separators(text);
  if (text.empty() || text == "auto") return std::optional<double>();
  const ScannedNumber number = scan_number(text);
  if (number.kind != ScannedNumber::Kind::finite)
    return SvgProblem{"\"" + std::string(text.substr(0, 20)) + "\" is not a length"};
  // In CSS an inch has 96 px.
  constexpr std::pair<std::string_view, double> units[] = {
      {"", 1},    {"px", 1},         {"mm", 96 / 25.4}, {"cm", 96 / 2.54},
      {"in", 96}, {"pt", 96.0 / 72}, {"pc", 16}};
  const std::string_view unit = without_separators(text.substr(number.length));
  for (const auto& [name, size] : units)
    if (same_word(unit, name)) return std::optional<double>(number.value * size);
  return SvgProblem{"the unit of \"" + std::string(text.substr(0, 20)) +
                    "\" is unknown to evenlift"};
}

SvgResult<Affine> svg_transform(std::string_view text) {
  Affine whole;
  for (text = without_separators(text); !text.empty(); text = without_separators(text)) {
    std::size_t letters = 0;
    while (letters < text.size() && is_letter(text[letters])) ++letters;
    const std::string_view name = text.substr(0, letters);
    const std::size_t open = text.find_first_not_of(" \t\r\n", letters);
    const std::size_t close = text.find(')');
    const auto refused = [&] {
      return SvgProblem{"the transform \"" +
                        std::string(text.substr(0, std::min<std::size_t>(close, 60))) +
                        (close < 60 ? ")" : "") + "\" is not understood"};
    };
    if (open == std::string_view::npos || text[open] != '(' || close == std::string_view::npos ||
        close < open)
      return refused();
    const auto values = svg_numbers(text.substr(open + 1, close - open - 1));
    if (std::holds_alternative<SvgProblem>(values)) return refused();
    const std::optional<Affine> next = transform_of(name, *std::get_if<0>(&values));
    if (!next) return refused();
    whole = whole * *next;
    text.remove_prefix(close + 1);
  }
  return whole;
}

SvgResult<std::vector<SvgOutline>> svg_path(std::string_view text) {
  return PathReader(text).read();
}

}  // namespace evenlift
