#include "document/support_settings.h"

#include <algorithm>
#include <utility>

#include "document/list_text.h"
#include "document/stand_settings.h"
#include "evenlift/numbers.h"
#include "evenlift/settings.h"

namespace evenlift {
namespace {

struct Given {
  Vec2 at;
  std::optional<double> capacity;
};

std::optional<Given> read_support(std::string_view word) {
  const std::size_t comma = word.find(','), sign = word.find('@');
  if (comma == std::string_view::npos) return std::nullopt;
  const std::size_t end = std::min(sign, word.size());
  if (comma > end) return std::nullopt;
  const auto x = read_number(word.substr(0, comma)),
             y = read_number(word.substr(comma + 1, end - comma - 1));
  if (!x || !y) return std::nullopt;
  Given given{Vec2(*x, *y), std::nullopt};
  if (sign == std::string_view::npos) return given;
  given.capacity = read_number(word.substr(sign + 1));
  if (!given.capacity || !is_in_range(Setting::capacity, *given.capacity)) return std::nullopt;
  return given;
}

}  // namespace

bool read_supports(std::string_view text, Document& document) {
  Points supports;
  Capacities capacities;
  const bool good = text == "none" || for_each_item(text, [&](std::string_view word) {
                      const std::optional<Given> given = read_support(word);
                      if (!given || supports.size() == most_supports) return false;
                      supports.push_back(given->at);
                      capacities.push_back(given->capacity);
                      return true;
                    });
  if (!good || (supports.empty() && text != "none")) return false;
  if (!are_capacities(capacities)) capacities.clear();  // none is given
  document.settings.supports = std::move(supports);
  document.shown.support_capacities = std::move(capacities);
  if (!document.settings.supports.empty()) document.settings.method = Method::given;
  return true;
}

std::string_view refused_support(std::string_view text) { return refused_item(text, read_support); }

std::string supports_text(const Points& supports) {
  std::string text;
  for (const Vec2& at : supports)
    text += (text.empty() ? "" : " ") + shortest(at.x) + ',' + shortest(at.y);
  return text.empty() ? "none" : text;
}

bool read_capacities(std::string_view text, Capacities& capacities) {
  Capacities read;
  const bool good = text.empty() || for_each_word(text, [&](std::string_view word) {
                      const std::optional<double> capacity = read_number(word);
                      read.push_back(capacity);
                      return capacity || word == "none";
                    });
  if (!good || !(read.empty() || are_capacities(read))) return false;
  capacities = std::move(read);
  return true;
}

std::string capacities_text(const Capacities& capacities) {
  std::string text;
  for (const std::optional<double>& capacity : capacities)
    text += (text.empty() ? "" : ",") + (capacity ? shortest(*capacity) : std::string("none"));
  return text;
}

bool are_capacities(const Capacities& capacities) {
  if (capacities.empty()) return true;
  if (capacities.size() > most_supports) return false;
  bool any = false;
  for (const std::optional<double>& capacity : capacities) {
    if (!capacity) continue;
    if (!is_in_range(Setting::capacity, *capacity)) return false;
    any = true;
  }
  return any;
}

}  // namespace evenlift
