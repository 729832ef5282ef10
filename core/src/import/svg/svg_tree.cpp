#include <algorithm>
#include <cstddef>
#include <map>

#include "evenlift/wording.h"
#include "import/svg/svg_reader.h"
#include "numbers/text_cursor.h"

namespace evenlift {
namespace {

constexpr std::size_t most_bytes = std::size_t{1} << 26, most_entities = 1000;
constexpr std::size_t longest_entity_name = 256;
constexpr int deepest_entity = 8;
constexpr std::string_view xml_space = " \t\r\n";

using Entities = std::map<std::string_view, std::string_view>;

// The declarations between the brackets of <!DOCTYPE svg [ … ]>, and what follows them.
struct Declared {
  std::string_view inside, after;
};
std::optional<Declared> declarations(std::string_view text) {
  const std::size_t type = text.find("<!DOCTYPE");
  if (type == std::string_view::npos) return std::nullopt;
  const std::size_t open = text.find_first_of("[>", type);
  if (open == std::string_view::npos || text[open] == '>') return std::nullopt;
  char quote = 0;
  for (std::size_t i = open + 1; i < text.size(); ++i) {
    const char c = text[i];
    if (quote != 0)
      quote = c == quote ? '\0' : quote;
    else if (c == '"' || c == '\'')
      quote = c;
    else if (c == ']')
      return Declared{text.substr(open + 1, i - open - 1), text.substr(i)};
  }
  return std::nullopt;
}

// Without those of other files, and without the entities of declarations (%).
Entities entities_of(std::string_view declared) {
  Entities entities;
  constexpr std::string_view begin = "<!ENTITY";
  for (std::size_t at = declared.find(begin);
       at != std::string_view::npos && entities.size() < most_entities;
       at = declared.find(begin, at)) {
    at += begin.size();
    const std::size_t name = declared.find_first_not_of(xml_space, at);
    if (name == std::string_view::npos) break;
    const std::size_t end = declared.find_first_of(xml_space, name);
    const std::size_t quote = declared.find_first_not_of(xml_space, end);
    if (quote == std::string_view::npos) break;
    if (declared[quote] != '"' && declared[quote] != '\'') continue;
    const std::size_t close = declared.find(declared[quote], quote + 1);
    if (close == std::string_view::npos) break;
    // The first declaration of a name counts.
    entities.emplace(declared.substr(name, end - name),
                     declared.substr(quote + 1, close - quote - 1));
    at = close;
  }
  return entities;
}

class Expansion {
 public:
  explicit Expansion(const Entities& entities) : entities_(entities) {}

  std::optional<InputError> add(std::string_view text, int depth) {
    if (depth > deepest_entity)
      return InputError{ErrorCode::unsupported,
                        "the SVG's entities contain each other more than eight deep"};
    // Also of entities that leave nothing behind.
    read_ += text.size() + 1;
    if (read_ > most_bytes)
      return InputError{ErrorCode::unsupported, "the SVG with its entities is longer than 64 MiB"};
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t mark = std::min(text.find('&', at), text.size());
      expanded_ += text.substr(at, mark - at);
      at = mark;
      if (at == text.size()) break;
      const std::size_t size = text.substr(at, longest_entity_name).find(';');
      const auto entity = size == std::string_view::npos
                              ? entities_.end()
                              : entities_.find(text.substr(at + 1, size - 1));
      if (entity == entities_.end()) {
        expanded_ += text[at++];
        continue;
      }
      if (auto error = add(entity->second, depth + 1)) return error;
      at += size + 1;
    }
    return std::nullopt;
  }

  std::string text() && { return std::move(expanded_); }

 private:
  const Entities& entities_;
  std::string expanded_;
  std::size_t read_ = 0;  // no less than the size of expanded_
};

}  // namespace

Result<std::optional<std::string>> with_entities(std::string_view text) {
  const auto declared = declarations(text);
  if (!declared) return std::optional<std::string>();
  const Entities entities = entities_of(declared->inside);
  if (entities.empty()) return std::optional<std::string>();
  const auto before = static_cast<std::size_t>(declared->after.data() - text.data());
  Expansion expansion(entities);
  if (auto error = expansion.add(declared->after, 0)) return *std::move(error);
  return std::optional(std::string(text.substr(0, before)) + std::move(expansion).text());
}

