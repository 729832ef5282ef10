#include "evenlift/output/svg.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "evenlift/output/label_places.h"
#include "evenlift/output/markup.h"
#include "evenlift/output/picture.h"
#include "evenlift/output/words.h"
#include "evenlift/stands.h"
#include "evenlift/tolerance.h"
#include "evenlift/wording.h"
#include "output/svg/svg_parts.h"

namespace evenlift {
namespace svg {
namespace {

// More loads or names would be unreadable. The JSON contains all loads.
constexpr std::size_t most_labels = 150;

// A smaller disc would be invisible.
constexpr double smallest_cargo_disc = 3;

// Beside a part of the picture.
struct Label {
  labels::Request request;
  std::string words;
  std::string look;
  bool overload = false;
};

class Drawing {
 public:
  explicit Drawing(const Reported& of, double share = 1)
      : of_(of),
        placement_(of.placement),
        sized_(robots_with_size(placement_)),
        paper_(extent(placement_, sized_), share) {
    const Placement& placement = placement_;
    const auto robots = static_cast<double>(count_robots(placement.teams));
    disc_ = std::clamp(13.5 - robots / 12, 6.5, 13.0);
    number_size_ = 1.15 * disc_;
    label_size_ = robots <= 12 ? 14 : robots <= 40 ? 12 : 10;
    chord_width_ = robots <= 24 ? 2 : robots <= 200 ? 1.25 : 0.6;
    // Lines to C only show which robots belong together.
    if (is_one_team(placement.settings.method)) chord_width_ = 0.75;
    const std::vector<LoadRange> loads =
        placement.loads ? of_.report.planned : std::vector<LoadRange>();
    for (const LoadRange& load : loads) largest_load_ = std::max(largest_load_, load.greatest);
    stands_ = find_stands(placement, sized_, loads, paper_, 0.8 * disc_);
  }

  std::string finished(std::string_view link, std::string_view cases) {
    const std::string drawing = drawn();
    return document(drawing, make_caption(of_, seen_, paper_.height, paper_.width), link, cases);
  }

  std::string without_caption() { return document(drawn(), {}, {}, {}); }

 private:
  // Later steps avoid and explain the shapes drawn before.
  std::string drawn() {
    std::string drawing;
    for (const Shape& shape : make_picture(placement_, of_.shown.overlays)) drawing += drawn(shape);
    if (placement_.stands) drawing += stands();
    drawing += tilt() + slide();
    if (own_centre_) drawing += own_centre_mark(*own_centre_, 6);
    drawing += robots();
    return drawing + named();
  }

  std::string document(const std::string& drawing, const Caption& caption, std::string_view link,
                       std::string_view cases) const {
    const double width = paper_.width, height = paper_.height + caption.height;
    const auto rect = [](double inset, double w, double h, const std::string& look) {
      return element("rect", attribute("x", inset) + attribute("y", inset) +
                                 attribute("width", w - 2 * inset) +
                                 attribute("height", h - 2 * inset) + look);
    };
    return "<svg xmlns=\"http://www.w3.org/2000/svg\"" + attribute("width", width) +
           attribute("height", height) +
           attribute("viewBox", "0 0 " + px(width) + " " + px(height)) +
           " role=\"img\" aria-labelledby=\"evenlift-title evenlift-description\""
           " font-family=\"Inter, 'Helvetica Neue', Helvetica, Arial, sans-serif\">\n" +
           "<title id=\"evenlift-title\">" + escaped(title()) + "</title>\n" +
           "<desc id=\"evenlift-description\">" + escaped(verdict(of_)) + "</desc>\n" +
           (link.empty() ? "" : "<metadata>" + escaped(link) + "</metadata>\n") +
           (cases.empty() ? "" : "<metadata>" + escaped(cases) + "</metadata>\n") + fills() +
           rect(0, width, height, attribute("fill", panel_colour)) +
           rect(0, width, paper_.height, attribute("fill", ground_colour)) + drawing +
           caption.markup +
           rect(0.5, width, height, attribute("fill", "none") + attribute("stroke", line_colour)) +
           "</svg>\n";
  }

