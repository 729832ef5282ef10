// The data of the walkthrough: random access to the steps of the algorithm (algorithm.md, The
// trace).
//
// A trace belongs to one placement. It contains the results of the stages (chords from vertices,
// edge pairs and their outcomes, contacts) and a short table of blocks of similar steps, in which
// step(k) finds step k in O(1). You can look at the steps in any order: progress_at(trace, k)
// counts the entries of the trace's and the placement's arrays that are known after step k.
// look_at() calls the functions of the stages to compute data that only one step needs, such as
// every candidate's score, or the free regions after the first few contacts.
//
// A walkthrough keeps the placement, its trace and the detail of the current step:
//
//   const Result<Trace> trace = make_trace(placement);
//   const StepDetail detail = look_at(*trace, k);    // once for each change of k
//   figures(*trace, detail)                          // the step's figures, to draw and point at
//   progress_at(*trace, k)                           // the background, to draw behind them
//   question(*trace, detail)                         // a question, if the step can be guessed
//   why_not(*trace, k, candidate)                    // why_not.h
//
// output/trace_words.h puts the steps into words.
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
#include "evenlift/report.h"
#include "evenlift/selection.h"
#include "evenlift/stands.h"
#include "evenlift/swaps.h"

namespace evenlift {

// The chapters, in order.
enum class Chapter : std::uint8_t {
  object,         // the object and its centre of mass
  law,            // balanced robots: from the law of the lever to the law of the centroid
  robots,         // given supports: the places where they stand
  vertex_chords,  // the chords from each vertex through C
  slopes,         // the order of these chords
  pairs,          // edges that face each other, opposite vertices, and their candidates
  candidates,
  first_team,
  further_teams,
  start,     // a first set of balanced robots
  exchange,  // swaps of three balanced robots each
  swaps,     // swaps of teams of two, for the goal `hold`
  loads,
  failures,  // balanced robots: the effect if one fails
  grasp,     // coverage and immobilization
};
inline constexpr std::uint32_t chapter_count = 15;

// The subject of a step. Among the steps of one kind, `item` counts from 0. Each comment begins
// with the things that `item` counts, or with "1" if a trace has at most one such step.
enum class StepKind : std::uint8_t {
  polygon,       // 1
  centroid,      // 1: the computation of the centroid
  centre,        // 1: the centre of mass in use, with all cargo, at the centroid or elsewhere
  radial,        // 1, if there are any: edges whose line passes through C
  ray,           // rays: a ray from a vertex through C, and its hits
  slopes,        // 1: the chords in order of slope
  sections,      // pairs: two edges and their facing parts
  outcome,       // pairs: the bisecting chord, nearer end or midpoint, accepted or not
  opposite,      // pairs of opposite vertices: the chord between the two, accepted or not
  duplicates,    // 1: chords found more than once
  candidates,    // 1: all candidates
  directions,    // 1, equal angles: the directions with places on both sides of C
  scores,        // teams: each candidate's score and rank, by area, circle or distance
  team,          // teams: the candidate or the places that the team takes
  base,          // teams: H grows
  fewer,         // 1: there are fewer teams than requested, or no set of balanced robots
  share,         // teams: the law of the lever
  loads,         // 1: the loads of all robots
  coverage,      // 1
  contacts,      // 1: where the robots touch edges
  cut,           // contacts: the normal line of a contact cuts the two free regions
  slide,         // 1: whether a translation is free
  closure,       // 1: form closure, margin
  second_order,  // 1, only without form closure
  result,        // 1: everything that place() reports
  // Balanced robots:
  lever,       // 1: two robots with C in the middle
  three,       // 1: three robots, and the law of the lever twice
  many,        // 1, from four robots on: the law of the centroid
  rest,        // 1: some robots, and the point where the middle of two more must be
  mirror,      // 1: the outline after half a turn about this point, and the even chords about it
  completion,  // 1: the chord that makes the best set
  start,       // sets of the start: the robots that stayed, and those that came
  exchange,    // swaps: three robots leave and three come, which makes the set better
  round,       // rounds: the end of each round that changed something
  settled,     // 1: why the swaps of three robots end
  failure,     // robots, if there are 3 to most_failing: one robot fails
  failures,    // 1: the number of robots that may fail at once
  pairs,       // 1, for an even number of robots: the same number of robots in teams of two
  // Teams anywhere in their ranges, and teams with the goal `hold`:
  range,  // ranges: the places of an edge pair that meet the minimum ratio, with two candidates
  swap,   // swaps of teams: the teams that moved, their new places, and why these are better
  held,   // 1: why the swaps of teams end
  // Robots with a size, or no-go edges:
  stands,  // 1, after the centre of mass: the usable boundary, and why the rest is unusable
  // Given supports:
  support,     // supports: whether one stands at the edge or beneath the object
  equations,   // 1: three equations, and whether they determine the loads
  by_lever,    // 1: the loads of two robots
  by_areas,    // 1: the loads of three robots that are not on one line
  by_springs,  // 1, if equations do not determine the loads: a board on equal springs
  extremes,    // 1, after `by_springs`: the greatest load at best and at worst
  falls,       // 1, in place of the loads: C is outside H
  // Cargo on the object:
  cargo,  // items, after the centroid: how an item moves the centre of mass
};
inline constexpr std::uint32_t step_kind_count = 50;
inline constexpr std::uint32_t most_failing = 16;

// Return the name that JSON, lessons and links use for a chapter, such as "first_team", or for a
// kind, such as "second_order". step_kind_from_name() returns nothing if the name is unknown. O(1).
std::string_view name(Chapter chapter);
std::string_view name(StepKind kind);
std::optional<StepKind> step_kind_from_name(std::string_view text);

struct Step {
  StepKind kind = StepKind::polygon;
  Chapter chapter = Chapter::object;
  std::uint32_t item = 0;
  bool operator==(const Step&) const = default;
};

// The greatest number of steps in a trace. A longer trace would take too long to watch and would
// not fit into a browser's memory.
inline constexpr std::uint32_t max_trace_steps = 1u << 20;

struct Trace {
  const PolygonWithHoles& object() const { return placement.object; }
  const Polygon& polygon() const { return placement.polygon(); }

