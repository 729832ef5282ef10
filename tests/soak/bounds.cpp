#include "soak/bounds.h"

#include <array>
#include <cmath>
#include <ctime>
#include <string_view>

#include "evenlift/generate.h"
#include "evenlift/numbers.h"
#include "evenlift/random.h"
#include "evenlift/request.h"

namespace bounds {
namespace {

using namespace evenlift;

// As many of each order of magnitude.
std::uint64_t any_size(Rng& rng, std::uint64_t least, std::uint64_t most) {
  return static_cast<std::uint64_t>(
      static_cast<double>(least) *
      std::pow(static_cast<double>(most) / static_cast<double>(least), rng.uniform()));
}

// The members of a JSON object.
class Members {
 public:
  void add(std::string_view name, std::string value) {
    if (!text_.empty()) text_ += ", ";
    text_ += '"' + std::string(name) + "\": " + std::move(value);
  }
  void add(std::string_view name, double value) { add(name, shortest(value)); }
  std::string object() const { return "{" + text_ + "}"; }

 private:
  std::string text_;
};

std::string array_of(const Points& points) {
  std::string text;
  for (const Vec2& p : points)
    text += (text.empty() ? "[" : ", ") + ("[" + shortest(p.x)) + ", " + shortest(p.y) + "]";
  return text + "]";
}

// Places on the outline.
Points supports_of(const Points& outline, std::size_t number, Rng& rng) {
  Points supports;
  while (supports.size() < number) {
    const auto i = static_cast<std::size_t>(rng.below(outline.size()));
    const Vec2 &a = outline[i], &b = outline[(i + 1) % outline.size()];
    supports.push_back(a + rng.uniform() * (b - a));
  }
  return supports;
}

constexpr std::uint64_t most_listed = 64;

}  // namespace

Case make_case(std::uint64_t number) {
  Rng rng(number);
  const Family family = all_families[rng.below(std::size(all_families))];
  const bool convex = family == Family::convex || family == Family::regular;
  const std::uint64_t n = rng.below(4) > 0 ? any_size(rng, 8, 1000) : any_size(rng, 1001, 50000);
  const std::uint64_t seed = rng.below(1000);
  std::uint64_t robots = any_size(rng, 2, most_listed + 1);
  const Points outline = *generate(family, static_cast<std::size_t>(n), seed);
  Members settings, request;
  request.add("polygon", array_of(outline));
  switch (rng.below(8)) {
    case 0:
    case 1:
    case 2:
      settings.add("metric", "\"balanced\"");
      settings.add("robots", std::to_string(robots));
      if (rng.below(4) == 0) settings.add("survive", std::to_string(rng.below(robots / 2 + 1)));
      break;
    case 3:
    case 4:
    case 5:
      settings.add("goal", "\"hold\"");
      settings.add("positions", rng.below(2) == 0 ? "\"best\"" : "\"range\"");
      settings.add("teams", std::to_string((robots + 1) / 2));
      break;
    case 6: {
      constexpr std::array<std::string_view, 5> methods = {"area", "circle", "distance",
                                                           "distributed", "random"};
      const std::size_t method = static_cast<std::size_t>(rng.below(methods.size()));
      settings.add("metric", '"' + std::string(methods[method]) + '"');
      if (convex && method < 3 && rng.below(2) == 0) {
        robots = 2 * n;
        settings.add("teams", "\"max\"");
      } else {
        settings.add("teams", std::to_string((robots + 1) / 2));
      }
      break;
    }
    default:
      if (rng.below(4) == 0) robots = any_size(rng, most_listed, 1000);
      settings.add("supports", array_of(supports_of(outline, robots, rng)));
      if (robots <= most_listed && rng.below(2) == 0) request.add("even_out", "true");
  }
  if (rng.below(4) == 0) settings.add("robot_radius", rng.uniform() * 10);
  const bool plans = rng.below(4) == 0;
  if (plans) settings.add("capacity", 200 / static_cast<double>(robots));
  if (rng.below(4) == 0) settings.add("com_radius", rng.uniform() * 20);
  if (rng.below(4) == 0) settings.add("slope", rng.uniform() * 0.2);
  if (rng.below(2) == 0) request.add("failures", "true");
  request.add("settings", settings.object());
  const bool small = n <= 1000 && robots <= most_listed;
  return {request.object(),
          std::string(name(family)) + " of " + std::to_string(n) + " vertices, seed " +
              std::to_string(seed) + ", settings " + settings.object().substr(0, 300),
          (small ? 10.0 : 60.0) * (plans ? 3 : 1)};
}

Outcome answer(const Case& c) {
  const std::clock_t before = std::clock();
  const std::string answer = evenlift::answer(c.request);
  const double seconds = static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
  if (answer.empty() || answer.back() != '\n') return {c.text + "\nno answer"};
  if (seconds <= c.most_seconds) return {{}, answer.starts_with("{\"error\"")};
  return {c.text + "\ntook " + shortest(seconds) + " s of a processor, more than " +
          shortest(c.most_seconds) + " s"};
}

}  // namespace bounds
