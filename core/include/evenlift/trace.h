// The data of the walkthrough: random access to the steps of the algorithm.
//
// A trace belongs to one placement. It contains what the stages found on the way (chords from
// vertices, edge pairs and their outcomes, contacts) and a short table of blocks of similar steps,
// from which step(k) is found in O(1). Playing the steps accumulates nothing: progress_at(trace, k)
// returns how much of the trace's and the placement's arrays is known after step k. look_at()
// computes what only one step needs (every candidate's score, the regions that a few contacts
// leave) with the stages' own functions.
//
// A walkthrough keeps the placement, its trace and the detail of the current step:
//
//   const Result<Trace> trace = make_trace(placement);
//   const StepDetail detail = look_at(*trace, k);    // once for each change of k
//   figures(*trace, detail)                          // the subject of the step, to draw and hover
//   progress_at(*trace, k)                           // for drawing the background
//   question(*trace, detail)                         // if the learner could guess the step
//   why_not(*trace, k, candidate)                    // why_not.h
// output/trace_words.h contains the words.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "evenlift/balanced_history.h"
#include "evenlift/failures.h"
#include "evenlift/placement.h"
#include "evenlift/polygon.h"
#include "evenlift/selection.h"
#include "evenlift/stands.h"
#include "evenlift/swaps.h"

namespace evenlift {

// The chapters, in the order of the thesis.
enum class Chapter : std::uint8_t {
  object,         // the polygon and its centre of mass
  law,            // balanced robots: from the law of the lever to the law of the centroid
  robots,         // given supports: where they stand
  vertex_chords,  // from each vertex through C
  slopes,         // the order of these chords
  pairs,          // edges that face each other, opposite vertices, and the candidates of both
  candidates,
  first_team,
  further_teams,
  start,     // balanced robots: a first set
  exchange,  // balanced robots: three move at a time
  swaps,     // teams of two, swapped for the goal `hold`
  loads,
  failures,  // balanced robots: if one fails
  grasp,     // coverage and immobilization
};
inline constexpr std::uint32_t chapter_count = 15;

// The subject of a step. The `item` of a step counts from 0 among the steps of its kind. Each
// comment begins with the things that `item` counts; "1" means that there is only one such step.
enum class StepKind : std::uint8_t {
  polygon,       // 1
  centroid,      // 1: how it is found
  centre,        // 1: the centre of mass in use: the centroid, or another point; with all cargo
  radial,        // 1: edges whose line passes through C; only if there are any
  ray,           // rays: the hits on the ray from a vertex through C
  slopes,        // 1: the chords in order of slope
  sections,      // pairs: two edges and their facing parts
  outcome,       // pairs: the bisecting chord or the nearer end, accepted or not
  opposite,      // opposite: two vertices straight across C; their chord, accepted or not
  duplicates,    // 1: chords found more than once
  candidates,    // 1
  directions,    // 1, equal angles: the directions with places on both sides
  scores,        // teams: every candidate's score and rank, by area, circle or distance
  team,          // teams: the candidate that it takes
  base,          // teams: H grows
  fewer,         // 1: only some of the teams requested find a place, or none
  share,         // teams: the law of the lever
  loads,         // 1: all robots
  coverage,      // 1
  contacts,      // 1: where the robots touch edges
  cut,           // contacts: its normal line cuts the two regions
  slide,         // 1: whether a translation is free
  closure,       // 1: form closure, margin
  second_order,  // 1: only without form closure
  result,        // 1: everything that place() reports
  // Balanced robots:
  lever,       // 1: two robots, C in the middle
  three,       // 1: three robots, and the law of the lever twice
  many,        // 1, from four robots on: all robots, and the law of the centroid
  rest,        // 1: some robots, and where the middle of two more must be
  mirror,      // 1: the outline turned about that point, and the even chords through it
  completion,  // 1: the chord that makes the best set
  start,       // sets of the start: the robots that stayed, and those that came
  exchange,    // swaps: three robots leave, three come, and the set is better
  round,       // rounds that changed something: the end of the round
  settled,     // 1: no swap of three robots makes the set better
  failure,     // robots, if there are 3 to most_failing: one fails
  failures,    // 1: the number of robots that may fail at once
  pairs,       // 1, for an even number: the same number of robots in teams of two
  // Teams anywhere in their ranges, and teams with the goal `hold`:
  range,  // ranges: the places of an edge pair that meet the minimum ratio, with two candidates
  swap,   // swaps of teams: which team moved where, and why that is better
  held,   // 1: no swap makes the teams better
  // Robots with a size, or no-go edges:
  stands,  // 1, after the centre of mass: the usable boundary, and why the rest is not usable
  // Given supports:
  support,     // supports: at the edge or beneath
  equations,   // 1: three equations, and whether they determine the loads
  by_lever,    // 1: two robots
  by_areas,    // 1: three robots, not on one line
  by_springs,  // 1: any other number: a board on equal springs
  extremes,    // 1, after by_springs: the loads at best and at worst
  falls,       // 1: C is outside H, in place of the loads
  // Cargo on the object:
  cargo,  // items of cargo, after the centroid: how each moves the centre of mass
};
inline constexpr std::uint32_t step_kind_count = 50;
inline constexpr std::uint32_t most_failing = 16;

// "pairs", "first_team"; "outcome", "second_order": the names in JSON, lessons and links. O(1).
std::string_view name(Chapter chapter);
std::string_view name(StepKind kind);
std::optional<StepKind> step_kind_from_name(std::string_view text);

struct Step {
  StepKind kind = StepKind::polygon;
  Chapter chapter = Chapter::object;
  std::uint32_t item = 0;
  bool operator==(const Step&) const = default;
};

// Longer traces are refused: they take too long to watch and exceed a browser's memory.
inline constexpr std::uint32_t max_trace_steps = 1u << 20;

struct Trace {
  const PolygonWithHoles& object() const { return placement.object; }
  const Polygon& polygon() const { return placement.polygon(); }