  Placement placement;
  Vec2 centre;  // C, with all cargo
  Units units;  // for captions; the units change no number

  // The chords of ray i are chords[begins[i] .. begins[i + 1]). Chords that an earlier ray has
  // already listed come first; the `vertex` of such a chord is the vertex of the earlier ray.
  struct Rays {
    std::vector<std::uint32_t> vertices;  // in the order of the sweep
    std::vector<std::uint32_t> begins;    // one more entry than `vertices`
    std::vector<VertexChord> chords;
  } rays;
  std::vector<std::uint32_t> radial_edges;

  // The members from here to `candidates_of_range` are only for the methods `area`, `circle` and
  // `distance`.
  std::vector<EdgePair> pairs;
  std::vector<OppositeVertices> opposite;
  // For each source, the candidate that its chord became, or no_index. Source i is pairs[i] or,
  // from i = pairs.size() on, opposite[i - pairs.size()].
  std::vector<std::uint32_t> candidate_of_source;
  // For each candidate: the source of the chord that was kept when equal chords were merged, and
  // the first source of any of these chords (no_index if they come from ranges only).
  std::vector<std::uint32_t> source_of_candidate, first_source_of_candidate;
  // With positions anywhere in the range: the pairs that add range candidates, and for each such
  // pair, the candidates that its two chords became.
  std::vector<std::uint32_t> ranges;
  std::vector<std::array<std::uint32_t, 2>> candidates_of_range;

  // With the goal `hold`: the swaps of teams, and the teams at the start and after each swap.
  std::optional<SwapHistory> swaps;
  std::vector<std::vector<Team>> stages;

  std::vector<Contact> contacts;