namespace {

// The depth of nested elements to which the reader recurses.
constexpr int max_nesting = 256;

// Not drawn in place.
constexpr WordList unseen =
    "defs clipPath mask pattern marker symbol style metadata title linearGradient desc script filter "
    "radialGradient font namedview"_words;
constexpr WordList drawn = "path polygon polyline rect circle ellipse line"_words;

struct Other {
  std::string_view name, one, many;
  bool is_text;
};
constexpr Other others[] = {{"text", "text", "texts", true},
                            {"flowRoot", "text", "texts", true},
                            {"image", "picture", "pictures", false},
                            {"foreignObject", "foreign object", "foreign objects", false}};

// Styles that move a shape and are not supported.
constexpr const char* movers[] = {"translate", "rotate", "scale"};

// In a <switch>, programs put first what only they can read, then a version for others.
bool may_be_chosen(const pugi::xml_node& node) {
  if (local_name(node) == "foreignObject" || !value_of(node, "requiredExtensions").empty())
    return false;
  const pugi::xml_attribute languages = node.attribute("systemLanguage");
  return !languages || std::string_view(languages.value()).substr(0, 2) == "en";
}

// The id after # in the reference; nullopt for a reference to another file.
std::optional<std::string_view> id_of_original(const pugi::xml_node& node) {
  std::string_view href;
  for (const pugi::xml_attribute attribute : node.attributes()) {
    const std::string_view name = attribute.name();
    if (without_prefix(name) != "href") continue;
    href = svg_trimmed(attribute.value());
    if (name == "href") break;  // the one without a prefix wins
  }
  if (href.empty()) return href;
  if (href[0] != '#') return std::nullopt;
  return href.substr(1);
}

}  // namespace

void SvgReader::too_deep(const pugi::xml_node& node) {
  stop(error_at(node, ErrorCode::unsupported, "the SVG's elements are nested too deeply"));
}

void SvgReader::hide(const pugi::xml_node& node, const Context& context) {
  constexpr std::size_t most_names = 3;
  ++hidden_;
  const std::string name =
      clean_name(context.name_of_copy.empty() ? own_name(node) : context.name_of_copy);
  if (name.empty() || hidden_names_.size() > most_names ||
      std::find(hidden_names_.begin(), hidden_names_.end(), name) != hidden_names_.end())
    return;
  hidden_names_.push_back(hidden_names_.size() == most_names ? "" : name);
}

bool SvgReader::leaves_out(const pugi::xml_node& node, std::string_view name,
                           const Context& inside) {
  for (const Other& other : others) {
    if (name != other.name) continue;
    has_texts_ = has_texts_ || other.is_text;
    if (inside.look.visible)
      gathering_.left_out.add(other.one, other.many);
    else
      hide(node, inside);
    return true;
  }
  return false;
}

namespace {

// The first number of an attribute that may list one for each letter.
std::optional<double> first_number(const pugi::xml_node& node, const char* attribute) {
  const std::string_view all = value_of(node, attribute);
  std::string_view first = all.substr(0, all.find_first_of(" ,\t\r\n"));
  if (first.ends_with("px")) first.remove_suffix(2);
  return first.empty() ? std::nullopt : read_number(first);
}

}  // namespace

// A text may name the part at its place. One whose place is not plain names none.
void SvgReader::take_text(const pugi::xml_node& node, const SvgDeclared& declared,
                          const Context& inside) {
  std::optional<double> x = first_number(node, "x"), y = first_number(node, "y");
  std::string words;
  for (const pugi::xml_node child : node.children()) {
    const bool is_span = local_name(child) == "tspan";
    if (is_span && !x) x = first_number(child, "x");
    if (is_span && !y) y = first_number(child, "y");
    const bool is_new_line = is_span && (child.attribute("y") || child.attribute("dy"));
    if (is_new_line && !words.empty()) words += ' ';
    words += is_span ? child.child_value() : child.value();
  }
  const std::string_view moved = declared["transform"];
  if (!x && !y && moved.empty()) return;
  Affine map = inside.matrix;
  if (!moved.empty()) {
    const auto read = svg_transform(moved);
    const Affine* const matrix = std::get_if<Affine>(&read);
    if (!matrix) return;
    map = map * *matrix;
  }
  gathering_.add_text(map({x.value_or(0), y.value_or(0)}), words, others[0].one);
}

bool SvgReader::transform(const pugi::xml_node& node, const SvgDeclared& declared,
                          Context& inside) {
  for (const char* const mover : movers) {
    const std::string_view value = declared[mover];
    if (value.empty() || same_word(value, "none")) continue;
    problem(node, say("the SVG moves a shape by the style {name}, which is not supported; use a "
                      "transform (in Inkscape: save as Plain SVG)",
                      {in_quotes(mover)}));
    return false;
  }
  const std::string_view text = declared["transform"];
  if (text.empty()) return true;
  const auto matrix = checked(node, "drawing", svg_transform(text));
  if (!matrix) return false;
  const std::string_view origin_text = declared["transform-origin"];
  if (origin_text.empty()) {
    inside.matrix = inside.matrix * *matrix;
    return true;
  }
  const std::string_view box = declared["transform-box"];
  if (!box.empty() && !same_word(box, "view-box")) {
    problem(node,
            "the SVG turns a shape about a point of its own box (transform-box), which is "
            "not supported; use a transform attribute (in Inkscape: save as Plain SVG)");
    return false;
  }
  const auto origin =
      checked(node, "drawing",
              svg_transform_origin(origin_text, inside.viewport.width, inside.viewport.height));
  if (!origin) return false;
  inside.matrix = inside.matrix * translation(origin->x, origin->y) * *matrix *
                  translation(-origin->x, -origin->y);
  return true;
}

