#include "import/svg/svg_reader.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <tuple>

#include "numbers/number_text.h"
#include "numbers/text_cursor.h"

namespace evenlift {
namespace {

constexpr std::size_t only_styles = 3;  // the last of svg_properties

bool is_white_space(char c) { return is_space_in_line(c) || ends_line(c) || c == '\f'; }

std::string_view without_space(std::string_view text) {
  while (!text.empty() && is_white_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_white_space(text.back())) text.remove_suffix(1);
  return text;
}

// The first of `marks` outside quotes, and outside parentheses if they count.
std::size_t find_outside(std::string_view text, std::string_view marks, std::size_t from,
                         bool parentheses) {
  char quote = 0;
  int depth = 0;
  for (std::size_t i = from; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '\\') {
      ++i;
    } else if (quote != 0) {
      if (c == quote || ends_line(c)) quote = 0;
    } else if (depth == 0 && marks.find(c) != std::string_view::npos) {
      return i;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (parentheses && c == '(') {
      ++depth;
    } else if (parentheses && c == ')' && depth > 0) {
      --depth;
    }
  }
  return text.size();
}

struct StyleValue {
  std::size_t property = svg_property_count;  // in svg_properties
  std::string_view value;
  bool important = false;
};

bool cut_important(std::string_view& value) {
  const std::size_t mark = value.rfind('!');
  if (mark == std::string_view::npos ||
      !same_word(without_space(value.substr(mark + 1)), "important"))
    return false;
  value = without_space(value.substr(0, mark));
  return true;
}

// Properties outside the table are skipped.
template <class Take>
void each_declaration(std::string_view text, Take take) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = find_outside(text, ";", at, true);
    const std::string_view declaration = text.substr(at, end - at);
    at = end + 1;
    const std::size_t colon = declaration.find(':');
    if (colon == std::string_view::npos) continue;
    const std::size_t property = svg_property(without_space(declaration.substr(0, colon)));
    if (property == svg_property_count) continue;
    StyleValue value{property, without_space(declaration.substr(colon + 1)), false};
    value.important = cut_important(value.value);
    if (!value.value.empty()) take(value);
  }
}

void append_without_comments(std::string& text, std::string_view css) {
  while (!css.empty()) {
    const std::size_t start = css.find("/*");
    text += css.substr(0, start);
    text += ' ';
    if (start == std::string_view::npos) return;
    const std::size_t end = css.find("*/", start + 2);
    if (end == std::string_view::npos) return;
    css.remove_prefix(end + 2);
  }
}

std::size_t after_block(std::string_view css, std::size_t open) {
  int depth = 0;
  for (std::size_t at = open; at < css.size();) {
    depth += css[at] == '{' ? 1 : -1;
    ++at;
    if (depth == 0) return at;
    at = find_outside(css, "{}", at, false);
  }
  return css.size();
}

bool is_name(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
    return is_letter(c) || (c >= '0' && c <= '9') || c == '-' || c == '_' ||
           static_cast<unsigned char>(c) >= 0x80;
  });
}

bool is_for_screens(std::string_view media) {
  media = without_space(media);
  return media.empty() || same_word(media, "all") || same_word(media, "screen");
}

// A number or percentage of at most 0.
bool is_zero(std::string_view value) {
  const ScannedNumber number = scan_number(value);
  return number.kind == ScannedNumber::Kind::finite && number.value <= 0;
}

bool is_paint(std::string_view value) {
  return !same_word(value, "none") && !same_word(value, "transparent");
}

bool is_white(std::string_view value) {
  for (const char* white : {"white", "#fff", "#ffffff", "rgb(255,255,255)", "rgb(255, 255, 255)",
                            "rgb(100%,100%,100%)", "rgb(100%, 100%, 100%)"})
    if (same_word(value, white)) return true;
  return false;
}

bool is_visible(std::string_view value) {
  return !same_word(value, "hidden") && !same_word(value, "collapse");
}