  // The members from here to `in_pairs` are only for balanced robots.
  std::optional<BalancedProblem> problem;
  BalancedHistory history;
  // The robots' numbers, from 0, in the last set of the start and after each swap. A robot keeps
  // its number from swap to swap. The numbers of the search's last set ascend along the outline.
  std::vector<std::vector<std::uint32_t>> robot_numbers;
  std::optional<Placement> in_pairs;  // the same number of robots in teams by area, if possible
  Report report_of_pairs;             // of these

  // Of the placement, without any conditions: with loads by all models for given supports, and with
  // failures if steps show them.
  Report report;

  // The placement that make_trace() received, if robots in it were moved by hand. Then `placement`
  // is the method's own result, which the steps show; only the last step describes both.
  std::optional<Placement> moved;

  // A run of similar steps. Each item has `kinds` steps, one of each kind, in the order of `kind`.
  // The steps of item first_item + i begin at step first + i * kinds.
  struct Block {
    std::uint32_t first = 0, items = 0, first_item = 0, kinds = 1;
    std::array<StepKind, 3> kind{};
    Chapter chapter = Chapter::object;
  };
  std::vector<Block> blocks;

  // All functions are O(1). size() is the number of steps, at least 5.
  std::uint32_t size() const;
  // Step k, where k < size().
  Step step(std::uint32_t k) const;
  // The number of steps of a kind.
  std::uint32_t count(StepKind kind) const;
  // The number of the step with this kind and item; empty if there is no such step.
  std::optional<std::uint32_t> find(StepKind kind, std::uint32_t item) const;
  // The number of a chapter's first step; empty if the trace has no such chapter.
  std::optional<std::uint32_t> chapter_begin(Chapter chapter) const;
  // Whether the method chooses teams among candidates: `area`, `circle` or `distance`.
  bool by_candidates() const;
  // The metric that selects the teams. Call it only if by_candidates().
  Metric metric() const;
  // The candidates that the metric selects, before any swap, and the teams on these candidates.
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

// The trace of a placement from place(). Returns an error if there are more than max_trace_steps
// steps or, with HistoryLength::whole, if the search for balanced robots would take too long
// (is_quick_to_finish()). HistoryLength::start traces only the start of this search, and only if
// that is quick enough to repeat during a drag. For balanced robots, the search sets the cost.
// Otherwise it is O(n log n + K log K) for K edge pairs and opposite vertices; selection and swaps
// for the goal `hold` add their cost, and so does place() if teams were moved by hand.
Result<Trace> make_trace(const Placement& placement, HistoryLength length = HistoryLength::whole,
                         const Units& units = {});

// The step of `trace` that is nearest to `step`, a step of the trace before an edit. It is the
// first of these that exists: the step of the same kind and item; the last step of this kind; the
// first step of the same chapter or of the next chapter that exists; the last step. O(1).
std::uint32_t nearest_step(const Trace& trace, const Step& step);

// What is known after a step. Each number counts the known entries at the beginning of an array of
// the trace or of the placement.
struct Progress {
  std::uint32_t robots = 0;  // given supports that stand
  std::uint32_t rays = 0;
  bool slopes = false;
  std::uint32_t sections = 0;    // pairs with known sections
  std::uint32_t sources = 0;     // sources with a known outcome: pairs, then opposite vertices
  bool merged = false;           // the placement's own candidates are known
  std::uint32_t teams = 0;       // teams that have taken candidates or places
  std::uint32_t base_teams = 0;  // teams whose robots form H
  std::uint32_t shares = 0;      // teams with known loads
  bool coverage = false;
  std::uint32_t swaps = 0;  // swaps of teams
  std::uint32_t cuts = 0;   // contacts whose normal lines have cut the regions
  bool closure = false;     // form closure, and everything else that place() reports
  bool stands = false;      // the part of the boundary that robots can use
  bool operator==(const Progress&) const = default;
};
// Returns what is known after step k, whichever steps were looked at before. Candidate c is known
// if `merged` is true or first_source_of_candidate[c] < `sources`. O(1).
Progress progress_at(const Trace& trace, std::uint32_t k);

// The teams after the known swaps. Only the first `known.teams` of them have been chosen. O(1).
const std::vector<Team>& teams_at(const Trace& trace, const Progress& known);

// The lifting base of the first `teams` teams that the method selects, before any swap. O(teams log
// teams).
Points lifting_base(const Trace& trace, std::uint32_t teams);

// The lifting base of the first `known.base_teams` teams of teams_at(). O(teams log teams).
Points lifting_base(const Trace& trace, const Progress& known);

// The outcome of an edge pair.
enum class Outcome : std::uint8_t {
  bisecting,     // C bisects a chord between the sections; this chord is the candidate
  nearer_end,    // C bisects no chord; the candidate is at the end with the larger ratio
  too_uneven,    // C bisects no chord; the ratios at both ends are below the minimum
  midpoint,      // parallel edges; the chord between the midpoints is the candidate
  parallel_low,  // parallel edges, whose ratio is below the minimum
};
std::string_view name(Outcome outcome);

// Whether robots with a size can stand on the best chord of an edge pair, only on another chord of
// this pair, or on none of its chords that meet the minimum ratio.
enum class Standing : std::uint8_t { there, elsewhere, nowhere };

struct PairDetail {
  EdgePair pair;
  PairVerdict verdict;
  Outcome outcome = Outcome::bisecting;
  // The section of edge a runs from a[0] to a[1], and the section of edge b from b[0] to b[1].
  // ends[i] connects a[i] and b[i].
  std::array<Vec2, 2> a{}, b{};
  std::array<Chord, 2> ends;
  // `reflected` is edge b reflected through C. Its line meets the line of edge a at `meeting`. This
  // is one end of the chord that C bisects; it may be far outside the section. `meeting` is empty
  // if the edges are parallel.
  std::array<Vec2, 2> reflected{};
  std::optional<Vec2> meeting;
  std::uint32_t nearer = 0;  // the end with the larger ratio: 0 or 1
  Chord chosen;              // the candidate's chord or, without one, the pair's best chord
  std::optional<std::uint32_t> candidate;  // index in placement.candidates
  bool stands = false;  // whether the candidate's chord is this pair's, not a duplicate's
  // Set if robots have a size or there are no-go edges. Robots can stand on `chosen` unless
  // `standing` is `nowhere`; if it is `elsewhere`, `chosen` is the other chord.
  std::optional<Standing> standing;
};
// The detail of trace.pairs[index]. O(1).
PairDetail look_at_pair(const Trace& trace, std::uint32_t index);

struct RangeDetail {
  EdgePair pair;
  PairRange range;
  // The chords at the ends of the range: the most uneven chords allowed, or those at the ends of
  // the section. For robots with a size, they are the first and the last chord in the longest part
  // of the range where two robots can stand.
  std::array<Chord, 2> ends;
  // Indices in placement.candidates. For robots with a size, the second is no_index if the pair
  // adds only one candidate, since the robots of a team would collide at the other place.
  std::array<std::uint32_t, 2> candidates{};
};
// The detail of trace.ranges[index]. O(1).
RangeDetail look_at_range(const Trace& trace, std::uint32_t index);

struct SwapDetail {
  HoldKeys before, after;
  std::optional<double> margin_before, margin;
  std::vector<std::uint32_t> teams;     // the teams that moved
  std::vector<std::uint32_t> from, to;  // the candidates that they left, and their new ones
  SwapKind kind = SwapKind::single;
  HoldKey decided_by = HoldKey::level;
};
// The detail of the swap with this index in `trace.swaps`. O(n log n).
SwapDetail look_at_swap(const Trace& trace, std::uint32_t index);

struct StandsDetail {
  double boundary = 0;                            // its length
  double usable = 0;                              // the length of the usable part
  std::array<double, why_unusable_count> lost{};  // the length of the rest, by reason
  // Contacts of robots that do not fit, one for each reason that occurs, except `no_go` and
  // `narrow`.
  // Each contact is in the middle of the longest part that is unusable for this reason; `part` is
  // the index of the part in Stands::unusable(). `fits` is the contact of a robot that fits, in the
  // middle of the longest usable interval. `misfits` and `fits` are empty if robots are points.
  struct Misfit {
    std::uint32_t part = 0;
    LiftingPoint contact;
  };
  std::vector<Misfit> misfits;
  std::optional<LiftingPoint> fits;
};
// The usable boundary. Robots must have a size, or there must be no-go edges. O(n + parts).
StandsDetail look_at_stands(const Trace& trace);

struct OppositeDetail {
  OppositeVertices vertices;
  Chord chord;                             // the chord between the two vertices
  std::optional<std::uint32_t> candidate;  // empty if the ratio is too low, or robots cannot stand
  bool stands = false;  // whether the candidate's chord is this one, not a pair's
};
// The detail of trace.opposite[index]. O(1).
OppositeDetail look_at_opposite(const Trace& trace, std::uint32_t index);

// How much one end of a candidate would widen H.
struct EndGain {
  bool outside = false;  // whether the end is outside H; otherwise its gain is 0
  Vec2 h1, h2;           // the edge of H in the direction from C to p
  Vec2 p;                // the end
  double value = 0;      // f(p)
};
// The key at which a candidate dropped out of a choice. For the choice as a whole, it is the key at
// which the last rival of the winner dropped out.
enum class DecidedBy : std::uint8_t { only_one, first_key, ratio, length, order };
struct Score {
  double value = 0;       // for a first team the length, or the ratio under Rule::most_even
  bool exact = true;      // if false, `value` is an upper bound that is too low to win
  bool taken = false;     // an earlier team has taken the candidate
  bool collides = false;  // one of its robots collides with a robot of an earlier team
  bool eligible = true;   // false for an uneven candidate under Rule::longest_even
  DecidedBy lost_by = DecidedBy::first_key;  // the key at which it dropped out, unless it won
  std::array<EndGain, 2> ends;               // of r1 and r2; not set for a first team
};
struct TeamScores {
  std::uint32_t team = 0;
  Rule rule = Rule::score;
  Points base;  // H before the choice
  std::vector<Score> of_candidate;
  // The candidates that a team can still take. The winner comes first; the others follow in reverse
  // order of dropping out.
  std::vector<std::uint32_t> ranking;
  DecidedBy decided_by = DecidedBy::only_one;
};

// A picture of a choice shows the numbers of at most this many candidates. More would hide it.
inline constexpr std::size_t most_ranked_numbered = 6;

// The best eligible candidates, up to `most_ranked_numbered`, the best first. O(K).
std::vector<std::uint32_t> best_ranked(const TeamScores& scores);

// The scores for the choice of this team. Call it only if by_candidates(). All scores are exact if
// the number of candidates times the number of vertices is at most exact_score_budget. Otherwise,
// only the scores that the selection itself evaluated are exact. O(K log K), plus the cost of the
// scores.
TeamScores look_at_scores(const Trace& trace, std::uint32_t team);
inline constexpr std::uint64_t exact_score_budget = 1u << 22;

// Balanced robots at a step.
struct BalancedDetail {
  std::vector<LiftingPoint> robots;
  std::vector<std::uint32_t> numbers;  // of the robots, from 0; in the step `pairs`, of their teams
  // In the steps `rest`, `mirror`, `completion`, `start` and `exchange`: how the set is completed.
  std::vector<LiftingPoint> rest;     // the robots that stay, and the one at a trial point
  std::optional<LiftingPoint> stand;  // the robot that came to a trial point
  Vec2 middle;                        // of the two other robots
  std::vector<Chord> chords;          // the even chords about the middle
  std::uint32_t chosen = 0;           // the index of the chord taken
  // In the step `exchange`: what changed since the preceding set.
  std::vector<std::uint32_t> moved;  // the numbers of the robots that moved, ascending
  std::vector<Vec2> ways;            // two points for each: the old and the new position
  BalancedKeys keys_before;
  std::optional<double> margin_before;
  // The keys and the margin of the set.
  BalancedKeys keys;
  std::optional<double> margin;
  // In the step `failure`: the robot that fails, and the loads of the others if all are equally
  // stiff. `robots` then holds only the others.
  std::optional<std::uint32_t> failed;
  std::vector<double> loads;
};

// The data that a step needs beyond the trace itself. The members for other steps are empty.
struct StepDetail {
  std::uint32_t number = 0;
  Step step;
  std::optional<PairDetail> pair;          // sections, outcome
  std::optional<OppositeDetail> opposite;  // opposite
  std::optional<RangeDetail> range;        // range
  std::optional<SwapDetail> swap;          // swap
  std::optional<StandsDetail> stands;      // stands
  std::optional<TeamScores> scores;        // scores, team, if by_candidates()
  // In the steps `scores`, `team` and `base`: H without and with the team. In the step `swap`: H
  // before and after the swap. With balanced robots, `base` is H of the step's robots, from the
  // step `completion` on. `base_before` is then H of the robots that stayed (in the step `start`),
  // of the preceding set (`exchange`) or of the search's result (`failure`, `pairs`).
  Points base_before, base;
  std::optional<BalancedDetail> balanced;  // from the first set of balanced robots on
  FreeRegion clockwise, counterclockwise;  // contacts, cut: the free regions left
  bool clockwise_before = true, counterclockwise_before = true;  // whether each existed before
};
// The detail of step k. Most steps cost O(1). The steps `scores` and `team` cost as much as
// look_at_scores(), `swap` as much as look_at_swap(), and `base` O(teams log teams). The steps
// `contacts` and `cut` cost O(n + c^2) at worst for c contacts so far. Each step of balanced robots
// costs up to one completion and the keys of two sets, and also single_failures() in the chapter
// `failures`.
StepDetail look_at(const Trace& trace, std::uint32_t k);

// The kind of a figure. Each comment gives the shape of a figure, its item and its value.
enum class FigureKind : std::uint8_t {
  object,       // the outline (area)
  triangle,     // of a vertex and an edge (area); value: its share of the object's area, negative
                // where the outline folds back
  centroid,     // point
  centre,       // point: C; in the step of an item of cargo, C with this item
  vertex,       // point; item: vertex
  radial_edge,  // segment; item: edge
  ray,          // segment from a vertex through C, long enough to leave the polygon; item: vertex
  chord,        // vertex-chord; item: index in rays.chords; value: ratio
  edge,         // segment: a whole edge; item: edge
  section,      // segment: the section of an edge in the pair; item: edge
  reflected,    // segment: edge b mirrored through C; item: edge b
  section_end,  // chord at an end of the section; item: 0 or 1; value: ratio
  bisecting,    // the chord that C bisects, on the lines of the edges, perhaps outside the sections
  chosen,       // chord that is taken or refused; item: candidate, or even chord; value: ratio
  candidate,    // chord; item: candidate; value: score, length or ratio
  team,         // chord; item: team; value: ratio
  robot,        // point; item: its number, team after team; value: load, once known
  gain_triangle,  // h1 h2 p (area); value: f(p)
  gain_part,    // the triangle's part in P (area); this part may touch itself along the triangle's
                // sides; value: f(p)
  gain_circle,  // 1 point, the centre; value: radius
  arm_before,   // segment from a vertex to H's edge; value: distance
  arm_after,    // segment from the vertex to H's new edge; value: distance
  base_before,  // area or segment
  base,         // area or segment
  contact,      // point; item: contact
  normal,       // segment: a long piece of a contact's normal line; item: contact
  clockwise,    // area, segment or point: free rotation centres
  counterclockwise,  // as for `clockwise`
  translation,       // segment from C in a free direction
  // Segment from a robot through C to another robot, or to the middle of two others. For an item of
  // cargo: from the centre of mass without the item, through the new centre of mass, to the item.
  lever,
  side,        // segment between two robots
  arm,         // segment from C to a robot; item: its number
  sum,         // chain of the arms end to end, each divided by the number of robots
  middle,      // point: where the middle of two more robots must be
  stand,       // point: the trial point to which one of three robots came
  mirrored,    // the polygon turned by half a turn about the middle (area)
  even_chord,  // chord about the middle; item: its number
  left,        // point that a robot left; item: the robot's number
  way,         // segment from the point that a robot left to its new place
  range,       // triangle of C and the part of an edge where robots may stand; item: edge
  range_end,   // chord at an end of the range; item: 0 or 1; value: ratio
  former,      // chord that a team left; item: candidate; value: ratio
  unusable,    // segment: a part of an edge; item: index in Stands::unusable()
  body,        // 1 point, the centre of a robot's body; value: radius; item: the unusable part
               // where the robot does not fit; no item if it fits
  hand,        // a robot's arm or hand, a segment or an area; item: as for `body`
  share,       // triangle of C and two of three robots; item: the third; value: its share of W
  level,       // segment on which springs carry the same load; value: this load
  sinks,       // segment from C in the direction in which the board sinks
  hole,        // outline of a hole (area); item: hole
  hole_part,   // triangle of a vertex and an edge of a hole; item: hole; value: its share of the
               // object's area as a negative number, positive where the hole folds back
  cargo,       // point: an item of cargo; item: its number; value: its weight
  old_centre,  // point: C before an item of cargo
};
inline constexpr std::uint32_t figure_kind_count = 52;
std::string_view name(FigureKind kind);

struct Figure {
  FigureKind kind = FigureKind::object;
  Points points;                      // 1: a point, 2: a segment, more: an area or chain
  std::optional<std::uint32_t> item;  // see FigureKind
  double value = 0;
};
// The figures of a step, from back to front. O(number of their points).
std::vector<Figure> figures(const Trace& trace, const StepDetail& detail);

// The chords of all rays in order of slope, each once, as indices in rays.chords. O(chords).
std::vector<std::uint32_t> chords_by_slope(const Trace& trace);

// The figures that the metric measures for a candidate: triangles clipped to P, circles, or arms.
// There are none for a first team, which is not chosen by its score. O(n).
std::vector<Figure> gain_figures(const Trace& trace, const TeamScores& scores,
                                 std::uint32_t candidate);

// The numbers of a step, with their names in JSON. O(1) for most steps; others are linear, or call
// coverage(), open_directions_rad(), robustness(), model_loads() or equilibrium().
struct Number {
  std::string_view name;
  double value;
};
std::vector<Number> numbers(const Trace& trace, const StepDetail& detail);

// The question about a choice that a learner could predict. Each comment gives the step, the
// question and the meaning of the answer.
enum class QuestionKind : std::uint8_t {
  nearer_end,     // outcome: which end is nearer to even? 0 or 1, an index in pair->ends
  winning_chord,  // scores: which candidate wins? an index in placement.candidates
  even_chord,     // `completion`, `exchange`: which chord do two robots take? an index in
                  // balanced->chords
  // For a swap that moves one team, the question is one of the next two: the first if there are
  // several teams and the swap's index is even, otherwise the second.
  leaving_team,      // which team moves? its number from 0
  coming_candidate,  // to which candidate? an index in placement.candidates
};
inline constexpr std::size_t question_kind_count =
    static_cast<std::size_t>(QuestionKind::coming_candidate) + 1;

struct Question {
  QuestionKind kind = QuestionKind::nearer_end;
  std::uint32_t answer = 0;
};
// The question to ask before step detail.number is shown, with the correct answer; empty if the
// step is not a choice. Costs as much as is_choice().
std::optional<Question> question(const Trace& trace, const StepDetail& detail);
// The possible answers, ascending. For `coming_candidate`, these are the candidates that no team
// has taken and at which robots with a size would not collide. O(K (teams + log K)); if robots have
// a size, O(K teams^2).
std::vector<std::uint32_t> choices(const Trace& trace, const StepDetail& detail,
                                   const Question& question);
// The chord of a possible answer; for `leaving_team`, the chord that this team would leave. O(1).
const Chord& chord_of_choice(const Trace& trace, const StepDetail& detail, const Question& question,
                             std::uint32_t choice);

// Whether step k is a choice; the caller does not need the step's detail. O(1); for balanced
// robots, the cost of look_at().
bool is_choice(const Trace& trace, std::uint32_t k);

}  // namespace evenlift
