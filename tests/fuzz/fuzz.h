// Shared by the fuzzers; a broken promise ends the program.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace fuzz {

// Works without assertions, unlike assert.
inline void require(bool condition) {
  if (!condition) __builtin_trap();
}

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

}  // namespace fuzz
