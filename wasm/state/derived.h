// Opened documents, and the derived part of the state.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "evenlift/capacity.h"
#include "evenlift/placement.h"
#include "evenlift/report.h"
#include "evenlift/task.h"
#include "evenlift/trace.h"
#include "state/view_state.h"
#include "state/work.h"

namespace evenlift::view {

// --- Opens documents. Opening a document also computes its placement, because that validates the
// document. Callers pass the placement on (Given), so that nothing is computed twice.

struct Opened {
  Document document;
  Placement placement;
  std::optional<Trace> trace;  // the placement's trace, if a check needed it
  bool left_robots = false;    // the robots placed by hand stay with the former object
};

// Opens the document, or returns why it is refused. Costs as much as place().
Result<Opened> opened(Document document);

// The polygon with the settings and `shown` of another document, except those that belong to its
// edges and lengths: the step, the shown lengths and the no-go edges.
Document with_settings_of(Document polygon, const Document& before);

// Opens another polygon with_settings_of() the present document. Robots placed by hand belong to the
// present polygon: the method is then the one before, with as many robots.
Result<Opened> opened_after(Document polygon, const Work& work);

// read_link() reads and opens a document from a link, and read_document() from a link or a
// polygon's text. Both return the first error.
Result<Opened> read_link(std::string_view link);
Result<Opened> read_document(std::string_view text);

// Reads a document from a link or a polygon's text, without computing its placement.
Result<Document> parse_document(std::string_view text);

// How urgently a placement is needed. With the goal *hold*, swaps among all candidates improve the
// teams, but can take seconds. If the swaps would take too long, the teams stay as the metric
// selects them, and the placement's `search_ended` is false. The limit is about a twentieth of a
// second during a drag, and a few seconds at rest.
enum class Haste : std::uint8_t { at_rest, drag };

// The view computes placements and traces only here. These functions count their calls, so that a
// test can check that an action computes one placement, or none if it changes only the picture. A
// placement `before` of the same object saves checking the object. Of a search for balanced robots,
// this computes only the start (derive/derive.h); compute_trace() may complete it.
Result<Placement> compute_placement(const Document& document,
                                    const std::optional<Placement>& before = std::nullopt,
                                    Haste haste = Haste::at_rest);

// Computes the placement with a worker's choice of teams (place_as_chosen()), without swaps.
Result<Placement> compute_as_chosen(const Document& document, const Placement& before,
                                    Choice choice);

// Computes a placement for an offer (derive/derive.h) with Haste::drag, and counts it in `tries`.
Result<Placement> try_placement(const Document& document, const Placement& before);

// Returns whether the teams have the goal *hold*, and teams and candidates are few enough for swaps
// in a drag. O(1).
bool swaps_in_a_drag(const Placement& placement);

// Returns whether the teams should be swapped until they hold, but are still as the metric selects
// them. O(1).
bool waits_for_swap(const Placement& placement);

// Computes the placement's trace. Costs as much as make_trace().
Result<Trace> compute_trace(const Placement& placement, const Units& units,
                            HistoryLength length = HistoryLength::whole);

// Computes and counts a plan. Costs as much as plan_capacity().
CapacityPlan compute_plan(const Placement& placement, double capacity);

struct Computed {
  std::uint64_t placements = 0, tries = 0, traces = 0, plans = 0;
};
Computed computed();  // the numbers since the start

// --- The derived part of the state: everything that follows from the work, the view and the session.
// Only derive() (derive/derive.h) writes it.

// A failed robot, and the placement after its failure. Robots are counted from 0, team after team.
struct Failure {
  std::size_t robot = 0;
  std::optional<RestOfRobots> rest;  // nothing if the others do not carry the object
  Placement placement;               // with_failure() of placed_robots.h
  Report report;                     // report_of_failure() of report.h
};

// The background search that improves the balanced robots on the screen. If a capacity is given, a
// further search then counts the robots needed if any one robot may fail.
struct Search {
  std::uint64_t number = 0;  // of the last search; results of earlier searches are dropped
  bool due = false;          // a search should begin, if the robots on the screen need one
  bool under_way = false;
  bool counting = false;  // the search that counts the robots is under way
};

// During a drag of a large object, a worker chooses the object's teams (derive/derive.h). The
// worker takes one document at a time, always the newest, and skips the documents in between.
struct Elsewhere {
  std::uint64_t number = 0;  // of the last document for the worker
  bool under_way = false;
  bool possible = true;     // false once the worker failed during a drag
  Document document;        // the document that the worker has now
  std::uint64_t edits = 0;  // Work::edits() of this document
};

// Settings that would improve a placement whose verdict is not good, and the label of the button
// that applies them.
struct Offer {
  Settings settings;
  std::string label;
  std::optional<Shown> shown = {};  // instead of the settings: other conditions
};

// The inputs of the last derive(). Results are out of date if the present inputs differ.
struct Basis {
  std::uint64_t edits = 0;  // Work::edits() of the placed or refused document
  Haste haste = Haste::at_rest;
  std::optional<Method> second_method;
  LoadModel load_model = LoadModel::plan;
  Shown shown;
  bool challenge = false;
  std::uint64_t fails = 0, card = 0;  // numbers of the last requests (view_state.h)
};

struct Derived {
  std::optional<InputError> refusal;   // why the document is refused
  std::optional<Placement> placement;  // of the last document not refused
  Document placed;                     // that document; last_good() adds the present Shown
  std::optional<Placement> second;     // of the same document by the second method
  std::shared_ptr<const Trace> trace;  // of the placement, while a step is shown
  std::uint64_t traces = 0;            // the number of traces made so far
  std::string untraced;                // why the requested trace is missing