bool is_nonzero_rule(std::string_view value) { return !same_word(value, "evenodd"); }

bool is_more_than_zero(std::string_view value) { return !is_zero(value); }

}  // namespace

std::size_t svg_property(std::string_view name) {
  const auto found = std::find_if(std::begin(svg_properties), std::end(svg_properties),
                                  [&](std::string_view each) { return same_word(name, each); });
  return static_cast<std::size_t>(found - std::begin(svg_properties));
}

std::string_view geometry_of(const SvgDeclared& declared, std::string_view attribute,
                             std::string_view otherwise) {
  const std::size_t property = svg_property(attribute);
  if (property == svg_property_count) return otherwise;
  std::string_view value = without_space(declared.values[property]);
  if (value.empty()) return otherwise;
  if (same_word(value, "auto")) return {};
  constexpr std::string_view path = "path(";
  if (attribute != "d" || !value.starts_with(path) || !value.ends_with(')')) return value;
  value = without_space(value.substr(path.size(), value.size() - path.size() - 1));
  const bool quoted = value.size() > 1 && (value[0] == '"' || value[0] == '\'');
  return quoted ? value.substr(1, value.size() - 2) : value;
}

bool hides_all(const SvgDeclared& declared) {
  return same_word(declared["display"], "none") || is_zero(declared["opacity"]);
}

SvgLook inherited(SvgLook look, const SvgDeclared& declared) {
  constexpr SvgLook first;
  struct Row {
    std::string_view property;
    bool SvgLook::*value;
    bool (*is_seen)(std::string_view);
  };
  constexpr Row rows[] = {{"visibility", &SvgLook::visible, is_visible},
                          {"fill", &SvgLook::fill, is_paint},
                          {"fill", &SvgLook::white, is_white},
                          {"fill-opacity", &SvgLook::fill_opaque, is_more_than_zero},
                          {"stroke", &SvgLook::stroke, is_paint},
                          {"stroke-opacity", &SvgLook::stroke_opaque, is_more_than_zero},
                          {"stroke-width", &SvgLook::stroke_wide, is_more_than_zero},
                          {"fill-rule", &SvgLook::nonzero, is_nonzero_rule}};
  for (const Row& row : rows) {
    const std::string_view value = declared[row.property];
    if (value.empty() || same_word(value, "inherit") || same_word(value, "unset")) continue;
    look.*row.value = same_word(value, "initial") ? first.*row.value : row.is_seen(value);
  }
  return look;
}

class SvgStyles::Cascade {
 public:
  void take(std::size_t at, std::string_view value, bool important, std::uint32_t specificity,
            std::uint32_t order) {
    const Strength strength{important, specificity, order};
    if (strength < strengths_[at]) return;
    strengths_[at] = strength;
    declared_.values[at] = value;
  }
  const SvgDeclared& declared() const { return declared_; }

 private:
  using Strength = std::tuple<bool, std::uint32_t, std::uint32_t>;
  std::array<Strength, svg_property_count> strengths_{};
  SvgDeclared declared_;
};

bool SvgStyles::read(const pugi::xml_node& root) {
  struct Finder final : pugi::xml_tree_walker {
    std::string text;
    bool for_each(pugi::xml_node& node) override {
      if (local_name(node) != "style" || !is_for_screens(value_of(node, "media"))) return true;
      for (const pugi::xml_node css : node.children()) append_without_comments(text, css.value());
      return true;
    }
  };
  Finder finder;
  pugi::xml_node start = root;
  start.traverse(finder);
  text_ = std::move(finder.text);
  if (!read_rules(text_)) return false;

  // Of declarations with the same selector and property, the winning one comes first.
  std::sort(declarations_.begin(), declarations_.end(),
            [](const Declaration& a, const Declaration& b) {
              return std::tie(a.selector, a.property, b.important, b.order) <
                     std::tie(b.selector, b.property, a.important, a.order);
            });
  const auto rest = std::unique(declarations_.begin(), declarations_.end(),
                                [](const Declaration& a, const Declaration& b) {
                                  return a.selector == b.selector && a.property == b.property;
                                });
  declarations_.erase(rest, declarations_.end());
  return true;
}

