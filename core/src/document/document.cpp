#include "evenlift/document.h"

namespace evenlift {

std::string_view name(Method method) {
  switch (method) {
    case Method::area:
      return "area";
    case Method::circle:
      return "circle";
    case Method::distance:
      return "distance";
    case Method::distributed:
      return "distributed";
    case Method::random:
      return "random";
  }
  return {};
}

std::optional<Method> method_from_name(std::string_view text) {
  for (const Method method : all_methods) {
    if (text == name(method)) return method;
  }
  return std::nullopt;
}

}  // namespace evenlift
