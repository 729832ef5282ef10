#include "evenlift/placement.h"

#include "evenlift/hull.h"
#include "evenlift/selection.h"
#include "evenlift/settings_text.h"
#include "evenlift/tolerance.h"

namespace evenlift {
namespace {

std::vector<LiftingPoint> lifting_points(const std::vector<Chord>& chords) {
  std::vector<LiftingPoint> points;
  points.reserve(2 * chords.size());
  for (const Chord& chord : chords) {
    points.push_back(chord.r1);
    points.push_back(chord.r2);
  }
  return points;
}

// Chooses the chords that the teams take, and notes which candidates they are.
std::vector<Chord> choose_chords(const Polygon& polygon, Placement& placement) {
  const Vec2& centre = placement.centre_of_mass;
  const std::size_t teams = placement.requested_teams;
  switch (placement.settings.method) {
    case Method::distributed:
      return distributed_teams(polygon, centre, teams);
    case Method::random:
      return random_teams(polygon, centre, teams, placement.settings.seed);
    default:
      placement.team_candidates =
          select_teams(polygon, centre, placement.candidates, placement.settings.method, teams);
  }
  std::vector<Chord> chords;
  chords.reserve(placement.team_candidates.size());
  for (const std::uint32_t i : placement.team_candidates)
    chords.push_back(placement.candidates[i].chord);
  return chords;
}

// Fills in everything of a placement that follows from the chords.
void describe_grasp(const Polygon& polygon, const std::vector<Chord>& chords,
                    Placement& placement) {
  const std::vector<LiftingPoint> points = lifting_points(chords);
  Points positions;
  positions.reserve(points.size());
  for (const LiftingPoint& point : points) positions.push_back(point.position);

  placement.teams = distribute_weight(chords, placement.settings.weight);
  placement.loads = summarize_loads(placement.teams);
  placement.lifting_base = convex_hull(std::move(positions), near_distance(polygon.diagonal()));
  placement.coverage = coverage(polygon, placement.lifting_base);
  placement.closure = analyse_closure(polygon, placement.centre_of_mass, points);
}

}  // namespace

std::optional<InputError> check_settings(const Settings& settings) {
  if (auto error = check_ranges(settings)) return error;
  if (settings.teams || selects_candidates(settings.method)) return std::nullopt;
  return InputError{ErrorCode::bad_setting,
                    "all candidates can be placed by area, circle and distance only; give a number",
                    {Place::Kind::option, 0, 0, std::string(name(Setting::teams))}};
}

Result<Placement> place(const Document& document) {
  if (auto error = check_settings(document.settings)) return *error;
  auto polygon = Polygon::create(document.vertices);
  if (!polygon) return polygon.error();
  const auto centre = check_centre_of_mass(*polygon, document.centre_of_mass);
  if (!centre) return centre.error();
  auto candidates = find_candidates(*polygon, *centre, document.settings.min_ratio);
  if (!candidates) return candidates.error();

  Placement placement;
  placement.vertices = document.vertices;
  placement.centre_of_mass = *centre;
  placement.settings = document.settings;
  placement.candidates = std::move(*candidates);
  placement.requested_teams =
      document.settings.teams.value_or(static_cast<std::uint32_t>(placement.candidates.size()));
  describe_grasp(*polygon, choose_chords(*polygon, placement), placement);
  return placement;
}

}  // namespace evenlift
