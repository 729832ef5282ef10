#include "import/svg/svg_reader.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "evenlift/angles.h"
#include "evenlift/document.h"
#include "evenlift/wording.h"
#include "import/gathering.h"
#include "numbers/number_text.h"
#include "numbers/text_cursor.h"

namespace evenlift {
namespace {

bool is_separator(char c) { return is_space_in_line(c) || ends_line(c) || c == ',' || c == '\f'; }

// Quarter turns, by far the most common, are exact.
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

// A CSS unit, in user units or degrees.
struct NamedUnit {
  std::string_view name;
  double size;
};
// A CSS inch has 96 px.
constexpr NamedUnit length_units[] = {{"", 1},           {"px", 1},        {"mm", 96 / 25.4},
                                      {"cm", 96 / 2.54}, {"in", 96},       {"pt", 96.0 / 72},
                                      {"pc", 16},        {"q", 96 / 101.6}};
constexpr NamedUnit angle_units[] = {
    {"", 1}, {"deg", 1}, {"grad", 0.9}, {"rad", 180 / pi}, {"turn", 360}};
constexpr NamedUnit ratio_units[] = {{"", 1}, {"%", 0.01}};
constexpr NamedUnit number_units[] = {{"", 1}};

template <std::size_t count>
std::optional<double> unit_size(std::string_view name, const NamedUnit (&units)[count]) {
  for (const NamedUnit& unit : units)
    if (same_word(name, unit.name)) return unit.size;
  return std::nullopt;
}

// Each letter of `arguments` is the kind of one: a length, an angle, a ratio or a number. At least
// `fewest` are required.
struct TransformFunction {
  std::string_view name, arguments;
  std::size_t fewest;
  Affine (*map)(const double* values, std::size_t count);
};

double tangent_of_degrees(double degrees) {
  return sine_of_degrees(degrees) / cosine_of_degrees(degrees);
}

constexpr TransformFunction transform_functions[] = {
    {"matrix", "nnnnnn", 6,
     [](const double* v, std::size_t) { return Affine{v[0], v[1], v[2], v[3], v[4], v[5]}; }},
    {"translate", "ll", 1,
     [](const double* v, std::size_t count) { return translation(v[0], count == 2 ? v[1] : 0); }},
    {"translateX", "l", 1, [](const double* v, std::size_t) { return translation(v[0], 0); }},
    {"translateY", "l", 1, [](const double* v, std::size_t) { return translation(0, v[0]); }},
    {"scale", "rr", 1,
     [](const double* v, std::size_t count) { return Affine{v[0], 0, 0, v[count - 1], 0, 0}; }},
    {"scaleX", "r", 1, [](const double* v, std::size_t) { return Affine{v[0], 0, 0, 1, 0, 0}; }},
    {"scaleY", "r", 1, [](const double* v, std::size_t) { return Affine{1, 0, 0, v[0], 0, 0}; }},
    {"rotate", "a", 1, [](const double* v, std::size_t) { return rotation(v[0]); }},
    {"rotate", "all", 3,
     [](const double* v, std::size_t) {
       return translation(v[1], v[2]) * rotation(v[0]) * translation(-v[1], -v[2]);
     }},
    {"skewX", "a", 1,
     [](const double* v, std::size_t) { return Affine{1, 0, tangent_of_degrees(v[0]), 1, 0, 0}; }},
    {"skewY", "a", 1,
     [](const double* v, std::size_t) { return Affine{1, tangent_of_degrees(v[0]), 0, 1, 0, 0}; }},
    {"skew", "aa", 1, [](const double* v, std::size_t count) {
       return Affine{1, count == 2 ? tangent_of_degrees(v[1]) : 0, tangent_of_degrees(v[0]), 1, 0,
                     0};
     }}};
constexpr std::size_t most_arguments = 6;

struct Argument {
  double value;
  std::string_view unit;
};

std::optional<std::vector<Argument>> arguments_of(std::string_view text, std::size_t most) {
  std::vector<Argument> arguments;
  while (!(text = svg_trimmed(text)).empty()) {
    const ScannedNumber number = scan_number(text);
    if (number.kind != ScannedNumber::Kind::finite || arguments.size() == most) return std::nullopt;
    text.remove_prefix(number.length);
    std::size_t letters = 0;
    while (letters < text.size() && (is_letter(text[letters]) || text[letters] == '%')) ++letters;
    arguments.push_back({number.value, text.substr(0, letters)});
    text.remove_prefix(letters);
  }
  return arguments;
}

std::optional<double> in_user_units(const Argument& argument, char kind) {
  const std::optional<double> size = kind == 'l'   ? unit_size(argument.unit, length_units)
                                     : kind == 'a' ? unit_size(argument.unit, angle_units)
                                     : kind == 'r' ? unit_size(argument.unit, ratio_units)
                                                   : unit_size(argument.unit, number_units);
  if (!size) return std::nullopt;
  return argument.value * *size;
}

std::optional<Affine> transform_of(std::string_view name, const std::vector<Argument>& arguments) {
  const std::size_t count = arguments.size();
  for (const TransformFunction& function : transform_functions) {
    if (name != function.name || count < function.fewest || count > function.arguments.size())
      continue;
    double values[most_arguments] = {};
    for (std::size_t i = 0; i < count; ++i) {
      const std::optional<double> value = in_user_units(arguments[i], function.arguments[i]);
      if (!value) return std::nullopt;
      values[i] = *value;
    }
    return function.map(values, count);
  }
  return std::nullopt;
}

SvgResult<double> origin_along(std::string_view word, std::optional<double> whole) {
  constexpr std::pair<std::string_view, double> shares[] = {
      {"left", 0}, {"top", 0}, {"center", 0.5}, {"right", 1}, {"bottom", 1}};
  for (const auto& [name, part] : shares) {
    if (!same_word(word, name)) continue;
    if (part == 0) return 0.0;
    if (whole) return part * *whole;
    return SvgProblem{say("{word} is a place in a drawing without a size", {in_quotes(word)})};
  }
  auto length = svg_length(word, whole);
  if (auto* problem = std::get_if<SvgProblem>(&length)) return std::move(*problem);
  return std::get_if<0>(&length)->value_or(0);
}

std::string at_character(std::size_t offset, const char* what) {
  return say("character {number}: {problem}", {offset + 1, what});
}

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

