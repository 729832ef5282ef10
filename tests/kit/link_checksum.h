// The checksum of docs/link-format.md, for hostile payloads that need a valid one.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace evenlift::testing {

inline constexpr std::string_view link_characters =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";

inline std::string with_checksum(std::string text) {
  std::uint32_t crc = 0xb704ce;
  for (const char c : text) {
    crc ^= static_cast<std::uint32_t>(static_cast<unsigned char>(c)) << 16;
    for (int i = 0; i < 8; ++i) crc = (crc << 1) ^ ((crc & 0x800000) != 0 ? 0x1864cfbu : 0u);
  }
  for (int shift = 18; shift >= 0; shift -= 6) text += link_characters[crc >> shift & 63];
  return text;
}

}  // namespace evenlift::testing
