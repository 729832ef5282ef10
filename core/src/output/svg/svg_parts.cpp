#include "output/svg/svg_parts.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "evenlift/output/carrying_words.h"
#include "evenlift/output/markup.h"
#include "evenlift/output/picture.h"
#include "evenlift/output/words.h"
#include "evenlift/plane.h"
#include "evenlift/stands.h"
#include "output/words/listed.h"

namespace evenlift {

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

std::size_t character_count(std::string_view text) {
  // Continuation bytes begin no character.
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
  }));
}

std::string shortened(std::string_view text, std::size_t most) {
  if (character_count(text) <= most) return std::string(text);
  std::size_t end = 0;
  for (std::size_t characters = 0; end < text.size(); ++end)
    if ((static_cast<unsigned char>(text[end]) & 0xC0) != 0x80 && ++characters == most) break;
  return std::string(text.substr(0, end)) + "…";
}

std::string robot_label(std::string_view name, const std::string& load) {
  constexpr std::size_t most = 16;
  if (name.empty()) return load;
  return shortened(name, most) + (load.empty() ? "" : " " + load);
}

}  // namespace evenlift

namespace evenlift::svg {

std::string px(double value) {
  std::string text = ascii_fixed(value, 2);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text;
}

std::string attribute(std::string_view name, std::string_view value) {
  return " " + std::string(name) + "=\"" + std::string(value) + "\"";
}

std::string attribute(std::string_view name, double value) { return attribute(name, px(value)); }

std::string element(std::string_view tag, std::string_view attributes) {
  return "<" + std::string(tag) + std::string(attributes) + "/>\n";
}

namespace {

std::string path_data(const Points& points, bool closed) {
  std::string data;
  for (const Vec2& p : points) data += (data.empty() ? "M" : "L") + px(p.x) + " " + px(p.y);
  return data + (closed ? "Z" : "");
}

}  // namespace

std::string path(const Points& points, bool closed) {
  return attribute("d", path_data(points, closed));
}

std::string path(const std::vector<Points>& rings) {
  std::string data;
  for (const Points& ring : rings) data += path_data(ring, true);
  return attribute("d", data);
}

std::string arrow(const Vec2& tail, const Vec2& head, std::string_view colour) {
  const Vec2 along = unit(head - tail), across(-along.y, along.x);
  const Vec2 neck = head - 9 * along;
  const auto line = [&](std::string_view stroke, double width) {
    return element("path", path({tail, neck}, false) + attribute("stroke", stroke) +
                               attribute("stroke-width", width) +
                               attribute("stroke-linecap", "round"));
  };
  return line("#FFFFFF", 6) + line(colour, 3) +
         element("path", path({head, neck + 5.5 * across, neck - 5.5 * across}, true) +
                             attribute("fill", colour) + attribute("stroke", "#FFFFFF") +
                             attribute("paint-order", "stroke") + attribute("stroke-width", 2));
}

std::string text(const Vec2& at, double size, std::string_view words, std::string_view attributes) {
  return "<text" + attribute("x", at.x) + attribute("y", at.y) + attribute("font-size", size) +
         std::string(attributes) + ">" + escaped(words) + "</text>\n";
}

double text_width(std::string_view words, double size, double average) {
  return average * size * static_cast<double>(character_count(words));
}

std::vector<std::string> wrapped(std::string_view words, double size, double width) {
  std::vector<std::string> lines = {""};
  while (!words.empty()) {
    const std::size_t end = words.find(' ');
    const std::string word(words.substr(0, end));
    words = end == std::string_view::npos ? "" : words.substr(end + 1);
    std::string& line = lines.back();
    if (line.empty())
      line = word;
    else if (text_width(line + " " + word, size) <= width)
      line += " " + word;
    else
      lines.push_back(word);
  }
  return lines;
}

Paper::Paper(const Points& vertices, double share) {
  const Box box = bounding_box(vertices);
  const Vec2 size = box.size();
  scale = share * std::min(largest_width / size.x, largest_height / size.y);
  middle = box.middle();
  width = std::max(share * smallest_width, std::ceil(size.x * scale) + 2 * margin);
  height = std::max(share * smallest_height, std::ceil(size.y * scale) + 2 * margin);
}

Vec2 Paper::operator()(const Vec2& p) const {
  return {width / 2 + (p.x - middle.x) * scale, height / 2 - (p.y - middle.y) * scale};
}

Points Paper::operator()(const Points& points) const {
  Points mapped;
  mapped.reserve(points.size());
  for (const Vec2& p : points) mapped.push_back((*this)(p));
  return mapped;
}

Points clipped(Points area, const Paper& paper) {
  return clip(std::move(area), Box{Vec2{}, Vec2(paper.width, paper.height)});
}

Points visible(const Points& outline) {
  constexpr double resolution = 0.04;
  Points kept;
  for (const Vec2& p : outline)
    if (kept.empty() || max_norm(p - kept.back()) > resolution) kept.push_back(p);
  return kept;
}

std::vector<Stand> find_stands(const Placement& placement, const std::vector<PlacedRobot>& sized,
                               const std::vector<LoadRange>& loads, const Paper& paper,
                               double apart) {
  std::vector<Stand> stands;
  std::size_t added = 0;
  const auto add = [&](const LiftingPoint& point, std::size_t team) {
    const std::size_t robot = added;
    const LoadRange load = loads.empty() ? LoadRange{} : loads[robot];
    const std::string number = std::to_string(placement.number_of(robot));
    const Vec2 at = paper(point.position);
    std::optional<Box> body;
    if (!sized.empty()) body = body_box(sized[added], placement.stands->robot(), paper);
    ++added;
    const auto taken = std::find_if(stands.begin(), stands.end(), [&](const Stand& stand) {
      return length(stand.at - at) < apart && stand.beneath == (point.edge == beneath);
    });
    if (taken == stands.end()) {
      stands.push_back({at,
                        number,
                        team,
                        {load},
                        {robot},
                        body,
                        point.edge == beneath,
                        std::string(placement.name_of(robot))});
    } else {
      taken->name.clear();
      taken->numbers += "·" + number;
      taken->team = 0;
      taken->loads.push_back(load);
      taken->robots.push_back(robot);
    }
  };
  const bool paired = !is_one_team(placement.settings.method);
  for (std::size_t i = 0; i < placement.teams.size(); ++i)
    for (const Robot& robot : placement.teams[i].robots) add(robot.point, paired ? i + 1 : 0);
  for (Stand& stand : stands)
    if (stand.loads.size() > 3) stand.numbers = "×" + std::to_string(stand.loads.size());
  return stands;
}

std::string load_text(const Stand& stand, double largest, const Units& units) {
  std::vector<std::string> texts;
  LoadRange sum;
  for (const LoadRange& load : stand.loads) {
    texts.push_back(amounts(load, largest));
    sum.least += load.least;
    sum.greatest += load.greatest;
  }
  const std::string& first = texts.front();
  if (texts.size() == 1) return with_weight_unit(first, units);
  if (std::all_of(texts.begin(), texts.end(), [&](const std::string& t) { return t == first; }))
    return std::to_string(texts.size()) + " × " + with_weight_unit(first, units);
  if (texts.size() == 2) return first + " + " + with_weight_unit(texts.back(), units);
  return "Σ " + load_in_words(sum, largest, units);
}

namespace {

std::string body(const PlacedRobot& robot, const RobotSize& size, const Paper& paper) {
  const Vec2 inward = robot.contact - robot.stand;
  const double way = length(inward);
  std::string out;
  if (size.reach > 0)
    out += element("path", attribute("class", "arm") +
                               path({paper(robot.stand), paper(robot.contact)}, false) +
                               attribute("stroke", body_colour) + attribute("stroke-width", 3));
  if (way > 0 && (size.depth > 0 || size.width > 0)) {
    const Vec2 aside = left_normal(inward) * (size.width / 2 / way);
    const Points hand{paper(robot.contact - aside), paper(robot.contact + aside),
                      paper(robot.at + aside), paper(robot.at - aside)};
    out += element("path", attribute("class", "hand") + path(hand, true) +
                               attribute("fill", body_colour) + attribute("fill-opacity", 0.3) +
                               attribute("stroke", body_colour));
  }
  if (size.radius == 0) return out;
  const Vec2 middle = paper(robot.stand);
  const double radius = size.radius * paper.scale;
  return out +
         element("circle", attribute("class", "body") + attribute("cx", middle.x) +
                               attribute("cy", middle.y) + attribute("r", radius) +
                               attribute("fill", body_colour) + attribute("fill-opacity", 0.15) +
                               attribute("stroke", body_colour));
}

}  // namespace

std::vector<PlacedRobot> robots_with_size(const Placement& placement) {
  if (!placement.stands || !placement.stands->has_body()) return {};
  return placed_robots(placement);
}

Points extent(const Placement& placement, const std::vector<PlacedRobot>& robots) {
  Points points = placement.vertices();
  for (const PlacedRobot& robot : robots) {
    const double radius = placement.stands->robot().radius;
    points.emplace_back(robot.stand - Vec2(radius, radius));
    points.emplace_back(robot.stand + Vec2(radius, radius));
  }
  add_discs_of_cargo(placement, points);
  return points;
}

std::string unusable_boundary(const Placement& placement, const Paper& paper) {
  if (!placement.stands) return "";
  std::string out;
  const Polygon& polygon = placement.polygon();
  for (const UnusablePart& part : placement.stands->unusable()) {
    const Vec2 &a = polygon.edge_start(part.edge), &b = polygon.edge_end(part.edge);
    const Vec2 along = (b - a) / length(b - a);
    const bool marked = part.why == WhyUnusable::no_go;
    out += element(
        "path",
        attribute("class", marked ? "no-go" : "unusable") +
            path({paper(a + part.part.from * along), paper(a + part.part.to * along)}, false) +
            attribute("stroke", marked ? no_go_colour : unusable_colour) +
            attribute("stroke-width", 5));
  }
  return out;
}

std::string bodies(const std::vector<PlacedRobot>& robots, const RobotSize& size,
                   const Paper& paper) {
  std::string out;
  for (const PlacedRobot& robot : robots) out += body(robot, size, paper);
  return out;
}

Box body_box(const PlacedRobot& robot, const RobotSize& size, const Paper& paper) {
  const Vec2 middle = paper(robot.stand), reach = Vec2(1, 1) * (size.radius * paper.scale);
  return {middle - reach, middle + reach};
}

namespace {

constexpr std::size_t most_characters = 24;  // of a name

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
  return shortened(item.name, most_characters);
}

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
