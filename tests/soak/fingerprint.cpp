// evenlift's output for an endless series of documents, as hashes, in lines that must be the same
// natively and in WebAssembly.
//
//   evenlift_fingerprint FIRST COUNT        for each 1,000 documents: first number, hash
//   evenlift_fingerprint FIRST COUNT each   for each document: number, hash
//   evenlift_fingerprint show NUMBER        that document's hashed text, for comparison
//
// A document is made from its number alone. Everything must be the same on every platform, also the
// making of the document, which is part of the hash.
#include <cinttypes>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>

#include "evenlift/capacity.h"
#include "evenlift/formats.h"
#include "evenlift/generate.h"
#include "evenlift/link.h"
#include "evenlift/numbers.h"
#include "evenlift/output/json.h"
#include "evenlift/output/svg.h"
#include "evenlift/output/trace_json.h"
#include "evenlift/output/words.h"
#include "evenlift/placement.h"
#include "evenlift/random.h"
#include "evenlift/trace.h"
#include "shapes/problem_document.h"
#include "shapes/small_polygons.h"

namespace {

using namespace evenlift;

constexpr std::uint64_t batch = 1000;

// FNV-1a.
class Hash {
 public:
  void take(std::string_view text) {
    for (const char c : text) {
      value_ ^= static_cast<unsigned char>(c);
      value_ *= 0x100000001b3;
    }
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325;
};

// The tests' small polygons, mostly hard. Of those refused, the reason must also be the same.
Document small_document(std::uint64_t number) {
  return testing::document_of(small_polygons::attempt_case(number, 0).problem);
}

// Of a generator's family; one in a hundred is large.
Document generated_document(Rng& rng) {
  const Family family = all_families[rng.below(std::size(all_families))];
  const std::uint64_t size = rng.below(100);
  const std::uint64_t n = size == 0   ? 100 + rng.below(300)
                          : size < 10 ? 30 + rng.below(70)
                                      : 8 + rng.below(23);
  Document document;
  if (auto points = generate(family, static_cast<std::size_t>(n), rng.below(1u << 30)))
    document.vertices = *std::move(points);
  // Between three vertices, so in the convex hull.
  if (rng.below(3) == 0 && !document.vertices.empty()) {
    Vec2 sum;
    for (int i = 0; i < 3; ++i)
      sum += document.vertices[static_cast<std::size_t>(rng.below(document.vertices.size()))];
    document.centre_of_mass = sum / 3;
  }
  return document;
}

// At vertices, on edges, or between, perhaps outside the object.
void add_supports(Rng& rng, Document& document) {
  Settings& settings = document.settings;
  const Points& vertices = document.vertices;
  settings.method = Method::given;
  const std::uint64_t number = 1 + rng.below(8);
  for (std::uint64_t i = 0; i < number; ++i) {
    const auto at = static_cast<std::size_t>(rng.below(vertices.size()));
    const std::size_t other = rng.below(3) > 0
                                  ? (at + 1) % vertices.size()
                                  : static_cast<std::size_t>(rng.below(vertices.size()));
    const double part = rng.below(4) == 0 ? 0 : rng.uniform();
    settings.supports.push_back(vertices[at] + part * (vertices[other] - vertices[at]));
  }
  if (rng.below(2) == 0) return;
  for (std::size_t i = 0; i < settings.supports.size(); ++i)
    settings.weighed.readings.push_back(10 + 20 * rng.uniform());
  settings.weighed.error.percent = rng.uniform();
  settings.weight = Settings{}.weight;
  document.centre_of_mass.reset();
}

Settings settings_from(Rng& rng) {
  Settings settings;
  settings.method = all_methods[rng.below(std::size(all_methods))];
  settings.robots = static_cast<std::uint32_t>(2 + rng.below(7));
  if (rng.below(3) == 0) settings.goal = Goal::cover;
  if (rng.below(4) == 0) settings.apart = rng.uniform();
  if (settings.method == Method::balanced && settings.robots >= 5)
    settings.survive = static_cast<std::uint32_t>(rng.below(2));
  settings.teams = static_cast<std::uint32_t>(1 + rng.below(8));
  if (rng.below(20) == 0) settings.teams = std::nullopt;
  const double ratios[] = {0.0, 0.5, 0.8, 0.8, 0.95, 1.0};
  settings.min_ratio = ratios[rng.below(std::size(ratios))];
  if (rng.below(4) == 0) settings.min_ratio = rng.uniform();
  settings.weight = 1 + 1000 * rng.uniform();
  settings.seed = rng.below(~std::uint64_t{0});
  if (rng.below(3) == 0) settings.positions = Positions::range;
  const bool may_hold = selects_candidates(settings.method);
  if (may_hold && rng.below(3) == 0) settings.goal = Goal::hold;
  if (may_hold && rng.below(6) == 0) settings.min_margin = 0.3 * rng.uniform();
  return settings;
}

// One in four gets a size where the method allows it, and sometimes a no-go edge. Sized balanced
// robots take by far the longest, so only one in twenty.
void give_size(Rng& rng, Document& document) {
  const bool has_size = rng.below(document.settings.method == Method::balanced ? 20 : 4) == 0;
  const double size = rng.uniform() / 20, parts[] = {0, 0.5, 1};
  const std::uint64_t reach = rng.below(3), depth = rng.below(3), width = rng.below(3);
  const bool marked = rng.below(4) == 0;
  if (!has_size || document.vertices.empty()) return;
  Settings& settings = document.settings;
  if (settings.method == Method::distributed || settings.method == Method::random) return;
  const double radius = size * bounding_box(document.vertices).diagonal();
  settings.robot = {radius, parts[reach] * radius, parts[depth] * radius, parts[width] * radius, 0};
  if (marked) settings.no_go.push_back({0, 0.25, 0.75});
  settings.positions = Positions::best;
}

Document document_of(std::uint64_t number) {
  Rng rng(number);
  Document document = rng.below(2) == 0 ? small_document(number) : generated_document(rng);
  document.settings = settings_from(rng);
  if (rng.below(8) == 0) add_supports(rng, document);
  give_size(rng, document);
  return document;
}

// Passes each text to `take`: the document, its results, and sometimes one other output.
template <class Take>
void say_all(std::uint64_t number, Take take) {
  const Document document = document_of(number);
  take(write_thesis(document));
  take(document_json(document));
  const Result<Placement> placement = place(document);
  if (!placement) {
    take(placement.error().message + "\n");
    return;
  }
  take(placement_json(*placement, true));
  take(verdict(*placement) + "\n");
  switch (number % 64) {
    case 0: {
      const Result<Trace> trace = make_trace(*placement);
      if (!trace)
        take(trace.error().message + "\n");
      else if (!check_printed_size(*trace))
        take(trace_json(*trace) + trace_list(*trace));
      break;
    }
    case 1:
      take(placement_svg(*placement));
      break;
    case 2: {
      const Result<std::string> link = encode_link(document);
      take((link ? *link : link.error().message) + "\n");
      break;
    }
    case 3:
      take(write_wkt(document) + write_geojson(document));
      break;
    case 4: {
      const double capacity = document.settings.weight / 9;
      Shown limited;
      limited.capacity = capacity;
      const ShownPlacement of(*placement, limited);
      Report report = report_of(of, {.models = true});
      report.plan = plan_capacity(*placement, capacity);
      report.known.plans = true;
      take(placement_json({of, report}, false, false));
      take(capacity_in_words({of, report}) + "\n");
      break;
    }
    case 5: {
      if (count_robots(placement->teams) > 64) break;  // each failure examines all of them
      Shown doubted;
      doubted.com_radius = bounding_box(document.vertices).diagonal() / 50;
      take(placement_json({*placement, doubted}, false, {.failures = true}));
      break;
    }
    default:
      break;
  }
}

void print_hashes(std::uint64_t first, std::uint64_t count, std::uint64_t in_one_line) {
  for (std::uint64_t done = 0; done < count;) {
    Hash hash;
    const std::uint64_t start = done;
    for (; done < count && done < start + in_one_line; ++done)
      say_all(first + done, [&](const std::string& text) { hash.take(text); });
    std::printf("%" PRIu64 " %016" PRIx64 "\n", first + start, hash.value());
    std::fflush(stdout);
  }
}

int usage() {
  std::fputs("usage: evenlift_fingerprint FIRST COUNT [each] | show NUMBER\n", stderr);
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  const auto argument = [&](int i) { return i < argc ? std::string_view(argv[i]) : ""; };
  const std::optional<std::uint64_t> first = read_whole(argument(1));
  const std::optional<std::uint64_t> second = read_whole(argument(2));
  if (argument(1) == "show" && second && argc == 3) {
    say_all(*second, [](const std::string& text) { std::fputs(text.c_str(), stdout); });
    return 0;
  }
  if (!first || !second || argc > 4 || (argc == 4 && argument(3) != "each")) return usage();
  print_hashes(*first, *second, argc == 4 ? 1 : batch);
  return 0;
}