  // Allows twice max_vertices parts, since some, such as moves, add no vertex.
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
  Vec2 position_, origin_;  // origin_: of a command's coordinates
  bool open_ = false;       // an outline has begun
  char last_ = 0;           // the last command, in lower case
  Vec2 last_control_;
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

// The next number may follow a flag immediately.
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
  origin_ = relative ? position_ : Vec2{};
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
  if (end == from) return true;  // by the standard
  if (rx == 0 || ry == 0) {
    outline().line_to(end);
    return true;
  }
  // SVG 1.1, F.6.5, with the ellipse as the unit circle.
  const Affine turn = rotation(v[2]);
  const Vec2 half = (from - end) / 2;
  Vec2 h((turn.a * half.x + turn.b * half.y) / rx, (turn.c * half.x + turn.d * half.y) / ry);
  const double size = length(h);
  if (size > 1) {  // an ellipse too small to reach both ends grows
    rx *= size;
    ry *= size;
    h /= size;
  }
  const double squared = dot(h, h);
  const double away = std::sqrt(std::max(0.0, (1 - squared) / squared));
  const Vec2 centre = (large == sweep ? -away : away) * Vec2(h.y, -h.x);
  const Affine frame = Affine{1, 0, 0, 1, (from.x + end.x) / 2, (from.y + end.y) / 2} * turn *
                       Affine{rx, 0, 0, ry, rx * centre.x, ry * centre.y};
  outline().arc_to(frame, h - centre, -h - centre, sweep, large, end);
  return true;
}

// L, H or V.
bool PathReader::line(char lower, const Vec2& from) {
  double v[2] = {};
  if (!numbers(v, lower == 'l' ? 2 : 1)) return false;
  outline().line_to(lower == 'l'   ? absolute(v[0], v[1])
                    : lower == 'h' ? Vec2(origin_.x + v[0], from.y)
                                   : Vec2(from.x, origin_.y + v[0]));
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

// `control` becomes the segment's last control point, if any.
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

bool PathReader::piece(char lower, bool relative) {
  if (!has_room()) return false;
  if (!open_) {  // after Z an outline begins at the start of the last one
    outlines_.push_back({{position_, {}}, false});
    open_ = true;
  }
  const Vec2 from = position_;
  origin_ = relative ? from : Vec2{};
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

std::string_view svg_trimmed(std::string_view text) {
  while (!text.empty() && is_separator(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_separator(text.back())) text.remove_suffix(1);
  return text;
}

SvgResult<std::optional<double>> svg_length(std::string_view text, std::optional<double> whole) {
  text = svg_trimmed(text);
  if (text.empty() || text == "auto") return std::optional<double>();
  const auto shown = [&] { return in_quotes(text.substr(0, 20)); };
  const ScannedNumber number = scan_number(text);
  if (number.kind != ScannedNumber::Kind::finite)
    return SvgProblem{say("{text} is not a length", {shown()})};
  const std::string_view unit = svg_trimmed(text.substr(number.length));
  if (unit == "%") {
    if (whole) return std::optional<double>(number.value / 100 * *whole);
    return SvgProblem{say("{text} is a part of a drawing without a size", {shown()})};
  }
  if (const auto size = unit_size(unit, length_units))
    return std::optional<double>(number.value * *size);
  return SvgProblem{say("the unit of {text} is unknown to evenlift", {shown()})};
}

Affine translation(double x, double y) { return {1, 0, 0, 1, x, y}; }

SvgResult<Affine> svg_transform(std::string_view text) {
  Affine whole;
  text = svg_trimmed(text);
  if (same_word(text, "none")) return whole;
  for (; !text.empty(); text = svg_trimmed(text)) {
    std::size_t letters = 0;
    while (letters < text.size() && is_letter(text[letters])) ++letters;
    const std::string_view name = text.substr(0, letters);
    const std::size_t open = text.find_first_not_of(" \t\r\n", letters);
    const std::size_t close = text.find(')');
    const auto refused = [&] {
      const std::string shown(text.substr(0, std::min<std::size_t>(close, 60)));
      return SvgProblem{say("the transform {text} is not understood",
                            {in_quotes(shown + (close < 60 ? ")" : ""))})};
    };
    if (open == std::string_view::npos || text[open] != '(' || close == std::string_view::npos ||
        close < open)
      return refused();
    const auto arguments = arguments_of(text.substr(open + 1, close - open - 1), most_arguments);
    if (!arguments) return refused();
    const std::optional<Affine> next = transform_of(name, *arguments);
    if (!next) return refused();
    whole = whole * *next;
    text.remove_prefix(close + 1);
  }
  return whole;
}

SvgResult<Vec2> svg_transform_origin(std::string_view text, std::optional<double> width,
                                     std::optional<double> height) {
  text = svg_trimmed(text);
  if (text.empty()) return Vec2{};
  const std::size_t end = std::min(text.find_first_of(" \t\r\n"), text.size());
  std::string_view first = text.substr(0, end), second = svg_trimmed(text.substr(end));
  second = second.substr(0, second.find_first_of(" \t\r\n"));  // a third value is a depth
  if (second.empty()) second = "center";
  const bool swapped = same_word(first, "top") || same_word(first, "bottom") ||
                       same_word(second, "left") || same_word(second, "right");
  if (swapped) std::swap(first, second);
  auto x = origin_along(first, width), y = origin_along(second, height);
  for (auto* side : {&x, &y})
    if (auto* problem = std::get_if<SvgProblem>(side)) return std::move(*problem);
  return Vec2(*std::get_if<double>(&x), *std::get_if<double>(&y));
}

SvgResult<std::vector<SvgOutline>> svg_path(std::string_view text) {
  return PathReader(text).read();
}

}  // namespace evenlift
