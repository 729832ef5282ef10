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

TEST_CASE("numbers have the reader's decimal mark, and points part their coordinates clearly",
          "[words]") {
  const Units units;
  CHECK(load_in_words(16.6667, 16.6667, units) == "16.7\u00A0kg");
  const Spoken german{{".", ","}, {"({x}, {y})", "({x}; {y})"}};
  CHECK(fixed(-1234.5, 2) == "−1234,50");
  CHECK(plain(0.8) == "0,8");
  CHECK(significant(0.001666, 2) == "0,0017");
  CHECK(amount(16.66, 16.66, Toward::up) == "16,7");
  CHECK(load_in_words(15.2, 18.1, 18.1, units) == "15,2–18,1\u00A0kg");
  CHECK(percentage(0.0004, 1) == "<\u00A00,1\u00A0%");
  CHECK(ratio_in_words(1) == "1,000");
  CHECK(point_in_words(Vec2(403.8, -480), 1) == "(403,8; −480,0)");
  CHECK(given_point(Vec2(3.5, 2)) == "(3,5; 2)");
}

TEST_CASE("what a user typed is not translated", "[words]") {
  const Spoken german{{"area", "Fläche"}};
  CHECK(translated("area") == "Fläche");
  {
    const AsTyped typed;
    CHECK(translated("area") == "area");
  }
  CHECK(translated("area") == "Fläche");
}