bool SvgStyles::read_rules(std::string_view css) {
  for (std::size_t at = 0; at < css.size();) {
    if (is_white_space(css[at])) {
      ++at;
    } else if (css[at] == '@') {
      const std::size_t open = find_outside(css, ";{", at, true);
      const bool has_block = open < css.size() && css[open] == '{';
      const std::size_t end = has_block ? after_block(css, open) : open + 1;
      if (has_block &&
          !read_at_rule(css.substr(at, open - at), css.substr(open + 1, end - open - 1)))
        return false;
      at = end;
    } else {
      const std::size_t open = find_outside(css, "{", at, false);
      const std::size_t end = after_block(css, open);
      if (open < css.size() &&
          !read_rule(css.substr(at, open - at), css.substr(open + 1, end - open - 1)))
        return false;
      at = end;
    }
  }
  return true;
}

// Rules for screens count; those for paper, and blocks that are no rules, do not. A condition on the
// screen, such as its width, is not known.
bool SvgStyles::read_at_rule(std::string_view heading, std::string_view block) {
  constexpr std::string_view media = "@media";
  if (!same_word(heading.substr(0, media.size()), media)) return true;
  const std::string_view condition = heading.substr(media.size());
  constexpr int deepest = 8;
  if (is_for_screens(condition) && depth_ < deepest) {
    if (!block.empty() && block.back() == '}') block.remove_suffix(1);
    ++depth_;
    const bool read = read_rules(block);
    --depth_;
    return read;
  }
  if (condition.find('(') != std::string_view::npos) skip(heading);
  return true;
}

void SvgStyles::skip(std::string_view what) {
  if (skipped_.empty()) skipped_ = without_space(what);
}

std::optional<SvgStyles::Selector> SvgStyles::simple_selector(std::string_view text) {
  const std::size_t mark = std::min(text.find_first_of(".#"), text.size());
  const std::string_view tag = text.substr(0, mark), rest = text.substr(mark);
  Selector selector;
  if (tag != "*") selector.tag = tag;
  if (!rest.empty()) (rest[0] == '#' ? selector.id : selector.name_of_class) = rest.substr(1);
  const bool whole = !text.empty() && (tag.empty() || tag == "*" || is_name(tag)) &&
                     (rest.empty() || is_name(rest.substr(1)));
  return whole ? std::optional(selector) : std::nullopt;
}

bool SvgStyles::read_rule(std::string_view selectors, std::string_view body) {
  if (!body.empty() && body.back() == '}') body.remove_suffix(1);
  // Keeps one value for each property before the list of selectors multiplies them.
  std::array<StyleValue, svg_property_count> values{};
  each_declaration(body, [&](const StyleValue& value) {
    StyleValue& kept = values[value.property];
    if (!kept.important || value.important) kept = value;
  });
  for (std::size_t at = 0; at <= selectors.size();) {
    const std::size_t comma = find_outside(selectors, ",", at, true);
    const std::string_view text = without_space(selectors.substr(at, comma - at));
    const std::optional<Selector> selector = simple_selector(text);
    at = comma + 1;
    for (const StyleValue& value : values) {
      if (value.property == svg_property_count) continue;
      if (!selector) {
        skipped_paint_ |= "fill stroke"_words.has(svg_properties[value.property]);
        skip(text);
        continue;
      }
      if (declarations_.size() >= most_declarations) return false;
      const auto order = static_cast<std::uint32_t>(declarations_.size() + 1);
      declarations_.push_back({*selector, value.property, value.important, order, value.value});
    }
  }
  return true;
}

