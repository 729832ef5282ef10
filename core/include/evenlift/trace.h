// The data of the walkthrough: random access to the steps of the algorithm (algorithm.md, The
// trace).
//
// A trace belongs to one placement. It contains the results of the stages (chords from vertices,
// edge pairs and their outcomes, contacts) and a short table of blocks of similar steps, from which
// step(k) is found in O(1). Nothing accumulates: progress_at(trace, k) counts how much of the
// trace's and the placement's arrays is known after step k. look_at() computes what only one step
// needs (every candidate's score, the regions that a few contacts leave) with the stages' own
// functions.
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

// The chapters of a trace, in the order of the thesis.
enum class Chapter : std::uint8_t {
  object,         // with its centre of mass
  law,            // balanced robots: from the law of the lever to the law of the centroid
  robots,         // given supports: where they stand
  vertex_chords,  // from each vertex through C
  slopes,         // the order of these chords
  pairs,          // edges that face each other, opposite vertices, and their candidates
  candidates,
  first_team,
  further_teams,
  start,     // a first set of balanced robots
  exchange,  // of balanced robots: three move at a time
  swaps,     // of teams of two, for the goal `hold`
  loads,
  failures,  // of balanced robots: if one fails
  grasp,     // coverage and immobilization
};
inline constexpr std::uint32_t chapter_count = 15;

// The subject of a step. The `item` of a step counts from 0 among the steps of its kind. Each
// comment begins with the things that `item` counts, or with "1" if there is only one such step.
enum class StepKind : std::uint8_t {
  polygon,       // 1
  centroid,      // 1: how it is found
  centre,        // 1: the centre of mass in use, with all cargo: the centroid, or another point
  radial,        // 1, if there are any: edges whose line passes through C
  ray,           // rays: the hits on it, from a vertex through C
  slopes,        // 1: the chords in order of slope
  sections,      // pairs: two edges and their facing parts
  outcome,       // pairs: the bisecting chord or the nearer end, accepted or not
  opposite,      // opposite: two vertices straight across C, whose chord is accepted or not
  duplicates,    // 1: chords found more than once
  candidates,    // 1
  directions,    // 1, equal angles: the directions with places on both sides
  scores,        // teams: each candidate's score and rank, by area, circle or distance
  team,          // teams: the candidate that it takes
  base,          // teams: H grows
  fewer,         // 1: only some of the teams requested find places, or none
  share,         // teams: the law of the lever
  loads,         // 1: the loads of all robots
  coverage,      // 1
  contacts,      // 1: where the robots touch edges
  cut,           // contacts: the normal line of one cuts the two free regions
  slide,         // 1: whether a translation is free
  closure,       // 1: form closure, margin
  second_order,  // 1, only without form closure
  result,        // 1: everything that place() reports
  // Balanced robots:
  lever,       // 1: two robots, C in the middle
  three,       // 1: three robots, and the law of the lever twice
  many,        // 1, from four robots on: the law of the centroid
  rest,        // 1: some robots, and where the middle of two more must be
  mirror,      // 1: the outline turned about that point, and the even chords through it
  completion,  // 1: the chord that makes the best set
  start,       // sets of the start: which robots stayed, and which came
  exchange,    // swaps: three robots leave, three come, and the set is better
  round,       // rounds that changed something: the end of each
  settled,     // 1: why the swaps of three robots end
  failure,     // robots, if there are 3 to most_failing: one fails
  failures,    // 1: the number of robots that may fail at once
  pairs,       // 1, for an even number: the same number of robots in teams of two
  // Teams anywhere in their ranges, and teams with the goal `hold`:
  range,  // ranges: the places of an edge pair that meet the minimum ratio, with two candidates
  swap,   // swaps of teams: which team moved where, and why that is better
  held,   // 1: why the swaps of teams end
  // Robots with a size, or no-go edges:
  stands,  // 1, after the centre of mass: the usable boundary, and why the rest is not
  // Given supports:
  support,     // supports: at the edge or beneath
  equations,   // 1: three equations, and whether they determine the loads
  by_lever,    // 1: two robots
  by_areas,    // 1: three robots, not on one line
  by_springs,  // 1, if equations do not determine the loads: a board on equal springs
  extremes,    // 1, after by_springs: the loads at best and at worst
  falls,       // 1, in place of the loads: C is outside H
  // Cargo on the object:
  cargo,  // items, after the centroid: how each moves the centre of mass
};
inline constexpr std::uint32_t step_kind_count = 50;
inline constexpr std::uint32_t most_failing = 16;

