#include <algorithm>

#include "commands/commands.h"
#include "evenlift/formats.h"
#include "evenlift/generate.h"
#include "input/options.h"

namespace evenlift::native {
namespace {

std::string family_names() {
  std::string names;
  for (const Family family : all_families)
    names += (names.empty() ? "" : ", ") + std::string(name(family));
  return names;
}

}  // namespace

void cmd_generate(const Arguments& arguments) {
  CommandLine line("evenlift generate",
                   "Writes a polygon in the thesis's format. The same seed gives the same polygon.",
                   "Example:\n  evenlift generate random --n 50 --seed 7 | evenlift place -\n");
  std::string family_text;
  std::optional<std::string> n_text, seed_text;
  line.positional(family_text, "FAMILY", family_names());
  line.value(n_text, "--n", "N", "number of vertices (default 12)");
  line.value(seed_text, "--seed", "S", "selects a polygon of the family (default 1)");
  if (!line.parse(arguments)) return;

  const std::optional<Family> family = family_from_name(family_text);
  if (!family) throw bad_value("FAMILY", "expected one of " + family_names(), family_text);
  const std::uint64_t n = n_text ? whole_option("--n", *n_text) : 12;
  Document document;  // its settings contain the seed
  if (seed_text) setting_option(Setting::seed, *seed_text, document);
  // size_t has 32 bits in WebAssembly; a larger number is too large anyway.
  const auto size = static_cast<std::size_t>(std::min<std::uint64_t>(n, 0xFFFFFFFF));
  Result<Points> points = generate(*family, size, document.settings.seed);
  if (!points) throw Failure{bad_input_status, "--n", points.error().message};
  document.vertices = *std::move(points);
  write_output(write_thesis(document));
}

}  // namespace evenlift::native