  std::string title() const {
    const std::size_t robots = count_robots(placement_.teams);
    if (placement_.settings.method == Method::given)
      return say("{robots} that already stand, below {object}",
                 {count_of(robots, "robot", "robots"), object_named()});
    if (placement_.settings.method == Method::balanced)
      return say("{robots} lifting {object}",
                 {count_of(robots, "balanced robot", "balanced robots"), object_named()});
    return say("{teams} of two robots lifting {object}",
               {count_of(placement_.teams.size(), "team", "teams"), object_named()});
  }

  std::string object_named() const {
    const std::size_t holes = placement_.object.holes().size();
    const bool has_cargo = !placement_.settings.cargo.empty();
    if (holes == 0) return say(has_cargo ? "a polygonal object with cargo" : "a polygonal object");
    return say(
        has_cargo ? "a polygonal object with {holes} and cargo" : "a polygonal object with {holes}",
        {count_of(holes, "hole", "holes")});
  }

  std::string drawn(const Shape& shape) {
    switch (shape.role) {
      case Role::object:
        return object(shape) + load();
      case Role::clockwise:
        return region(shape, true, seen_.clockwise);
      case Role::counterclockwise:
        return region(shape, false, seen_.counterclockwise);
      case Role::lifting_base:
        return hull(shape);
      case Role::candidate:
        return drawn_path(
            "candidate", paper_(shape.points), false,
            attribute("stroke", candidate_colour) + attribute("stroke-dasharray", "5 4"));
      case Role::chord:
        chords_.emplace_back(paper_(shape.points[0]), paper_(shape.points[1]));
        return drawn_path(
            "chord", paper_(shape.points), false,
            attribute("stroke", chord_colour) + attribute("stroke-width", chord_width_));
      case Role::centre_of_mass:
        return centre_mark(paper_(shape.points[0]), 8);
      case Role::cargo:
        return cargo(shape);
      case Role::cargo_lever:
        return lever(shape);
      case Role::own_centre:
        // Drawn later, in front of arrows from here.
        if (is_on_paper(paper_(shape.points[0]))) own_centre_ = paper_(shape.points[0]);
        seen_.own_centre = own_centre_.has_value();
        break;
      case Role::robot:
        break;  // robots() draws robots at one place together
    }
    return "";
  }

  static std::string drawn_path(std::string_view name, const Points& points, bool closed,
                                const std::string& look) {
    return element("path", attribute("class", name) + path(points, closed) + look +
                               attribute("stroke-linejoin", "round"));
  }

  // Holes are empty: the inside of the path excludes them.
  std::string object(const Shape& shape) {
    outline_ = visible(paper_(shape.points));
    const std::string look = attribute("fill", object_colour) +
                             attribute("stroke", outline_colour) + attribute("stroke-width", 2);
    if (shape.holes.empty()) return drawn_path("object", outline_, true, look);
    for (const Points& hole : shape.holes) holes_.push_back(visible(paper_(hole)));
    std::vector<Points> rings = {outline_};
    rings.insert(rings.end(), holes_.begin(), holes_.end());
    return element("path", attribute("class", "object") + path(rings) +
                               attribute("fill-rule", "evenodd") + look +
                               attribute("stroke-linejoin", "round"));
  }

  // Where a further load may stand.
  std::string load() {
    seen_.load = of_.shown.overlays.load && of_.report.extra;
    if (!seen_.load) return "";
    std::vector<Points> rings = {outline_};
    rings.insert(rings.end(), holes_.begin(), holes_.end());
    return load_region(rings, paper_(of_.report.extra->region));
  }

  std::string tilt() {
    const std::string circles = of_.shown.overlays.tilt ? tilt_marks(of_, paper_) : std::string();
    seen_.tilt = !circles.empty();
    return circles;
  }

