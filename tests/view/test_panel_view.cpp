// The panel: the answer, three controls, the loads, and drawers; and what explains itself.

#include <map>
#include <set>
#include <string>

#include "evenlift/plane.h"
#include "kit/catch.h"
#include "panels/summary.h"
#include "tools/picture_marks.h"
#include "ui/controls.h"
#include "view/view_page.h"

using namespace evenlift;
using namespace evenlift::view;
using namespace view_page;

namespace {

const char* const drawers[] = {"Object", "Robots", "Carrying", "Show", "Compare"};

// Cards get their size from the last frame.
void settle_cards(Page& page) {
  for (int i = 0; i < 3; ++i) page.frame();
}

const Control& shown_control(const std::string& name) {
  const auto& all = controls();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Control& c) { return c.name == name; });
  INFO(name);
  REQUIRE(found != all.end());
  return *found;
}

// What each closed drawer says.
std::map<std::string, std::string> lines(Page& page) {
  settle_cards(page);
  std::map<std::string, std::string> said;
  for (const char* drawer : drawers) {
    const std::string label = shown_control(drawer).label;
    said[drawer] = label == drawer ? "" : label.substr(std::string(drawer).size() + 2);
  }
  return said;
}

std::set<std::string> drawn_texts(Page& page) {
  std::vector<DrawnText> drawn;
  record_texts(&drawn);
  page.frame();
  record_texts(nullptr);
  std::set<std::string> texts;
  for (const DrawnText& each : drawn) texts.insert(each.text);
  return texts;
}

}  // namespace

TEST_CASE("the answer, three controls and four loads are above the drawers, all at 800 pixels",
          "[view][panel]") {
  Page page;
  page.app.state.session.screen.height = 800;
  settle_cards(page);
  double above = shown_control("failures").place.bottom;
  for (const char* name : {"methods", "teams", "weight", "Team 1", "Object", "Robots", "Carrying",
                           "Show", "Compare"}) {
    INFO(name);
    CHECK(shown_control(name).place.top >= above);
    above = shown_control(name).place.bottom - 1;
  }
  CHECK(above < 784);
  CHECK(shown_control("Object").place.top - shown_control("Team 1").place.top >= 4 * 28);
  // However many robots there are, and whatever the result, the drawers stay where they are.
  const double at = shown_control("Object").place.top;
  for (const char* teams : {"1", "4", "9", "max"}) {
    set(page, "teams", teams);
    settle_cards(page);
    CHECK(shown_control("Object").place.top == at);
  }
}

TEST_CASE("a closed drawer says what differs from the default", "[view][panel]") {
  Page page;
  for (const auto& [drawer, said] : lines(page)) CHECK(said == "");
  struct Changed {
    const char *name, *text, *drawer, *said, *usual;
  };
  for (const Changed& each : {
           Changed{"com", "200,100", "Object", "C at (200.0, 100.0)", "centroid"},
           Changed{"com_radius", "3", "Object", "C uncertainty 3", "0"},
           Changed{"com_height", "70", "Object", "Height of C 70", "0"},
           Changed{"unit", "mm", "Object", "mm, kg", "none"},
           Changed{"cargo", "50,50:20", "Object", "cargo 20\u00A0kg", "none"},
           Changed{"capacity", "40", "Robots", "A robot carries 40\u00A0kg", "none"},
           Changed{"min_ratio", "0.5", "Robots", "Min. load ratio 0.5", "0.8"},
           Changed{"robot_radius", "4", "Robots", "Radius 4", "0"},
           Changed{"no_go", "2", "Robots", "No-go edges 2", "none"},
           Changed{"positions", "range", "Robots", "Anywhere in the range", "best"},
           Changed{"slope", "0.08", "Carrying", "Slope 8\u00A0%", "0"},
           Changed{"acceleration", "0.2", "Carrying", "Braked at 0.2\u00A0g", "0"},
           Changed{"uneven", "2", "Carrying", "Uneven by 2", "0"},
           Changed{"extra", "50", "Carrying", "Another load 50\u00A0kg", "none"},
       }) {
    INFO(each.name);
    set(page, each.name, each.text);
    for (const auto& [drawer, said] : lines(page))
      CHECK(said == (drawer == each.drawer ? each.said : ""));
    set(page, each.name, each.usual);
  }
  give(page.app.state, Compare{Method::circle});
  CHECK(lines(page)["Compare"] == "Circle");
}

TEST_CASE("the height of C stands beside the slope, which needs it", "[view][panel]") {
  Page page;
  give(page.app.state, SetDrawerOpen{Drawer::carrying, true});
  settle_cards(page);
  CHECK(shown_control("com height").place.top > shown_control("slope").place.top);
  CHECK(shown_control("com height").place.bottom < shown_control("acceleration").place.top);
}

