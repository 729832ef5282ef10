// What the page writes, as a golden file.
#include <cstdlib>
#include <iterator>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "kit/catch.h"
#include "kit/corpus.h"
#include "kit/texts.h"
#include "panels/summary.h"
#include "tools/drawing.h"
#include "ui/controls.h"
#include "view/view_page.h"
#include "widgets/text.h"

using namespace evenlift;
using namespace evenlift::view;
using namespace view_page;

namespace {

// Writes down each text that differs from all before by more than numbers.
class WrittenPage : public RecordedPage {
 public:
  void open(const std::string& sample) { page.open(corpus::polygon(sample)); }

  // The heading stands in the golden file.
  void look(const std::string& heading, const Pointer& pointer = {}) {
    written += heading + "\n";
    for (const DrawnText& text : RecordedPage::look(pointer)) add(text.text);
    for (const Control& control : controls()) add(control.label);
    add(summary(page.app.state));
  }

  // The robot's card, and what its hint says.
  void look_at_robot(const std::string& heading, std::size_t robot) {
    const Placement& placement = *page.app.state.derived().placement;
    const auto [team, end] = find_robot(placement.teams, robot);
    const Vec2 at = placement.teams[team].robots[end].point.position;
    look(heading + ", pointed at", page.at(at));
    page.click(at);
    look(heading + ", pressed");
    page.press({"Escape"});
  }

  std::string written;

 private:
  void add(const std::string& text) {
    for (std::size_t at = 0, next = 0; at < text.size(); at = next) {
      next = std::min(text.find('\n', at), text.size() - 1) + 1;
      std::string line = text.substr(at, next - at);
      if (line.ends_with('\n')) line.pop_back();
      const std::string kind = testing::without_numbers(line);
      if (!kind.empty() && known_.insert(kind).second) written += "    " + line + "\n";
    }
  }

  std::set<std::string> known_;
};

}  // namespace

TEST_CASE("the page writes what it wrote", "[view][words][expected]") {
  WrittenPage page;
  page.open("comb");
  set(page.page, "min_ratio", "0.1");
  set(page.page, "teams", "70");
  page.look("Many teams");
  page.page.open(document(l_shape));
  page.look("An L");
  for (std::size_t i = 0; i < drawer_count; ++i)
    give(page.state(), SetDrawerOpen{static_cast<Drawer>(i), true});
  page.look("All drawers");
  page.look_at_robot("A robot", 1);
  for (const std::size_t failing : {0u, 3u}) {
    give(page.state(), Fail{failing});
    page.look_at_robot("While robot " + std::to_string(failing + 1) + " fails", 2);
    give(page.state(), Fail{});
  }
  page.open("guitar");
  give(page.state(), Compare{Method::circle});
  set(page.page, "com_radius", "20");
  page.look("A comparison with a C uncertainty");
  give(page.state(), Compare{});
  set(page.page, "capacity", "14");
  set(page.page, "slope", "8%");
  set(page.page, "com_height", "500");
  page.look("A slope, a height and a capacity");
  set(page.page, "slope", "30%");
  give(page.state(), Fail{0});
  page.look_at_robot("While robot 1 fails on a steep slope", 2);
  give(page.state(), Fail{});
  page.open("guitar");
  give(page.state(), SetMethod{Method::given});
  page.look("By hand");
  page.look_at_robot("A robot by hand", 0);
  give(page.state(), SetMethod{Method::balanced});
  page.look("Balanced");
  page.look_at_robot("A balanced robot", 0);
  page.open("dodecagon");
  set(page.page, "teams", "max");
  page.look("Twelve corners, all teams");

  for (const Method method : {Method::area, Method::balanced}) {
    page.open("thesis-sample-centroid");
    page.walk(method, [&](std::uint32_t step) {
      page.look("Step " + std::to_string(step + 1) + ", " + std::string(name(method)));
    });
  }

  const std::filesystem::path path =
      std::filesystem::path(EVENLIFT_TESTS_DIR) / "expected" / "written.txt";
  if (std::getenv("EVENLIFT_UPDATE_EXPECTED") != nullptr) corpus::write_file(path, page.written);
  CHECK(page.written == corpus::read_file(path));
}

TEST_CASE("the key of the heat map has the colours of its bands", "[view]") {
  const Theme& theme = view::theme(AppState{});
  CHECK(heat_colour(theme, 0).packed() == theme.heat[0].packed());
  for (std::size_t level = 0; level < std::size(heat_levels); ++level)
    CHECK(heat_colour(theme, heat_levels[level]).packed() == theme.heat[level + 1].packed());
  CHECK(heat_colour(theme, std::numeric_limits<double>::infinity()).packed() ==
        theme.heat[std::size(heat_levels) + 1].packed());
}

TEST_CASE("a text that is cut ends with whole letters", "[view][words]") {
  const Page page;
  const std::string text = "\u00e4\u00b0\u00b7\u00e4\u00b0\u00b7";
  const float whole = text_size(Face::label, text).x;
  for (float width = 0; width < whole; width += 1) {
    const std::string cut = cut_off(Face::label, text, width);
    CHECK(cut.ends_with("\u2026"));
    CHECK((cut.size() - 3) % 2 == 0);  // each letter has two bytes
  }
  CHECK(cut_off(Face::label, text, whole) == text);
}

TEST_CASE("points snap to the horizontals and verticals through both neighbours", "[view]") {
  Page page;
  give(page.app.state, SetSnap{Snap{.axis = true}});
  const double near = 3 / page.app.state.view.camera.scale;
  const Vec2 before(100, 100), after(200, 50);
  const auto at = [&](const Vec2& to) { return snapped(page.app.state, to, before, after); };
  CHECK(at({100 + near, 75}).x == 100);
  CHECK(at({200 - near, 75}).x == 200);
  CHECK(at({150, 100 - near}).y == 100);
  CHECK(at({150, 50 + near}).y == 50);
}

TEST_CASE("the card of a team's robot tells its load and that of the other end", "[view]") {
  Page page(asset(EVENLIFT_ASSETS_DIR "/polygons/thesis-sample.txt"));
  const Placement& placement = *page.app.state.derived().placement;
  const std::vector<LoadRange>& loads = shown_report(page.app.state).loads;
  for (std::uint32_t robot = 0; robot < 6; ++robot) {
    const auto [team, end] = find_robot(placement.teams, robot);
    const Explanation card = explain(
        page.app.state, {Pick::Kind::robot, static_cast<std::uint32_t>(team), static_cast<int>(end),
                         placement.teams[team].robots[end].point.position});
    const auto told = [&](const std::string& label) {
      for (const auto& row : card.rows)
        if (row.label == label) return std::stod(row.value);
      return 0.0;
    };
    CHECK(told("It carries") == Approx(loads[robot].greatest).margin(0.051));
    CHECK(told("The other end carries") == Approx(loads[robot ^ 1u].greatest).margin(0.051));
  }
  CHECK(loads[3].greatest > loads[2].greatest + 1);
}