namespace {

Box common(const Box& a, const Box& b) {
  return {{std::max(a.low.x, b.low.x), std::max(a.low.y, b.low.y)},
          {std::min(a.high.x, b.high.x), std::min(a.high.y, b.high.y)}};
}

// The id of "url(#id)"; empty for other values.
std::string_view referenced(std::string_view value) {
  value = svg_trimmed(value);
  if (!value.starts_with("url(") || !value.ends_with(")")) return {};
  value = svg_trimmed(value.substr(4, value.size() - 5));
  while (!value.empty() && (value.front() == '"' || value.front() == '\'')) value.remove_prefix(1);
  while (!value.empty() && (value.back() == '"' || value.back() == '\'')) value.remove_suffix(1);
  return value.starts_with("#") ? value.substr(1) : std::string_view();
}

}  // namespace

// The rectangle that a clip path leaves, in the import's coordinates; nothing if it has another form.
std::optional<Box> SvgReader::window_of(std::string_view id, const Context& inside) {
  const pugi::xml_node clip = node_of(id);
  const Affine& m = inside.matrix;
  const bool keeps_axes = (m.b == 0 && m.c == 0) || (m.a == 0 && m.d == 0);
  if (!clip || !keeps_axes || clip.attribute("transform") ||
      value_of(clip, "clipPathUnits") == "objectBoundingBox")
    return std::nullopt;
  pugi::xml_node only;
  for (const pugi::xml_node child : clip.children()) {
    if (child.type() != pugi::node_element) continue;
    if (only) return std::nullopt;
    only = child;
  }
  if (local_name(only) == "use" && !only.attribute("transform") && !only.attribute("x") &&
      !only.attribute("y"))
    if (const auto original = id_of_original(only)) only = node_of(*original);
  if (local_name(only) != "rect" || only.attribute("transform")) return std::nullopt;
  Context own = inside;
  own.declared = {};
  const auto side = [&](const char* name) {
    const auto read = length(only, own, name);
    return read ? std::optional(read->value_or(0)) : std::nullopt;
  };
  const auto x = side("x"), y = side("y"), width = side("width"), height = side("height");
  if (!x || !y || !width || !height) return std::nullopt;
  return bounding_box({m({*x, *y}), m({*x + *width, *y + *height})});
}

void SvgReader::take_cuts(const SvgDeclared& declared, Context& inside) {
  for (const std::string_view property : {"clip-path", "mask"}) {
    const std::string_view id = referenced(declared[property]);
    if (id.empty() || !node_of(id)) continue;  // one that is not there cuts nothing
    const auto window = property == "clip-path" ? window_of(id, inside) : std::nullopt;
    inside.is_cut = inside.is_cut || !window;
    if (window) inside.window = inside.window ? common(*inside.window, *window) : *window;
  }
}

// Returns false if the element is left out.
bool SvgReader::enter(const pugi::xml_node& node, std::string_view name, Context& inside) {
  const SvgDeclared declared = styles_.of(node);
  inside.declared = drawn.has(name) ? declared : SvgDeclared{};
  if (hides_all(declared)) {
    hide(node, inside);
    return false;
  }
  inside.look = inherited(inside.look, declared);
  if (name == "text" && inside.look.visible) take_text(node, declared, inside);
  if (leaves_out(node, name, inside) || !transform(node, declared, inside)) return false;
  take_cuts(declared, inside);
  if (!drawn.has(name)) return true;
  if (!inside.look.visible) {
    hide(node, inside);
    return false;
  }
  // A line has nothing to fill.
  const bool painted = inside.look.is_stroked() || (inside.look.is_filled() && name != "line");
  if (painted || styles_.skipped_paint()) return true;
  ++unpainted_;
  return takes_unpainted_;
}

void SvgReader::element(const pugi::xml_node& node, const Context& context, int depth) {
  const std::string_view name = local_name(node);
  if (unseen.has(name) || is_foreign(node)) return;
  Context inside = context;
  if (!enter(node, name, inside)) return;
  if (drawn.has(name)) return shape(node, inside, name);
  if (name == "use") return copy(node, inside, depth);
  if (name == "svg") return nested(node, node, inside, depth);
  name_layer(node, inside);
  if (const std::string_view title = title_of(node); name == "g" && !title.empty())
    inside.title = title;
  children(node, inside, depth + 1);
}

