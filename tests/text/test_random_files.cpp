#include "kit/catch.h"
#include "shapes/random_files.h"

TEST_CASE("drawings and tables of random form are read as they are meant", "[import][families]") {
  for (std::uint64_t number = 0; number < 3000; ++number) {
    const std::string differences = random_files::compare(random_files::make_file(number));
    INFO(number << ": " << differences);
    REQUIRE(differences.empty());
  }
}
