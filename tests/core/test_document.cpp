#include "evenlift/document.h"
#include "kit/catch.h"

using namespace evenlift;

TEST_CASE("every metric has a name, and only these", "[document]") {
  for (const Method method : all_methods) {
    CHECK(!name(method).empty());
    CHECK(method_from_name(name(method)) == method);
  }
  CHECK(name(Method::area) == "area");
  CHECK(name(Method::distributed) == "distributed");
  CHECK(name(static_cast<Method>(5)).empty());
  for (const char* other : {"", "Area", "area ", "are", "max"}) CHECK(!method_from_name(other));
}
