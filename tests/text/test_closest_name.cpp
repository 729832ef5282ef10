#include "evenlift/closest_name.h"

#include "evenlift/similar_setting.h"
#include "kit/catch.h"

using namespace evenlift;

TEST_CASE("a mistyped name is the closest one within two edits", "[text]") {
  const std::vector<std::string_view> names = {"weight", "width", "seed", "min_ratio"};
  CHECK(closest_name("wieght", names) == "weight");  // exchanged
  CHECK(closest_name("weigt", names) == "weight");   // left out
  CHECK(closest_name("widht", names) == "width");
  CHECK(closest_name("min-ratio", names) == "min_ratio");
  CHECK(closest_name("sead", names) == "seed");
  CHECK(closest_name("weight", names) == "weight");
  CHECK(closest_name("xy", names).empty());
  CHECK(closest_name("", names).empty());
  CHECK(closest_name("teams", names).empty());
  CHECK(closest_name(std::string(100, 'w'), names).empty());
}

TEST_CASE("an unknown setting names the one that may be meant", "[text]") {
  CHECK(unknown_setting("wieght") == "unknown setting; did you mean weight?");
  CHECK(unknown_setting("colour") == "unknown setting");
}
