// What follows from the document and from what somebody looks at. Everybody reads it; only derive()
// (derive/derive.h) writes it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "evenlift/capacity.h"
#include "evenlift/placed_robots.h"
#include "evenlift/placement.h"
#include "evenlift/trace.h"
#include "state/explanation.h"
#include "state/opened.h"

namespace evenlift::view {

// What the robots of a placement bear as it is shown, and what may go wrong with them. Robots are
// counted from 0, team after team.
struct Outlook {
  std::vector<LoadRange> loads;  // of each robot, by `model`
  LoadModel model = LoadModel::plan;
  double greatest = 0;    // of these loads
  Robustness robustness;  // see placed_robots.h
  std::optional<ModelLoads>
      models;  // only if another model than the plan is shown, or a doubt about C
};

// A robot that fails, and the placement as it is then.
struct Failure {
  std::size_t robot = 0;
  std::optional<RestOfRobots> rest;  // none if the others do not carry the object
  Placement placement;               // with_failure() of placed_robots.h
  Outlook outlook;                   // the loads and the robustness of the others
};

// The search that betters the balanced robots on the screen, and goes on beside the page; and after
// it the count of those that it takes if any one may fail.
struct Search {
  std::uint64_t number = 0;  // of the last one; what an earlier one finds is dropped
  bool due = false;          // the robots on the screen are the start of one
  bool under_way = false;
  bool counting = false;
};

// What the facts were derived from, by which derive() sees what is out of date.
struct Basis {
  std::uint64_t edits = 0;  // Work::edits()
  Haste haste = Haste::at_rest;
  std::optional<Method> second_method;
  LoadModel load_model = LoadModel::plan;
  Shown shown;
  std::uint64_t fails = 0, card = 0;  // the last ones that were asked for (view_state.h)
};

struct Derived {
  std::optional<InputError> refusal;   // why the document is refused, if it is
  std::optional<Placement> placement;  // of the last document that was not refused
  Document placed;                     // that document; last_good() has what is shown of it
  std::optional<Placement> second;     // by the second method, of the same document
  std::shared_ptr<const Trace> trace;  // of the placement, while a step of it is shown
  std::uint64_t traces = 0;            // how many were made
  std::string untraced;                // why there is none, if one is wanted

  // Sums of the above.
  std::optional<double> best_ratio;  // if no chord has the minimum load ratio: the best there is
  std::optional<CapacityPlan> plan;  // for the capacity; not renewed during a drag
  std::optional<FailurePlan> spare;  // for it if any robot may fail; that of balanced robots comes
                                     // later, since each number of them takes a search (search.h)
  bool plan_due = false;             // the plan may have changed
  Outlook outlook, second_outlook;   // of the placement and of the second one
  std::vector<std::optional<RestOfRobots>> failures;  // if one robot of the placement fails; empty
                                                      // while that is not known
  bool failures_due = true;                           // they are to be found out
  std::optional<Failure> failure;                     // the robot that somebody let fail
  std::optional<Explanation> explanation;             // the card beside a robot or chord
  Search search;

  std::uint64_t revision = 0;  // grows with every change of what the pictures show
  Basis basis;
};

// What commands bring along for derive(), which empties it: a check has computed it already, or it
// comes from beside the page.
struct Given {
  std::optional<Placement> placement;  // of the document
  std::optional<Trace> trace;          // of that placement
  // If the placement differs only by robots that were moved by hand: the number of one that is
  // held, and its number now.
  struct Moved {
    std::size_t robot, now;
  };
  std::optional<Moved> moved;
  // What the search of this number found: robots, or how many were counted; nothing if it cannot go
  // on.
  struct Found {
    std::uint64_t number;
    std::optional<std::string> robots;
    bool ended;
  };
  std::optional<Found> found;
};

}  // namespace evenlift::view
