// Shared by the fuzzers. Each is one libFuzzer entry; a broken promise ends the program.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace fuzz {

// Unlike assert, it also works in builds without assertions.
inline void require(bool condition) {
  if (!condition) __builtin_trap();
}

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

}  // namespace fuzz
