// The brush, undo, and no-go parts that follow the vertices.
#include <string>

#include "evenlift/placed_robots.h"
#include "evenlift/settings.h"
#include "evenlift/stands.h"
#include "kit/catch.h"
#include "marks/marks.h"
#include "state/derived.h"
#include "state/method.h"
#include "tools/drawing.h"
#include "view/view_page.h"

using namespace evenlift;
using namespace evenlift::view;
using namespace view_page;

namespace {

std::string marks(const Page& page) { return no_go_text(settings(page.app.state).no_go); }

void give(Page& page, Command command) {
  page.app.commands.push_back(std::move(command));
  page.frame();
}

}  // namespace

TEST_CASE("a click of the brush marks a whole edge, a second one takes the mark away",
          "[view][stands]") {
  Page page;
  page.frame();
  give(page, SetTool{Tool::mark});
  page.click({200, 0});
  CHECK(marks(page) == "1");
  REQUIRE(page.app.state.derived().placement->stands);
  CHECK(page.app.state.derived().placement->stands->usable(0).empty());
  page.click({200, 0});
  CHECK(marks(page) == "none");
  CHECK_FALSE(page.app.state.derived().placement->stands);
}

TEST_CASE("a drag of the brush marks what it passes and erases marks, each as one step of undo",
          "[view][stands]") {
  Page page;
  page.frame();
  give(page, SetTool{Tool::mark});
  page.drag({100, 0}, {300, 0});
  const std::vector<EdgePart> marked = settings(page.app.state).no_go;
  REQUIRE(marked.size() == 1);
  CHECK(marked[0].edge == 0);
  CHECK(marked[0].from == Approx(0.25).margin(0.06));
  CHECK(marked[0].to == Approx(0.75).margin(0.06));
  // A stroke that begins on a no-go edge erases.
  page.drag({200, 0}, {250, 0});
  CHECK(settings(page.app.state).no_go.size() == 2);
  give(page, Undo{});
  CHECK(settings(page.app.state).no_go == marked);
  give(page, Undo{});
  CHECK(marks(page) == "none");
  give(page, Redo{});
  CHECK(settings(page.app.state).no_go == marked);
}

TEST_CASE("off the boundary the brush pans, and marks nothing", "[view][stands]") {
  Page page;
  page.frame();
  give(page, SetTool{Tool::mark});
  const Vec2 before = page.app.state.view.camera.to_screen({0, 0});
  page.drag({80, 80}, {120, 80});
  CHECK(marks(page) == "none");
  CHECK(page.app.state.view.camera.to_screen({0, 0}) != before);
}

TEST_CASE("marks stay where they are if a vertex is added or removed", "[view][stands]") {
  Page page;
  page.frame();
  Settings changed = settings(page.app.state);
  changed.no_go = {{0, 0.25, 0.75}, {3, 0, 1}};
  give(page, SetSettings{changed});
  give(page, InsertVertex{0, {200, 0}});
  CHECK(marks(page) == "1:0.5-1,2:0-0.5,5");
  give(page, RemoveVertex{1});
  CHECK(marks(page) == "1:0.25-0.75,4");
  give(page, RemoveVertex{0});  // joins edges 6 and 1
  CHECK(settings(page.app.state).no_go.size() == 2);
  CHECK(settings(page.app.state).no_go.front().edge == 2);
  CHECK(settings(page.app.state).no_go.back().edge == 4);
}

TEST_CASE("a method that looks for no places takes robots as points", "[view][stands]") {
  Page page;
  Settings changed = settings(page.app.state);
  changed.robot.radius = 10;
  changed.no_go = {{0, 0, 1}};
  const Settings distributed = with_method(changed, Method::distributed, 3);
  CHECK(distributed.robot == evenlift::RobotSize{});
  CHECK(distributed.no_go.empty());
  CHECK(with_method(changed, Method::circle, 3).robot == changed.robot);
  CHECK(with_method(changed, Method::balanced, 3).no_go == changed.no_go);
}