  // Items that overhang too far are off the paper.
  std::string cargo(const Shape& shape) {
    const Vec2 at = paper_(shape.points[0]);
    if (!is_on_paper(at)) return "";
    seen_.cargo = true;
    const double radius = std::max(smallest_cargo_disc, shape.radius * paper_.scale);
    const Vec2 corner(radius, radius);
    cargo_.push_back({shape.item, {at - corner, at + corner}});
    return cargo_disc(at, radius);
  }

  // From the object's own centre of mass to C.
  std::string lever(const Shape& shape) {
    const Points line = clipped(paper_(shape.points), paper_);
    if (line.size() < 2) return "";
    chords_.emplace_back(line[0], line[1]);
    return drawn_path("cargo-lever", line, false, attribute("stroke", text_colour));
  }

  bool is_on_paper(const Vec2& at) const {
    return at.x > 0 && at.x < paper_.width && at.y > 0 && at.y < paper_.height;
  }

  // With one team H is a segment: a broad stroke under the chord.
  std::string hull(const Shape& shape) {
    seen_.hull = shape.points.size() >= 3;
    const std::string stroke = attribute("stroke", hull_outline_colour);
    const std::string base = drawn_path(
        "hull", paper_(shape.points), seen_.hull,
        seen_.hull ? attribute("fill", hull_colour) + attribute("fill-opacity", 0.24) + stroke +
                         attribute("stroke-width", 1.75)
                   : stroke + attribute("stroke-width", 7) + attribute("stroke-opacity", 0.4) +
                         attribute("stroke-linecap", "round"));
    return holes_.empty() ? base : base + empty_holes();
  }

  // The ground in the holes covers what was drawn above the object.
  std::string empty_holes() const {
    return element("path", attribute("class", "holes") + path(holes_) +
                               attribute("fill", ground_colour) +
                               attribute("stroke", outline_colour) + attribute("stroke-width", 2) +
                               attribute("stroke-linejoin", "round"));
  }

  std::string region(const Shape& shape, bool clockwise, bool& shown) const {
    const Points area = clipped(paper_(shape.points), paper_);
    shown = !area.empty();
    if (!shown) return "";
    const std::string_view name = clockwise ? "clockwise" : "counterclockwise";
    const std::string look =
        region_fill(clockwise) +
        attribute("stroke", clockwise ? clockwise_colour : counterclockwise_colour) +
        attribute("stroke-width", 1.5) + attribute("stroke-opacity", 0.7) +
        // Both regions may shrink to the same line: one is dashed.
        (shape.points.size() == 2 && !clockwise ? attribute("stroke-dasharray", "8 8") : "");
    if (shape.points.size() > 1) return drawn_path(name, area, true, look);
    return element("circle", attribute("class", name) + attribute("cx", area[0].x) +
                                 attribute("cy", area[0].y) + attribute("r", clockwise ? 5 : 8) +
                                 look);
  }

  // A disc; a rounded box for several numbers.
  labels::Box disc(const Stand& stand) const {
    const double needed = text_width(stand.numbers, number_size_, 0.6) + 0.9 * disc_;
    const Vec2 half(std::max(disc_, needed / 2), disc_);
    return {stand.at - half, stand.at + half};
  }

  // The middle of a capital is 0.36 of the size above its baseline.
  static std::string centred(const Vec2& at, double size, std::string_view words,
                             const std::string& look) {
    return text(at + Vec2(0, 0.36 * size), size, words,
                attribute("text-anchor", "middle") + attribute("font-weight", 600) + look);
  }

  std::string stands() {
    const Stands& rules = *placement_.stands;
    seen_.body = rules.has_body();
    for (const UnusablePart& part : rules.unusable())
      (part.why == WhyUnusable::no_go ? seen_.no_go : seen_.unusable) = true;
    return unusable_boundary(placement_, paper_) + bodies(sized_, rules.robot(), paper_);
  }

