// The settings that share links of version 1 and later begin with, and numbers that are not vertices, for either coder.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

#include "evenlift/document.h"
#include "exact/bits.h"
#include "link/quantizer.h"
#include "link/range_coder.h"

namespace evenlift {

// The values of settings that a link of version 1 leaves out. They stay as they are even if the
// defaults of Settings change (test_link.cpp compares the two).
inline Settings defaults_of_link_1() {
  Settings settings;
  settings.teams = 3;
  settings.method = Method::area;
  settings.min_ratio = 0.8;
  settings.weight = 100;
  settings.seed = 1;
  settings.overlays = {false, true, true, true, true, false, false};
  settings.step = std::nullopt;
  return settings;
}

// The settings that came after version 1, which records hold if they are needed (records.h).
inline void forget_later_settings(Settings& settings) {
  const Settings usual;
  if (settings.method == Method::balanced) settings.method = usual.method;
  settings.robots = usual.robots;
  settings.goal = usual.goal;
  settings.min_margin = usual.min_margin;
  settings.apart = usual.apart;
  settings.clear = usual.clear;
  settings.survive = usual.survive;
  settings.positions = usual.positions;
  settings.com_radius = usual.com_radius;
  settings.capacity = usual.capacity;
  settings.units = usual.units;
  settings.robot = usual.robot;
  settings.no_go = usual.no_go;
  settings.overlays.halo = usual.overlays.halo;
}

// Codes a finite number: as a decimal if it has a short one, otherwise as its 64 bits. O(1).
template <class Coder>
double code_number(Coder& coder, double value) {
  int kind = 0;
  std::int64_t number = 0;
  if constexpr (!Coder::decoding) {
    kind = decimals_of(value);
    number = Scale(kind).number_of(value).value_or(0);
  }
  kind = static_cast<int>(coder.code_uniform(static_cast<std::uint32_t>(kind), Scale::doubles + 1));
  if (kind == Scale::doubles) return from_bits(code_bits(coder, to_bits(value), 64));
  const bool negative = coder.code_uniform(number < 0 ? 1 : 0, 2) != 0;
  const auto size =
      code_integer(coder, static_cast<std::uint64_t>(negative ? -number : number), 51);
  number = static_cast<std::int64_t>(size);
  return Scale(kind).value_of(negative ? -number : number);
}

// The overlays of version 1 as bits, except tipping, which came later.
inline std::uint32_t overlay_mask(const Overlays& shown) {
  return (shown.candidates ? 1u : 0u) | (shown.chords ? 2u : 0u) | (shown.lifting_base ? 4u : 0u) |
         (shown.clockwise ? 8u : 0u) | (shown.counterclockwise ? 16u : 0u);
}

inline Overlays overlays_of_mask(std::uint32_t mask, bool tipping) {
  return {(mask & 1) != 0,
          (mask & 2) != 0,
          (mask & 4) != 0,
          (mask & 8) != 0,
          (mask & 16) != 0,
          tipping,
          false};
}

template <class Coder>
std::optional<std::uint32_t> code_teams(Coder& coder, std::optional<std::uint32_t> teams) {
  constexpr int widest = 21;
  static_assert(max_teams == 1u << (widest - 1));
  const bool every_candidate = coder.code_uniform(teams ? 0 : 1, 2) != 0;
  if (every_candidate) return std::nullopt;
  return static_cast<std::uint32_t>(code_integer(coder, teams.value_or(0), widest));
}

// Codes the settings that differ from their defaults. When decoding, `settings` must hold the
// defaults. O(1).
template <class Coder>
void code_settings(Coder& coder, Settings& settings) {
  const Settings usual = defaults_of_link_1();
  forget_later_settings(settings);
  // Compares bits, because -0 and 0 must be told apart.
  const bool ratio = !same_bits(settings.min_ratio, usual.min_ratio);
  const bool weight = !same_bits(settings.weight, usual.weight);
  const auto differs = [&](bool different) {
    return coder.code_uniform(different ? 1 : 0, 2) != 0;
  };

  BitModel model{{15, 1}};
  if (!coder.code_bit(ratio || weight || !(settings == usual), model)) return;
  if (differs(settings.teams != usual.teams)) settings.teams = code_teams(coder, settings.teams);
  if (differs(settings.method != usual.method)) {
    const auto index =
        std::max(1u, static_cast<unsigned>(settings.method)) - 1;  // area is the default
    settings.method = static_cast<Method>(1 + coder.code_uniform(index, 4));
  }
  if (differs(ratio)) settings.min_ratio = code_number(coder, settings.min_ratio);
  if (differs(weight)) settings.weight = code_number(coder, settings.weight);
  if (differs(settings.seed != usual.seed)) settings.seed = code_integer(coder, settings.seed, 64);
  if (differs(!(settings.overlays == usual.overlays))) {
    // Overlays that are at their defaults are not written, so the default mask is free to say that
    // tipping is shown. Then the mask itself follows.
    const std::uint32_t sign = overlay_mask(usual.overlays),
                        shown = overlay_mask(settings.overlays);
    std::uint32_t mask = coder.code_uniform(settings.overlays.tipping ? sign : shown, 32);
    const bool tipping = mask == sign;
    if (tipping) mask = coder.code_uniform(shown, 32);
    settings.overlays = overlays_of_mask(mask, tipping);
  }
  if (differs(settings.step.has_value())) {
    settings.step = static_cast<std::uint32_t>(code_integer(coder, settings.step.value_or(0), 32));
  }
}

}  // namespace evenlift
