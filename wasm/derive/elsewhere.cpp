#include "derive/elsewhere.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "derive/settings_text.h"
#include "evenlift/swaps.h"

namespace evenlift::view {
namespace {

// A placement takes about a microsecond per vertex and candidate (docs/performance.md), and drawing
// takes half of a frame.
constexpr std::size_t most_within_a_frame = 8000;

// After a wrong number, all that follow are 0, and ok() is false.
class Reader {
 public:
  explicit Reader(std::span<const double> numbers) : rest_(numbers) {}

  bool ok() const { return ok_; }
  bool is_at_end() const { return ok_ && rest_.empty(); }
  std::size_t left() const { return rest_.size(); }

  double number() {
    if (rest_.empty() || !std::isfinite(rest_.front())) ok_ = false;
    if (!ok_) return 0;
    const double value = rest_.front();
    rest_ = rest_.subspan(1);
    return value;
  }
  std::size_t whole(std::size_t most) {
    const double value = number();
    if (!(value >= 0 && value <= static_cast<double>(most) && value == std::floor(value)))
      ok_ = false;
    return ok_ ? static_cast<std::size_t>(value) : 0;
  }
  std::uint32_t index(std::size_t end) {
    if (end == 0) ok_ = false;
    return ok_ ? static_cast<std::uint32_t>(whole(end - 1)) : 0;
  }
  Vec2 point() {
    const double x = number();
    return {x, number()};
  }

 private:
  std::span<const double> rest_;
  bool ok_ = true;
};

void add(std::vector<double>& numbers, const Vec2& point) {
  numbers.insert(numbers.end(), {point.x, point.y});
}

void add(std::vector<double>& numbers, const LiftingPoint& point) {
  add(numbers, point.position);
  numbers.push_back(point.edge);
}

void add(std::vector<double>& numbers, const Candidate& candidate) {
  const Chord& chord = candidate.chord;
  add(numbers, chord.r1);
  add(numbers, chord.r2);
  numbers.insert(numbers.end(),
                 {chord.arm1, chord.arm2, chord.ratio, static_cast<double>(candidate.kind),
                  candidate.between_vertices ? 1.0 : 0.0});
  add(numbers, candidate.direction);
  numbers.push_back(candidate.length);
}
constexpr std::size_t numbers_of_a_candidate = 14;
constexpr std::size_t candidate_kinds = static_cast<std::size_t>(CandidateKind::range) + 1;

LiftingPoint read_point(Reader& reader, std::size_t edges) {
  const Vec2 position = reader.point();
  return {position, reader.index(edges)};
}

Candidate read_candidate(Reader& reader, std::size_t edges) {
  Candidate candidate;
  Chord& chord = candidate.chord;
  chord.r1 = read_point(reader, edges);
  chord.r2 = read_point(reader, edges);
  chord.arm1 = reader.number();
  chord.arm2 = reader.number();
  chord.ratio = reader.number();
  candidate.kind = static_cast<CandidateKind>(reader.index(candidate_kinds));
  candidate.between_vertices = reader.whole(1) == 1;
  candidate.direction = reader.point();
  candidate.length = reader.number();
  return candidate;
}

std::optional<Points> read_ring(Reader& reader, std::size_t size) {
  if (size > reader.left() / 2) return std::nullopt;
  Points ring(size);
  for (Vec2& vertex : ring) vertex = reader.point();
  return ring;
}

}  // namespace

bool is_for_a_worker(const Document& document, const Placement& before) {
  return selects_candidates(document.settings.method) && stands_anywhere(document.settings) &&
         !document.moved.any() && document.vertices.size() == before.vertices().size() &&
         document.holes.size() == before.object.holes().size() &&
         document.vertices.size() + before.candidates.size() > most_within_a_frame;
}

std::vector<double> rings_as_numbers(const Document& document) {
  std::vector<const Points*> rings = {&document.vertices};
  for (const Points& hole : document.holes) rings.push_back(&hole);
  std::vector<double> numbers = {static_cast<double>(rings.size())};
  for (const Points* ring : rings) numbers.push_back(static_cast<double>(ring->size()));
  for (const Points* ring : rings)
    for (const Vec2& vertex : *ring) add(numbers, vertex);
  return numbers;
}

std::string settings_as_selected(const Document& document) {
  Document as_selected{{}, document.centre_of_mass, document.settings};
  as_selected.settings.supports.clear();  // as text, they would make the method `given`
  if (swaps_teams(document.settings)) as_selected.settings.goal = Goal::cover;
  return settings_text(as_selected);
}

std::optional<Document> read_task(std::span<const double> rings, std::string_view settings) {
  Reader reader(rings);
  const std::size_t number = reader.whole(reader.left());
  if (number == 0 || number > reader.left()) return std::nullopt;
  std::vector<std::size_t> sizes(number);
  for (std::size_t& size : sizes) size = reader.whole(max_vertices);
  Document document;
  for (std::size_t i = 0; i < number; ++i) {
    std::optional<Points> ring = read_ring(reader, sizes[i]);
    if (!ring) return std::nullopt;
    if (i == 0)
      document.vertices = *std::move(ring);
    else
      document.holes.push_back(*std::move(ring));
  }
  if (!reader.is_at_end() || !read_lines(settings, document)) return std::nullopt;
  return document;
}

std::vector<double> choice_as_numbers(const Placement& placement) {
  std::vector<double> numbers;
  numbers.reserve(2 + placement.candidates.size() * numbers_of_a_candidate +
                  placement.team_candidates.size());
  numbers.push_back(static_cast<double>(placement.candidates.size()));
  numbers.push_back(static_cast<double>(placement.team_candidates.size()));
  for (const Candidate& candidate : placement.candidates) add(numbers, candidate);
  for (const std::uint32_t team : placement.team_candidates) numbers.push_back(team);
  return numbers;
}

std::optional<Choice> read_choice(std::span<const double> numbers, std::size_t edges) {
  Reader reader(numbers);
  const std::size_t candidates = reader.whole(numbers.size() / numbers_of_a_candidate),
                    teams = reader.whole(candidates);
  if (!reader.ok()) return std::nullopt;
  Choice choice;
  choice.candidates.reserve(candidates);
  for (std::size_t i = 0; i < candidates; ++i)
    choice.candidates.push_back(read_candidate(reader, edges));
  for (std::size_t i = 0; i < teams; ++i) choice.teams.push_back(reader.index(candidates));
  return reader.is_at_end() ? std::optional(std::move(choice)) : std::nullopt;
}

}  // namespace evenlift::view
