// Codes the settings of version 1, with which every share link begins, and what
// docs/link-format.md calls a separate number.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

#include "evenlift/document.h"
#include "exact/pseudo_angle.h"
#include "link/quantizer.h"
#include "link/range_coder.h"

namespace evenlift {

// The defaults of version 1.0.0, which a link omits. They are still the defaults. If a default
// changes, set the old value here; until then, a test in test_link.cpp fails.
inline Document defaults_of_links() { return {}; }

// The document's settings of version 1. Settings added later have their defaults here; a link holds
// them in records if they differ (records.h).
inline Document settings_of_link_1(const Document& document) {
  Document first = defaults_of_links();
  const Settings& settings = document.settings;
  first.settings.teams = settings.teams;
  if (!is_one_team(settings.method)) first.settings.method = settings.method;
  first.settings.min_ratio = settings.min_ratio;
  first.settings.weight = settings.weight;
  first.settings.seed = settings.seed;
  first.shown.overlays = document.shown.overlays;
  first.shown.overlays.halo = first.shown.overlays.tilt = first.shown.overlays.load = false;
  first.shown.step = document.shown.step;
  return first;
}

// Codes a finite number as a decimal if decimals_of() finds one, otherwise as 64 bits. O(1).
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

// The overlays of version 1 as bits, except tipping, which has no bit (code_settings()).
inline std::uint32_t overlay_mask(const Overlays& shown) {
  return (shown.candidates ? 1u : 0u) | (shown.chords ? 2u : 0u) | (shown.lifting_base ? 4u : 0u) |
         (shown.clockwise ? 8u : 0u) | (shown.counterclockwise ? 16u : 0u);
}

inline Overlays overlays_of_mask(std::uint32_t mask, bool tipping) {
  return {(mask & 1) != 0, (mask & 2) != 0,  (mask & 4) != 0,
          (mask & 8) != 0, (mask & 16) != 0, tipping};
}

template <class Coder>
std::optional<std::uint32_t> code_teams(Coder& coder, std::optional<std::uint32_t> teams) {
  constexpr int widest = 21;
  static_assert(max_teams == 1u << (widest - 1));
  const bool every_candidate = coder.code_uniform(teams ? 0 : 1, 2) != 0;
  if (every_candidate) return std::nullopt;
  return static_cast<std::uint32_t>(code_integer(coder, teams.value_or(0), widest));
}

// Codes the settings that differ from their defaults. If the coder is a decoder, the document must
// have the defaults before the call. O(1).
template <class Coder>
void code_settings(Coder& coder, Document& document) {
  const Document defaults = defaults_of_links();
  const Settings& usual = defaults.settings;
  document = settings_of_link_1(document);
  Settings& settings = document.settings;
  Overlays& overlays = document.shown.overlays;
  std::optional<std::uint32_t>& step = document.shown.step;
  // These two comparisons are of bits, so -0 and 0 differ.
  const bool ratio = !same_bits(settings.min_ratio, usual.min_ratio);
  const bool weight = !same_bits(settings.weight, usual.weight);
  const auto differs = [&](bool different) {
    return coder.code_uniform(different ? 1 : 0, 2) != 0;
  };

  BitModel model{{15, 1}};
  if (!coder.code_bit(
          ratio || weight || !(settings == usual) || !(document.shown == defaults.shown), model))
    return;
  if (differs(settings.teams != usual.teams)) settings.teams = code_teams(coder, settings.teams);
  if (differs(settings.method != usual.method)) {
    const auto index =
        std::max(1u, static_cast<unsigned>(settings.method)) - 1;  // a decoder's method is area
    settings.method = static_cast<Method>(1 + coder.code_uniform(index, 4));
  }
  if (differs(ratio)) settings.min_ratio = code_number(coder, settings.min_ratio);
  if (differs(weight)) settings.weight = code_number(coder, settings.weight);
  if (differs(settings.seed != usual.seed)) settings.seed = code_integer(coder, settings.seed, 64);
  if (differs(!(overlays == defaults.shown.overlays))) {
    // Default overlays are not written, so the default mask is free to mean something else here:
    // that tipping is shown, and that the mask of the other overlays follows.
    const std::uint32_t sign = overlay_mask(defaults.shown.overlays),
                        shown = overlay_mask(overlays);
    std::uint32_t mask = coder.code_uniform(overlays.tipping ? sign : shown, 32);
    const bool tipping = mask == sign;
    if (tipping) mask = coder.code_uniform(shown, 32);
    overlays = overlays_of_mask(mask, tipping);
  }
  if (differs(step.has_value())) {
    step = static_cast<std::uint32_t>(code_integer(coder, step.value_or(0), 32));
  }
}

}  // namespace evenlift