  Placement placement;
  Vec2 centre = Vec2::Zero();  // C, the placement's centre of mass with all cargo
  Units units;                 // for captions; they change no number

  // Chapter vertex_chords. The chords of ray i are chords[begins[i] .. begins[i + 1]). Chords
  // already listed at an earlier ray come first; their `vertex` is their other end.
  struct Rays {
    std::vector<std::uint32_t> vertices;  // in the order found
    std::vector<std::uint32_t> begins;    // one more entry than `vertices`
    std::vector<VertexChord> chords;
  } rays;
  std::vector<std::uint32_t> radial_edges;

  // Chapter pairs; only for the methods area, circle and distance.
  std::vector<EdgePair> pairs;
  std::vector<OppositeVertices> opposite;
  // Candidates come from sources: source i is pair i, or opposite vertices i - pairs.size(). This
  // is the candidate that each source led to, or no_index.
  std::vector<std::uint32_t> candidate_of_source;
  // For each candidate, the source whose chord was kept, and the first source that led to it.
  std::vector<std::uint32_t> source_of_candidate, first_source_of_candidate;
  // With positions anywhere in the range: the pairs that add range candidates, and what the two
  // candidates of each became.
  std::vector<std::uint32_t> ranges;
  std::vector<std::array<std::uint32_t, 2>> candidates_of_range;

  // With the goal `hold`: the swaps of teams, and the teams at the start and after each swap.
  std::optional<SwapHistory> swaps;
  std::vector<std::vector<Team>> stages;

  std::vector<Contact> contacts;

  // Balanced robots only: the history of their search.
  std::optional<BalancedProblem> problem;
  BalancedHistory history;
  // The robots' numbers, from 0, in the last set of the start and after each swap. A robot keeps
  // its number from swap to swap; in the last set, numbers follow the order along the outline.
  std::vector<std::vector<std::uint32_t>> robot_numbers;
  std::optional<Placement> in_pairs;  // the same number of robots by area, if they find places

