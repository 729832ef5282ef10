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

inline std::string_view value_of(const pugi::xml_node& node, const char* attribute) {
  return node.attribute(attribute).value();
}

}  // namespace evenlift
