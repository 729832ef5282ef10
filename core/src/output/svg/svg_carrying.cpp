#include "output/svg/svg_carrying.h"

#include "evenlift/output/carrying_words.h"
#include "output/svg/svg_markup.h"
#include "output/svg/svg_style.h"

namespace evenlift::svg {
namespace {

std::string green() { return attribute("fill", hull_colour) + attribute("fill-opacity", 0.3); }

std::string circle(const Vec2& at, double radius) {
  return element("circle",
                 attribute("class", "tilt") + attribute("cx", at.x) + attribute("cy", at.y) +
                     attribute("r", radius) + attribute("fill", "none") +
                     attribute("stroke", hull_outline_colour) + attribute("stroke-width", 1.25));
}

}  // namespace

std::string load_region(const std::vector<Points>& rings, const Points& region) {
  const std::string stripe =
      element("rect", attribute("width", 9) + attribute("height", 2.5) +
                          attribute("fill", overload_colour) + attribute("fill-opacity", 0.5));
  std::string out =
      "<defs>\n<pattern id=\"evenlift-no-load\"" + attribute("width", 9) + attribute("height", 9) +
      attribute("patternUnits", "userSpaceOnUse") + attribute("patternTransform", "rotate(-45)") +
      ">" + stripe + "</pattern>\n<clipPath id=\"evenlift-object\">" +
      element("path", path(rings) + attribute("clip-rule", "evenodd")) + "</clipPath>\n</defs>\n" +
      element("path", attribute("class", "no-load") + path(rings) +
                          attribute("fill-rule", "evenodd") +
                          attribute("fill", "url(#evenlift-no-load)"));
  if (region.size() < 3) return out;
  const std::string area = path(region, true) + attribute("clip-path", "url(#evenlift-object)");
  out += element("path", area + attribute("fill", object_colour));
  return out + element("path", attribute("class", "load-region") + area + green());
}

std::string load_swatch() {
  return element("rect", attribute("x", -9) + attribute("y", -6) + attribute("width", 18) +
                             attribute("height", 12) + attribute("rx", 2) + green());
}

std::string tilt_marks(const ShownPlacement& of, const Paper& paper) {
  const Vec2 centre = paper(of.placement.centre_of_mass);
  std::string out;
  for (const TiltCircle& each : tilt_circles(of, paper.scale)) {
    const double radius = each.radius * paper.scale;
    out += circle(centre, radius);
    if (each.is_labelled)
      out += text(centre - Vec2(0, radius - 4), 11, degrees_in_words(each.degrees),
                  attribute("text-anchor", "middle") + attribute("fill", text_colour) +
                      attribute("stroke", "#FFFFFF") + attribute("stroke-width", 3) +
                      attribute("paint-order", "stroke"));
  }
  return out;
}

std::string tilt_swatch() { return circle(Vec2(0, 0), 5.5); }

}  // namespace evenlift::svg