// The names in JSON, lessons and links, such as "pairs" and "first_team", or "outcome" and
// "second_order"; and the kind with a name, empty if it is unknown. O(1).
std::string_view name(Chapter chapter);
std::string_view name(StepKind kind);
std::optional<StepKind> step_kind_from_name(std::string_view text);

struct Step {
  StepKind kind = StepKind::polygon;
  Chapter chapter = Chapter::object;
  std::uint32_t item = 0;
  bool operator==(const Step&) const = default;
};

// The most steps of a trace. Longer traces take too long to watch and exceed a browser's memory.
inline constexpr std::uint32_t max_trace_steps = 1u << 20;

struct Trace {
  const PolygonWithHoles& object() const { return placement.object; }
  const Polygon& polygon() const { return placement.polygon(); }

  Placement placement;
  Vec2 centre = Vec2::Zero();  // C, with all cargo
  Units units;                 // for captions; they change no number

  // The chords of ray i are chords[begins[i] .. begins[i + 1]). Chords already listed at an earlier
  // ray come first; their `vertex` is their other end.
  struct Rays {
    std::vector<std::uint32_t> vertices;  // in the order found
    std::vector<std::uint32_t> begins;    // one more entry than `vertices`
    std::vector<VertexChord> chords;
  } rays;
  std::vector<std::uint32_t> radial_edges;

  // The members from here to `candidates_of_range` are only for the methods area, circle and
  // distance.
  std::vector<EdgePair> pairs;
  std::vector<OppositeVertices> opposite;
  // The candidate that each source led to, or no_index. Source i is pair i, or opposite vertices
  // i - pairs.size().
  std::vector<std::uint32_t> candidate_of_source;
  // For each candidate, the source whose chord was kept, and the first source that led to it.
  std::vector<std::uint32_t> source_of_candidate, first_source_of_candidate;
  // With positions anywhere in the range: the pairs that add range candidates, and what the two
  // candidates of each became.
  std::vector<std::uint32_t> ranges;
  std::vector<std::array<std::uint32_t, 2>> candidates_of_range;

  // With the goal `hold`: the swaps of teams; and the teams at the start and after each swap.
  std::optional<SwapHistory> swaps;
  std::vector<std::vector<Team>> stages;

  std::vector<Contact> contacts;

  // The members from here to `in_pairs` are only for balanced robots.
  std::optional<BalancedProblem> problem;
  BalancedHistory history;
  // The robots' numbers, from 0, in the last set of the start and after each swap. A robot keeps
  // its number from swap to swap; those of the search's last set are in order along the outline.
  std::vector<std::vector<std::uint32_t>> robot_numbers;
  std::optional<Placement> in_pairs;  // the same number in teams by area, if they find places

  // The given placement, if robots were moved by hand. The steps are those of the method, and
  // `placement` is its own result; only the last step describes both.
  std::optional<Placement> moved;

  // A run of similar steps. Item i of a block has `kinds` steps, from step first + i * kinds on,
  // one of each kind in the order of `kind`.
  struct Block {
    std::uint32_t first = 0, items = 0, first_item = 0, kinds = 1;
    std::array<StepKind, 3> kind{};
    Chapter chapter = Chapter::object;
  };
  std::vector<Block> blocks;

  // All functions are O(1). The number of steps is at least 5.
  std::uint32_t size() const;
  // Step k, where k < size().
  Step step(std::uint32_t k) const;
  // The number of items of a kind; the items are 0 .. count - 1.
  std::uint32_t count(StepKind kind) const;
  // The number of the step; empty if there is no such step.
  std::optional<std::uint32_t> find(StepKind kind, std::uint32_t item) const;
  // The number of a chapter's first step; empty if the trace has no such chapter.
  std::optional<std::uint32_t> chapter_begin(Chapter chapter) const;
  // Whether the method chooses teams among candidates: area, circle or distance.
  bool by_candidates() const;
  // The metric that selects the teams. Call it only if by_candidates().
  Metric metric() const;
  // The candidates and teams that the metric selects, before any swap.
  const std::vector<std::uint32_t>& selected() const {
    return swaps ? swaps->start : placement.team_candidates;
  }
  const std::vector<Team>& selected_teams() const {
    return stages.empty() ? placement.teams : stages.front();
  }
  bool balanced() const { return problem.has_value(); }
  bool given() const { return placement.settings.method == Method::given; }
};

