#include "import/svg/svg_entities.h"

#include <algorithm>
#include <cstddef>
#include <map>

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
      return InputError{
          ErrorCode::unsupported, "the SVG's entities contain each other more than eight deep", {}};
    // Also of entities that leave nothing behind.
    read_ += text.size() + 1;
    if (read_ > most_bytes)
      return InputError{
          ErrorCode::unsupported, "the SVG with its entities is longer than 64 MiB", {}};
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

}  // namespace evenlift
