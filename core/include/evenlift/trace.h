// The lesson's data: random access to the steps of the algorithm.
//
// A trace belongs to one placement. It holds what the stages found on the way (chords from
// vertices, edge-pairs and what became of each, contacts) and a short table of blocks of similar
// steps, from which step(k) is found in O(1). Playing the steps accumulates nothing:
// progress_at(trace, k) says how much of the trace's and the placement's arrays is known after step
// k, and look_at() computes what only one step needs (every candidate's score, the regions that a
// few contacts leave) with the stages' own functions.
//
// A program that shows a lesson keeps the placement, its trace and the detail of the current step:
//
//   const Result<Trace> trace = make_trace(placement);
//   const StepDetail detail = look_at(*trace, k);    // once for each change of k
//   figures(*trace, detail)                          // what the step is about, to draw and hover
//   progress_at(*trace, k)                           // what to draw in the background
//   question(*trace, detail)                         // if the learner could guess it
//   why_not(*trace, k, candidate)                    // why_not.h
// and the words in output/trace_words.h.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "evenlift/balanced_history.h"
#include "evenlift/exchange.h"
#include "evenlift/failures.h"
#include "evenlift/placement.h"
#include "evenlift/polygon.h"
#include "evenlift/selection.h"
#include "evenlift/stands.h"

namespace evenlift {

// The chapters in the thesis's order.
enum class Chapter : std::uint8_t {
  object,         // the polygon and its centre of mass
  law,            // balanced: from the law of the lever to the law of the centroid
  vertex_chords,  // from each vertex through C
  slopes,         // their order
  pairs,          // edges that face each other, opposite vertices, and the candidates of both
  candidates,     // the list
  first_team,
  further_teams,
  start,     // balanced: a first set
  exchange,  // balanced: three robots move at a time
  swaps,     // teams of two that are to hold are exchanged
  loads,
  failures,  // balanced: if a robot fails
  grasp,     // coverage and immobilization
};
inline constexpr std::uint32_t chapter_count = 14;

// What a step is about. The `item` of a step counts from 0 among the steps of its kind. The
// comments say what it numbers; "1" means that there is only one such step.
enum class StepKind : std::uint8_t {
  polygon,       // 1
  centroid,      // 1: how it is found
  centre,        // 1: the centre of mass in force: the centroid, or moved
  radial,        // 1: edges whose line passes through C; only where there are some
  ray,           // rays: what is hit on the ray from a vertex through C
  slopes,        // 1: the chords in order of slope
  sections,      // pairs: two edges and their parts that face each other
  outcome,       // pairs: the bisecting chord or the nearer end, accepted or not
  opposite,      // opposite: two vertices straight across C, their chord accepted or not
  duplicates,    // 1: chords that were found more than once
  candidates,    // 1: the list
  directions,    // 1, distributed: the directions that have places on both sides
  scores,        // teams: every candidate's score and rank, by area, circle or distance
  team,          // teams: the one that is taken
  base,          // teams: H grows
  fewer,         // 1: no place for as many teams as were asked for, or for any
  share,         // teams: the law of the lever
  loads,         // 1: all robots
  coverage,      // 1
  contacts,      // 1: where the robots touch edges
  cut,           // contacts: its normal line cuts the two regions
  slide,         // 1: is a translation free?
  closure,       // 1: form closure, margin
  second_order,  // 1: only where form closure does not hold
  result,        // 1: all that place() reports
  // Balanced robots:
  lever,       // 1: two of them, C in the middle
  three,       // 1: three of them, and the law of the lever twice
  many,        // 1, from four robots on: all of them, and the law of the centroid
  rest,        // 1: some robots, and where the middle of two more must be
  mirror,      // 1: the outline turned about that point, and the even chords through it
  completion,  // 1: the chord that makes the best set
  start,       // sets of the start: the robots that stayed, and those that came
  exchange,    // exchanges: three robots leave, three come, and the set is better
  round,       // rounds that changed something: their end
  settled,     // 1: no three robots can move to make it better
  failure,     // robots, of 3 to most_failing: it fails
  failures,    // 1: how many may fail at once
  pairs,       // 1, of an even number: as many robots in pairs on the same object
  // Teams anywhere in their ranges, and teams that are to hold:
  range,  // ranges: the places of an edge-pair that are even enough, and the two candidates there
  swap,   // exchanges of teams: who went where, and why that is better
  held,   // 1: no exchange makes them better
  // Robots with a size, or edges that they must not touch:
  stands,  // 1, after the centre of mass: which boundary they can use, and why not the rest
};
inline constexpr std::uint32_t step_kind_count = 42;
inline constexpr std::uint32_t most_failing = 16;

// "pairs", "first_team"; "outcome", "second_order": as in JSON, lessons and links. O(1).
std::string_view name(Chapter chapter);
std::string_view name(StepKind kind);
std::optional<StepKind> step_kind_from_name(std::string_view text);

struct Step {
  StepKind kind = StepKind::polygon;
  Chapter chapter = Chapter::object;
  std::uint32_t item = 0;
  bool operator==(const Step&) const = default;
};

// Longer traces are refused: nobody would watch them, and a browser could not hold them.
inline constexpr std::uint32_t max_trace_steps = 1u << 20;

struct Trace {
  Placement placement;
  Polygon polygon;
  Vec2 centre = Vec2::Zero();  // the placement's centre of mass
  Units units;                 // for captions; they change no number

