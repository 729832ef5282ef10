#include "experiment/experiment_run.h"

#include <algorithm>
#include <set>
#include <string_view>

#include "evenlift/numbers.h"
#include "evenlift/output/markup.h"
#include "evenlift/output/words.h"

namespace evenlift::native {
namespace {

// Embedded by the build.
constexpr unsigned char template_bytes[] = {
#include "template.html.inc"
};
constexpr unsigned char report_style[] = {
#include "report.css.inc"
};
constexpr unsigned char charts_style[] = {
#include "charts.css.inc"
};
constexpr unsigned char script_bytes[] = {
#include "report_charts.js.inc"
};

template <std::size_t n>
std::string text_of(const unsigned char (&bytes)[n]) {
  return std::string(bytes, bytes + n);
}

bool have_charts() { return sizeof script_bytes > 1; }

std::string count(std::size_t n, const std::string& of) {
  return std::to_string(n) + " " + of + (n == 1 ? "" : "s");
}

std::string summary(const std::vector<experiment::PolygonResult>& results) {
  std::size_t measured = 0, convex = 0, without = 0, rows = 0;
  for (const experiment::PolygonResult& r : results) {
    if (!r.problem.empty()) continue;
    ++measured;
    convex += r.convex;
    without += r.candidates == 0;
    rows += r.measurements.size();
  }
  std::string text = count(measured, "polygon") + " (" + std::to_string(convex) + " convex), " +
                     count(rows, "measurement") + ".";
  if (without > 0)
    text += " The algorithm can place no team on " + std::to_string(without) +
            " of the polygons, so only balanced robots were measured there.";
  return text;
}

// Sets, each on its own line if there are several.
std::string summaries(const std::vector<experiment::ResultSet>& sets,
                      const experiment::ExperimentSettings& settings) {
  std::string text;
  for (const experiment::ResultSet& set : sets)
    text += (sets.size() > 1 ? "<strong>" + escaped(set.name) + "</strong>: " : std::string()) +
            summary(set.results) + (sets.size() > 1 ? "<br>" : " ");
  return text + "Minimum load ratio " + shortest(settings.min_ratio) + ", object of " +
         shortest(experiment::experiment_weight) + " kg, " +
         count(settings.samples, "random placement") + " averaged.";
}

std::string problems(const std::vector<experiment::ResultSet>& sets) {
  std::string items;
  for (const experiment::ResultSet& set : sets)
    for (const experiment::PolygonResult& r : set.results)
      if (!r.problem.empty())
        items += "<li>" + escaped(r.polygon) + ": " + escaped(r.problem) + "</li>";
  if (items.empty()) return "";
  return "<div class=\"problem\">Left out, since they could not be read:<ul>" + items +
         "</ul></div>";
}

// The number of robots up to which charts show teams of two.
std::uint32_t most_robots(const std::vector<experiment::Figure>& figures, const std::string& set) {
  std::uint32_t most = 0;
  for (const experiment::Figure& figure : figures)
    if (figure.set == set)
      for (const experiment::FigureSeries& series : figure.series)
        if (series.method != Method::balanced)
          for (const experiment::FigurePoint& point : series.points)
            most = std::max(most, point.robots);
  return most;
}

std::string ends_of_charts(const std::vector<experiment::ResultSet>& sets,
                           const std::vector<experiment::Figure>& figures) {
  std::string ends;
  for (const experiment::ResultSet& set : sets)
    if (const std::uint32_t most = most_robots(figures, set.name); most > 0)
      ends += (ends.empty() ? "" : ", ") +
              (sets.size() > 1 ? "of " + escaped(set.name) + " " : std::string()) + "at " +
              std::to_string(most) + " robots";
  return ends;
}

std::string shown(const std::vector<experiment::ResultSet>& sets,
                  const std::vector<experiment::Figure>& figures,
                  const experiment::ExperimentSettings& settings) {
  std::string text;
  if (const std::string ends = ends_of_charts(sets, figures); !ends.empty())
    text = "The charts end " + ends +
           ", the greatest number on at least a fifth of the polygons; the files continue. ";
  return text + "Balanced robots are measured up to " + std::to_string(settings.most_balanced) +
         ", odd numbers included: a search for more takes long and adds little.";
}

std::string value_text(const experiment::Figure& figure, double value) {
  return figure.unit == "%" ? fixed(100 * value, 1) : fixed(value, 2);
}

std::string data_table(const experiment::Figure& figure) {
  std::set<std::uint32_t> robots;
  std::string head = "<th scope=\"col\">robots</th>";
  for (const experiment::FigureSeries& series : figure.series) {
    head += "<th scope=\"col\">" + std::string(name(series.method)) + "</th>";
    for (const experiment::FigurePoint& point : series.points) robots.insert(point.robots);
  }
  std::string body;
  for (const std::uint32_t r : robots) {
    body += "<tr><th scope=\"row\">" + std::to_string(r) + "</th>";
    for (const experiment::FigureSeries& series : figure.series) {
      const auto at = std::lower_bound(
          series.points.begin(), series.points.end(), r,
          [](const experiment::FigurePoint& p, std::uint32_t value) { return p.robots < value; });
      const bool there = at != series.points.end() && at->robots == r;
      body += "<td>" + (there ? value_text(figure, at->value) : "") + "</td>";
    }
    body += "</tr>\n";
  }
  return "<div class=\"wide\" tabindex=\"0\" role=\"region\" aria-label=\"Numbers: " +
         escaped(figure.title) + "\"><table class=\"numbers\"><thead><tr>" + head +
         "</tr></thead><tbody>\n" + body + "</tbody></table></div>";
}

std::string figure_html(const experiment::Figure& figure, bool named) {
  return "<figure data-figure=\"" + figure.id + "\" data-set=\"" + escaped(figure.set) + "\"><h3>" +
         (named ? escaped(figure.set) + ": " : std::string()) + escaped(figure.title) +
         " <span>(figure " + figure.id + ", " + figure.unit +
         ")</span></h3><div class=\"plot\"></div>" + "<figcaption>" + escaped(figure.sentence) +
         "</figcaption><details" + (have_charts() ? "" : " open") + "><summary>Numbers</summary>" +
         data_table(figure) + "</details></figure>\n";
}

std::string figures_html(const std::vector<experiment::Figure>& figures, bool named,
                         std::initializer_list<std::string_view> ids) {
  std::string html = "<div class=\"figures\">\n";
  for (const experiment::Figure& figure : figures)
    if (std::find(ids.begin(), ids.end(), figure.id) != ids.end())
      html += figure_html(figure, named);
  return html + "</div>";
}

std::string claim_heads(const std::vector<experiment::SetClaims>& sets) {
  std::string html;
  for (const experiment::SetClaims& set : sets)
    html += "<th scope=\"col\">" + escaped(set.set) + "</th>";
  return html;
}

std::string claim_rows(const std::vector<experiment::SetClaims>& sets) {
  std::string html;
  for (std::size_t i = 0; !sets.empty() && i < sets.front().claims.size(); ++i) {
    const experiment::Claim& c = sets.front().claims[i];
    html += "<tr><td>" + escaped(c.section) + "</td><th scope=\"row\">" + escaped(c.what) +
            "</th><td>" + escaped(c.thesis) + "</td>";
    for (const experiment::SetClaims& set : sets)
      html += "<td>" + escaped(set.claims[i].ours) + "</td>";
    html += "</tr>\n";
  }
  return html;
}

std::string header_cells(const std::vector<std::string>& heads) {
  std::string html;
  for (const std::string& head : heads) html += "<th scope=\"col\">" + escaped(head) + "</th>";
  return html;
}

std::string few_robots_table(const std::string& set, const std::string& what,
                             const std::vector<experiment::FewRobotsRow>& rows) {
  std::vector<std::string> heads = {"robots"};
  for (const Method method : all_methods) heads.emplace_back(name(method));
  std::string body;
  for (const experiment::FewRobotsRow& row : rows) {
    if (row.what != what) continue;
    body += "<tr><th scope=\"row\">" + std::to_string(row.robots) + "</th>";
    for (const std::string& cell : row.cells) body += "<td>" + escaped(cell) + "</td>";
    body += "</tr>\n";
  }
  const std::string title = (set.empty() ? "" : set + ": ") + what;
  return "<figure><h3>" + escaped(title) +
         "</h3><div class=\"wide\" tabindex=\"0\" role=\"region\" aria-label=\"" + escaped(title) +
         "\"><table class=\"numbers\"><thead><tr>" + header_cells(heads) +
         "</tr></thead><tbody>\n" + body + "</tbody></table></div></figure>\n";
}

std::string few_robots_html(const std::vector<experiment::FewRobots>& sets) {
  std::string html = "<div class=\"figures\">\n";
  for (const experiment::FewRobots& set : sets) {
    std::string before;
    for (const experiment::FewRobotsRow& row : set.rows) {
      if (row.what != before)
        html += few_robots_table(sets.size() > 1 ? set.set : "", row.what, set.rows);
      before = row.what;
    }
  }
  return html + "</div>";
}

std::string polygon_rows(const std::vector<experiment::ResultSet>& sets) {
  std::string html;
  for (const experiment::ResultSet& set : sets)
    for (const experiment::PolygonResult& r : set.results)
      if (r.problem.empty())
        html += "<tr><th scope=\"row\">" + escaped(set.name) + "</th><th scope=\"row\">" +
                escaped(r.polygon) + "</th><td>" + std::to_string(r.vertices) + "</td><td>" +
                (r.convex ? "yes" : "no") + "</td><td>" + std::to_string(r.candidates) +
                "</td></tr>\n";
  return html;
}

// A "<" could end the script element.
std::string inside_script(std::string json) {
  for (std::size_t at = 0; (at = json.find('<', at)) != std::string::npos; at += 6)
    json.replace(at, 1, "\\u003c");
  return json;
}

struct Blank {
  std::string name, content;
};

// Inserted text is not searched for blanks.
std::string filled(const std::string& form, const std::vector<Blank>& blanks) {
  std::string out;
  for (std::size_t at = 0; at < form.size();) {
    const Blank* found = nullptr;
    for (const Blank& blank : blanks)
      if (form[at] == '@' && form.compare(at, blank.name.size(), blank.name) == 0) found = &blank;
    if (found) {
      out += found->content;
      at += found->name.size();
    } else {
      out += form[at++];
    }
  }
  return out;
}

}  // namespace

std::string report_html(const std::vector<experiment::ResultSet>& sets,
                        const experiment::Outputs& outputs,
                        const experiment::ExperimentSettings& settings) {
  const std::vector<experiment::Figure>& figures = outputs.figures;
  std::size_t measured = 0;
  for (const experiment::ResultSet& set : sets)
    measured += static_cast<std::size_t>(
        std::count_if(set.results.begin(), set.results.end(),
                      [](const experiment::PolygonResult& r) { return r.problem.empty(); }));
  const bool named = sets.size() > 1;
  const std::string no_charts =
      have_charts()
          ? ""
          : "<p class=\"problem\">The charts are missing: this program was built without Observable Plot or esbuild, which draw them (./dev build installs both). Their numbers are below.</p>";
  return filled(text_of(template_bytes),
                {{"@STYLE@", text_of(report_style) + text_of(charts_style)},
                 {"@SUMMARY@", summaries(sets, settings)},
                 {"@PROBLEMS@", problems(sets)},
                 {"@SHOWN@", shown(sets, figures, settings)},
                 {"@NO_CHARTS@", no_charts},
                 {"@FIGURES_5.3@", figures_html(figures, named, {"5.3", "5.4", "5.5", "5.6"})},
                 {"@FIGURES_5.4@", figures_html(figures, named, {"5.7", "5.8"})},
                 {"@FIGURES_5.5@", figures_html(figures, named, {"5.11"})},
                 {"@FEW_ROBOTS@", few_robots_html(outputs.few_robots)},
                 {"@CLAIM_SETS@", claim_heads(outputs.claims)},
                 {"@CLAIMS@", claim_rows(outputs.claims)},
                 {"@POLYGON_COUNT@", count(measured, "polygon")},
                 {"@POLYGONS@", polygon_rows(sets)},
                 {"@VERSION@", EVENLIFT_VERSION},
                 {"@DATA@", inside_script(experiment::figures_json(figures))},
                 {"@SCRIPT@", have_charts() ? text_of(script_bytes) : ""}});
}

}  // namespace evenlift::native
