#include "output/svg/svg_cargo.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "evenlift/output/markup.h"
#include "evenlift/output/picture.h"
#include "evenlift/output/words.h"
#include "evenlift/plane.h"
#include "output/svg/svg_markup.h"
#include "output/svg/svg_style.h"

namespace evenlift::svg {
namespace {

constexpr std::size_t most_characters = 24;  // of a name

std::string first_characters(const std::string& text, std::size_t number) {
  std::size_t end = 0, characters = 0;
  for (; end < text.size(); ++end) {
    const bool begins = (static_cast<unsigned char>(text[end]) & 0xC0) != 0x80;
    if (begins && characters++ == number) break;
  }
  return text.substr(0, end);
}

std::string disc(std::string_view name, const Vec2& at, double radius, const std::string& look) {
  return element("circle", attribute("class", name) + attribute("cx", at.x) +
                               attribute("cy", at.y) + attribute("r", radius) + look);
}

}  // namespace

void add_discs_of_cargo(const Placement& placement, Points& points) {
  const std::vector<Cargo>& cargo = placement.settings.cargo;
  if (cargo.empty()) return;
  const Box box = bounding_box(placement.vertices());
  const std::vector<double> radii = cargo_radii(placement);
  for (std::size_t i = 0; i < cargo.size(); ++i) {
    const Vec2 off = cargo[i].at - box.middle();
    const double beyond =
        std::max(std::fabs(off.x) - box.size().x / 2, std::fabs(off.y) - box.size().y / 2);
    if (beyond > placement.polygon().diameter() / 2) continue;
    const Vec2 corner(radii[i], radii[i]);
    points.emplace_back(cargo[i].at - corner);
    points.emplace_back(cargo[i].at + corner);
  }
}

std::string cargo_disc(const Vec2& at, double radius) {
  return disc("cargo", at, radius,
              attribute("fill", cargo_colour) + attribute("fill-opacity", 0.3) +
                  attribute("stroke", cargo_colour) + attribute("stroke-width", 1.5));
}

std::string own_centre_mark(const Vec2& at, double radius) {
  return disc("own-centre", at, radius,
              attribute("fill", object_colour) + attribute("stroke", text_colour) +
                  attribute("stroke-width", 1.75));
}

std::string cargo_label(const Cargo& item, const Units& units) {
  if (item.name.empty()) return given_weight(item.weight, units);
  if (character_count(item.name) <= most_characters) return item.name;
  return first_characters(item.name, most_characters - 1) + "…";
}

}  // namespace evenlift::svg