// Whether C is outside the polygon; the boundary counts as inside. Exact. O(n).
bool centre_is_outside(const Trace& trace);

// The trace of a placement from place(). If balanced robots or teams were moved by hand, the
// trace's own placement is the method's result. It is an error if the trace has more than
// max_trace_steps steps, or if a whole search for balanced robots is not quick to finish. The cost
// is O(n log n + K log K) for K edge pairs and opposite vertices, plus that of the selection and
// swaps if teams are swapped or were moved; for balanced robots it is that of their search. With
// HistoryLength::start only the start of the search is traced, if that is quick, so that the trace
// can follow a drag.
Result<Trace> make_trace(const Placement& placement, HistoryLength length = HistoryLength::whole,
                         const Units& units = {});

// The step nearest to one of another trace, from before an edit: the step of the same kind and
// item, or else the last of that kind, or else the beginning of its chapter or of the next existing
// one, or else the last step. O(1).
std::uint32_t nearest_step(const Trace& trace, const Step& step);

// What is known after step k, as counts from the beginning of the trace's and the placement's
// arrays.
struct Progress {
  std::uint32_t robots = 0;  // given supports that stand
  std::uint32_t rays = 0;
  bool slopes = false;
  std::uint32_t sections = 0;    // pairs with known sections
  std::uint32_t sources = 0;     // decided sources: pairs, then opposite vertices
  bool merged = false;           // the placement's own candidates are known
  std::uint32_t teams = 0;       // teams that have taken candidates or places
  std::uint32_t base_teams = 0;  // teams whose robots form H
  std::uint32_t shares = 0;      // teams with known loads
  bool coverage = false;
  std::uint32_t swaps = 0;  // swaps of teams
  std::uint32_t cuts = 0;   // contacts whose normal lines have cut the regions
  bool closure = false;     // the closure, and everything else that place() reports
  bool stands = false;      // the boundary that robots with a size can use
  bool operator==(const Progress&) const = default;
};
// What is known after step k; it depends on k alone. Candidate c is known if `merged`, or if
// first_source_of_candidate[c] < `sources`. O(1).
Progress progress_at(const Trace& trace, std::uint32_t k);

// The teams after the known swaps; the first `known.teams` are taken. O(1).
const std::vector<Team>& teams_at(const Trace& trace, const Progress& known);

// The lifting base of the first `teams` teams that the method selects, before any swap. O(teams log
// teams).
Points lifting_base(const Trace& trace, std::uint32_t teams);

// The lifting base of the first `known.base_teams` of teams_at(). O(teams log teams).
Points lifting_base(const Trace& trace, const Progress& known);

// The outcome of an edge pair.
enum class Outcome : std::uint8_t {
  bisecting,     // C bisects a chord between the sections: the candidate
  nearer_end,    // C bisects no chord; the end with the larger ratio is the candidate
  too_uneven,    // C bisects no chord, and even that end is below the minimum ratio
  midpoint,      // parallel edges; the chord between the midpoints is the candidate
  parallel_low,  // parallel edges, whose ratio is below the minimum
};
std::string_view name(Outcome outcome);

// Whether robots with a size can stand on a pair's best chord, on another of its chords, or on
// none.
enum class Standing : std::uint8_t { there, elsewhere, nowhere };

struct PairDetail {
  EdgePair pair;
  PairVerdict verdict;
  Outcome outcome = Outcome::bisecting;
  // The section of edge a runs from a[0] to a[1], that of b from b[0] to b[1]; ends[i] connects
  // a[i] and b[i].
  std::array<Vec2, 2> a{Vec2::Zero(), Vec2::Zero()}, b{Vec2::Zero(), Vec2::Zero()};
  std::array<Chord, 2> ends;
  // Edge b reflected through C, and the point where its line meets that of a: an end of the chord
  // that C bisects, perhaps far outside. `meeting` is empty if the edges are parallel.
  std::array<Vec2, 2> reflected{Vec2::Zero(), Vec2::Zero()};
  std::optional<Vec2> meeting;
  std::uint32_t nearer = 0;  // the end with the larger ratio: 0 or 1
  Chord chosen;              // the candidate, or the best chord if its ratio is too low
  std::optional<std::uint32_t> candidate;  // index of placement.candidates
  bool stands = false;               // the candidate's chord is this pair's, not a duplicate's
  std::optional<Standing> standing;  // of robots with a size; `chosen` is then usable
};
// The detail of trace.pairs[index]. O(1).
PairDetail look_at_pair(const Trace& trace, std::uint32_t index);

