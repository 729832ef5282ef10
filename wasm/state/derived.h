// Everything that follows from the document and the view. All code may read it; only derive()
// (derive/derive.h) writes it.
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

// The loads of a placement as shown, and its robustness. Robots are counted from 0, team after
// team.
struct Outlook {
  std::vector<LoadRange> loads;  // of each robot, by `model`
  LoadModel model = LoadModel::plan;
  double greatest = 0;    // the greatest of these loads
  Robustness robustness;  // see placed_robots.h
  std::optional<ModelLoads>
      models;  // only if the shown model is not the plan, or there is a disturbance
  std::optional<ExtraLoad> extra;  // where a further load may stand, if one is asked about
};

// A failed robot, and the placement without it.
struct Failure {
  std::size_t robot = 0;
  std::optional<RestOfRobots> rest;  // nothing if the others do not carry the object
  Placement placement;               // with_failure() of placed_robots.h
  Outlook outlook;                   // the loads and the robustness of the others
};

// The search that improves the balanced robots on the screen, in the background. Afterwards it
// counts the robots needed if any one may fail.
struct Search {
  std::uint64_t number = 0;  // of the last search; results of earlier ones are dropped
  bool due = false;          // the robots on the screen are the start of a search
  bool under_way = false;
  bool counting = false;
};

// During a drag of a large object, a worker chooses its teams, one document after another; documents
// that are overtaken meanwhile are left out (derive/elsewhere.h).
struct Elsewhere {
  std::uint64_t number = 0;  // of the last document that the worker got
  bool under_way = false;
  bool possible = true;     // false once the worker has failed during a drag
  Document document;        // the one that is under way
  std::uint64_t edits = 0;  // Work::edits() of that document
};

// Other settings that would mend what is amiss, and the words of the button that takes them.
struct Offer {
  Settings settings;
  std::string label;
};

// The inputs of the last derive(), by which it sees what is out of date.
struct Basis {
  std::uint64_t edits = 0;  // Work::edits() of the document that was placed or refused
  Haste haste = Haste::at_rest;
  std::optional<Method> second_method;
  LoadModel load_model = LoadModel::plan;
  Shown shown;
  bool challenge = false;
  std::uint64_t fails = 0, card = 0;  // the last ones requested (view_state.h)
};

struct Derived {
  std::optional<InputError> refusal;   // why the document is refused, if so
  std::optional<Placement> placement;  // of the last document that was not refused
  Document placed;                     // that document; last_good() adds what is shown
  std::optional<Placement> second;     // by the second method, of the same document
  std::shared_ptr<const Trace> trace;  // of the placement, while a step of it is shown
  std::uint64_t traces = 0;            // the number of traces made
  std::string untraced;                // why the requested trace is missing

  // Summaries of the above.
  std::optional<double> best_ratio;  // the best load ratio, if no chord has the minimum
  std::optional<Offer> offer;        // if the placement is not good; none during a drag
  bool offer_due = true;             // the offer may have changed
  std::optional<CapacityPlan> plan;  // for the capacity; not updated during a drag
  std::optional<FailurePlan> spare;  // for the capacity if any robot may fail; for balanced robots
                                     // it comes later, since each number of robots needs a search
                                     // (search.h)
  bool plan_due = false;             // the plan may have changed
  Outlook outlook, second_outlook;   // of the placement and of the second one
  std::vector<std::optional<RestOfRobots>> failures;  // by the robot of the placement that fails;
                                                      // empty while unknown
  bool failures_due = true;                           // they must be computed
  std::optional<Failure> failure;                     // the robot that the user let fail
  std::optional<Explanation> explanation;             // the card beside a robot or chord
  Search search;
  Elsewhere elsewhere;

  std::uint64_t revision = 0;  // grows with every change to the pictures
  Basis basis;
};

// Values that commands pass to derive(), which empties it: results that a check has already
// computed, and results that arrive from outside the view.
struct Given {
  std::optional<Placement> placement;  // of the document
  std::optional<Trace> trace;          // of that placement
  // If the placement differs only by robots that were moved by hand: the number of the held robot
  // before and after the move.
  struct Moved {
    std::size_t robot, now;
  };
  std::optional<Moved> moved;
  // The result of the search with this number: robots, or a count; nothing if it cannot continue.
  struct Found {
    std::uint64_t number;
    std::optional<std::string> robots;
    bool ended;
  };
  std::optional<Found> found;
  // The choice that the worker made for the document with this number, as numbers
  // (derive/elsewhere.h); empty if the document is refused, nothing if the worker failed.
  struct Chosen {
    std::uint64_t number;
    std::optional<std::vector<double>> choice;
  };
  std::optional<Chosen> chosen;
  bool at_once = false;  // the document is placed now, even if a worker is choosing its teams
};

}  // namespace evenlift::view
