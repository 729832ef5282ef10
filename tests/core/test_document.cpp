#include "evenlift/document.h"
#include "kit/catch.h"

using namespace evenlift;

TEST_CASE("every metric has a name, and only these", "[document]") {
  for (const Metric metric : all_metrics) {
    CHECK(!name(metric).empty());
    CHECK(metric_from_name(name(metric)) == metric);
  }
  CHECK(name(Metric::area) == "area");
  CHECK(name(Metric::distributed) == "distributed");
  CHECK(name(static_cast<Metric>(5)).empty());
  for (const char* other : {"", "Area", "area ", "are", "max"}) CHECK(!metric_from_name(other));
}