struct RangeDetail {
  EdgePair pair;
  PairRange range;
  // The most uneven chords allowed, or the ends of the section; for robots with a size, the first
  // and last chord in the longest part of the range where they can stand.
  std::array<Chord, 2> ends;
  // Indices of placement.candidates. For robots with a size, the second may be no_index: the robots
  // of a team would collide there.
  std::array<std::uint32_t, 2> candidates{};
};
// The detail of trace.ranges[index]. O(1).
RangeDetail look_at_range(const Trace& trace, std::uint32_t index);

struct SwapDetail {
  HoldKeys before, after;
  std::optional<double> margin_before, margin;
  std::vector<std::uint32_t> teams;     // the teams that moved
  std::vector<std::uint32_t> from, to;  // their candidates
  SwapKind kind = SwapKind::single;
  HoldKey decided_by = HoldKey::level;
};
// The detail of the swap with this index in `trace.swaps`. O(n log n).
SwapDetail look_at_swap(const Trace& trace, std::uint32_t index);

struct StandsDetail {
  double boundary = 0;                            // its length
  double usable = 0;                              // length of the usable part
  std::array<double, why_unusable_count> lost{};  // length of the rest, by reason
  // Contacts of robots that do not fit, one for each reason that occurs, except no_go and narrow.
  // Each is in the middle of the longest part with that reason, whose index in Stands::unusable()
  // is `part`. `fits` is the contact of a robot that fits, in the middle of the longest usable
  // interval. Both members are empty if robots are points.
  struct Misfit {
    std::uint32_t part = 0;
    LiftingPoint contact;
  };
  std::vector<Misfit> misfits;
  std::optional<LiftingPoint> fits;
};
// The usable boundary of a trace with a robot's size or no-go edges. O(n + parts).
StandsDetail look_at_stands(const Trace& trace);

struct OppositeDetail {
  OppositeVertices vertices;
  Chord chord;                             // between them
  std::optional<std::uint32_t> candidate;  // empty if the load ratio is below the minimum
  bool stands = false;                     // the candidate's chord is this one, not a pair's
};
// The detail of trace.opposite[index]. O(1).
OppositeDetail look_at_opposite(const Trace& trace, std::uint32_t index);

// By how much one end of a candidate would widen H.
struct EndGain {
  bool outside = false;  // whether the end is outside H; if not, it gains nothing
  Vec2 h1 = Vec2::Zero(), h2 = Vec2::Zero();  // the edge of H beyond which C sees the end
  Vec2 p = Vec2::Zero();                      // the end
  double value = 0;                           // f(p)
};
// The key at which a candidate dropped out; for the choice as a whole, the one that separated the
// winner from its last rival.
enum class DecidedBy : std::uint8_t { only_one, first_key, ratio, length, order };
struct Score {
  double value = 0;       // for a first team its length (or ratio, with `most_even`)
  bool exact = true;      // otherwise `value` is an upper bound, too low to win
  bool taken = false;     // an earlier team has taken it
  bool collides = false;  // one of its robots collides with one of an earlier team
  bool eligible = true;   // a first team needs an even candidate if there are any
  DecidedBy lost_by = DecidedBy::first_key;  // the key at which it dropped out, unless it won
  std::array<EndGain, 2> ends;               // of r1 and r2; empty for a first team
};
struct TeamScores {
  std::uint32_t team = 0;
  Rule rule = Rule::score;
  Points base;  // H before the choice
  std::vector<Score> of_candidate;
  // The candidates that can still be taken: the winner first, then the others, of which the last to
  // drop out comes first.
  std::vector<std::uint32_t> ranking;
  DecidedBy decided_by = DecidedBy::only_one;
};

// The most candidates that a picture of a choice numbers; more would hide the picture.
inline constexpr std::size_t most_ranked_numbered = 6;

// The best eligible candidates, which a picture numbers. O(K).
std::vector<std::uint32_t> best_ranked(const TeamScores& scores);

// The scores for the choice of this team, only if by_candidates(). All scores are exact if
// candidates times vertices are at most exact_score_budget. Beyond that, only those that the
// selection itself evaluated are exact. O(K log K) plus the cost of the scores.
TeamScores look_at_scores(const Trace& trace, std::uint32_t team);
inline constexpr std::uint64_t exact_score_budget = 1u << 22;

