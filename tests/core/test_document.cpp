#include "evenlift/document.h"

#include <algorithm>
#include <iterator>

#include "kit/catch.h"

using namespace evenlift;

// Exactly the methods with a metric choose among candidates.
static_assert(std::all_of(std::begin(all_methods), std::end(all_methods), [](Method method) {
  return selects_candidates(method) ==
         (std::find(std::begin(candidate_methods), std::end(candidate_methods), method) !=
          std::end(candidate_methods));
}));

TEST_CASE("every metric has a name, and only these", "[document]") {
  for (const Method method : named_methods) {
    CHECK(!name(method).empty());
    CHECK(method_from_name(name(method)) == method);
  }
  CHECK(name(Method::area) == "area");
  CHECK(name(Method::distributed) == "distributed");
  CHECK(name(static_cast<Method>(7)).empty());
  CHECK(name(Method::balanced) == "balanced");
  CHECK(name(Method::given) == "given");
  for (const char* other : {"", "Area", "area ", "are", "max"}) CHECK(!method_from_name(other));
}

TEST_CASE("balanced robots hold unless they are told otherwise or are too few", "[document]") {
  Settings settings;
  CHECK(goal_of(settings) == Goal::cover);
  settings.method = Method::balanced;
  CHECK(goal_of(settings) == Goal::hold);
  settings.robots = 3;
  CHECK(goal_of(settings) == Goal::cover);
  settings.goal = Goal::hold;
  CHECK(goal_of(settings) == Goal::hold);
  for (const Goal goal : {Goal::cover, Goal::hold}) CHECK(goal_from_name(name(goal)) == goal);
  CHECK_FALSE(goal_from_name("win"));
}