void SvgStyles::apply(const Selector& selector, Cascade& cascade) const {
  const auto first = std::lower_bound(
      declarations_.begin(), declarations_.end(), selector,
      [](const Declaration& a, const Selector& wanted) { return a.selector < wanted; });
  const std::uint32_t specificity = (selector.id.empty() ? 0u : 0x10000u) +
                                    (selector.name_of_class.empty() ? 0u : 0x100u) +
                                    (selector.tag.empty() ? 0u : 1u);
  for (auto next = first; next != declarations_.end() && next->selector == selector; ++next)
    cascade.take(next->property, next->value, next->important, specificity, next->order);
}

SvgDeclared SvgStyles::of(const pugi::xml_node& node) const {
  constexpr std::uint32_t of_style_attribute = 0x1000000;
  Cascade cascade;
  std::string_view id, classes, style;
  for (const pugi::xml_attribute attribute : node.attributes()) {
    const std::string_view name = attribute.name(), value = attribute.value();
    if (name == "id") id = value;
    if (name == "class") classes = value;
    if (name == "style") style = value;
    const std::size_t property = svg_property(name);
    const std::string_view trimmed = without_space(value);
    if (property < svg_property_count - only_styles && !trimmed.empty())
      cascade.take(property, trimmed, false, 0, 0);
  }
  if (!declarations_.empty()) {
    const std::string_view tag = local_name(node);
    apply({}, cascade);
    apply({tag, {}, {}}, cascade);
    while (!(classes = without_space(classes)).empty()) {
      const std::size_t end = std::min(classes.find_first_of(" \t\r\n\f"), classes.size());
      apply({{}, {}, classes.substr(0, end)}, cascade);
      apply({tag, {}, classes.substr(0, end)}, cascade);
      classes.remove_prefix(end);
    }
    if (!id.empty()) {
      apply({{}, id, {}}, cascade);
      apply({tag, id, {}}, cascade);
    }
  }
  each_declaration(style, [&](const StyleValue& value) {
    cascade.take(value.property, value.value, value.important, of_style_attribute, 0);
  });
  return cascade.declared();
}

namespace {

// In px, as in CSS.
constexpr double inch = 96;

struct Aspect {
  bool stretched = false, slice = false;
  double across = 0.5, down = 0.5;  // part of the free space before the drawing
};

double share(std::string_view word) { return word == "Min" ? 0 : word == "Max" ? 1 : 0.5; }

Aspect aspect_of(std::string_view text) {
  Aspect aspect;
  while (!(text = svg_trimmed(text)).empty()) {
    const std::size_t end = std::min(text.find_first_of(" \t\r\n,"), text.size());
    const std::string_view word = text.substr(0, end);
    text.remove_prefix(end);
    if (word == "none") aspect.stretched = true;
    if (word == "slice") aspect.slice = true;
    if (word.size() == 8 && word[0] == 'x' && word[4] == 'Y') {
      aspect.across = share(word.substr(1, 3));
      aspect.down = share(word.substr(5, 3));
    }
  }
  return aspect;
}

Vec2 scale_of(const Aspect& aspect, const Vec2& box, const Vec2& size) {
  const Vec2 scale(size.x / box.x, size.y / box.y);
  if (aspect.stretched) return scale;
  const double both = aspect.slice ? std::max(scale.x, scale.y) : std::min(scale.x, scale.y);
  return {both, both};
}

// In px; nullopt if invalid, in per cent or not above 0.
std::optional<double> side_in_pixels(std::string_view text) {
  const auto length = svg_length(text);
  const auto* pixels = std::get_if<std::optional<double>>(&length);
  if (pixels == nullptr || !*pixels || !(**pixels > 0)) return std::nullopt;
  return *pixels;
}

struct PaperUnit {
  std::string_view name;
  LengthUnit unit;
};
// Pixels are not a size on paper.
constexpr PaperUnit paper_units[] = {{"mm", LengthUnit::mm}, {"cm", LengthUnit::cm},
                                     {"in", LengthUnit::in}, {"pt", LengthUnit::mm},
                                     {"pc", LengthUnit::mm}, {"q", LengthUnit::mm}};

LengthUnit paper_unit(std::string_view length) {
  length = svg_trimmed(length);
  std::size_t letters = 0;
  while (letters < length.size() && is_letter(length[length.size() - letters - 1])) ++letters;
  for (const PaperUnit& unit : paper_units)
    if (same_word(length.substr(length.size() - letters), unit.name)) return unit.unit;
  return LengthUnit::none;
}

struct UnitSize {
  LengthUnit unit;
  double pixels;
};
constexpr UnitSize unit_sizes[] = {{LengthUnit::mm, inch / 25.4},
                                   {LengthUnit::cm, inch / 2.54},
                                   {LengthUnit::m, inch / 0.0254},
                                   {LengthUnit::in, inch}};

double pixels_of(LengthUnit unit) {
  for (const UnitSize& size : unit_sizes)
    if (size.unit == unit) return size.pixels;
  return 1;
}

// In px across and down; nullopt for a malformed view box.
std::optional<Vec2> user_unit(const SvgSize& size, const std::optional<SvgViewBox>& box,
                              std::optional<double> width, std::optional<double> height) {
  if (svg_trimmed(size.view_box).empty()) return Vec2(1, 1);
  if (!box || !(box->size.x > 0) || !(box->size.y > 0)) return std::nullopt;
  // A missing side follows from the other one.
  if (!width) width = *height * (box->size.x / box->size.y);
  if (!height) height = *width * (box->size.y / box->size.x);
  return scale_of(aspect_of(size.aspect), box->size, {*width, *height});
}

}  // namespace