TEST_CASE("the turns are offered only while there are any", "[view][panel]") {
  for (const auto& path : assets()) {
    Page page(asset(path));
    give(page.app.state, SetDrawerOpen{Drawer::show, true});
    settle_cards(page);
    const Closure& closure = page.app.state.derived().placement->closure;
    const auto offered = [](const char* name) {
      const auto& all = controls();
      return std::any_of(all.begin(), all.end(), [&](const Control& c) { return c.name == name; });
    };
    INFO(path.stem().string());
    CHECK(offered("Clockwise") == closure.clockwise.exists);
    CHECK(offered("Counter-clockwise") == closure.counterclockwise.exists);
  }
}

TEST_CASE("the verdict has three lines, and all of them at a press", "[view][panel]") {
  Page page;
  give(page.app.state, PlaceYourself{});
  settle_cards(page);
  const double height = shown_control("whole verdict").place.height(),
               failures = shown_control("failures").place.top;
  give(page.app.state, SetSectionOpen{&View::whole_verdict, true});
  settle_cards(page);
  CHECK(shown_control("whole verdict").place.height() > height + 20);
  CHECK(shown_control("failures").place.top > failures + 20);
  give(page.app.state, SetSectionOpen{&View::whole_verdict, false});
  for (const char* teams : {"1", "3", "max"}) {
    give(page.app.state, SetMethod{Method::area});
    set(page, "teams", teams);
    settle_cards(page);
    CHECK(shown_control("failures").place.top == failures);
  }
}

TEST_CASE("the worst news is whole in the three lines of the verdict", "[view][panel]") {
  for (const auto& path : assets()) {
    Page page(asset(path));
    give(page.app.state, PlaceYourself{});
    give(page.app.state, RemoveRobot{0});
    give(page.app.state, RemoveRobot{0});  // two robots: it falls, or tips over their line
    settle_cards(page);
    const std::string headline = verdict(page.app.state, Words::in_panel).headline;
    INFO(path.stem().string() << ": " << headline);
    std::vector<DrawnText> drawn;
    record_texts(&drawn);
    page.frame();
    record_texts(nullptr);
    CHECK(std::none_of(drawn.begin(), drawn.end(), [&](const DrawnText& each) {
      return each.text == headline && !each.has_room;
    }));
  }
}

TEST_CASE("every mark of the picture explains itself by a key, one after another",
          "[view][panel][marks]") {
  Page page(asset(EVENLIFT_ASSETS_DIR "/polygons/guitar.txt"));
  give(page.app.state, PlaceYourself{});
  page.frame();
  const std::vector<PictureMark> marks = marks_in_picture(page.app.state);
  REQUIRE(marks.size() >= 6);
  for (const PictureMark mark : marks) {
    page.press({"/"});
    CHECK(drawn_texts(page).contains(mark_in_words(page.app.state, mark)));
  }
  page.press({"/"});
  CHECK_FALSE(page.app.state.view.explained);
  page.press({"/"});
  page.press({"Escape"});
  CHECK_FALSE(page.app.state.view.explained);
}

TEST_CASE("dark green is explained only if the lifting base goes beyond the object",
          "[view][panel][marks]") {
  std::size_t with = 0, without = 0;
  for (const auto& path : assets()) {
    Page page(asset(path));
    const Placement& placement = *page.app.state.derived().placement;
    if (!placement.loads) continue;
    const std::vector<PictureMark> marks = marks_in_picture(page.app.state);
    const bool told =
        std::find(marks.begin(), marks.end(), PictureMark::base_beyond) != marks.end();
    // By a grid of points.
    const Box box = bounding_box(placement.lifting_base);
    std::size_t beyond = 0;
    constexpr int steps = 150;
    for (int i = 0; i < steps; ++i)
      for (int j = 0; j < steps; ++j) {
        const Vec2 size = box.high - box.low,
                   at = box.low + Vec2((i + 0.5) / steps * size.x, (j + 0.5) / steps * size.y);
        if (inside(placement.lifting_base, at) && !inside(placement.vertices(), at)) ++beyond;
      }
    INFO(path.stem().string() << ", " << beyond << " of " << steps * steps << " points");
    if (beyond == 0) CHECK_FALSE(told);
    if (beyond > steps * steps / 50 && placement.object.holes().empty()) CHECK(told);
    (told ? with : without) += 1;
  }
  CHECK((with > 10 && without > 10));
}

