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
  for (pugi::xml_node each = node; each; each = each.parent())
    if (const pugi::xml_attribute found = each.attribute(declared.c_str()))
      return std::string_view(found.value()) != "http://www.w3.org/2000/svg";
  return false;  // a prefix that nothing declares is taken for SVG's
}

inline std::string_view value_of(const pugi::xml_node& node, const char* attribute) {
  return node.attribute(attribute).value();
}

}  // namespace evenlift