  // Summaries of the above.
  std::optional<double> best_ratio;  // the best load ratio of any chord, if none meets the minimum
  std::optional<Offer> offer;        // if the verdict is not good; nothing during a drag
  bool offer_due = true;             // the offer may have changed
  std::optional<CapacityPlan> plan;  // robots needed for the capacity; not updated in a drag
  std::optional<FailurePlan> spare;  // the robots needed if any one robot may fail; for balanced
                                     // robots, a search finds it later (derive/derive.h)
  bool plan_due = false;             // `plan` or `spare` may have changed
  // Of the first and the second placement, by the shown load model. The first has the effects of
  // failures and plans as soon as they are known.
  Report report, second_report;
  bool failures_due = true;                // report.failures must be computed
  std::optional<Failure> failure;          // the simulated failure of a robot
  std::optional<Attempt> attempt;          // at the open task, of the placement
  std::optional<Explanation> explanation;  // the card about a robot, chord or candidate
  Search search;
  Elsewhere elsewhere;

  std::uint64_t revision = 0;  // grows with every change to the pictures
  Basis basis;
};

// Values that commands pass to derive(): what a command has already computed, and results from
// outside the view. derive() empties this struct.
struct Given {
  std::optional<Placement> placement;  // of the document
  std::optional<Trace> trace;          // of that placement
  // Set if the user moves a robot by hand and changes nothing else: the robot's number before and
  // after the move.
  struct Moved {
    std::size_t robot, now;
  };
  std::optional<Moved> moved;
  // The result of the search with this number. `robots` is a text with robots or a count
  // (robots_text.h), and absent if the search cannot continue.
  struct Found {
    std::uint64_t number;
    std::optional<std::string> robots;
    bool ended;
    bool cut_short = false;  // whether it ended by a limit of work
  };
  std::optional<Found> found;
  // The worker's choice for the document with this number (derive/derive.h). The choice is empty
  // if the document is refused, and absent if the worker failed.
  struct Chosen {
    std::uint64_t number;
    std::optional<std::vector<double>> choice;
  };
  std::optional<Chosen> chosen;
  bool at_once = false;  // place the document now, even if a worker is choosing its teams
};

}  // namespace evenlift::view
