// Everything that follows from the document and the view. Only derive() (derive/derive.h) writes
// it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "evenlift/capacity.h"
#include "evenlift/extra_load.h"
#include "evenlift/placed_robots.h"
#include "evenlift/placement.h"
#include "evenlift/trace.h"
#include "state/explanation.h"
#include "state/opened.h"

namespace evenlift::view {

// A placement's loads as shown, and its robustness. Robots are counted from 0, team after team.
struct Outlook {
  std::vector<LoadRange> loads;  // of each robot, by `model`
  LoadModel model = LoadModel::plan;
  double greatest = 0;    // of these loads
  Robustness robustness;  // see placed_robots.h
  std::optional<ModelLoads>
      models;  // only if the shown model is not the plan, or there is a disturbance
  std::optional<ExtraLoad> extra;  // where a further load may stand, if asked
};

// A failed robot, and the placement without it.
struct Failure {
  std::size_t robot = 0;
  std::optional<RestOfRobots> rest;  // nothing if the others do not carry the object
  Placement placement;               // with_failure() of placed_robots.h
  Outlook outlook;                   // of the others
};

// Improves the balanced robots on the screen, in the background. Afterwards it counts the robots
// needed if any one may fail.
struct Search {
  std::uint64_t number = 0;  // of the last search; earlier results are dropped
  bool due = false;          // the robots on the screen are the start of a search
  bool under_way = false;
  bool counting = false;
};

// During a drag of a large object, a worker chooses its teams, one document after another, and
// skips documents that are overtaken meanwhile (derive/elsewhere.h).
struct Elsewhere {
  std::uint64_t number = 0;  // of the last document for the worker
  bool under_way = false;
  bool possible = true;     // false once the worker failed during a drag
  Document document;        // under way
  std::uint64_t edits = 0;  // Work::edits() of it
};

// Other settings that would mend what is amiss, and the words of their button.
struct Offer {
  Settings settings;
  std::string label;
};

// The inputs of the last derive(), which show what is out of date.
struct Basis {
  std::uint64_t edits = 0;  // Work::edits() of the placed or refused document
  Haste haste = Haste::at_rest;
  std::optional<Method> second_method;
  LoadModel load_model = LoadModel::plan;
  Shown shown;
  bool challenge = false;
  std::uint64_t fails = 0, card = 0;  // the last ones requested (view_state.h)
};

struct Derived {
  std::optional<InputError> refusal;   // why the document is refused
  std::optional<Placement> placement;  // of the last document not refused
  Document placed;                     // that document; last_good() adds what is shown
  std::optional<Placement> second;     // of the same document by the second method
  std::shared_ptr<const Trace> trace;  // of the placement, while a step is shown
  std::uint64_t traces = 0;            // made so far
  std::string untraced;                // why the requested trace is missing

  // Summaries of the above.
  std::optional<double> best_ratio;  // of any chord, if none has the minimum
  std::optional<Offer> offer;        // if the placement is not good; none during a drag
  bool offer_due = true;             // it may have changed
  std::optional<CapacityPlan> plan;  // for the capacity; not updated during a drag
  std::optional<FailurePlan> spare;  // if any robot may fail; for balanced robots it comes later:
                                     // each number needs a search (search.h)
  bool plan_due = false;             // it may have changed
  Outlook outlook, second_outlook;   // of the placement and of the second one
  std::vector<std::optional<RestOfRobots>> failures;  // by the failing robot; empty while unknown
  bool failures_due = true;                           // they must be computed
  std::optional<Failure> failure;                     // the robot that the user let fail
  std::optional<Explanation> explanation;             // the card beside a robot or chord
  Search search;
  Elsewhere elsewhere;

  std::uint64_t revision = 0;  // grows with every change to the pictures
  Basis basis;
};

// Values that commands pass to derive(), which empties it: results of a check, and results from
// outside the view.
struct Given {
  std::optional<Placement> placement;  // of the document
  std::optional<Trace> trace;          // of that placement
  // If only robots moved by hand differ: the held robot's number before and after.
  struct Moved {
    std::size_t robot, now;
  };
  std::optional<Moved> moved;
  // Robots or a count from the search with this number; nothing if it cannot continue.
  struct Found {
    std::uint64_t number;
    std::optional<std::string> robots;
    bool ended;
  };
  std::optional<Found> found;
  // The worker's choice for the document with this number (derive/elsewhere.h); empty if the
  // document is refused, nothing if the worker failed.
  struct Chosen {
    std::uint64_t number;
    std::optional<std::vector<double>> choice;
  };
  std::optional<Chosen> chosen;
  bool at_once = false;  // place the document now, even if a worker is choosing its teams
};

}  // namespace evenlift::view