// Balanced robots at a step.
struct BalancedDetail {
  std::vector<LiftingPoint> robots;
  std::vector<std::uint32_t> numbers;  // the robots' numbers, from 0
  // rest, mirror, completion, start, `exchange`: how the set is completed
  std::vector<LiftingPoint> rest;     // the robots that stay, and the one at a trial point
  std::optional<LiftingPoint> stand;  // the robot that came to a trial point
  Vec2 middle = Vec2::Zero();         // of the two other robots
  std::vector<Chord> chords;          // the even chords about the middle
  std::uint32_t chosen = 0;           // the index of the one taken
  // `exchange`: compared with the preceding set
  std::vector<std::uint32_t> moved;  // the numbers of the robots that moved, increasing
  std::vector<Vec2> ways;            // for each of them, the old and the new position
  BalancedKeys keys_before;
  std::optional<double> margin_before;
  // start, `exchange`: the keys and margin of the set
  BalancedKeys keys;
  std::optional<double> margin;
  // failure, failures: the rest of the robots if each robot fails; empty if the object then falls
  std::vector<std::optional<RestOfRobots>> rest_of;
  std::optional<std::uint32_t> failed;  // failure: this robot; the others are `robots`
  std::vector<double> loads;            // failure: those of the others, if equally stiff
};

// What a step needs beyond the trace itself. Members of other steps are empty.
struct StepDetail {
  std::uint32_t number = 0;
  Step step;
  std::optional<PairDetail> pair;          // sections, outcome
  std::optional<OppositeDetail> opposite;  // opposite
  std::optional<RangeDetail> range;        // range
  std::optional<SwapDetail> swap;          // swap
  std::optional<StandsDetail> stands;      // stands
  std::optional<TeamScores> scores;        // scores, team, if by_candidates()
  // H before and after a step. For scores, team, base: without and with the team. For swap: before
  // and after the swap. For completion, start, `exchange` and all later steps of balanced robots:
  // `base` is of the step's own robots; `base_before` is of the robots that stayed (start) or of
  // the preceding set (`exchange`), otherwise empty.
  Points base_before, base;
  std::optional<BalancedDetail> balanced;  // from the first set of balanced robots on
  FreeRegion clockwise, counterclockwise;  // contacts, cut: the free regions left
  bool clockwise_before = true, counterclockwise_before = true;  // whether any was left before
};
// The detail of step k. O(1), except for these steps: `scores` and `team` cost as much as
// look_at_scores(); `base` O(teams log teams); `contacts` and `cut` O(n + c^2) at worst for c
// contacts so far; `swap` as much as look_at_swap(); steps of balanced robots a completion and the
// keys of a set.
StepDetail look_at(const Trace& trace, std::uint32_t k);