std::optional<SvgViewBox> svg_view_box(std::string_view text) {
  const auto numbers = svg_numbers(text);
  const auto* values = std::get_if<std::vector<double>>(&numbers);
  if (values == nullptr || values->size() != 4) return std::nullopt;
  return SvgViewBox{{(*values)[0], (*values)[1]}, {(*values)[2], (*values)[3]}};
}

Affine fitted(const SvgViewBox& box, const Vec2& size, std::string_view aspect_text) {
  const Aspect aspect = aspect_of(aspect_text);
  const Vec2 scale = scale_of(aspect, box.size, size);
  const Vec2 room(size.x - scale.x * box.size.x, size.y - scale.y * box.size.y);
  const double across = aspect.stretched ? 0 : aspect.across * room.x;
  const double down = aspect.stretched ? 0 : aspect.down * room.y;
  return {scale.x, 0, 0, scale.y, across - scale.x * box.low.x, down - scale.y * box.low.y};
}

SvgPaper paper_of(const SvgSize& size) {
  SvgPaper paper;
  const std::optional<double> width = side_in_pixels(size.width),
                              height = side_in_pixels(size.height);
  const std::optional<SvgViewBox> box = svg_view_box(size.view_box);
  paper.viewport = {width, height};
  if (box) paper.viewport = {box->size.x, box->size.y};

  const LengthUnit of_width = width ? paper_unit(size.width) : LengthUnit::none;
  const LengthUnit of_height = height ? paper_unit(size.height) : LengthUnit::none;
  const LengthUnit written = of_width != LengthUnit::none ? of_width : of_height;
  if (written == LengthUnit::none) return paper;
  const std::optional<Vec2> pixels = user_unit(size, box, width, height);
  if (!pixels) return paper;

  constexpr double rounding = 1e-4;
  for (const UnitSize& unit : unit_sizes) {
    const Vec2 difference = *pixels - Vec2(unit.pixels, unit.pixels);
    if (!(max_norm(difference) < rounding * unit.pixels)) continue;
    paper.unit = unit.unit;
    return paper;
  }
  paper.unit = written;
  paper.across = pixels->x / pixels_of(written);
  paper.down = pixels->y / pixels_of(written);
  return paper;
}

}  // namespace evenlift
