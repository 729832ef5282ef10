#pragma once

#include <string>
#include <utility>

namespace evenlift::view {

// Returns the text for the caller in JavaScript, and keeps it alive until the next call.
inline const char* hand_over(std::string text) {
  static std::string kept;
  kept = std::move(text);
  return kept.c_str();
}

}  // namespace evenlift::view
