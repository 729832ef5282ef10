#include "evenlift/wording.h"

#include <string>

#include "evenlift/output/words.h"
#include "kit/catch.h"

using namespace evenlift;

namespace {

// A language's words, until the end of a test.
class Spoken {
 public:
  Spoken(std::initializer_list<std::pair<const char*, const char*>> words) {
    for (const auto& [english, other] : words) add_translation(english, other);
  }
  ~Spoken() { forget_translations(); }
  Spoken(const Spoken&) = delete;
  Spoken& operator=(const Spoken&) = delete;
};

}  // namespace

TEST_CASE("without translations a sentence is English", "[words]") {
  CHECK(translated("Only this.") == "Only this.");
  CHECK(say("Robot {robot} carries {load}.", {3U, "16.7 kg"}) == "Robot 3 carries 16.7 kg.");
  CHECK(say("No place.") == "No place.");
  CHECK(say("{a} and {b}, then {a} again", {1U, 2U}) == "1 and 2, then 1 again");
}

TEST_CASE("a translation may change the order of what it says", "[words]") {
  const Spoken german{
      {"Of {all} robots {number} fail.", "{number} von {all} Robotern fallen aus."}};
  CHECK(say("Of {all} robots {number} fail.", {7U, 2U}) == "2 von 7 Robotern fallen aus.");
  CHECK(translated("Another sentence.") == "Another sentence.");
}

TEST_CASE("words in a sentence are translated with it", "[words]") {
  const Spoken german{{"by {metric}", "nach {metric}"},
                      {"area", "Fläche"},
                      {"robot", "Roboter"},
                      {"robots", "Roboter"}};
  CHECK(say("by {metric}", {"area"}) == "nach Fläche");
  CHECK(say("by {metric}", {"circle"}) == "nach circle");
  CHECK(count_of(1, "robot", "robots") == "1 Roboter");
}

TEST_CASE("a text with braces is no pattern once it is a value", "[words]") {
  CHECK(say("{name} is here", {"{robot}"}) == "{robot} is here");
  CHECK(say("{name", {}) == "{name");
}