  // Chapter 2. The chords of ray i are chords[begins[i] .. begins[i + 1]). Those that were already
  // listed at an earlier ray come first; their `vertex` is their other end.
  struct Rays {
    std::vector<std::uint32_t> vertices;  // in the order found
    std::vector<std::uint32_t> begins;    // one more
    std::vector<VertexChord> chords;
  } rays;
  std::vector<std::uint32_t> radial_edges;

  // Chapter 4, area, circle and distance only.
  std::vector<EdgePair> pairs;
  std::vector<OppositeVertices> opposite;
  // Candidates come from sources: source i is pair i, or opposite vertices i - pairs.size(). For
  // each source this is the candidate that it led to, or no_index.
  std::vector<std::uint32_t> candidate_of_source;
  // For each candidate the source whose chord was kept, and the first source that led to it.
  std::vector<std::uint32_t> source_of_candidate, first_source_of_candidate;
  // With positions anywhere in the range: the pairs that add range candidates, and for each of them
  // what its two became.
  std::vector<std::uint32_t> ranges;
  std::vector<std::array<std::uint32_t, 2>> candidates_of_range;

  // Teams that are to hold: what was exchanged; and the teams at the start, and after each
  // exchange.
  std::optional<ExchangeHistory> exchanges;
  std::vector<std::vector<Team>> stages;

  std::vector<Contact> contacts;

  // Balanced robots only: what the search did.
  std::optional<BalancedProblem> problem;
  BalancedHistory history;
  // The robots' numbers from 0 in the last set of the start, and after each exchange. A robot keeps
  // its number from exchange to exchange; in the last set they are in their order along the
  // outline.
  std::vector<std::vector<std::uint32_t>> robot_numbers;
  std::optional<Placement> in_pairs;  // as many robots by area, if there are as many

  // If somebody moved robots by hand, the placement as it was given. The steps are those of the
  // method, and `placement` is what they come to; only the last step tells of both.
  std::optional<Placement> moved;

  // A run of similar steps. Item i of it is the `kinds` steps from first + i * kinds on, one of
  // each kind in the order of `kind`.
  struct Block {
    std::uint32_t first = 0, items = 0, first_item = 0, kinds = 1;
    std::array<StepKind, 3> kind{};
    Chapter chapter = Chapter::object;
  };
  std::vector<Block> blocks;