  // From C in a direction in which the object can slide freely.
  std::string slide() {
    const Closure& closure = placement_.closure;
    seen_.slide = closure.translation_free && closure.translation && !placement_.teams.empty();
    if (!seen_.slide) return "";
    const Vec2 along(closure.translation->x, -closure.translation->y);
    const Vec2 centre = paper_(placement_.centre_of_mass);
    const Vec2 tail = centre + along * 14, head = centre + along * 58;
    chords_.emplace_back(tail, head);
    return "<g class=\"slide\">\n" + arrow(tail, head, slide_colour) + "</g>\n";
  }

  std::vector<TallyStroke> strokes_of(const Stand& stand) const {
    const Vec2 outward = stand.at - paper_(placement_.centre_of_mass);
    return tally(stand.team, stand.at, outward, disc_ + 1.5);
  }

  // A pale body, not to scale, and the team's mark beneath each disc. Very many would hide each
  // other.
  std::string around_robots() const {
    std::string out;
    if (stands_.size() > most_labels) return out;
    for (const Stand& stand : stands_) {
      labels::Box box = disc(stand);
      const Vec2 beyond(0.4 * disc_, 0.4 * disc_);
      box = {box.low - beyond, box.high + beyond};
      const Vec2 size = box.high - box.low;
      if (sized_.empty())
        out +=
            element("rect", attribute("class", "small-body") + attribute("x", box.low.x) +
                                attribute("y", box.low.y) + attribute("width", size.x) +
                                attribute("height", size.y) + attribute("rx", size.y / 2) +
                                attribute("fill", body_colour) + attribute("fill-opacity", 0.15));
      for (const auto& [line, five] : strokes_of(stand))
        out += element("path", attribute("class", "tally") + path({line.from, line.to}, false) +
                                   attribute("stroke", text_colour) +
                                   attribute("stroke-width", five ? 3.5 : 1.75));
    }
    return out;
  }

  std::string robots() const {
    std::string out = around_robots();
    for (std::size_t i = stands_.size(); i-- > 0;) {  // first teams on top
      const labels::Box box = disc(stands_[i]);
      const Vec2 size = box.high - box.low;
      constexpr const char* white = "#FFFFFF";
      const bool beneath = stands_[i].beneath;  // pale, with a dashed rim
      out += element(
          "rect",
          attribute("class", beneath ? "robot beneath" : "robot") + attribute("x", box.low.x) +
              attribute("y", box.low.y) + attribute("width", size.x) + attribute("height", size.y) +
              attribute("rx", disc_) + attribute("fill", beneath ? white : text_colour) +
              attribute("stroke", beneath ? text_colour : white) + attribute("stroke-width", 1.5) +
              (beneath ? " stroke-dasharray=\"3 2\"" : ""));
      out += centred(stands_[i].at, number_size_, stands_[i].numbers,
                     attribute("fill", beneath ? text_colour : white));
    }
    return out;
  }

  bool overloads(const Stand& stand) const {
    const std::vector<std::size_t>& all = of_.report.overloaded_as_planned;
    return std::any_of(stand.robots.begin(), stand.robots.end(), [&](std::size_t robot) {
      return std::find(all.begin(), all.end(), robot) != all.end();
    });
  }

