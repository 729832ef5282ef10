#include "modules/handout_paper.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "evenlift/output/label_places.h"
#include "evenlift/output/trace_words.h"
#include "evenlift/output/words.h"
#include "evenlift/plane.h"

namespace evenlift {
namespace {

constexpr std::size_t most_lines = 60;  // text cannot avoid more
constexpr std::size_t most_ratios = 8;  // more numbers would hide the drawing
constexpr double letter = 0.6;          // greatest width of a letter, as a fraction of its height
constexpr double beside = 0.75;         // place of the load ratio along a chord

Box around(const Vec2& middle, double reach) {
  return {middle - Vec2(reach, reach), middle + Vec2(reach, reach)};
}

// The number of bytes that begin a UTF-8 character.
std::size_t letters(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

// The words to write, and their obstacles.
class Words {
 public:
  Words(const Paper& paper, const Trace& trace)
      : paper_(paper),
        placement_(trace.placement),
        units_(trace.units),
        balanced_(trace.balanced()),
        centre_(paper(trace.centre)) {
    around_.frame = {Vec2(3, 3), Vec2(Paper::width - 3, Paper::height - 3)};
    around_.outline = paper(placement_.vertices());
    around_.marks = {around(centre_, 5)};
    add("C", around(centre_, 4), Vec2(1, -1));
    for (PaperCargo& item : cargo_on_paper(paper, trace)) {
      const Box disc = around(item.middle, item.radius);
      around_.marks.push_back(disc);
      add(std::move(item.name), disc, Vec2(1, 0));
    }
  }

  void add_robots(const std::vector<PaperRobot>& robots) {
    for (const PaperRobot& robot : robots) {
      const Box disc = around(robot.middle, Paper::disc);
      around_.marks.push_back(disc);
      if (robot.load)
        add(load_in_words(*robot.load, placement_.loads->max, units_), disc,
            robot.middle - centre_);
    }
  }

  void line(const Points& ends) {
    if (around_.chords.size() < most_lines)
      around_.chords.emplace_back(paper_(ends[0]), paper_(ends[1]));
  }

  void add_figures(const std::vector<Figure>& figures) {
    for (const Figure& figure : figures) {
      if (figure.points.size() == 2) line(figure.points);
      if (figure.points.size() == 1 && figure.kind != FigureKind::gain_circle)
        around_.marks.push_back(around(paper_(figure.points[0]), 5));
    }
    for (const Figure& figure : figures) add_name(figure);
    add_ratios(figures);
  }

  // Adds the numbers of the best candidates, beyond their right ends.
  void add_ranked(const TeamScores& scores) {
    for (const std::uint32_t c : best_ranked(scores)) {
      const Vec2 end = paper_(placement_.candidates[c].chord.r2.position);
      add(std::to_string(c + 1), around(end, Paper::disc), end - centre_);
    }
  }

  std::vector<PaperWords> placed() const {
    const std::vector<std::optional<Box>> places = labels::place(requests_, around_);
    std::vector<PaperWords> words;
    for (std::size_t i = 0; i < places.size(); ++i)
      if (places[i]) words.push_back({places[i]->middle(), texts_[i]});
    return words;
  }

 private:
  void add(std::string text, const Box& owner, const Vec2& away) {
    const Vec2 size(letter * Paper::text * static_cast<double>(letters(text)), Paper::text);
    requests_.push_back({owner, away, size});
    texts_.push_back(std::move(text));
  }

  // Beside an edge or its image, on the side away from the object; otherwise away from C.
  void add_name(const Figure& figure) {
    std::string name = figure.kind == FigureKind::middle ? "M" : part_name(figure);
    if (name.empty()) return;
    const Points at = paper_(figure.points);
    if (at.size() == 1) {
      const Vec2 away = at[0] - centre_;
      if (figure.kind == FigureKind::centroid && length(away) < 2) return;
      return add(std::move(name), around(at[0], 5), away);
    }
    const Vec2 along = at[1] - at[0], middle = (at[0] + at[1]) / 2;
    Vec2 away = Vec2(along.y, -along.x) / std::max(length(along), 1e-9);
    if (inside(around_.outline, Vec2(middle + 2 * away))) away = -away;
    add(std::move(name), around(middle, 1), away);
  }

  // Adds the ratios of the chords that a step compares. The chosen one is among the figures twice.
  void add_ratios(const std::vector<Figure>& figures) {
    std::vector<const Figure*> chords;
    for (const Figure& figure : figures) {
      const bool compared = figure.kind == FigureKind::section_end ||
                            figure.kind == FigureKind::range_end ||
                            (figure.kind == FigureKind::chosen && !balanced_);
      const bool before = std::any_of(chords.begin(), chords.end(), [&](const Figure* other) {
        return other->points == figure.points ||
               other->points == Points{figure.points[1], figure.points[0]};
      });
      if (compared && figure.points.size() == 2 && !before) chords.push_back(&figure);
    }
    if (chords.size() > most_ratios) return;
    for (const Figure* chord : chords) {
      const Vec2 from = paper_(chord->points[0]), way = paper_(chord->points[1]) - from;
      add(ratio_in_words(chord->value), around(from + beside * way, 1), Vec2(way.y, -way.x));
    }
  }

  const Paper& paper_;
  const Placement& placement_;
  const Units& units_;
  bool balanced_;
  Vec2 centre_;
  labels::Surroundings around_;
  std::vector<labels::Request> requests_;
  std::vector<std::string> texts_;
};

double rounded(double value) { return std::round(value * 10) / 10; }

}  // namespace

Paper::Paper(const Points& points) {
  const Box box = bounding_box(points);
  const Vec2 size = box.size();
  scale_ = std::min((width - 2 * margin) / size.x, (height - 2 * margin) / size.y);
  middle_ = box.middle();
}

Vec2 Paper::operator()(const Vec2& p) const {
  return {rounded(width / 2 + (p.x - middle_.x) * scale_),
          rounded(height / 2 - (p.y - middle_.y) * scale_)};
}

Points Paper::operator()(const Points& points) const {
  Points mapped;
  mapped.reserve(points.size());
  for (const Vec2& p : points) mapped.push_back((*this)(p));
  return mapped;
}

std::vector<PaperCargo> cargo_on_paper(const Paper& paper, const Trace& trace) {
  constexpr double least = 3, whole = 24;  // radii; `whole` is for all the weight
  const Placement& placement = trace.placement;
  std::vector<PaperCargo> cargo;
  for (const Cargo& item : placement.settings.cargo) {
    const double radius = whole * std::sqrt(item.weight / placement.weight());
    cargo.push_back({paper(item.at), rounded(std::max(least, radius)),
                     item.name.empty() ? given_weight(item.weight, trace.units) : item.name});
  }
  return cargo;
}

std::vector<PaperRobot> robots_on_paper(const Paper& paper, const Trace& trace,
                                        const StepDetail& detail) {
  std::vector<PaperRobot> robots;
  if (trace.balanced()) {
    if (!detail.balanced) return robots;
    const BalancedDetail& balanced = *detail.balanced;
    const Chapter chapter = detail.step.chapter;
    std::optional<double> load;
    if (chapter == Chapter::loads || chapter == Chapter::grasp) load = trace.placement.loads->max;
    for (std::size_t i = 0; i < balanced.robots.size(); ++i)
      robots.push_back({paper(balanced.robots[i].position), balanced.numbers[i] + 1, load});
    return robots;
  }
  const Progress known = progress_at(trace, detail.number);
  for (std::uint32_t t = 0; t < known.teams; ++t)
    for (const Robot& robot : teams_at(trace, known)[t].robots)
      robots.push_back({paper(robot.point.position), static_cast<std::uint32_t>(robots.size()) + 1,
                        t < known.shares ? std::optional(robot.load) : std::nullopt});
  return robots;
}

std::vector<PaperWords> words_on_paper(const Paper& paper, const Trace& trace,
                                       const StepDetail& detail,
                                       const std::vector<Figure>& figures) {
  Words words(paper, trace);
  const Progress known = progress_at(trace, detail.number);
  for (std::uint32_t t = 0; t < known.teams && !trace.balanced(); ++t) {
    const Chord chord = chord_of(teams_at(trace, known)[t]);
    words.line({chord.r1.position, chord.r2.position});
  }
  words.add_robots(robots_on_paper(paper, trace, detail));
  words.add_figures(figures);
  if (detail.scores) words.add_ranked(*detail.scores);
  return words.placed();
}

}  // namespace evenlift