// The kind of a figure. Each comment gives the shape of a figure, its item and its value.
enum class FigureKind : std::uint8_t {
  object,       // the outline (area)
  triangle,     // a vertex and an edge; value: its share of the area, negative where it folds back
  centroid,     // point
  centre,       // point: C; in the step of an item of cargo, with that item
  vertex,       // point; item: vertex
  radial_edge,  // segment; item: edge
  ray,          // from the vertex to C or to the farthest hit
  chord,        // vertex-chord; item: index of rays.chords; value: ratio
  edge,         // a whole edge of the pair; item: edge
  section,      // the part of an edge in the pair; item: edge
  reflected,    // edge b mirrored through C
  section_end,  // chord at an end of the section; item: 0 or 1; value: ratio
  bisecting,    // the chord that C bisects, on the lines of the edges, perhaps outside the sections
  chosen,       // the pair's candidate, or the refused chord; value: ratio
  candidate,    // chord; item: candidate; value: score, length or ratio
  team,         // chord; item: team; value: ratio
  robot,        // point; item: its number, team after team; value: load, once known
  gain_triangle,  // h1 h2 p; value: f(p)
  gain_part,  // the triangle's part in P: a chain that may touch itself along the triangle's sides
  gain_circle,  // 1 point, the centre; value: radius
  arm_before,   // from a vertex to H's edge; item: vertex; value: distance
  arm_after,    // from the vertex to H's new edge
  base_before,  // area or segment
  base,
  contact,    // point; item: contact
  normal,     // a long line along a contact's inward normal; item: contact
  clockwise,  // area, segment or point: free rotation centres
  counterclockwise,
  translation,  // from C in a free direction
  // from a robot through C to another, or to the middle of two others; or for an item of cargo:
  // from the centre of mass without the item, through that with it, to the item
  lever,
  side,        // between two robots
  arm,         // from C to a robot; item: its number
  sum,         // the arms end to end, each divided by the number of robots
  middle,      // point: where the middle of two more robots must be
  stand,       // point: the trial point to which one of three robots came
  mirrored,    // the polygon turned by half a turn about the middle (area)
  even_chord,  // chord about the middle; item: its number
  left,        // point: where a robot was before; item: its number then
  way,         // from there to its new place
  range,       // C and the part of an edge where robots may stand (area); item: edge
  range_end,   // chord at an end of the range; item: 0 or 1; value: ratio
  former,      // chord that a team left; item: candidate; value: ratio
  unusable,    // a part of an edge; item: index of Stands::unusable()
  body,        // 1 point, the centre of a robot's body; value: radius; item: the unusable part
               // where the robot does not fit; no item if it fits
  hand,        // a robot's arm or hand, a segment or an area; item: as for `body`
  share,       // triangle of C and two of three robots; item: the third; value: its share
  level,       // line on which springs carry the same load; value: that load
  sinks,       // from C in the direction in which the board sinks
  hole,        // outline of a hole (area); item: hole
  hole_part,   // a vertex and an edge of a hole; item: hole; value: as for `triangle`, but
               // negative, or positive where it folds back
  cargo,       // point of an item of cargo; item: its number; value: its weight
  old_centre,  // point: C before an item of cargo
};
inline constexpr std::uint32_t figure_kind_count = 52;
std::string_view name(FigureKind kind);

struct Figure {
  FigureKind kind = FigureKind::object;
  Points points;                      // 1: a point, 2: a segment, more: an area
  std::optional<std::uint32_t> item;  // see FigureKind
  double value = 0;
};
// The figures of a step, from back to front. O(number of points in them).
std::vector<Figure> figures(const Trace& trace, const StepDetail& detail);

// The chords of all rays in order of slope, each once: indices of rays.chords. O(their number).
std::vector<std::uint32_t> chords_by_slope(const Trace& trace);

// What the metric measures for a candidate: triangles clipped to P, circles, or arms. `scores` must
// be of a further team, not of the first. O(n).
std::vector<Figure> gain_figures(const Trace& trace, const TeamScores& scores,
                                 std::uint32_t candidate);

// The numbers of a step, with their names in JSON. O(1).
struct Number {
  std::string_view name;
  double value;
};
std::vector<Number> numbers(const Trace& trace, const StepDetail& detail);

// A choice in this step that a learner could predict, with the correct answer.
enum class QuestionKind : std::uint8_t {
  nearer_end,     // outcome: which end is nearer to even? 0 or 1, an index of pair->ends
  winning_chord,  // scores: which candidate wins? an index of placement.candidates
  even_chord,     // completion, `exchange`: which chord do two robots take? an index of
                  // balanced->chords
  // swap of one team; with several teams, swaps 0, 2, 4 ... ask the first question, and all others
  // the second:
  leaving_team,      // which team moves? its number from 0
  coming_candidate,  // to which candidate? an index of placement.candidates
};
inline constexpr std::size_t question_kind_count =
    static_cast<std::size_t>(QuestionKind::coming_candidate) + 1;

struct Question {
  QuestionKind kind = QuestionKind::nearer_end;
  std::uint32_t answer = 0;
};
// The question before step detail.number is shown; empty if the step is not a choice. Costs as much
// as is_choice().
std::optional<Question> question(const Trace& trace, const StepDetail& detail);
// The possible answers, increasing. For coming_candidate, they are the candidates that no team has
// taken and at which robots with a size would not collide. O(K (teams + log K)); if robots have a
// size, O(K teams^2).
std::vector<std::uint32_t> choices(const Trace& trace, const StepDetail& detail,
                                   const Question& question);
// The chord of a possible answer; for a team, the chord that it may leave. O(1).
const Chord& chord_of_choice(const Trace& trace, const StepDetail& detail, const Question& question,
                             std::uint32_t choice);

// Whether step k is a choice, decided without its detail. O(1); for balanced robots, the cost of
// look_at().
bool is_choice(const Trace& trace, std::uint32_t k);

}  // namespace evenlift
