// The program and the page show the same words and digits for a result.
#include <cstdlib>
#include <regex>
#include <string>
#include <vector>

#include "evenlift/numbers.h"
#include "evenlift/output/words.h"
#include "kit/catch.h"
#include "kit/corpus.h"
#include "panels/summary.h"
#include "view/view_page.h"

using namespace evenlift;
using namespace view_page;

namespace {

struct AskedOfBoth {
  std::uint32_t teams;
  Method method;
  double min_ratio;
  double weight;
  std::optional<double> capacity;
};

const AskedOfBoth asked[] = {
    {3, Method::area, 0.8, 100, std::nullopt},      {1, Method::circle, 0.8, 1234.5, 400.0},
    {12, Method::distance, 0.5, 99.97, 6.5},        {4, Method::distributed, 0.8, 0.0123, 1e-3},
    {5, Method::random, 0.8, 100000, std::nullopt}, {9, Method::area, 1, 480, 20.0},
};

std::string options_of(const AskedOfBoth& a) {
  std::string options = " --teams " + std::to_string(a.teams) + " --metric " +
                        std::string(name(a.method)) + " --min-ratio " + shortest(a.min_ratio) +
                        " --weight " + shortest(a.weight);
  if (a.capacity) options += " --capacity " + shortest(*a.capacity);
  return options;
}

std::vector<std::string> printed(const std::string& polygon, const AskedOfBoth& a) {
  const std::filesystem::path out = std::filesystem::temp_directory_path() /
                                    ("evenlift-agreement-" + std::to_string(::getpid()) + ".txt");
  const std::string command = "'" EVENLIFT_PROGRAM "' place '" EVENLIFT_ASSETS_DIR "/polygons/" +
                              polygon + ".txt'" + options_of(a) + " > '" + out.string() + "'";
  REQUIRE(std::system(command.c_str()) == 0);
  std::istringstream text(corpus::read_file(out));
  std::filesystem::remove(out);
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  return lines;
}

// For the program's lines: the sentences, then the rows of its table.
std::string said_of(const std::vector<std::string>& lines, const AskedOfBoth& a) {
  std::string text = lines.at(0);
  if (a.capacity && !lines.at(1).empty()) text += " " + lines.at(1);
  const std::regex row(R"(^\s+(\d+)\s+(\S+)\s+(\(\S+, \S+\))\s+(\S+)\s+(\(\S+, \S+\))\s+(\S+).*$)");
  std::size_t teams = 0;
  std::string rows;
  for (const std::string& line : lines) {
    std::smatch found;
    if (!std::regex_match(line, found, row)) continue;
    if (++teams > 12) continue;
    rows += " Team " + found.str(1) + " at " + found.str(3) + " and " + found.str(5) + ": " +
            found.str(4) + " and " + found.str(6) + "\u00A0kg, load ratio " + found.str(2) + ".";
  }
  return text + " " + count_of(teams, "team", "teams") + " of " + std::to_string(a.teams) +
         " requested, method " + method_in_words(a.method) + ", minimum load ratio " +
         plain(a.min_ratio) + "." + rows;
}

}  // namespace

TEST_CASE("the page's live region says what the program prints, in the same words and digits",
          "[words][view][agreement][thorough]") {
  std::size_t with_teams = 0, with_capacity = 0;
  Page page;
  const std::vector<std::string> names = corpus::polygon_names();
  for (std::size_t i = 0; i < names.size(); i += 3) {
    for (const AskedOfBoth& a : asked) {
      INFO(names[i] << options_of(a));
      Document document = corpus::polygon(names[i]);
      document.settings.teams = a.teams;
      document.settings.method = a.method;
      document.settings.min_ratio = a.min_ratio;
      document.settings.weight = a.weight;
      document.shown.capacity = a.capacity;
      page.app.commands.push_back(OpenDocument{placed(document)});
      settle(page.app);
      const std::vector<std::string> lines = printed(names[i], a);
      CHECK(summary(page.app.state) == said_of(lines, a));
      const Verdict shown = verdict(page.app.state);
      CHECK(shown.headline + (shown.detail.empty() ? "" : " ") + shown.detail == lines.at(0));
      with_teams += page.app.state.derived().placement->teams.empty() ? 0u : 1u;
      with_capacity += a.capacity ? 1u : 0u;
    }
  }
  CHECK(with_teams > 100);
  CHECK(with_capacity > 80);
}
