// Searches for cases that break a promise, from an untried number on:
//
//   evenlift_soak KIND FIRST SECONDS   case after case, until the time is over
//   evenlift_soak KIND NUMBER          one case
//
// Kinds: `oracle` compares the core with the exact oracle; `one-shape` compares a shape with copies
// turned, mirrored, moved and scaled; `files` reads drawings and tables of random form; `bounds` answers requests of any size within their bounds of
// time. Prints each failure with the command that repeats it, and at
// the end one line: the numbers of cases tried, skipped and failed.
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>

#include "comparisons/against_oracle.h"
#include "comparisons/one_shape.h"
#include "evenlift/numbers.h"
#include "evenlift/random.h"
#include "kit/metrics.h"
#include "shapes/holed_polygons.h"
#include "shapes/problem_document.h"
#include "shapes/random_files.h"
#include "shapes/small_polygons.h"
#include "soak/bounds.h"

namespace {

struct Outcome {
  std::string differences;  // empty if all is well
  bool passed_over = false;
};

Outcome try_oracle(std::uint64_t number) {
  using namespace against_oracle;
  Outcome outcome;
  const auto add = [&](const char* what, const Case& c, const Finding& finding) {
    outcome.passed_over = outcome.passed_over || finding.passed_over > 0;
    if (!finding.differences.empty())
      outcome.differences += std::string(what) + "\n" + text(c) + finding.differences;
  };
  const Case c = small_polygons::make_case(number);
  add("placement", c, compare_placement(c));
  const Case holed = holed_polygons::with_holes(c, number);
  if (!holed.problem.holes.empty()) add("with holes", holed, compare_placement(holed));
  add("vertex-chords", c, compare_vertex_chords(c));
  if (number % 4 == 0) add("distributed teams", c, compare_distributed(c));
  const Case careless = small_polygons::make_careless_case(number);
  add("refusal", careless, compare_refusal(careless));
  return outcome;
}

Outcome try_one_shape(std::uint64_t number) {
  const small_polygons::Case c = small_polygons::make_plain_case(number);
  evenlift::Document document = evenlift::testing::document_of(c.problem);
  if (!one_shape::is_clear_of_refusal(document)) return {.passed_over = true};
  evenlift::Rng rng(number);
  const std::vector<evenlift::Method> metrics = evenlift::testing::metrics();
  document.settings.method = metrics[rng.below(metrics.size())];
  const one_shape::Motion motion = one_shape::any_motion(document, rng);
  constexpr std::uint32_t teams = 6;
  const std::string differences = one_shape::compare(document, motion, teams).differences;
  if (differences.empty()) return {};
  return {.differences = c.name + "\n" + one_shape::text(document, motion) + "\n" + differences};
}

Outcome try_files(std::uint64_t number) {
  return {.differences = random_files::compare(random_files::make_file(number))};
}

Outcome try_bounds(std::uint64_t number) {
  const bounds::Outcome outcome = bounds::answer(bounds::make_case(number));
  return {outcome.wrong, outcome.refused};
}

struct Kind {
  std::string_view name;
  Outcome (*attempt)(std::uint64_t number);
};
constexpr Kind kinds[] = {{"oracle", try_oracle},
                          {"one-shape", try_one_shape},
                          {"files", try_files},
                          {"bounds", try_bounds}};

struct Totals {
  std::uint64_t tried = 0, passed_over = 0, failed = 0;
};

void attempt(const Kind& kind, std::uint64_t number, Totals& totals) {
  const Outcome outcome = kind.attempt(number);
  ++totals.tried;
  totals.passed_over += outcome.passed_over;
  if (outcome.differences.empty()) return;
  ++totals.failed;
  const std::string name(kind.name);
  std::printf("%s %s: to repeat it: build/bin/evenlift_soak %s %s\n%s\n", name.c_str(),
              std::to_string(number).c_str(), name.c_str(), std::to_string(number).c_str(),
              outcome.differences.c_str());
  std::fflush(stdout);
}

// So many failures show a broken rule, not a rare case.
constexpr std::uint64_t most_failures = 20;

Totals search(const Kind& kind, std::uint64_t first, std::uint64_t seconds) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point end = Clock::now() + std::chrono::seconds(seconds);
  Totals totals;
  for (std::uint64_t number = first; Clock::now() < end && totals.failed < most_failures; ++number)
    attempt(kind, number, totals);
  return totals;
}

int usage() {
  std::fputs("usage: evenlift_soak KIND FIRST SECONDS | KIND NUMBER, where KIND is", stderr);
  for (const Kind& kind : kinds) std::fprintf(stderr, " %s", std::string(kind.name).c_str());
  std::fputs("\n", stderr);
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3 || argc > 4) return usage();
  const Kind* kind = nullptr;
  for (const Kind& known : kinds)
    if (known.name == argv[1]) kind = &known;
  const std::optional<std::uint64_t> first = evenlift::read_whole(argv[2]);
  const std::optional<std::uint64_t> seconds = evenlift::read_whole(argc == 4 ? argv[3] : "0");
  if (kind == nullptr || !first || !seconds) return usage();
  Totals totals;
  if (argc == 4)
    totals = search(*kind, *first, *seconds);
  else
    attempt(*kind, *first, totals);
  std::printf("tried %llu, passed over %llu, failed %llu\n",
              static_cast<unsigned long long>(totals.tried),
              static_cast<unsigned long long>(totals.passed_over),
              static_cast<unsigned long long>(totals.failed));
  return totals.failed == 0 ? 0 : 1;
}
