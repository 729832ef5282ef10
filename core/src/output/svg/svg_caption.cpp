#include "output/svg/svg_parts.h"

#include <string_view>
#include <vector>

#include "evenlift/output/carrying_words.h"
#include "evenlift/output/weighing_words.h"
#include "evenlift/wording.h"

namespace evenlift::svg {
namespace {

// "Method: area · 3 teams · minimum load ratio 0.8 · coverage 81 % · no form closure", and
// other given settings.
std::string settings_line(const ShownPlacement& of) {
  const Placement& placement = of.placement;
  const Shown& shown = of.shown;
  const Settings& settings = placement.settings;
  const bool by_ratio = selects_candidates(settings.method);
  const std::string method = method_in_words(settings.method);
  std::string line =
      settings.method == Method::random
          ? say("Method: {method}, seed {seed}", {method, std::to_string(settings.seed)})
          : say("Method: {method}", {method});
  line += " · " + (is_one_team(settings.method)
                       ? count_of(count_robots(placement.teams), "robot", "robots")
                       : count_of(placement.teams.size(), "team", "teams"));
  const auto add = [&](const char* pattern, std::initializer_list<Value> values = {}) {
    line += " · " + say(pattern, values);
  };
  if (by_ratio) add("minimum load ratio {ratio}", {plain(settings.min_ratio)});
  add("coverage {coverage}", {percentage(placement.coverage)});
  if (shown.capacity)
    add("a robot can carry {weight}", {given_weight(*shown.capacity, shown.units)});
  if (shown.com_radius > 0)
    add("C uncertainty {length}", {given_length(shown.com_radius, shown.units)});
  const Carrying& carrying = shown.carrying;
  if (carrying.has_height())
    add("C at a height of {length}", {given_length(carrying.com_height, shown.units)});
  if (carrying.slope > 0) add("slopes up to {slope}", {slope_in_words(carrying.slope)});
  add(placement.closure.form_closure ? "form closure" : "no form closure");
  if (const std::size_t holes = placement.object.holes().size())
    add(holes == 1 ? "{holes}\u00A0hole" : "{holes}\u00A0holes", {holes});
  if (const std::size_t items = settings.cargo.size())
    add(items == 1 ? "{items}\u00A0item of\u00A0cargo" : "{items}\u00A0items of\u00A0cargo",
        {items});
  return line;
}

struct KeyEntry {
  std::string swatch;  // centred on (0, 0), in a box of 18 x 12
  std::string_view words;
};

std::vector<KeyEntry> key(const Seen& seen) {
  const auto swatch = [](const std::string& fill, std::string_view stroke) {
    return element("rect", attribute("x", -9) + attribute("y", -6) + attribute("width", 18) +
                               attribute("height", 12) + attribute("rx", 2) + fill +
                               attribute("stroke", stroke) + attribute("stroke-width", 1.25));
  };
  std::vector<KeyEntry> entries;
  if (seen.hull)
    entries.push_back({swatch(attribute("fill", hull_colour) + attribute("fill-opacity", 0.24),
                              hull_outline_colour),
                       "lifting base"});
  if (seen.clockwise)
    entries.push_back(
        {swatch(region_fill(true), clockwise_colour), "can turn clockwise about here"});
  if (seen.counterclockwise)
    entries.push_back({swatch(region_fill(false), counterclockwise_colour),
                       "can turn counter-clockwise about here"});
  if (seen.slide) entries.push_back({arrow({-9, 0}, {9, 0}, slide_colour), "can slide this way"});
  entries.push_back({centre_mark(Vec2(0, 0), 6), "centre of mass"});
  if (seen.own_centre)
    entries.push_back({own_centre_mark(Vec2(0, 0), 5), "centre of mass without cargo"});
  if (seen.load) entries.push_back({load_swatch(), "a further load may stand here"});
  if (seen.tilt) entries.push_back({tilt_swatch(), "slope at which it tips that way"});
  if (seen.cargo) entries.push_back({cargo_disc(Vec2(0, 0), 6), "cargo, by weight"});
  if (seen.body)
    entries.push_back(
        {element("circle", attribute("r", 6) + attribute("fill", body_colour) +
                               attribute("fill-opacity", 0.15) + attribute("stroke", body_colour)),
         "robot's body"});
  const auto stroke = [](std::string_view colour) {
    return element("path", path({{-9, 0}, {9, 0}}, false) + attribute("stroke", colour) +
                               attribute("stroke-width", 5));
  };
  if (seen.no_go) entries.push_back({stroke(no_go_colour), "no-go edge"});
  if (seen.unusable) entries.push_back({stroke(unusable_colour), "no robot fits here"});
  if (seen.overload)
    entries.push_back({text({-9, 4.5}, 13, "00",
                            attribute("fill", overload_colour) + attribute("font-weight", 600)),
                       "more than a robot can carry"});
  return entries;
}

}  // namespace

Caption make_caption(const Reported& of, const Seen& seen, double top, double width) {
  const std::string dark = attribute("fill", text_colour);
  const std::string grey = attribute("fill", second_text_colour);
  Caption caption;
  double y = top + 14;
  const auto paragraph = [&](const std::string& words, double size, const std::string& look) {
    for (const std::string& line : wrapped(words, size, width - 2 * caption_margin)) {
      y += 1.4 * size;
      caption.markup += text({caption_margin, y}, size, line, look);
    }
    y += 2;
  };
  paragraph(loads_in_words(of), 17, dark + attribute("font-weight", 600));
  paragraph(detail_in_words(of), 15, dark);
  if (const std::string weighed = weighed_in_words(of); !weighed.empty())
    paragraph(weighed, 15, dark);
  const Carrying& carrying = of.shown.carrying;
  if (carrying.dynamic > 1 || carrying.weight_doubt > 0) paragraph(use_in_words(of), 15, dark);
  if (seen.tilt) paragraph(tilt_in_words(of), 15, dark);
  if (seen.load) paragraph(extra_in_words(of), 15, dark);
  paragraph(settings_line(of), 13, grey);

  double x = caption_margin;
  y += 24;
  for (const KeyEntry& entry : key(seen)) {
    const std::string_view words = translated(entry.words);
    const double needed = 26 + text_width(words, 13) + 18;
    if (x > caption_margin && x + needed > width) {
      x = caption_margin;
      y += 22;
    }
    const std::string place = "translate(" + px(x + 9) + " " + px(y - 4.5) + ")";
    caption.markup += "<g" + attribute("transform", place) + ">" + entry.swatch + "</g>\n";
    caption.markup += text({x + 26, y}, 13, words, grey);
    x += needed;
  }
  caption.height = y + 20 - top;
  return caption;
}

std::string region_fill(bool clockwise) {
  return attribute("fill",
                   clockwise ? "url(#evenlift-clockwise)" : "url(#evenlift-counterclockwise)");
}

std::string fills() {
  const auto pattern = [](std::string_view id, std::string_view colour, std::string_view turn) {
    const std::string side = attribute("width", 9);
    return "<pattern" + attribute("id", id) + side + attribute("height", 9) +
           attribute("patternUnits", "userSpaceOnUse") + attribute("patternTransform", turn) + ">" +
           element("rect", side + attribute("height", 9) + attribute("fill", colour) +
                               attribute("fill-opacity", 0.08)) +
           element("rect", side + attribute("height", 1.2) + attribute("fill", colour) +
                               attribute("fill-opacity", 0.42)) +
           "</pattern>\n";
  };
  return "<defs>\n" + pattern("evenlift-clockwise", clockwise_colour, "rotate(-45)") +
         pattern("evenlift-counterclockwise", counterclockwise_colour, "rotate(45)") + "</defs>\n";
}

std::string centre_mark(const Vec2& at, double radius) {
  const std::string r = px(radius);
  const std::string arc = "A" + r + " " + r + " 0 0 1 ";
  const std::string quarters = "M0 0V-" + r + arc + r + " 0ZM0 0V" + r + arc + "-" + r + " 0Z";
  return "<g class=\"centre-of-mass\"" +
         attribute("transform", "translate(" + px(at.x) + " " + px(at.y) + ")") + ">\n" +
         element("circle", attribute("r", radius + 2) + attribute("fill", "#FFFFFF")) +
         element("path", attribute("d", quarters) + attribute("fill", text_colour)) +
         element("circle", attribute("r", radius) + attribute("fill", "none") +
                               attribute("stroke", text_colour) + attribute("stroke-width", 1.75)) +
         "</g>\n";
}

}  // namespace evenlift::svg
