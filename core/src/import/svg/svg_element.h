// Names and attributes of SVG elements.
#pragma once

#include <pugixml.hpp>
#include <string_view>

namespace evenlift {

// The name without its prefix: "href" for "xlink:href".
inline std::string_view without_prefix(std::string_view name) {
  const std::size_t colon = name.rfind(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

inline std::string_view local_name(const pugi::xml_node& node) {
  return without_prefix(node.name());
}

// Whether the element's prefix, if it has one, stands for another namespace than SVG.
inline bool is_foreign(const pugi::xml_node& node) {
  const std::string_view name = node.name();
  const std::size_t colon = name.find(':');
  if (colon == std::string_view::npos) return false;
  const std::string declared = "xmlns:" + std::string(name.substr(0, colon));
  constexpr int most_looked_at = 100;  // of the attributes of an element
  for (pugi::xml_node each = node; each; each = each.parent()) {
    int looked_at = 0;
    for (const pugi::xml_attribute attribute : each.attributes()) {
      if (++looked_at > most_looked_at) break;
      if (declared == attribute.name())
        return std::string_view(attribute.value()) != "http://www.w3.org/2000/svg";
    }
  }
  return false;  // a prefix that nothing declares is taken for SVG's
}

inline std::string_view value_of(const pugi::xml_node& node, const char* attribute) {
  return node.attribute(attribute).value();
}

}  // namespace evenlift
