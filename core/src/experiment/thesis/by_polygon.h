// Tables, sentences and claims about chapter 5 of the thesis.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "evenlift/experiment/aggregates.h"
#include "evenlift/experiment/claims.h"

namespace evenlift::experiment::markdown {

// --- Writes tables in Markdown.

// A cell that shows the text. Since names may contain any characters, the special characters of
// HTML and Markdown are escaped, and control characters become spaces.
inline std::string cell(std::string_view text) {
  std::string out;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::string_view("\\|`*_~[]").find(c) != std::string_view::npos) out += '\\';
    if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '&')
      out += "&amp;";
    else
      out += byte < 0x20 || byte == 0x7f ? ' ' : c;
  }
  return out;
}

inline std::string row(const std::vector<std::string>& cells) {
  std::string text = "|";
  for (const std::string& c : cells) text += " " + c + " |";
  return text + "\n";
}

}  // namespace evenlift::experiment::markdown

namespace evenlift::experiment {

// --- Writes a sentence or two about each figure from the figure's data.

// `most_robots` is the largest number of robots in teams of two, or 0 if there are no such teams.
// O(rows most_robots).
using Sentence = std::string (*)(const std::vector<Aggregate>& aggregates,
                                 std::uint32_t most_robots);

std::string spread_sentence(const std::vector<Aggregate>&, std::uint32_t);
std::string spread_deviation_sentence(const std::vector<Aggregate>&, std::uint32_t);
std::string share_sentence(const std::vector<Aggregate>&, std::uint32_t);
std::string share_deviation_sentence(const std::vector<Aggregate>&, std::uint32_t);
std::string coverage_sentence(const std::vector<Aggregate>&, std::uint32_t);
std::string coverage_deviation_sentence(const std::vector<Aggregate>&, std::uint32_t);
std::string closure_sentence(const std::vector<Aggregate>&, std::uint32_t);

// These functions write parts of such sentences. A no-break space keeps a value and its unit on one
// line.
std::string in_unit(double value, const std::string& unit);
std::string in_kg(double value);
std::string in_percent(double share);
// Names the method in words: "by area", "at equal angles", "in balance".
std::string by(Method method);

// --- Computes what chapter 5 of the thesis states about single polygons rather than averages.

// `of` is the number of polygons or steps that count, and `yes` the number of those with a
// property.
struct Count {
  std::uint32_t yes = 0, of = 0;
};

// The row of a method and a number of robots; null if this combination was not measured. O(log
// rows).
const Measurement* find(const PolygonResult& result, Method method, std::uint32_t robots);

// Counts polygons with at most `most_vertices` vertices and with candidates for `teams` teams
// (`of`), and those on which all metrics choose the same last team (`yes`). With more than two
// teams, `of` includes only polygons on which the metrics choose the same team before the last
// (thesis, 5.4).
Count same_choice(const std::vector<PolygonResult>& results, std::uint32_t teams,
                  std::size_t most_vertices = max_vertices);

// Counts the polygons on which the three metrics do not all choose the same second team (`of`), and
// those where their coverages with two teams differ by less than `difference` (`yes`).
Count alike_coverage(const std::vector<PolygonResult>& results, double difference);

// For each polygon with two teams or more: the method's coverage less the algorithm's coverage (the
// mean of the three metrics), averaged over all numbers of teams from 2 on.
std::vector<double> coverage_differences(const std::vector<PolygonResult>& results, Method method);

// For each polygon with candidates: the algorithm's coverage with the greatest number of teams.
std::vector<double> final_coverages(const std::vector<PolygonResult>& results);

// The coverage for each polygon, each metric and each number of teams from two on, since one team
// covers nothing.
std::vector<double> all_coverages(const std::vector<PolygonResult>& results);

// Polygons NAME-moved, NAME-moved-1, NAME-moved-2 ... are the polygon NAME with another C.
// greatest_loss() compares coverages with `robots` robots placed by area. It returns the moved
// polygon whose coverage is farthest below that of NAME, or nothing if there is none to compare.
struct Loss {
  std::string polygon;  // the name of the moved polygon, such as NAME-moved-1
  double before = 0, after = 0;
};
std::optional<Loss> greatest_loss(const std::vector<PolygonResult>& results, std::uint32_t robots);

// Counts polygons. `of`: those on which some teams of two, by any method, pass the test that
// `closed` selects (can_close(), aggregates.h); `yes`: those on which teams by some metric pass it.
Count closed(const std::vector<PolygonResult>& results, Closed closed);

// Considers the polygons with at most `most_vertices` vertices on which `method`, a method of the
// thesis, can place `robots` robots. `of`: those of them on which some teams of two pass the test
// (can_close()); `yes`: those on which these robots pass it.
Count closed_with(const std::vector<PolygonResult>& results, Closed closed, Method method,
                  std::uint32_t robots, std::size_t most_vertices);

// How often a placement that passes the test fails it with one more team.
struct Lost {
  Count steps;  // passing placements given one more team (`of`), and those that then fail (`yes`)
  std::vector<std::uint32_t> robots;  // the numbers of robots after a loss, each once, ascending
};
Lost closure_lost(const std::vector<PolygonResult>& results, Closed closed, Method method);

}  // namespace evenlift::experiment
namespace evenlift::experiment::claims {

// --- The thesis's claims, section by section.

using Results = std::vector<PolygonResult>;
using Rows = std::vector<Aggregate>;

// The text of a cell without a value.
inline constexpr const char* none = "—";

std::string percent(double share, int decimals = 0);
std::string rate(const Count& count);  // "56 % (63 of 113)"
// Writes "1.5 kg (s.d. 1.9 kg)". `value` is the text "1.5 kg"; the deviation, if any, is multiplied
// by `scale`.
std::string with_deviation(const std::string& value, const std::optional<double>& deviation,
                           double scale, int decimals, const char* unit);

// Each function adds the claims of the section of the thesis whose number is beside it.
// `most_robots` is the largest number of robots in teams of two in the charts.
void add_loads(std::vector<Claim>& claims, const Rows& rows, std::uint32_t most_robots);  // 5.3
void add_coverage(std::vector<Claim>& claims, const Results& results, const Rows& rows,
                  std::uint32_t most_robots);                                            // 5.4
void add_closure(std::vector<Claim>& claims, const Results& results, const Rows& rows);  // 5.5

}  // namespace evenlift::experiment::claims