void SvgReader::name_layer(const pugi::xml_node& node, Context& inside) {
  if (!inside.name_of_copy.empty()) inside.layer = inside.name_of_copy;
  if (const std::string_view label = label_of(node); !label.empty()) inside.layer = label;
  inside.name_of_copy = {};
}

void SvgReader::children(const pugi::xml_node& parent, const Context& context, int depth) {
  if (depth > max_nesting) return too_deep(parent);
  const bool chooses = local_name(parent) == "switch";
  open_.push_back(parent);
  for (const pugi::xml_node node : parent.children()) {
    if (full() || (context.in_copy && !has_room_to_copy(node))) break;
    if (node.type() != pugi::node_element || (chooses && !may_be_chosen(node))) continue;
    element(node, context, depth);
    if (chooses) break;
  }
  open_.pop_back();
}

bool SvgReader::has_room_to_copy(const pugi::xml_node& node) {
  copied_bytes_ += 64;
  for (const pugi::xml_attribute attribute : node.attributes())
    copied_bytes_ += std::string_view(attribute.value()).size();
  return copied_bytes_ <= most_copied_bytes;
}

// Returns a null node, and leaves out the copy, if there is no original.
pugi::xml_node SvgReader::original_of(const pugi::xml_node& node) {
  const std::optional<std::string_view> id = id_of_original(node);
  if (!id) {
    gathering_.left_out.add("copy (<use>) from another file", "copies (<use>) from other files");
    return {};
  }
  const pugi::xml_node original = node_of(*id);
  if (!original)
    gathering_.left_out.add("copy (<use>) without an original",
                            "copies (<use>) without an original");
  return original;
}

// The element with this id; a null node if there is none.
pugi::xml_node SvgReader::node_of(std::string_view id) {
  if (!has_ids_) index_ids();
  const auto found = std::lower_bound(
      by_id_.begin(), by_id_.end(), id,
      [](const auto& entry, std::string_view wanted) { return entry.first < wanted; });
  return id.empty() || found == by_id_.end() || found->first != id ? pugi::xml_node()
                                                                   : found->second;
}

void SvgReader::index_ids() {
  document_.find_node([&](const pugi::xml_node& node) {
    if (const std::string_view id = value_of(node, "id"); !id.empty())
      by_id_.emplace_back(id, node);
    return false;
  });
  // Of equal ids the first counts.
  std::stable_sort(by_id_.begin(), by_id_.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  has_ids_ = true;
}

void SvgReader::copy(const pugi::xml_node& node, Context& inside, int depth) {
  if (depth > max_nesting) return too_deep(node);
  const pugi::xml_node original = original_of(node);
  if (!original) return;
  if (original == node || std::find(open_.begin(), open_.end(), original) != open_.end())
    return problem(node, "the SVG's copies (<use>) contain themselves");
  const auto x = length(node, inside, "x"), y = length(node, inside, "y");
  if (!x || !y || !has_room_to_copy(original)) return;
  inside.matrix = inside.matrix * translation(x->value_or(0), y->value_or(0));
  inside.in_copy = true;
  if (const std::string_view name = own_name(node); !name.empty()) inside.name_of_copy = name;
  open_.push_back(node);
  const std::string_view name = local_name(original);
  if (name != "symbol" && name != "svg")
    element(original, inside, depth + 1);
  else if (enter(original, name, inside))
    nested(original, node, inside, depth + 1);
  open_.pop_back();
}

void SvgReader::nested(const pugi::xml_node& node, const pugi::xml_node& sized, Context& inside,
                       int depth) {
  const auto side = [&](const char* attribute) {
    return length(value_of(sized, attribute).empty() ? node : sized, inside, attribute);
  };
  const auto x = length(node, inside, "x"), y = length(node, inside, "y"), width = side("width"),
             height = side("height");
  if (!x || !y || !width || !height) return;
  inside.matrix = inside.matrix * translation(x->value_or(0), y->value_or(0));
  const std::optional<SvgViewBox> box = svg_view_box(value_of(node, "viewBox"));
  // A missing side is that of the surrounding viewport.
  SvgViewport size{*width ? *width : inside.viewport.width,
                   *height ? *height : inside.viewport.height};
  if (box && !size.width) size.width = box->size.x;
  if (box && !size.height) size.height = box->size.y;
  for (const auto& each : {size.width, size.height})
    if (each && !(*each > 0)) return;  // not drawn, by the standard
  if (box && !(box->size.x > 0 && box->size.y > 0)) return;
  inside.viewport = size;
  if (box) {
    inside.matrix = inside.matrix * fitted(*box, {*size.width, *size.height},
                                           value_of(node, "preserveAspectRatio"));
    inside.viewport = {box->size.x, box->size.y};
  }
  name_layer(node, inside);
  children(node, inside, depth + 1);
}

}  // namespace evenlift