TEST_CASE(
    "the robots' size, no-go edges and the goal come back after methods that have no use for them",
    "[view][stands]") {
  Page page;
  const auto now = [&]() -> const Settings& { return settings(page.app.state); };
  Settings changed = now();
  changed.robot.radius = 10;
  changed.no_go = {{2, 0, 1}};
  changed.goal = Goal::hold;
  give(page, SetSettings{changed});
  for (const Method method : {Method::distributed, Method::random}) {
    give(page, SetMethod{method});
    CHECK(now().robot == evenlift::RobotSize{});
    CHECK_FALSE(page.app.state.derived().refusal);
  }
  give(page, InsertVertex{0, {100, 0}});  // the marked edge gets the next number
  give(page, SetMethod{Method::balanced});
  CHECK(now().robot.radius == 10);
  REQUIRE(now().no_go.size() == 1);
  CHECK(now().no_go[0].edge == 3);
  give(page, SetMethod{Method::area});
  CHECK(now().robot.radius == 10);
  CHECK(now().goal == Goal::hold);
  give(page, SetMethod{Method::balanced});
  give(page, SetMethod{Method::distance});
  CHECK(now().goal == Goal::hold);
  give(page, SetMethod{Method::random});
  Settings otherwise = now();  // by a script
  otherwise.method = Method::area;
  give(page, SetSettings{otherwise});
  give(page, SetMethod{Method::circle});
  CHECK(now().robot == evenlift::RobotSize{});
  give(page, SetSettings{changed});
  give(page, SetMethod{Method::random});
  Result<Opened> again = opened(Document{page.app.state.work.document()});
  REQUIRE(again);
  give(page, OpenDocument{std::move(again).value()});
  give(page, SetMethod{Method::area});
  CHECK(now().robot == evenlift::RobotSize{});  // it belonged to another object
}

TEST_CASE("a robot's body that is smaller than its mark is not drawn", "[view][stands]") {
  Page page;
  Settings changed = settings(page.app.state);
  changed.robot.radius = 8;
  give(page, SetSettings{changed});
  const AppState& state = page.app.state;
  const Layout places = layout(state);
  const Scene scene;
  const auto vertices = [&](double radius_in_pixels) {
    Camera camera = state.view.camera;
    camera.scale = radius_in_pixels / 8;
    ImDrawList list(ImGui::GetDrawListSharedData());
    list._ResetForNewFrame();
    const Rect window{-1e4, -1e4, 1e4, 1e4};
    const CanvasView view{state, theme(state), places, &*state.derived().placement,
                          scene, camera,       window, false};
    draw_stands(Painter(list, camera, window), view);
    return list.VtxBuffer.Size;
  };
  const double mark = static_cast<double>(mark_radius(state.derived().placement->teams));
  CHECK(vertices(mark - 1) < 200);  // the unusable part of the boundary
  CHECK(vertices(mark + 1) > vertices(mark - 1) + 6 * 64);
}

TEST_CASE("every frame with robots of a size can be drawn", "[view][stands][slow]") {
  for (const Method method : {Method::area, Method::balanced}) {
    Page page;
    page.app.state.view.open_drawers.fill(true);
    Settings changed = with_method(settings(page.app.state), method, 3);
    changed.robot = {12, 8, 20, 16, 3};
    changed.no_go = {{1, 0, 0.5}};
    give(page, SetSettings{changed});
    CHECK_FALSE(page.app.state.derived().refusal);
    REQUIRE(page.app.state.derived().placement->stands);
    REQUIRE_FALSE(page.app.state.derived().placement->teams.empty());
    for (const PlacedRobot& robot : placed_robots(*page.app.state.derived().placement))
      CHECK(length(robot.stand - robot.contact) == Approx(20));
    for (int x = 0; x < 400; x += 7) page.frame(page.at({static_cast<double>(x), 0}));
    give(page, SetTool{Tool::mark});
    page.frame(page.at({100, 0}));
  }
}

TEST_CASE("parts of marks are joined, cut and looked up", "[stands]") {
  CHECK(with_part({{2, 0.5, 1}, {0, 0, 0.2}}, {0, 0.1, 0.4}) ==
        std::vector<EdgePart>{{0, 0, 0.4}, {2, 0.5, 1}});
  CHECK(with_part({{0, 0.1, 0.9}}, {0, 0.2, 0.3}) == std::vector<EdgePart>{{0, 0.1, 0.9}});
  CHECK(without_part({{0, 0, 1}}, {0, 0.25, 0.5}) ==
        std::vector<EdgePart>{{0, 0, 0.25}, {0, 0.5, 1}});
  CHECK(without_part({{0, 0, 1}}, {0, 0, 1}).empty());
  // Marks beside the part stay as they are.
  CHECK(without_part({{0, 0, 0.2}, {0, 0.8, 1}}, {0, 0.4, 0.6}) ==
        std::vector<EdgePart>{{0, 0, 0.2}, {0, 0.8, 1}});
  CHECK(is_marked({{1, 0.2, 0.4}}, 1, 0.4));
  CHECK_FALSE(is_marked({{1, 0.2, 0.4}}, 1, 0.5));
  CHECK_FALSE(is_marked({{1, 0.2, 0.4}}, 0, 0.3));
}