  // What words must not cover, or should avoid.
  labels::Surroundings surroundings() const {
    const Vec2 centre = paper_(placement_.centre_of_mass);
    labels::Surroundings around;
    around.frame = {Vec2(6, 6), Vec2(paper_.width - 6, paper_.height - 6)};
    around.outline = outline_;
    around.holes = holes_;
    around.chords = chords_;
    around.marks = {{centre - Vec2(11, 11), centre + Vec2(11, 11)}};
    for (const Stand& stand : stands_) {
      around.marks.push_back(disc(stand));
      for (const TallyStroke& stroke : strokes_of(stand))
        around.marks.push_back({componentwise_min(stroke.line.from, stroke.line.to),
                                componentwise_max(stroke.line.from, stroke.line.to)});
    }
    for (const PlacedRobot& robot : sized_) {
      around.marks.push_back(body_box(robot, placement_.stands->robot(), paper_));
      around.chords.emplace_back(paper_(robot.at), paper_(robot.stand));
    }
    for (const auto& [item, box] : cargo_) around.marks.push_back(box);
    if (own_centre_) around.marks.push_back({*own_centre_ - Vec2(8, 8), *own_centre_ + Vec2(8, 8)});
    return around;
  }

  Label label(const labels::Box& owner, const Vec2& away, std::string words,
              std::string look) const {
    const double width = text_width(words, label_size_, 0.58);
    return {{owner, away, {width, label_size_}}, std::move(words), std::move(look)};
  }

  void add_loads(std::vector<Label>& wanted) const {
    if (stands_.size() > most_labels) return;
    const Vec2 centre = paper_(placement_.centre_of_mass);
    for (const Stand& stand : stands_) {
      const bool over = placement_.loads && overloads(stand);
      const std::string load =
          placement_.loads ? load_text(stand, largest_load_, of_.shown.units) : std::string();
      if (load.empty() && stand.name.empty()) continue;
      wanted.push_back(label(stand.body.value_or(disc(stand)), stand.at - centre,
                             robot_label(stand.name, load),
                             attribute("class", over ? "load overload" : "load") +
                                 attribute("fill", over ? overload_colour : text_colour)));
      wanted.back().overload = over;
    }
  }

  // Beneath the item if there is room.
  void add_names_of_cargo(std::vector<Label>& wanted) const {
    if (cargo_.size() > most_labels) return;
    for (const auto& [item, box] : cargo_)
      wanted.push_back(label(box, Vec2(0, 1),
                             cargo_label(placement_.settings.cargo[item], of_.shown.units),
                             attribute("class", "cargo-name") + attribute("fill", text_colour)));
  }

  std::string named() {
    std::vector<Label> wanted;
    add_loads(wanted);
    add_names_of_cargo(wanted);
    std::vector<labels::Request> requests;
    for (const Label& each : wanted) requests.push_back(each.request);
    const std::vector<std::optional<labels::Box>> places = labels::place(requests, surroundings());

    // Keeps words readable on hatching or a line.
    const std::string border = attribute("stroke", "#FFFFFF") + attribute("stroke-width", 3.5) +
                               attribute("stroke-linejoin", "round") +
                               attribute("paint-order", "stroke");
    std::string out;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      if (!places[i]) continue;
      seen_.overload = seen_.overload || wanted[i].overload;
      out += centred((places[i]->low + places[i]->high) / 2, label_size_, wanted[i].words,
                     wanted[i].look + border);
    }
    return out;
  }

  const Reported of_;
  const Placement& placement_;
  const std::vector<PlacedRobot> sized_;  // all, or none if they are points
  const Paper paper_;
  double disc_ = 0;  // a robot's radius
  double number_size_ = 0, label_size_ = 0, chord_width_ = 0;
  double largest_load_ = 0;
  std::vector<Stand> stands_;
  // Known after drawing:
  Points outline_;
  std::vector<Points> holes_;
  std::vector<labels::Segment> chords_;
  std::vector<std::pair<std::uint32_t, labels::Box>> cargo_;  // items, and their discs' boxes
  std::optional<Vec2> own_centre_;
  Seen seen_;
};

}  // namespace
}  // namespace svg

std::string placement_svg(const Reported& of, std::string_view link, std::string_view cases) {
  return svg::Drawing(of).finished(link, cases);
}

std::string placement_sketch(const Reported& of) {
  constexpr double share = 0.5;
  return svg::Drawing(of, share).without_caption();
}

}  // namespace evenlift