TEST_CASE("a mark explains itself where the pointer rests", "[view][panel][marks]") {
  Page page(asset(EVENLIFT_ASSETS_DIR "/polygons/guitar.txt"));
  page.frame();
  AppState& state = page.app.state;
  const Placement& placement = *state.derived().placement;
  const auto rests = [&](const Vec2& on_screen, PictureMark mark) {
    ImGui::GetIO().MousePos =
        ImVec2(static_cast<float>(on_screen.x), static_cast<float>(on_screen.y));
    state.session.screen.asking = false;
    CHECK_FALSE(drawn_texts(page).contains(mark_in_words(page.app.state, mark)));
    state.session.screen.asking = true;
    CHECK(drawn_texts(page).contains(mark_in_words(page.app.state, mark)));
  };
  const auto at = [&](const Vec2& world) { return state.view.camera.to_screen(world); };
  rests(at(placement.teams[0].robots[0].point.position), PictureMark::robots);
  rests(at(placement.centre_of_mass), PictureMark::centre);
  const Vec2 slide = *placement.closure.translation;
  rests(at(placement.centre_of_mass) + 40 * Vec2(slide.x, -slide.y), PictureMark::slide);
  bool green = false, dark = false, blue = false;
  for (double y = 70; y < 700; y += 5)
    for (double x = 20; x < 880; x += 5) {
      const Vec2 world = state.view.camera.to_world({x, y});
      const bool in_base = inside(placement.lifting_base, world),
                 on = inside(placement.vertices(), world);
      const auto is_clear = [&](const Vec2& from) { return length(at(from) - Vec2(x, y)) > 80; };
      bool clear = is_clear(placement.centre_of_mass);
      for (const LiftingPoint& robot : lifting_points(placement.teams))
        clear = clear && is_clear(robot.position);
      if (!clear) continue;
      if (in_base && on && !green) rests({x, y}, PictureMark::base), green = true;
      if (in_base && !on && !dark) rests({x, y}, PictureMark::base_beyond), dark = true;
      if (!in_base && inside(placement.closure.counterclockwise.clipped, world) && !blue)
        rests({x, y}, PictureMark::counterclockwise), blue = true;
    }
  CHECK((green && blue));
}

TEST_CASE("a robot's card covers no robot and not C, if there is room for that",
          "[view][panel][slow]") {
  std::size_t cards = 0, clear = 0;
  for (const auto& path : assets()) {
    Page page(asset(path));
    AppState& state = page.app.state;
    give(state, SetCanvas{1440, 900, 1});
    settle_cards(page);
    Points marks{state.derived().placement->centre_of_mass};
    const std::vector<LiftingPoint> robots = lifting_points(state.derived().placement->teams);
    for (const LiftingPoint& robot : robots) marks.push_back(robot.position);
    const auto is_clear = [&](const Rect& rect, double reach) {
      const Rect near{rect.left - reach, rect.top - reach, rect.right + reach, rect.bottom + reach};
      return std::none_of(marks.begin(), marks.end(), [&](const Vec2& mark) {
        return near.contains(state.view.camera.to_screen(mark));
      });
    };
    for (std::size_t i = 0; i < robots.size(); ++i) {
      const Pick robot{Pick::Kind::robot, i / 2, static_cast<int>(i % 2), robots[i].position};
      give(state, Explain{robot});
      settle_cards(page);
      const Rect card = shown_control("close explanation").window, free = layout(state).free,
                 tools = layout(state).tools;
      bool has_room = false;
      for (double y = free.top + 16; y + 332 <= free.bottom - 16; y += 24)
        for (double x = free.left + 16; x + card.width() <= free.right - 16; x += 24)
          if (x >= tools.right || y + 332 <= tools.top)
            has_room = has_room || is_clear({x, y, x + card.width(), y + 332}, 16);
      INFO(path.stem().string() << ", robot " << i + 1);
      if (has_room) CHECK(is_clear(card, 0));
      ++cards;
      clear += has_room ? 1 : 0;
    }
  }
  CHECK(clear > cards * 9 / 10);
}

TEST_CASE("a notice with its button does not move the picture on a wide screen", "[view][panel]") {
  Page page;
  give(page.app.state, PlaceYourself{});
  give(page.app.state, ShowNotice{});
  settle_cards(page);
  const Camera before = page.app.state.view.camera;
  give(page.app.state, ShowNotice{{Notice::Kind::info, "Robot 3 is taken away.", "Bring it back"}});
  settle_cards(page);
  CHECK(page.app.state.view.camera.scale == before.scale);
  CHECK(page.app.state.view.camera.centre == before.centre);
  CHECK(page.app.state.view.camera.anchor == before.anchor);
}