  // If the user moved robots by hand, the given placement. The steps are those of the method, and
  // `placement` is their result; only the last step describes both.
  std::optional<Placement> moved;

  // A run of similar steps. Item i of a block consists of `kinds` steps, from step first + i *
  // kinds on, one of each kind in the order of `kind`.
  struct Block {
    std::uint32_t first = 0, items = 0, first_item = 0, kinds = 1;
    std::array<StepKind, 3> kind{};
    Chapter chapter = Chapter::object;
  };
  std::vector<Block> blocks;

  // The number of steps, at least 5. O(1).
  std::uint32_t size() const;
  // Step k < size(). O(1).
  Step step(std::uint32_t k) const;
  // The number of steps of a kind; their items are 0 .. count - 1. O(1).
  std::uint32_t count(StepKind kind) const;
  // The number of a step; nothing if the trace has no such step. O(1).
  std::optional<std::uint32_t> find(StepKind kind, std::uint32_t item) const;
  // The first step of a chapter; nothing if the trace has no such chapter. O(1).
  std::optional<std::uint32_t> chapter_begin(Chapter chapter) const;
  // Whether the method chooses teams among candidates: area, circle or distance. O(1).
  bool by_candidates() const;
  // The metric of that choice, in traces by_candidates() only. O(1).
  Metric metric() const;
  // The candidates that the metric selects, and the teams on them, before any swap. O(1).
  const std::vector<std::uint32_t>& selected() const {
    return swaps ? swaps->start : placement.team_candidates;
  }
  const std::vector<Team>& selected_teams() const {
    return stages.empty() ? placement.teams : stages.front();
  }
  // Whether the robots are balanced, and whether they are given supports. O(1).
  bool balanced() const { return problem.has_value(); }
  bool given() const { return placement.settings.method == Method::given; }
};

// Whether C lies outside the polygon; the boundary counts as inside. Exact. O(n).
bool centre_is_outside(const Trace& trace);

// The trace of a placement from place(). An error if it has more than max_trace_steps steps. Costs
// as much as place() without the selection: O(n log n + K log K) for K edge pairs and opposite
// vertices; for balanced robots as much as their search. It is an error if that search is to be
// traced whole and is not quick to finish. For balanced robots, and for teams moved by hand, the
// trace's placement is the method's own result, wherever the robots of `placement` stand. With
// HistoryLength::start only the start of the search is traced, if that is quick, so that the trace
// can follow a drag.
Result<Trace> make_trace(const Placement& placement, HistoryLength length = HistoryLength::whole,
                         const Units& units = {});

// The step of `trace` nearest to a step of another trace, from before an edit: the step of the same
// kind and item, else the last of that kind, else the beginning of its chapter or of the next
// existing chapter. O(1).
std::uint32_t nearest_step(const Trace& trace, const Step& step);

// The knowledge after step k, as counts from the beginning of the trace's and the placement's
// arrays.
struct Progress {
  std::uint32_t robots = 0;  // given supports shown
  std::uint32_t rays = 0;
  bool slopes = false;
  std::uint32_t sections = 0;    // pairs shown
  std::uint32_t sources = 0;     // pairs and, after all of these, opposite vertices decided
  bool merged = false;           // the placement's own candidates from here on
  std::uint32_t teams = 0;       // teams taken
  std::uint32_t base_teams = 0;  // teams whose robots form H
  std::uint32_t shares = 0;      // teams whose loads are known
  bool coverage = false;
  std::uint32_t swaps = 0;  // swaps of teams made
  std::uint32_t cuts = 0;   // contacts whose normal lines have cut the regions
  bool closure = false;     // everything that place() reports
  bool stands = false;      // the boundary that robots with a size can use
  bool operator==(const Progress&) const = default;
};
// Depends on k alone. Candidate c is known if `merged`, or else if first_source_of_candidate[c] <
// `sources`. O(1).
Progress progress_at(const Trace& trace, std::uint32_t k);

// The teams after the known swaps; the first `known.teams` of them are taken. O(1).
const std::vector<Team>& teams_at(const Trace& trace, const Progress& known);

// The lifting base H of the first `teams` teams that the metric selects. O(teams log teams).
Points lifting_base(const Trace& trace, std::uint32_t teams);

// The lifting base H of the first `known.base_teams` of teams_at(). O(teams log teams).
Points lifting_base(const Trace& trace, const Progress& known);

// The outcome of an edge pair.
enum class Outcome : std::uint8_t {
  bisecting,     // C bisects a chord between the sections; that chord is the candidate
  nearer_end,    // C bisects no chord; the end with the larger ratio is the candidate
  too_uneven,    // C bisects no chord, and even the better end is below the minimum ratio
  midpoint,      // the edges are parallel; the chord between the midpoints is the candidate
  parallel_low,  // the edges are parallel, and their ratio is below the minimum
};
std::string_view name(Outcome outcome);

// Whether robots with a size can stand on a pair's best chord, on another chord of the pair, or on
// none.
enum class Standing : std::uint8_t { there, elsewhere, nowhere };

struct PairDetail {
  EdgePair pair;
  PairVerdict verdict;
  Outcome outcome = Outcome::bisecting;
  // The section of edge a runs from a[0] to a[1], the section of edge b from b[0] to b[1]. The
  // chord ends[i] connects a[i] and b[i].
  std::array<Vec2, 2> a{Vec2::Zero(), Vec2::Zero()}, b{Vec2::Zero(), Vec2::Zero()};
  std::array<Chord, 2> ends;
  // Edge b reflected through C, and the point where its line meets the line of a: an end of the
  // chord that C bisects, perhaps far outside. No such point if the edges are parallel.
  std::array<Vec2, 2> reflected{Vec2::Zero(), Vec2::Zero()};
  std::optional<Vec2> meeting;
  std::uint32_t nearer = 0;  // the end with the larger ratio: 0 or 1
  Chord chosen;              // the candidate, or the best chord if its ratio is too low
  std::optional<std::uint32_t> candidate;  // index of placement.candidates
  bool stands = false;               // the candidate's chord is this pair's, not a duplicate's
  std::optional<Standing> standing;  // of robots with a size; `chosen` is then a usable chord
};
// O(1).
PairDetail look_at_pair(const Trace& trace, std::uint32_t index);

// A range, and the candidates in it.
struct RangeDetail {
  EdgePair pair;
  PairRange range;
  // The most uneven chords allowed, or the ends of the section; for robots with a size, the first
  // and the last chord in the longest part of the range where they can stand.
  std::array<Chord, 2> ends;
  // Indices of placement.candidates. For robots with a size, the second may be no_index: the two
  // robots of a team would collide there.
  std::array<std::uint32_t, 2> candidates{};
};
// For trace.ranges[index]. O(1).
RangeDetail look_at_range(const Trace& trace, std::uint32_t index);

// The effect of a swap of teams.
struct SwapDetail {
  HoldKeys before, after;
  std::optional<double> margin_before, margin;
  std::vector<std::uint32_t> teams;     // the teams that moved
  std::vector<std::uint32_t> from, to;  // their candidates before and after
  SwapKind kind = SwapKind::single;
  HoldKey decided_by = HoldKey::level;
};
// For swap `index` of `trace.swaps`. O(n log n).
SwapDetail look_at_swap(const Trace& trace, std::uint32_t index);

// The boundary that robots with a size can use.
struct StandsDetail {
  double boundary = 0;                            // its length
  double usable = 0;                              // length of the usable part
  std::array<double, why_unusable_count> lost{};  // length of the rest, by reason
  // Contacts of robots that do not fit: for each reason except no_go and narrow, in the middle of
  // the longest part, with its index in Stands::unusable(). `fits` is the contact of a robot that
  // fits, in the middle of the longest usable interval. Both are empty if robots are points.
  struct Misfit {
    std::uint32_t part = 0;
    LiftingPoint contact;
  };
  std::vector<Misfit> misfits;
  std::optional<LiftingPoint> fits;
};
// For traces of robots with a size, or with no-go edges. O(n + parts).
StandsDetail look_at_stands(const Trace& trace);

// The outcome of two opposite vertices.
struct OppositeDetail {
  OppositeVertices vertices;
  Chord chord;                             // between them
  std::optional<std::uint32_t> candidate;  // nothing if its load ratio is below the minimum
  bool stands = false;                     // the candidate's chord is this one, not a pair's
};
// For trace.opposite[index]. O(1).
OppositeDetail look_at_opposite(const Trace& trace, std::uint32_t index);

// The amount by which one end of a candidate would widen H.
struct EndGain {
  bool outside = false;                       // outside H; if not, it gains nothing
  Vec2 h1 = Vec2::Zero(), h2 = Vec2::Zero();  // the edge of H beyond which C sees the end
  Vec2 p = Vec2::Zero();                      // the end
  double value = 0;                           // f(p)
};
// The key at which a candidate dropped out. For the choice as a whole, the key that separated the
// winner from its last rival.
enum class DecidedBy : std::uint8_t { only_one, first_key, ratio, length, order };
struct Score {
  double value = 0;       // score; for a first team its length (or ratio, with `most_even`)
  bool exact = true;      // otherwise an upper bound, too low to win
  bool taken = false;     // by an earlier team
  bool collides = false;  // one of its robots, with one of an earlier team
  bool eligible = true;   // a first team needs an even candidate if there are any
  DecidedBy lost_by = DecidedBy::first_key;  // unless it won
  std::array<EndGain, 2> ends;               // of r1 and r2; empty for a first team
};
struct TeamScores {
  std::uint32_t team = 0;
  Rule rule = Rule::score;
  Points base;  // H before the choice
  std::vector<Score> of_candidate;
  // The candidates not taken yet: the winner, then the others, the last to drop out first.
  std::vector<std::uint32_t> ranking;
  DecidedBy decided_by = DecidedBy::only_one;
};

// The greatest number of candidates numbered in a picture of a choice; more would hide it.
inline constexpr std::size_t most_ranked_numbered = 6;

// The candidates that a picture numbers: the best eligible ones, at most most_ranked_numbered.
// O(K).
std::vector<std::uint32_t> best_ranked(const TeamScores& scores);

// The scores for the choice of team `team`, in traces by_candidates() only. Every score is exact if
// candidates times vertices are at most exact_score_budget; beyond that, only the scores that the
// selection itself evaluated are exact. O(K log K) plus the cost of the scores.
TeamScores look_at_scores(const Trace& trace, std::uint32_t team);
inline constexpr std::uint64_t exact_score_budget = 1u << 22;

// Balanced robots at a step.
struct BalancedDetail {
  std::vector<LiftingPoint> robots;
  std::vector<std::uint32_t> numbers;  // from 0
  // rest, mirror, completion, start, `exchange`: how the set is completed
  std::vector<LiftingPoint> rest;     // the robots that stay, and the one at a trial point
  std::optional<LiftingPoint> stand;  // the robot that came to a trial point
  Vec2 middle = Vec2::Zero();         // the middle of the two other robots
  std::vector<Chord> chords;          // the even chords about the middle
  std::uint32_t chosen = 0;           // the index of the chord taken
  // `exchange`: compared with the preceding set
  std::vector<std::uint32_t> moved;  // the numbers of the robots that moved, increasing
  std::vector<Vec2> ways;            // for each of them, the old and the new position
  BalancedKeys keys_before;
  std::optional<double> margin_before;
  // start, swap
  BalancedKeys keys;
  std::optional<double> margin;
  // failure, failures: the remaining robots if each one fails; nothing if the object falls
  std::vector<std::optional<RestOfRobots>> rest_of;
  std::optional<std::uint32_t> failed;  // failure: the robot that fails; the others are `robots`
  std::vector<double> loads;            // failure: loads of the others if equally stiff
};

// The data of a step beyond the trace itself. Members that do not concern the step are empty.
struct StepDetail {
  std::uint32_t number = 0;
  Step step;
  std::optional<PairDetail> pair;          // sections, outcome
  std::optional<OppositeDetail> opposite;  // opposite
  std::optional<RangeDetail> range;        // range
  std::optional<SwapDetail> swap;          // swap
  std::optional<StandsDetail> stands;      // stands
  std::optional<TeamScores> scores;        // scores, team, in traces by_candidates() only
  // scores, team, base: H without and with the team. swap: H before and after. completion, start,
  // `exchange` and all later steps of balanced robots: `base` is H of the step's own robots;
  // `base_before` is H of the robots that stayed (start) or of the preceding set (`exchange`),
  // otherwise empty.
  Points base_before, base;
  std::optional<BalancedDetail> balanced;  // steps of balanced robots, from their first set on
  FreeRegion clockwise, counterclockwise;  // contacts, cut: the regions left after the step
  bool clockwise_before = true, counterclockwise_before = true;  // whether a region was left before
};
// O(1), except: `scores` and `team` cost as much as look_at_scores(); `base` O(teams log teams);
// `contacts` and `cut` O(n + c^2) at worst for c contacts so far; `swap` as look_at_swap(); steps
// of balanced robots a completion and the keys of a set.
StepDetail look_at(const Trace& trace, std::uint32_t k);

// The meaning of a figure. Each comment gives its shape, item and value.
enum class FigureKind : std::uint8_t {
  object,       // the outline (area)
  triangle,     // a vertex and an edge; value: its share of the area, negative where it folds back
  centroid,     // point
  centre,       // point: C; in the step of an item of cargo, the centre of mass with it
  vertex,       // point; item: vertex
  radial_edge,  // segment; item: edge
  ray,          // from the vertex to C or to the farthest hit
  chord,        // vertex-chord; item: index of rays.chords; value: ratio
  edge,         // a whole edge of the pair; item: edge
  section,      // the part of an edge in the pair; item: edge
  reflected,    // edge b mirrored through C
  section_end,  // chord at an end of the sections; item: 0 or 1; value: ratio
  bisecting,    // the chord that C bisects, on the lines of the edges, perhaps outside the sections
  chosen,       // the pair's candidate, or the refused chord; value: ratio
  candidate,    // chord; item: candidate; value: score, length or ratio
  team,         // chord; item: team; value: ratio
  robot,        // point; item: its number, team after team; value: load, once known
  gain_triangle,  // h1 h2 p; value: f(p)
  gain_part,      // the part of it in P: a chain that may touch itself along the triangle's sides
  gain_circle,    // 1 point, the centre; value: radius
  arm_before,     // from a vertex to H's edge; item: vertex; value: distance
  arm_after,      // to the new edge
  base_before,    // area or segment
  base,
  contact,    // point; item: contact
  normal,     // a long line along the inward normal of a contact; item: contact
  clockwise,  // area, segment or point: free rotation centres
  counterclockwise,
  translation,  // from C in a free direction
  // from a robot through C to another, or to the middle of two others; or from the centre of mass
  // without an item of cargo, through the centre of mass with it, to the item
  lever,
  side,        // between two robots
  arm,         // from C to a robot; item: its number
  sum,         // the arms laid end to end, each divided by the number of robots
  middle,      // point: where the middle of two more robots must be
  stand,       // point: the trial point that one of three robots came to
  mirrored,    // the polygon turned by half a turn about the middle (area)
  even_chord,  // about the middle; item: its number
  left,        // point: where a robot stood before; item: its number then
  way,         // from there to where a robot came
  range,       // C and the part of an edge where robots may stand (area); item: edge
  range_end,   // chord at an end of a range; item: 0 or 1; value: ratio
  former,      // chord that a team left; item: candidate; value: ratio
  unusable,    // a part of an edge; item: index of Stands::unusable()
  body,        // 1 point, the centre of a robot's body; value: radius; item: the unusable part
               // where the robot does not fit, none if it fits
  hand,        // a robot's arm or hand, a segment or an area; item: as for `body`
  share,       // triangle of C and two of three robots; item: the third robot; value: its share
  level,       // line on which springs carry the same; value: that load
  sinks,       // from C in the direction in which a board on springs sinks
  hole,        // its outline (area); item: hole
  hole_part,   // a vertex and an edge of a hole; item: hole; value: as for `triangle`, but
               // negative, or positive where it folds back
  cargo,       // point; item: of cargo; value: its weight
  old_centre,  // point: the centre of mass before an item of cargo
};
inline constexpr std::uint32_t figure_kind_count = 52;
std::string_view name(FigureKind kind);

struct Figure {
  FigureKind kind = FigureKind::object;
  Points points;                      // 1: a point, 2: a segment, more: an area
  std::optional<std::uint32_t> item;  // see FigureKind
  double value = 0;
};
// The figures of a step, back to front. O(number of points in them).
std::vector<Figure> figures(const Trace& trace, const StepDetail& detail);

// The chords of all rays in order of slope, each once: indices of rays.chords. O(their number).
std::vector<std::uint32_t> chords_by_slope(const Trace& trace);

// The quantities that the metric measures for a candidate: triangles clipped to P, circles, or
// arms. `scores` must be those of a further team, not of the first. O(n).
std::vector<Figure> gain_figures(const Trace& trace, const TeamScores& scores,
                                 std::uint32_t candidate);

// The numbers of a step with their names in JSON. O(1).
struct Number {
  std::string_view name;
  double value;
};
std::vector<Number> numbers(const Trace& trace, const StepDetail& detail);

// A choice in this step that a learner could predict. The answer is the correct choice.
enum class QuestionKind : std::uint8_t {
  nearer_end,     // outcome: which end is nearer to even? 0 or 1, an index of pair->ends
  winning_chord,  // scores: which candidate wins? an index of placement.candidates
  even_chord,     // completion, `exchange`: which chord do two robots take?
                  // an index of balanced->chords
  // swap of one team: the first question for swaps 0, 2, 4 ... if there are several teams,
  // otherwise the second:
  leaving_team,      // which team moves? its number from 0
  coming_candidate,  // to which candidate? an index of placement.candidates
};
inline constexpr std::size_t question_kind_count =
    static_cast<std::size_t>(QuestionKind::coming_candidate) + 1;

struct Question {
  QuestionKind kind = QuestionKind::nearer_end;
  std::uint32_t answer = 0;
};
// The question before step detail.number is shown. Nothing if the step is not a choice. O(1).
std::optional<Question> question(const Trace& trace, const StepDetail& detail);
// The possible answers, increasing. For coming_candidate, these are the candidates that no team has
// taken and at which robots with a size would not collide. O(K teams).
std::vector<std::uint32_t> choices(const Trace& trace, const StepDetail& detail,
                                   const Question& question);
// The chord of a possible answer; for a team, the chord that it may leave. O(1).
const Chord& chord_of_choice(const Trace& trace, const StepDetail& detail, const Question& question,
                             std::uint32_t choice);

// Whether step k is a choice, without its detail. O(1); for balanced robots a completion.
bool is_choice(const Trace& trace, std::uint32_t k);

}  // namespace evenlift
