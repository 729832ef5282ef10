// The methods in words.
#pragma once

#include <algorithm>
#include <iterator>

#include <vector>

#include "evenlift/document.h"
#include "widgets/text.h"

namespace evenlift::view {

struct MethodWords {
  Method method;
  const char* label;
  const char* about;
};
inline constexpr MethodWords methods[] = {
    {Method::area, "Area", "each team adds the most area"},
    {Method::circle, "Circle", "each team fits the largest circles"},
    {Method::distance, "Distance", "each team shortens what juts out"},
    {Method::distributed, "Equal angles", "teams at equal angles, for comparison"},
    {Method::random, "Random", "teams at random, for comparison"},
    {Method::balanced, "Balanced", "all robots can carry the same load"},
    {Method::given, "By hand", "robots where you put them"},
};

inline const MethodWords& words_of(Method method) {
  return *std::find_if(std::begin(methods), std::end(methods),
                       [&](const MethodWords& m) { return m.method == method; });
}

inline std::vector<Choice> method_choices() {
  std::vector<Choice> choices;
  for (const MethodWords& m : methods) choices.push_back({m.label, m.about});
  return choices;
}

}  // namespace evenlift::view
