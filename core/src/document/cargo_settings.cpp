#include "document/cargo_settings.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "document/list_text.h"
#include "evenlift/numbers.h"
#include "evenlift/settings.h"
#include "numbers/utf8.h"

namespace evenlift {
namespace {

// A name as it is, or between quotes with each of its quotes doubled.
std::optional<std::string> read_name(std::string_view text) {
  if (text.empty()) return std::nullopt;
  if (text.find('"') == std::string_view::npos) return std::string(text);
  if (text.size() < 2 || text.front() != '"' || text.back() != '"') return std::nullopt;
  std::string name;
  for (std::size_t i = 1; i + 1 < text.size(); ++i) {
    if (text[i] == '"' && (++i + 1 == text.size() || text[i] != '"')) return std::nullopt;
    name += text[i];
  }
  return name;
}

std::string name_text(const std::string& name) {
  if (name.find_first_of(" \"") == std::string::npos) return name;
  std::string text = "\"";
  for (const char c : name) text += c == '"' ? std::string("\"\"") : std::string(1, c);
  return text + '"';
}

// Of ASCII, or U+0080 to U+009F.
bool is_control(std::string_view character) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(character[i]); };
  if (character.size() == 1) return byte(0) < 0x20 || byte(0) == 0x7f;
  return byte(0) == 0xc2 && byte(1) < 0xa0;
}

bool is_item(const Cargo& item) {
  return is_finite(item.at) && max_norm(item.at) <= max_coordinate &&
         !fault_of_cargo_weight(item.weight) && !fault_of_cargo_name(item.name);
}

std::optional<Cargo> read_item(std::string_view text) {
  const std::size_t comma = text.find(','), colon = std::min(text.find(':'), text.size());
  if (comma > colon || colon == text.size()) return std::nullopt;
  const std::size_t end = std::min(text.find(':', colon + 1), text.size());
  const auto x = read_number(text.substr(0, comma)),
             y = read_number(text.substr(comma + 1, colon - comma - 1)),
             weight = read_number(text.substr(colon + 1, end - colon - 1));
  const std::optional<std::string> name =
      end == text.size() ? std::string() : read_name(text.substr(end + 1));
  if (!x || !y || !weight || !name) return std::nullopt;
  Cargo item{Vec2(*x, *y), *weight, *name};
  return is_item(item) ? std::optional(std::move(item)) : std::nullopt;
}

}  // namespace

const char* fault_of_cargo_weight(double weight) {
  static_assert(min_weight == 1e-100 && max_weight == 1e100, "the message names the numbers");
  return weight >= min_weight && weight <= max_weight
             ? nullptr
             : "the weight of cargo must be a number greater than 0, from 1e-100 to 1e100";
}

const char* fault_of_cargo_name(std::string_view name) {
  static_assert(max_name_characters == 60, "the message names the number");
  for (std::size_t characters = 0; !name.empty(); ++characters) {
    const std::size_t length = utf8_length(name);
    if (length == 0) return "the name of cargo must be valid UTF-8";
    if (is_control(name.substr(0, length)))
      return "the name of cargo must have no control characters";
    if (characters == max_name_characters)
      return "the name of cargo must have at most 60 characters";
    name.remove_prefix(length);
  }
  return nullptr;
}

bool read_cargo(std::string_view text, std::vector<Cargo>& cargo) {
  std::vector<Cargo> read;
  const bool good = text == "none" || for_each_item(text, [&](std::string_view word) {
                      std::optional<Cargo> item = read_item(word);
                      if (!item || read.size() == max_cargo) return false;
                      read.push_back(*std::move(item));
                      return true;
                    });
  if (!good || (read.empty() && text != "none")) return false;
  cargo = std::move(read);
  return true;
}

std::string_view refused_cargo(std::string_view text) { return refused_item(text, read_item); }

std::string cargo_text(const std::vector<Cargo>& cargo) {
  std::string text;
  for (const Cargo& item : cargo) {
    text += (text.empty() ? "" : " ") + shortest(item.at.x) + ',' + shortest(item.at.y) + ':' +
            shortest(item.weight);
    if (!item.name.empty()) text += ':' + name_text(item.name);
  }
  return text.empty() ? "none" : text;
}

bool is_cargo(const std::vector<Cargo>& cargo) {
  return cargo.size() <= max_cargo && std::all_of(cargo.begin(), cargo.end(), is_item);
}

}  // namespace evenlift