  // Number of steps, at least 5. O(1).
  std::uint32_t size() const;
  // Step k < size(). O(1).
  Step step(std::uint32_t k) const;
  // Number of steps of a kind that a trace has: its items are 0 .. count - 1. O(1).
  std::uint32_t count(StepKind kind) const;
  // The number of a step; nothing if the trace has no such step. O(1).
  std::optional<std::uint32_t> find(StepKind kind, std::uint32_t item) const;
  // The first step of a chapter; nothing if this trace has no such chapter. O(1).
  std::optional<std::uint32_t> chapter_begin(Chapter chapter) const;
  // Whether teams are chosen among candidates: area, circle or distance. O(1).
  bool by_candidates() const;
  // By what they are chosen, in traces by_candidates() only. O(1).
  Metric metric() const;
  // The candidates that the metric selects, and the teams there: before any exchange. O(1).
  const std::vector<std::uint32_t>& selected() const {
    return exchanges ? exchanges->start : placement.team_candidates;
  }
  const std::vector<Team>& selected_teams() const {
    return stages.empty() ? placement.teams : stages.front();
  }
  // Whether the robots are balanced. O(1).
  bool balanced() const { return problem.has_value(); }
};

// Whether C lies outside of the polygon. Its boundary counts as inside. Exact. O(n).
bool centre_is_outside(const Trace& trace);

// The trace of a placement that place() returned. An error if it would have more than
// max_trace_steps steps. Costs as much as place() without the selection: O(n log n + K log K) for K
// edge-pairs and opposite vertices. With balanced robots it costs as much as their search. It is an
// error if that is not quick to finish, and the trace's placement is what the search came to,
// wherever the given robots stand. So it is with teams that were moved by hand. With
// HistoryLength::start only its start is traced, if that is quick, so that the trace can follow a
// drag.
Result<Trace> make_trace(const Placement& placement, HistoryLength length = HistoryLength::whole,
                         const Units& units = {});

// The step of `trace` that is nearest to a step of another trace, from before an edit: the step
// with the same kind and item, else the last of that kind, else the beginning of its chapter or of
// the next chapter that exists. O(1).
std::uint32_t nearest_step(const Trace& trace, const Step& step);

// What is known after step k, as counts from the beginning of the trace's and placement's arrays.
struct Progress {
  std::uint32_t rays = 0;
  bool slopes = false;
  std::uint32_t sections = 0;    // pairs shown
  std::uint32_t sources = 0;     // pairs and, after all of these, opposite vertices decided
  bool merged = false;           // from here on the placement's own candidates
  std::uint32_t teams = 0;       // teams taken
  std::uint32_t base_teams = 0;  // teams whose robots H is the hull of
  std::uint32_t shares = 0;      // teams whose loads are known
  bool coverage = false;
  std::uint32_t swaps = 0;  // exchanges of teams that were made
  std::uint32_t cuts = 0;   // contacts whose normal lines have cut the regions
  bool closure = false;     // all that place() reports
  bool stands = false;      // which boundary robots with a size can use
  bool operator==(const Progress&) const = default;
};
// Depends on k alone. Candidate c is known if `merged`, or else if first_source_of_candidate[c] <
// `sources`. O(1).
Progress progress_at(const Trace& trace, std::uint32_t k);

// The teams as they are after the exchanges that are known; the first `known.teams` of them are
// taken. O(1).
const std::vector<Team>& teams_at(const Trace& trace, const Progress& known);

// The lifting base H of the first `teams` teams that the metric selects. O(teams log teams).
Points lifting_base(const Trace& trace, std::uint32_t teams);

// The lifting base H of the first `known.base_teams` of teams_at(). O(teams log teams).
Points lifting_base(const Trace& trace, const Progress& known);

// What became of an edge-pair.
enum class Outcome : std::uint8_t {
  bisecting,     // C bisects a chord between the sections, which is the candidate
  nearer_end,    // C bisects none; the end with the larger ratio is the candidate
  too_uneven,    // C bisects none, and even the better end is below the minimum ratio
  midpoint,      // the edges are parallel; the chord between the middles is the candidate
  parallel_low,  // the edges are parallel, and their ratio is below the minimum
};
std::string_view name(Outcome outcome);

// Whether robots with a size can stand on a pair's best chord, on another one of the pair, or on
// none.
enum class Standing : std::uint8_t { there, elsewhere, nowhere };

struct PairDetail {
  EdgePair pair;
  PairVerdict verdict;
  Outcome outcome = Outcome::bisecting;
  // The section of edge a goes from a[0] to a[1], that of edge b from b[0] to b[1]. The chord
  // ends[i] connects a[i] and b[i].
  std::array<Vec2, 2> a{Vec2::Zero(), Vec2::Zero()}, b{Vec2::Zero(), Vec2::Zero()};
  std::array<Chord, 2> ends;
  // Edge b reflected through C, and where its line meets the line of a: an end of the chord that C
  // bisects, perhaps far outside. Nothing if the edges are parallel.
  std::array<Vec2, 2> reflected{Vec2::Zero(), Vec2::Zero()};
  std::optional<Vec2> meeting;
  std::uint32_t nearer = 0;  // the end of larger ratio: 0 or 1
  Chord chosen;              // the candidate, or what was tried and had too low a ratio
  std::optional<std::uint32_t> candidate;  // into placement.candidates
  bool stands = false;               // the candidate's chord is this pair's, not a duplicate's
  std::optional<Standing> standing;  // of robots with a size; `chosen` is then what they came to
};
// O(1).
PairDetail look_at_pair(const Trace& trace, std::uint32_t index);

// A range, and the candidates in it.
struct RangeDetail {
  EdgePair pair;
  PairRange range;
  // The most uneven that are allowed, or the section's; of robots with a size the first and the
  // last in the longest part of the range where they can stand.
  std::array<Chord, 2> ends;
  // Into placement.candidates. Of robots with a size the second may be no_index: the two of a team
  // would collide there.
  std::array<std::uint32_t, 2> candidates{};
};
// Of trace.ranges[index]. O(1).
RangeDetail look_at_range(const Trace& trace, std::uint32_t index);

// What an exchange of teams changed.
struct SwapDetail {
  HoldKeys before, after;
  std::optional<double> margin_before, margin;
  std::vector<std::uint32_t> teams;     // that went elsewhere
  std::vector<std::uint32_t> from, to;  // their candidates
  ExchangeKind kind = ExchangeKind::single;
  HoldKey decided_by = HoldKey::level;
};
// Of trace.exchanges. O(n log n).
SwapDetail look_at_swap(const Trace& trace, std::uint32_t index);

// What robots with a size leave of the boundary.
struct StandsDetail {
  double boundary = 0;                            // its length
  double usable = 0;                              // of that, where somebody can stand
  std::array<double, why_unusable_count> lost{};  // the rest by its reason
  // Contacts of robots that do not fit: for each reason but marks in the middle of its longest
  // part, which is an index into the unusable ones of the stands. And of one that does, in the
  // longest stretch. None where robots are points.
  struct Misfit {
    std::uint32_t part = 0;
    LiftingPoint contact;
  };
  std::vector<Misfit> misfits;
  std::optional<LiftingPoint> fits;
};
// Of traces of robots with a size, or with marked edges. O(n + parts).
StandsDetail look_at_stands(const Trace& trace);

// What became of two opposite vertices.
struct OppositeDetail {
  OppositeVertices vertices;
  Chord chord;                             // between them
  std::optional<std::uint32_t> candidate;  // none if its load ratio is below the minimum
  bool stands = false;                     // the candidate's chord is this one, not a pair's
};
// Of trace.opposite[index]. O(1).
OppositeDetail look_at_opposite(const Trace& trace, std::uint32_t index);

// How much one end of a candidate would widen H.
struct EndGain {
  bool outside = false;                       // of H; if not, it gains nothing
  Vec2 h1 = Vec2::Zero(), h2 = Vec2::Zero();  // the edge of H that C sees it beyond
  Vec2 p = Vec2::Zero();                      // the end
  double value = 0;                           // f(p)
};
// The key at which a candidate dropped out. For the choice as a whole: the key that told the winner
// from the last of the others.
enum class DecidedBy : std::uint8_t { only_one, first_key, ratio, length, order };
struct Score {
  double value = 0;    // of a further team; of a first one its length (or ratio, with `most_even`)
  bool exact = true;   // else an upper bound, found to be too low to win
  bool taken = false;  // by an earlier team
  bool collides = false;                     // one of its robots with one of an earlier team
  bool eligible = true;                      // first team, with even candidates: only these
  DecidedBy lost_by = DecidedBy::first_key;  // unless it won
  std::array<EndGain, 2> ends;               // of r1 and r2; of a first team empty
};
struct TeamScores {
  std::uint32_t team = 0;
  Rule rule = Rule::score;
  Points base;  // H before
  std::vector<Score> of_candidate;
  // The candidates that are not taken yet: the winner, then the others; what dropped out last comes
  // first.
  std::vector<std::uint32_t> ranking;
  DecidedBy decided_by = DecidedBy::only_one;
};

// So many candidates have their numbers in pictures of a choice; more would hide it.
inline constexpr std::size_t most_ranked_numbered = 6;

// The candidates that a picture numbers: the best that were eligible, at most most_ranked_numbered.
// O(K).
std::vector<std::uint32_t> best_ranked(const TeamScores& scores);

// The scores for the choice of team `team`, in traces by_candidates() only. Every score is exact if
// candidates times vertices are at most exact_score_budget; beyond that, only the scores that the
// selection itself evaluated are. O(K log K) plus the cost of the scores.
TeamScores look_at_scores(const Trace& trace, std::uint32_t team);
inline constexpr std::uint64_t exact_score_budget = 1u << 22;

// What balanced robots do at a step.
struct BalancedDetail {
  std::vector<LiftingPoint> robots;    // that stand there
  std::vector<std::uint32_t> numbers;  // theirs, from 0
  // rest, mirror, completion, start, exchange: what completes the set
  std::vector<LiftingPoint> rest;     // the robots that stay, and the one that came to a stand
  std::optional<LiftingPoint> stand;  // that one
  Vec2 middle = Vec2::Zero();         // of the two others
  std::vector<Chord> chords;          // the even ones about the middle
  std::uint32_t chosen = 0;           // of these
  // exchange: against the set before
  std::vector<std::uint32_t> moved;  // the numbers of the robots that moved, increasing
  std::vector<Vec2> ways;            // of each from where and to where: twice as many
  BalancedKeys keys_before;
  std::optional<double> margin_before;
  // start, exchange
  BalancedKeys keys;
  std::optional<double> margin;
  // failure, failures: what is left if each of the robots fails; nothing where it falls
  std::vector<std::optional<RestOfRobots>> rest_of;
  std::optional<std::uint32_t> failed;  // failure: which robot does; the others are `robots`
  std::vector<double> loads;            // failure: theirs, if they are equally stiff
};

// What a step shows beyond the trace itself. Members that the step is not about are empty.
struct StepDetail {
  std::uint32_t number = 0;
  Step step;
  std::optional<PairDetail> pair;          // sections, outcome
  std::optional<OppositeDetail> opposite;  // opposite
  std::optional<RangeDetail> range;        // range
  std::optional<SwapDetail> swap;          // swap
  std::optional<StandsDetail> stands;      // stands
  std::optional<TeamScores> scores;        // scores, team: by candidates
  // scores, team, base: H without and with the team. start, exchange and all that follows: H of the
  // set before, and of the step's own.
  Points base_before, base;
  std::optional<BalancedDetail> balanced;  // balanced robots, from the first of them on
  FreeRegion clockwise, counterclockwise;  // contacts, cut: what is left after the step
  bool clockwise_before = true, counterclockwise_before = true;  // whether a region was left before
};
// O(1), except: `scores` and `team` cost as much as look_at_scores; `base` O(teams log teams);
// `contacts` and `cut` O(n + c^2) at worst for c contacts so far; `swap` as look_at_swap; steps of
// balanced robots a completion and the keys of a set.
StepDetail look_at(const Trace& trace, std::uint32_t k);

// What a figure means. The comment says its shape, and what its item and value are.
enum class FigureKind : std::uint8_t {
  object,       // the polygon (area)
  triangle,     // a vertex and an edge; value: its share of the area, negative where it folds back
  centroid,     // point
  centre,       // point: C
  vertex,       // point; item: vertex
  radial_edge,  // segment; item: edge
  ray,          // from the vertex to C or the farthest hit
  chord,        // vertex-chord; item: into rays.chords; value: ratio
  edge,         // a whole edge of the pair; item: edge
  section,      // its part in the pair; item: edge
  reflected,    // edge b mirrored through C
  section_end,  // chord at an end of the sections; item: 0 or 1; value: ratio
  bisecting,    // the chord that C bisects, of the lines, perhaps outside of the sections
  chosen,       // the pair's candidate, or the chord that was refused; value: ratio
  candidate,    // chord; item: candidate; value: score, length or ratio
  team,         // chord; item: team; value: ratio
  robot,        // point; item: its number, team after team; value: load, once known
  gain_triangle,  // h1 h2 p; value: f(p)
  gain_part,      // what of it is in P: a chain that may touch itself along the triangle's sides
  gain_circle,    // 1 point, the middle; value: radius
  arm_before,     // from a vertex to H's edge; item: vertex; value: distance
  arm_after,      // to the new edge
  base_before,    // area or segment
  base,
  contact,    // point; item: contact
  normal,     // the inward normal line through a contact, long; item: contact
  clockwise,  // area, segment or point of free rotation centres
  counterclockwise,
  translation,  // from C, a free direction
  lever,        // from a robot through C to another, or to the middle of two others
  side,         // between two robots
  arm,          // from C to a robot; item: its number
  sum,          // the arms laid end to end, each as short as its part of the weight
  middle,       // point: where the middle of two more robots must be
  stand,        // point: where one of three robots came to
  mirrored,     // the polygon turned by half a turn about the middle (area)
  even_chord,   // about the middle; item: its number
  left,         // point: where a robot stood before; item: its number then
  way,          // from there to where one came
  range,        // C and a stretch of an edge where robots may stand (area); item: edge
  range_end,    // chord at an end of a range; item: 0 or 1; value: ratio
  former,       // chord that a team left; item: candidate; value: ratio
  unusable,     // a part of an edge; item: into the unusable ones of the stands
  body,  // 1 point, the middle of a robot's body; item: the unusable part where it does not fit,
         // none of one that fits; value: radius
  hand,  // a robot's arm or hand, a segment or an area; item: likewise
};
inline constexpr std::uint32_t figure_kind_count = 45;
std::string_view name(FigureKind kind);

struct Figure {
  FigureKind kind = FigureKind::object;
  Points points;                      // 1: a point, 2: a segment, more: an area
  std::optional<std::uint32_t> item;  // what FigureKind says
  double value = 0;
};
// The figures of a step, back to front. O(number of points in them).
std::vector<Figure> figures(const Trace& trace, const StepDetail& detail);

// The chords of all rays in order of slope, each once: indices into rays.chords. O(their number).
std::vector<std::uint32_t> chords_by_slope(const Trace& trace);

// What the metric measures for a candidate: triangles clipped to P, circles, or arms. `scores` are
// those of a further team, not of the first. O(n).
std::vector<Figure> gain_figures(const Trace& trace, const TeamScores& scores,
                                 std::uint32_t candidate);

// The numbers of a step under the names that JSON gives them. O(1).
struct Number {
  std::string_view name;
  double value;
};
std::vector<Number> numbers(const Trace& trace, const StepDetail& detail);

// A choice that a learner could predict, made in this step. The answer is the correct one.
enum class QuestionKind : std::uint8_t {
  nearer_end,     // outcome: which end is nearer to even? 0 or 1, of pair->ends
  winning_chord,  // scores: which candidate wins? an index of placement.candidates
  even_chord,     // completion, exchange: which chord do two robots take? of balanced->chords
  // swap of one team, by turns:
  leaving_team,      // which team goes elsewhere? its number from 0
  coming_candidate,  // to which candidate? an index of placement.candidates
};
inline constexpr std::size_t question_kind_count =
    static_cast<std::size_t>(QuestionKind::coming_candidate) + 1;

struct Question {
  QuestionKind kind = QuestionKind::nearer_end;
  std::uint32_t answer = 0;
};
// The question to ask before step detail.number is shown. Nothing if the step is not a choice.
// O(1).
std::optional<Question> question(const Trace& trace, const StepDetail& detail);
// The answers that can be given, increasing. Of coming_candidate these are the candidates that no
// team has, and at which robots with a size would have room. O(K teams).
std::vector<std::uint32_t> choices(const Trace& trace, const StepDetail& detail,
                                   const Question& question);
// The chord that a choice of a question stands for: of a team the one that it may leave. O(1).
const Chord& chord_of_choice(const Trace& trace, const StepDetail& detail, const Question& question,
                             std::uint32_t choice);

// Whether step k is a choice, without its detail. O(1), with balanced robots a completion.
bool is_choice(const Trace& trace, std::uint32_t k);

}  // namespace evenlift
