#include "evenlift/wording.h"

#include <algorithm>
#include <cassert>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace evenlift {
namespace {

using Translations = std::map<std::string, std::string, std::less<>>;

Translations& translations() {
  static Translations all;
  return all;
}

int typed_texts = 0;  // AsTyped objects

// Calls text() between the places, and place() for their names.
template <class Text, class Place>
void read_pattern(std::string_view pattern, const Text& text, const Place& place) {
  while (!pattern.empty()) {
    const std::size_t open = pattern.find('{'), close = pattern.find('}', open);
    if (close == std::string_view::npos) break;
    text(pattern.substr(0, open));
    place(pattern.substr(open + 1, close - open - 1));
    pattern.remove_prefix(close + 1);
  }
  text(pattern);
}

std::vector<std::string_view> names_in(std::string_view pattern) {
  std::vector<std::string_view> names;
  read_pattern(
      pattern, [](std::string_view) {},
      [&](std::string_view name) {
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
      });
  return names;
}

}  // namespace

void add_translation(std::string english, std::string translated) {
  translations().insert_or_assign(std::move(english), std::move(translated));
}

void forget_translations() { translations().clear(); }

std::string_view translated(std::string_view english) {
  const Translations& all = translations();
  if (all.empty() || typed_texts > 0) return english;
  const auto found = all.find(english);
  return found == all.end() ? english : found->second;
}

namespace {

bool y_is_down = false;

}  // namespace

void write_y_down() { y_is_down = true; }
double written_y(double y) { return y_is_down ? -y : y; }

std::string as_read(std::string number) {
  std::replace(number.begin(), number.end(), '.', translated(".")[0]);
  return number;
}

AsTyped::AsTyped() { ++typed_texts; }
AsTyped::~AsTyped() { --typed_texts; }

// Not inline, as the page has a thousand of them.
Value::Value(std::string_view text) : text_(text.data() ? text.data() : ""), size_(text.size()) {}
Value::Value(const char* text) : Value(std::string_view(text)) {}
Value::Value(const std::string& text) : Value(std::string_view(text)) {}

std::string Value::written() const {
  return text_ ? std::string(translated({text_, size_})) : std::to_string(size_);
}

std::string say(std::string_view english, std::initializer_list<Value> values) {
  std::vector<std::string> written;
  for (const Value& value : values) written.push_back(value.written());
  return say_written(english, written.data(), written.size());
}

std::string say_written(std::string_view english, const std::string* values, std::size_t number) {
  const std::vector<std::string_view> names = names_in(english);
  assert(names.size() == number);
  std::string said;
  read_pattern(
      translated(english), [&](std::string_view text) { said += text; },
      [&](std::string_view name) {
        const auto found =
            static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
        if (found < number) said += values[found];
      });
  return said;
}

std::string listed(const std::vector<std::string>& items) {
  if (items.size() < 2) return items.empty() ? std::string() : items[0];
  std::string ends[] = {items.front(), items.back()};
  for (std::size_t i = 1; i + 1 < items.size(); ++i) ends[0] += ", " + items[i];
  return say_written("{first} and {last}", ends, 2);
}

}  // namespace evenlift
