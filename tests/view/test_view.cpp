#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "actions/actions.h"
#include "app/app.h"
#include "app/opening.h"
#include "app/update.h"
#include "canvas/canvas.h"
#include "edits/undo.h"
#include "evenlift/link.h"
#include "evenlift/numbers.h"
#include "evenlift/output/json.h"
#include "evenlift/plane.h"
#include "evenlift/stability.h"
#include "kit/catch.h"
#include "marks/marks.h"
#include "panels/summary.h"
#include "picture/canvas_view.h"
#include "picture/labels.h"
#include "picture/scene.h"
#include "picture/triangulate.h"
#include "state/derived.h"
#include "state/layout.h"
#include "state/work.h"
#include "tools/drawing.h"
#include "tools/pick.h"
#include "ui/controls.h"
#include "ui/theme.h"
#include "view/view_page.h"
#include "walkthrough/walkthrough.h"

using namespace evenlift;
using namespace evenlift::view;
using namespace view_page;

namespace {

double area_of(const Points& polygon, const std::vector<std::uint32_t>& triangles) {
  double area = 0;
  for (std::size_t i = 0; i < triangles.size(); i += 3) {
    const Vec2 &a = polygon[triangles[i]], &b = polygon[triangles[i + 1]],
               &c = polygon[triangles[i + 2]];
    area += std::abs(cross(b - a, c - a)) / 2;
  }
  return area;
}

double area_of(const Points& polygon) {
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    twice +=
        cross(polygon[i] - polygon[0], polygon[i + 1 == polygon.size() ? 0 : i + 1] - polygon[0]);
  }
  return std::abs(twice) / 2;
}

}  // namespace

TEST_CASE("every panel draws for every sample on every kind of screen, and then comes to rest",
          "[view][slow]") {
  Page page;
  for (const auto& path : assets()) {
    INFO(path.string());
    page.open(document(asset(path)));
    for (const auto& [width, height] : {std::pair{1280, 800}, {844, 390}, {390, 844}}) {
      for (const bool embed : {false, true}) {
        Screen& screen = page.app.state.session.screen;
        screen.width = width;
        screen.height = height;
        screen.embed = embed;
        screen.dark = !screen.dark;
        for (int i = 0; i < 4; ++i) page.frame();
        page.frame();
        CHECK_FALSE(settle(page.app));  // nothing needs another frame
        CHECK(page.app.commands.empty());
        // The drawing and the cards have separate lists. A phone on its side has no card of tools.
        const ImDrawData& drawn = *ImGui::GetDrawData();
        CHECK(drawn.CmdListsCount >= (embed ? 2 : 3));
        for (int list = 0; list < drawn.CmdListsCount; ++list)
          CHECK(drawn.CmdLists[list]->VtxBuffer.Size > 0);
        CHECK(drawn.TotalVtxCount > (embed ? 500 : 2000));
      }
    }
  }
}

TEST_CASE("triangles fill a polygon exactly", "[view]") {
  for (const auto& path : assets()) {
    INFO(path.string());
    const Points polygon = document(asset(path)).vertices;
    const auto triangles = triangulate(polygon);
    CHECK(triangles.size() == 3 * (polygon.size() - 2));
    CHECK(area_of(polygon, triangles) == Approx(area_of(polygon)).epsilon(1e-9));
  }
}

TEST_CASE("triangulation of a large star and of nonsense ends soon", "[view]") {
  Points star;
  for (int i = 0; i < 30000; ++i) {
    const double a = 2 * 3.14159265358979 * i / 30000, r = i % 2 ? 100 : 99.9;
    star.emplace_back(r * std::cos(a), r * std::sin(a));
  }
  CHECK(area_of(star, triangulate(star)) == Approx(area_of(star)).epsilon(1e-6));
  CHECK(triangulate({{0, 0}, {2, 2}, {2, 0}, {0, 2}}).size() == 6);
  CHECK(triangulate({{1, 1}, {1, 1}, {1, 1}, {1, 1}, {1, 1}}).size() == 9);
  CHECK(triangulate({}).empty());
}

TEST_CASE("a drag of a vertex is one step of undo", "[view]") {
  Page page;
  page.frame();
  const Points before = page.app.state.work.document().vertices;
  page.drag({400, 150}, {430, 190});
  const AppState& state = page.app.state;
  CHECK(length(state.work.document().vertices[2] - Vec2(430, 190)) < 2);
  CHECK(state.view.selected == 2u);
  CHECK_FALSE(state.work.edit_open);
  page.press({"z", true});
  CHECK(state.work.document().vertices == before);
  CHECK_FALSE(state.work.history.can_undo());
  page.press({"z", true, true});
  CHECK(length(state.work.document().vertices[2] - Vec2(430, 190)) < 2);
}

TEST_CASE("a refused polygon keeps the last good placement, link and reason", "[view]") {
  Page page;
  page.frame();
  const AppState& state = page.app.state;
  Pointer held = page.at({400, 150});
  page.frame(held);
  held.pressed = held.down = true;
  page.frame(held);
  held.pressed = false;
  // The polygon is valid at first; then its edges cross.
  std::string last_link, last_json;
  for (int i = 1; i <= 12; ++i) {
    held.at =
        state.view.camera.to_screen(Vec2(400, 150) + (Vec2(75, 350) - Vec2(400, 150)) * i / 12);
    held.moved = 4.0 * i;
    page.frame(held);
    if (state.derived().refusal) continue;
    last_link = encode_link(state.work.document()).value();
    last_json = placement_json(place(state.work.document()).value(), true);
  }
  held.down = false;
  held.released = true;
  page.frame(held);
  REQUIRE_FALSE(last_link.empty());
  REQUIRE(state.derived().refusal);
  CHECK(state.derived().refusal->code == ErrorCode::edges_cross);
  CHECK(state.derived().refusal->place.kind == Place::Kind::edge);
  CHECK(verdict(state).mood == Mood::refused);
  CHECK(verdict(state).headline.find("cross") != std::string::npos);
  CHECK(encode_link(last_good(state)).value() == last_link);
  REQUIRE(state.derived().placement);
  CHECK(placement_json(*state.derived().placement, true) == last_json);
  for (int i = 0; i < 3; ++i) page.frame();
  page.press({"z", true});
  CHECK_FALSE(state.derived().refusal);
  CHECK(verdict(state).mood != Mood::refused);
}

TEST_CASE(
    "a double press on an edge adds a vertex that can be dragged at once, Delete takes it away",
    "[view]") {
  Page page;
  page.frame();
  Pointer p = page.at({200, 0});
  p.pressed = p.down = p.double_pressed = true;
  page.frame(p);
  const AppState& state = page.app.state;
  REQUIRE(state.work.document().vertices.size() == 7);
  CHECK(state.view.held.kind == Pick::Kind::vertex);
  CHECK(state.view.held.index == 1);
  p.pressed = p.double_pressed = p.down = false;
  page.frame(p);
  page.press({"Delete"});
  CHECK(state.work.document().vertices.size() == 6);
}

TEST_CASE("the last three vertices stay", "[view]") {
  Page page("(0,0)\n(10,0)\n(0,10)\n");
  page.app.commands = {SelectVertex{0}, RemoveVertex{0}};
  settle(page.app);
  CHECK(page.app.state.work.document().vertices.size() == 3);
  CHECK_FALSE(page.app.state.session.notice.text.empty());
}

TEST_CASE("the centre of mass can be dragged and given back", "[view]") {
  Page page;
  page.frame();
  const Vec2 centroid = page.app.state.derived().placement->centre_of_mass;
  page.drag(centroid, centroid + Vec2(20, 10));
  REQUIRE(page.app.state.work.document().centre_of_mass);
  page.app.commands = {ReleaseCentre{}};
  settle(page.app);
  CHECK(page.app.state.derived().placement->centre_of_mass == centroid);
}

TEST_CASE("a centre of mass on a vertex is what is taken hold of there", "[view]") {
  Page page("CoM:(150,150)\n" + l_shape);
  page.frame();
  const AppState& state = page.app.state;
  const Vec2 there = state.view.camera.to_screen({150, 150});
  CHECK(pick(state, there).kind == Pick::Kind::centre);
  CHECK(pick_to_hold(state, there).kind == Pick::Kind::centre);
}

TEST_CASE("a vertex that does not exist cannot be selected", "[view]") {
  Page page;
  give(page.app.state, SelectVertex{5});
  CHECK(page.app.state.view.selected == 5u);
  give(page.app.state, SelectVertex{6});
  CHECK_FALSE(page.app.state.view.selected);
}

TEST_CASE("a unit, a capacity or a C uncertainty takes effect by itself, as one step of undo",
          "[view]") {
  const std::vector<void (*)(Shown&)> edits{[](Shown& s) { s.units.length = LengthUnit::mm; },
                                            [](Shown& s) { s.units.weight = WeightUnit::t; },
                                            [](Shown& s) { s.capacity = 20; },
                                            [](Shown& s) { s.com_radius = 5; }};
  for (std::size_t i = 0; i < edits.size(); ++i) {
    INFO("edit " << i);
    Page page;
    AppState& state = page.app.state;
    Document edited = state.work.document();
    edits[i](edited.shown);
    CHECK_FALSE(edit_by_script(state, edited));
    CHECK(state.work.document().shown == edited.shown);
    CHECK(state.work.history.depth() == 1);
    CHECK_FALSE(edit_by_script(state, edited));  // no change, no step
    CHECK(state.work.history.depth() == 1);
  }
}

TEST_CASE("the part of a segment in a rectangle, its edge included", "[view]") {
  const Rect rect{10, 20, 30, 60};
  const auto part = part_within(rect, {0, 40}, {40, 40});
  REQUIRE(part);
  CHECK(part->from == 0.25);
  CHECK(part->to == 0.75);
  const auto whole = part_within(rect, {15, 25}, {15, 50});
  REQUIRE(whole);
  CHECK(whole->from == 0);
  CHECK(whole->to == 1);
  CHECK(part_within(rect, {10, 0}, {10, 100}));        // along the edge
  CHECK(part_within(rect, {20, 30}, {20, 30}));        // a point
  CHECK_FALSE(part_within(rect, {9, 0}, {9, 100}));    // beside it
  CHECK_FALSE(part_within(rect, {0, 0}, {9, 100}));    // ends before it
  CHECK_FALSE(part_within(rect, {0, 50}, {20, 100}));  // passes the corner
}

TEST_CASE("zooming keeps the point under the pointer", "[view]") {
  Camera camera;
  camera.centre = {3, 4};
  camera.anchor = {400, 300};
  camera.scale = 7;
  const Vec2 about(123, 456), world = camera.to_world(about);
  const Camera zoomed = zoom(camera, about, 1.7, 0.1, 1000);
  CHECK(length(zoomed.to_screen(world) - about) < 1e-9);
  CHECK(zoomed.scale == Approx(7 * 1.7));
  CHECK(length(pan(camera, {10, -5}).to_screen(world) - (about + Vec2(10, -5))) < 1e-9);
}

TEST_CASE("dragged coordinates are short decimals within a pixel", "[view]") {
  Camera camera;
  for (const double scale : {0.003, 0.7, 1.0, 3.3, 250.0}) {
    camera.scale = scale;
    const Vec2 p(123.456789123, -0.000123456), rounded = rounded_to_pixels(camera, p);
    CHECK(length(rounded - p) * scale <= 1);
    CHECK(shortest(rounded.x).size() <= 9);
  }
}

TEST_CASE("history gives back whole documents, without limit", "[view]") {
  History history;
  Document now = document(l_shape);
  for (int i = 0; i < 500; ++i) {
    history.record(now);
    now.settings.weight += 1;
  }
  for (int i = 0; i < 500; ++i) now = history.undo(now).document;
  CHECK(now.settings.weight == 100);
  CHECK_FALSE(history.can_undo());
  for (int i = 0; i < 500; ++i) now = history.redo(now).document;
  CHECK(now.settings.weight == 600);
  CHECK(now.vertices == document(l_shape).vertices);
}

TEST_CASE("labels stand clear of each other, of robots and of what covers the drawing", "[view]") {
  std::vector<LabelRequest> requests;
  for (int i = 0; i < 6; ++i)
    requests.push_back({Vec2(200 + 60 * i, 200), Vec2(0, -1), Vec2(58, 20)});
  const Rect window{0, 0, 800, 600}, covered{0, 100, 300, 170};
  Occupied occupied(window);
  occupied.box(covered);
  for (const LabelRequest& request : requests)
    occupied.box(
        {request.robot.x - 15, request.robot.y - 15, request.robot.x + 15, request.robot.y + 15});
  const auto places = place_labels(requests, occupied, 15, 0);
  const auto apart = [](const Rect& a, const Rect& b) {
    return a.right <= b.left || b.right <= a.left || a.bottom <= b.top || b.bottom <= a.top;
  };
  // There is room for all.
  REQUIRE(places.size() == requests.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    REQUIRE(places[i]);
    CHECK(apart(*places[i], covered));
    for (std::size_t j = 0; j < i; ++j) CHECK(apart(*places[i], *places[j]));
    for (const LabelRequest& request : requests) {
      const Rect robot{request.robot.x - 15, request.robot.y - 15, request.robot.x + 15,
                       request.robot.y + 15};  // its mark
      CHECK(apart(*places[i], robot));
    }
  }
}

TEST_CASE("a label stands beyond the body of a robot with a size", "[view]") {
  const Vec2 stand(300, 300);
  constexpr double radius = 70;
  const std::vector<LabelRequest> request{{stand, Vec2(0.6, -0.8), Vec2(58, 20), radius + 4}};
  Occupied occupied(Rect{0, 0, 800, 600});
  occupied.disc(stand, radius);
  const auto place = place_labels(request, occupied, 15, 0)[0];
  REQUIRE(place);
  const Vec2 nearest(std::clamp(stand.x, place->left, place->right),
                     std::clamp(stand.y, place->top, place->bottom));
  CHECK(length(nearest - stand) > radius);
  CHECK_FALSE(occupied.is_free({stand.x - 5, stand.y - radius + 4, stand.x + 5, stand.y}));
  CHECK(occupied.is_free({stand.x - radius, stand.y - radius, stand.x - radius + 8,
                          stand.y - radius + 8}));  // the corner of its box
}

TEST_CASE("a label avoids lines, and is left out where that is not possible", "[view]") {
  const Rect window{0, 0, 400, 400};
  const std::vector<LabelRequest> request{{Vec2(200, 200), Vec2(0, -1), Vec2(58, 20)}};
  Occupied occupied(window);
  occupied.line({0, 170}, {400, 170});  // where the label would be
  const auto beside = place_labels(request, occupied, 15, 0);
  REQUIRE(beside[0]);
  CHECK((beside[0]->top > 172 || beside[0]->bottom < 168));
  Occupied full(window);
  for (int y = 0; y < 400; y += 8)
    full.line({0, static_cast<double>(y)}, {400, static_cast<double>(y)});
  CHECK(!place_labels(request, full, 15, 4)[0]);
  CHECK(place_labels(request, full, 15, 1000)[0]);
}

TEST_CASE("texts on lines that cross do not cover each other", "[view]") {
  const auto apart = [](const Rect& a, const Rect& b) {
    return a.right <= b.left || b.right <= a.left || a.bottom <= b.top || b.bottom <= a.top;
  };
  std::vector<Rect> before;
  const Vec2 size(20, 20);
  const Rect first = box_on_line({0, 0}, {200, 200}, size, from_middle, before);
  CHECK(first.middle() == Vec2(100, 100));
  box_on_line({0, 200}, {200, 0}, size, from_middle, before);
  box_on_line({0, 100}, {200, 100}, size, from_middle, before);
  REQUIRE(before.size() == 3);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < i; ++j) CHECK(apart(before[i], before[j]));
  // Without a free place, the first is used.
  for (int i = 0; i < 10; ++i) box_on_line({0, 0}, {30, 0}, size, from_middle, before);
  CHECK(before.back().middle() == Vec2(15, 0));
}

TEST_CASE("the zoom is told against what fits: the polygon with a centre of mass beside it",
          "[view]") {
  Page page;
  page.app.commands = {MoveCentre{Vec2(1500, 100)}, EndEdit{}, FitView{}};
  settle(page.app);
  page.app.commands = {ZoomView{2}};
  settle(page.app);
  page.frame();
  const auto zoom = std::find_if(controls().begin(), controls().end(),
                                 [](const Control& c) { return c.name == "zoom"; });
  REQUIRE(zoom != controls().end());
  CHECK(zoom->label.starts_with("200\u00A0%"));
}

TEST_CASE("the verdict is a sentence", "[view]") {
  Page page;
  const AppState& state = page.app.state;
  CHECK(verdict(state).headline.starts_with("6 robots carry "));
  CHECK(summary(state).find("Team 3 at ") != std::string::npos);
  Settings one = state.work.document().settings;
  one.teams = 1;
  page.app.commands = {SetSettings{one}};
  settle(page.app);
  CHECK(verdict(state).mood == Mood::not_quite);
}

TEST_CASE("no two actions share a key, except in the lesson, while drawing and for a robot",
          "[view]") {
  std::vector<Key> seen;
  for (const Action& a : actions()) {
    for (const Key& key : a.keys) {
      if (key.name.empty()) continue;
      const bool lessons = a.id >= ActionId::step_on && a.id <= ActionId::predict;
      if (lessons && key.name.starts_with("Arrow")) continue;
      // Delete takes the selected vertex, or else the robot with the open card.
      if (a.id == ActionId::remove_robot) continue;
      if (a.id == ActionId::place || a.id == ActionId::take_back || a.id == ActionId::type_edge)
        continue;
      for (const Key& other : seen) {
        CHECK_FALSE(
            (other.name == key.name && other.command == key.command && other.shift == key.shift));
      }
      seen.push_back(key);
    }
  }
  CHECK(seen.size() > 20);
}

TEST_CASE("a wide screen has a panel at the side, a narrow one a sheet that leaves most of it free",
          "[view]") {
  AppState state;
  state.session.screen.width = 390;
  state.session.screen.height = 844;
  CHECK_FALSE(layout(state).wide);
  CHECK(layout(state).panel.top >= 0.53 * 844);
  state.view.sheet = Sheet::half;
  CHECK(layout(state).panel.top >= 0.53 * 844 - 1);
  state.session.screen.width = 1280;
  state.session.screen.height = 800;
  CHECK(layout(state).wide);
  CHECK(layout(state).room.right < layout(state).panel.left);
}

TEST_CASE(
    "on a small screen the verdict's words give way to two pictures, and to the whole in its frame",
    "[view]") {
  Page page;
  AppState& state = page.app.state;
  for (const auto& [width, height] : {std::pair(320.0, 568.0), {390.0, 500.0}}) {
    CAPTURE(width, height);
    state.session.screen.width = width;
    state.session.screen.height = height;
    settle(page.app);
    for (int i = 0; i < 4; ++i) page.frame();  // the sheet measures itself
    CHECK_FALSE(layout(state).brief);
    const double alone = layout(state).room.height();
    state.view.tool = Tool::transform;
    CHECK(layout(state).brief);
    CHECK(layout(state).room.height() >= 70);
    state.view.tool = Tool::parts;
    state.work.second_method = Method::circle;
    CHECK(layout(state).brief);
    CHECK(layout(state).room.height() >= 65);
    state.work.second_method.reset();
    CHECK(layout(state).room.height() == alone);
  }
  state.session.screen.width = 390;
  state.session.screen.height = 844;
  state.work.second_method = Method::circle;
  CHECK_FALSE(layout(state).brief);
}

TEST_CASE(
    "a window over the panel leaves the drawing as it is, and takes its width where the panel is folded",
    "[view]") {
  AppState state;
  state.session.screen.width = 844;
  state.session.screen.height = 390;
  const Layout before = layout(state);
  state.session.screen.window_right = state.session.screen.width - before.panel.left;
  CHECK(layout(state).free == before.free);
  CHECK(layout(state).room == before.room);
  state.view.panel_open = false;
  CHECK(layout(state).free.right == before.free.right);
  state.work.second_method = Method::circle;
  CHECK(layout(state).second.right == before.free.right);
  state.session.screen.window_right = 0;
  CHECK(layout(state).free.right > before.free.right + 200);
}

TEST_CASE("a notice of several lines covers no robot where the view fits", "[view][slow]") {
  const std::string text =
      "The drawing has 3 shapes; the largest is open, with its holes filled. Curves became straight edges that are at "
      "most 0.1 mm away from them, and Open can read it again with other choices.";
  for (const auto& path : assets()) {
    CAPTURE(path.stem().string());
    Page page(asset(path));
    AppState& state = page.app.state;
    for (const auto& [width, height] : {std::pair(320.0, 568.0), {390.0, 844.0}, {1280.0, 800.0}}) {
      state.session.screen.width = width;
      state.session.screen.height = height;
      page.app.commands = {ShowNotice{}, FitView{}};
      settle(page.app);
      page.frame();
      const Rect without = layout(state).room;
      page.app.commands = {ShowNotice{{Notice::Kind::problem, text}}};
      settle(page.app);
      for (int i = 0; i < 4; ++i) page.frame();  // it measures itself
      REQUIRE(state.session.notice_height > 40);
      const Rect place = layout(state).notice;
      for (const LiftingPoint& robot : lifting_points(state.derived().placement->teams)) {
        const Vec2 at = state.view.camera.to_screen(robot.position);
        const bool beside = at.x + 14 <= place.left || at.x - 14 >= place.right;
        CAPTURE(width, at.y, place.bottom, state.session.notice_height,
                layout(state).room.height());
        CHECK((beside || at.y + 14 <= place.bottom - state.session.notice_height));
      }
      page.app.commands = {ShowNotice{}};
      settle(page.app);
      CHECK(layout(state).room == without);
    }
  }
}

TEST_CASE("on a sheet that is pulled up to the top a notice stands at its foot", "[view]") {
  Page page;
  AppState& state = page.app.state;
  state.session.screen.width = 390;
  state.session.screen.height = 844;
  page.app.commands = {ShowNotice{{Notice::Kind::info, "“table.txt” is opened."}}};
  settle(page.app);
  state.view.sheet = Sheet::full;
  for (int i = 0; i < 4; ++i) page.frame();
  CHECK(layout(state).notice.bottom - state.session.notice_height > layout(state).panel.middle().y);
}

TEST_CASE(
    "the way back is shown where nothing of the outline is seen: beside it, or deep inside it",
    "[view]") {
  Page page;
  AppState& state = page.app.state;
  const auto way_back = [&] {
    page.frame();
    page.frame();
    return std::any_of(controls().begin(), controls().end(),
                       [](const Control& c) { return c.name == "show object"; });
  };
  CHECK_FALSE(way_back());
  const Camera fitting = state.view.camera;
  Camera inside = fitting;
  inside.centre = state.derived().placement->centre_of_mass;
  inside.scale *= 500;
  page.app.commands = {SetCamera{inside}};
  settle(page.app);
  CHECK(way_back());
  page.app.commands = {SetCamera{pan(fitting, Vec2(30, 30))}};
  settle(page.app);
  CHECK_FALSE(way_back());
  page.app.commands = {SetCamera{pan(fitting, Vec2(9000, 30))}};
  settle(page.app);
  CHECK(way_back());
  page.app.commands = {FitView{}};
  settle(page.app);
  CHECK_FALSE(way_back());
}

TEST_CASE("what a huge disc covers is found at once, and is what it covers of the window",
          "[view]") {
  const Rect window{0, 0, 800, 600};
  Occupied occupied(window);
  occupied.disc(Vec2(400, 600 + 1e12), 1e12 + 300);  // its top is in the window's middle
  CHECK_FALSE(occupied.is_free({390, 320, 410, 340}));
  CHECK_FALSE(occupied.is_free({10, 320, 30, 340}));
  CHECK(occupied.is_free({390, 200, 410, 220}));
  occupied.disc(Vec2(400, 300), 1e300);
  CHECK_FALSE(occupied.is_free({390, 200, 410, 220}));
}

TEST_CASE("each press of the sheet's handle shows more of it, until it is closed again", "[view]") {
  Page page;
  AppState& state = page.app.state;
  const auto press = [&] {
    page.frame();
    page.frame();  // it has measured itself
    const double top = layout(state).panel.top;
    ask_control(ControlRequest::press, "sheet", "handle", 0);
    page.frame();
    page.frame();
    return top - layout(state).panel.top;
  };
  for (const bool lesson : {false, true}) {
    if (lesson) page.press({"b"});
    CAPTURE(lesson);
    state.session.screen.width = 390;
    state.session.screen.height = 844;
    CHECK(press() > 24);
    CHECK(state.view.sheet == Sheet::half);
    CHECK(press() > 24);
    CHECK(state.view.sheet == Sheet::full);
    CHECK(press() < -24);
    CHECK(state.view.sheet == Sheet::closed);

    state.session.screen.width = 320;  // half is no more than the closed sheet
    state.session.screen.height = 568;
    CHECK(press() > 24);
    CHECK(state.view.sheet == Sheet::full);
    CHECK(press() < -24);
    CHECK(state.view.sheet == Sheet::closed);
  }
}

TEST_CASE(
    "while methods are compared no caption and no tool covers a robot, however narrow the screen",
    "[view][slow]") {
  for (const auto& path : assets()) {
    CAPTURE(path.stem().string());
    Page page(asset(path));
    AppState& state = page.app.state;
    for (const auto& [width, height] : {std::pair(390.0, 844.0), {320.0, 568.0}, {1280.0, 800.0}})
      for (const Sheet sheet : {Sheet::closed, Sheet::half}) {
        state.session.screen.width = width;
        state.session.screen.height = height;
        page.app.commands = {SetSheet{sheet}, Compare{Method::distance}, FitView{}};
        settle(page.app);
        const Layout places = layout(state);
        const auto clear = [&](const Placement& placement, const Rect& window) {
          for (const LiftingPoint& robot : lifting_points(placement.teams)) {
            const Vec2 at = state.view.camera.to_screen(robot.position) +
                            Vec2(window.left - places.first.left, window.top - places.first.top);
            CHECK(at.y - 14 >= window.top + places.caption);
            CHECK(at.y + 14 <= window.bottom);
            CHECK_FALSE(places.tools.contains(at));
          }
        };
        clear(*state.derived().placement, places.first);
        clear(*state.derived().second, places.second);
        page.app.commands = {Compare{}};
        settle(page.app);
      }
  }
}

TEST_CASE("a polygon is drawn by clicks, vertex by vertex, and opens when it is closed", "[view]") {
  Page page;
  page.frame();
  page.press({"d"});
  const Points corners = {{10, 10}, {300, 20}, {280, 200}, {30, 180}};
  for (const Vec2& corner : corners) page.click(corner);
  CHECK(page.app.state.view.drawing.points.size() == 4);
  CHECK(page.app.state.work.document().vertices.size() == 6);  // the old one is still there
  page.press({"Escape"});
  CHECK(page.app.state.view.drawing.points.size() == 3);
  page.press({"z", true, true});
  CHECK(page.app.state.view.drawing.points.size() == 4);
  page.click(corners[0]);
  CHECK(page.app.state.view.tool == Tool::parts);
  REQUIRE(page.app.state.work.document().vertices.size() == 4);
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(length(page.app.state.work.document().vertices[i] - corners[i]) < 2);
  }
  CHECK_FALSE(page.app.state.work.document().centre_of_mass);
  page.press({"z", true});
  CHECK(page.app.state.work.document().vertices.size() == 6);
}

TEST_CASE("the centroid of a chain, and the end of an edge that was typed", "[view]") {
  const auto centroid = centroid_of({{0, 0}, {4, 0}, {4, 2}, {0, 2}});
  REQUIRE(centroid);
  CHECK(length(*centroid - Vec2(2, 1)) < 1e-12);
  CHECK_FALSE(centroid_of({{0, 0}, {1, 1}, {2, 2}}));
  Drawing drawing;
  drawing.points = {{0.1, 0.2}};
  drawing.length = 50;
  drawing.degrees = 90;
  CHECK(typed_end(drawing, {3, 3}) == Vec2(0.1, 50.2));
  drawing.degrees.reset();  // towards the pointer
  CHECK(typed_end(drawing, {0.1 + 3, 0.2 + 4}) == Vec2(30.1, 40.2));
}

TEST_CASE("a drawing whose edges cross does not close, and says why", "[view]") {
  Page page;
  page.frame();
  page.press({"d"});
  for (const Vec2& corner : Points{{0, 0}, {300, 300}, {300, 0}, {0, 300}}) page.click(corner);
  page.press({"Enter"});
  CHECK(page.app.state.view.tool == Tool::draw);
  CHECK(page.app.state.view.drawing.points.size() == 4);
  CHECK(page.app.state.session.notice.text.find("cross") != std::string::npos);
  for (int i = 0; i < 4; ++i)
    page.press({"Escape"});  // vertex by vertex, and the notice with the first
  CHECK(page.app.state.view.drawing.points.empty());
  page.press({"Escape"});
  CHECK(page.app.state.view.tool == Tool::parts);
}

TEST_CASE("crossing edges of a chain are found exactly", "[view]") {
  using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;
  CHECK(crossings({{0, 0}, {4, 0}, {4, 4}, {0, 4}}) == Pairs{});
  CHECK(crossings({{0, 0}, {4, 4}, {4, 0}, {0, 4}}) == Pairs{{0, 2}});
  CHECK(crossings({{0, 0}, {4, 0}, {2, 0}}) == Pairs{{0, 1}});          // folds back
  CHECK(crossings({{0, 0}, {4, 0}, {4, 4}, {2, 0}}) == Pairs{{0, 2}});  // touches
  CHECK(crossings({{0, 0}, {4, 0}, {4, 4}, {0, 0}}) == Pairs{});        // closed
  CHECK(crossings({{0, 0}, {2, 0}, {4, 0}}) == Pairs{});                // straight on
}

TEST_CASE("what is dragged and drawn snaps to the dots, or level with its neighbours", "[view]") {
  Page page;
  page.frame();
  page.press({"n"});
  page.drag({400, 150}, {433.7, 171.2});
  const double step = grid_step(page.app.state.view.camera);
  const Vec2 at = page.app.state.work.document().vertices[2];
  CHECK(length(at - Vec2(433.7, 171.2)) < step + 2);
  CHECK(std::fmod(at.x, step) == 0);
  CHECK(std::fmod(at.y, step) == 0);
  page.press({"n"});
  page.press({"x"});
  page.drag({0, 300}, {3, 260});
  CHECK(page.app.state.work.document().vertices[5].x == 0);
}

TEST_CASE("the whole snaps with the lower left corner of its box onto a dot", "[view]") {
  Page page("(3.7,1.3)\n(404.8,1.3)\n(404.8,151.3)\n(153.7,151.3)\n(153.7,303.6)\n(3.7,303.6)\n");
  page.frame();
  page.press({"n"});
  page.press({"w"});
  page.frame();
  const Camera camera = page.app.state.view.camera;
  const auto low = [&] { return bounding_box(page.app.state.work.document().vertices).low; };
  const Vec2 by(108, 109), goal = nearest_dot(camera, low() + by);
  REQUIRE(length(low() - nearest_dot(camera, low())) > 0.1);
  page.drag({150, 100}, Vec2(150, 100) + by);
  CHECK(length(low() - goal) < 1e-9);
}

TEST_CASE("the whole moves, turns and scales, each drag a step of undo", "[view]") {
  Page page;
  page.frame();
  const Points before = page.app.state.work.document().vertices;
  const auto area = [&] {
    return page.app.state.derived().placement->lifting_base.empty()
               ? 0
               : area_of(page.app.state.work.document().vertices);
  };
  const double size = area();
  page.press({"w"});
  page.frame();
  page.drag({150, 100}, {250, 140});
  Vec2 moved = page.app.state.work.document().vertices[0] - before[0];
  CHECK(length(moved - Vec2(100, 40)) < 1);
  CHECK(std::abs(area() - size) < 1e-6 * size);
  page.press({"z", true});
  CHECK(page.app.state.work.document().vertices == before);
  page.press({"["});
  page.press({"["});
  CHECK(length(page.app.state.work.document().vertices[1] - before[1]) > 1);
  CHECK(std::abs(area() - size) < 1e-3 * size);
  page.press({"]"});
  page.press({"]"});
  for (std::size_t i = 0; i < before.size(); ++i) {
    CHECK(length(page.app.state.work.document().vertices[i] - before[i]) < 0.1);
  }
  page.press({"}"});
  CHECK(std::abs(area() / size - 1.21) < 1e-3);
  const Points scaled = page.app.state.work.document().vertices;
  page.press({"ArrowRight"});
  for (std::size_t i = 0; i < before.size(); ++i)
    CHECK(page.app.state.work.document().vertices[i].x > scaled[i].x);
  page.press({"Escape"});
  CHECK(page.app.state.view.tool == Tool::parts);
}

TEST_CASE("keys alone select, move, add and remove vertices", "[view]") {
  Page page;
  page.frame();
  page.press({"v"});
  CHECK(page.app.state.view.selected == 0u);
  page.press({"V"});
  CHECK(page.app.state.view.selected == 5u);
  const Vec2 before = page.app.state.work.document().vertices[5];
  page.press({"ArrowLeft"});
  page.press({"ArrowUp"});
  const Vec2 after = page.app.state.work.document().vertices[5];
  CHECK(after.x < before.x);
  CHECK(after.y > before.y);
  page.press({"i"});
  CHECK(page.app.state.work.document().vertices.size() == 7);
  page.press({"Delete"});
  CHECK(page.app.state.work.document().vertices.size() == 6);
}

TEST_CASE("two methods stand side by side and follow the same polygon", "[view]") {
  Page page;
  page.press({"k"});
  page.frame();
  REQUIRE(page.app.state.derived().second);
  CHECK(page.app.state.derived().second->settings.method == Method::circle);
  const Layout places = layout(page.app.state);
  CHECK(places.first.right == places.second.left);
  // A drag in the second drawing moves the one polygon.
  const Vec2 offset(places.second.left - places.first.left, places.second.top - places.first.top);
  page.drag({400, 150}, {420, 180}, offset);
  CHECK(length(page.app.state.work.document().vertices[2] - Vec2(420, 180)) < 2);
  CHECK(page.app.state.derived().second->vertices() ==
        page.app.state.derived().placement->vertices());
  // Through the other methods, and back.
  for (std::size_t i = 1; i < std::size(all_methods); ++i) page.press({"k"});
  CHECK_FALSE(page.app.state.work.second_method);
}

TEST_CASE("a capacity tells how many robots are needed and who carries too much", "[view]") {
  Page page(asset(EVENLIFT_ASSETS_DIR "/polygons/grand-piano.txt"));
  AppState& state = page.app.state;
  Commands commands{showing(state, &Shown::capacity, 12.0)};
  apply(state, commands);
  REQUIRE(state.derived().plan);
  CHECK(need_in_words(state).find("All 6 robots are overloaded, with more than") == 0);
  CHECK(verdict(state).headline.find("All 6 robots are overloaded, with more than") == 0);
  CHECK(verdict(state).mood == Mood::falls);
  REQUIRE(state.derived().plan->possible);
  CHECK(state.derived().plan->teams > 3);
  Settings changed = state.work.document().settings;
  changed.teams = state.derived().plan->teams;
  commands = {SetSettings{changed}};
  apply(state, commands);
  CHECK(need_in_words(state).find("No robot carries more") != std::string::npos);
  CHECK(verdict(state).mood != Mood::not_quite);
}

TEST_CASE("a capacity that no number of robots stays within says so", "[view]") {
  Page page;  // it has three candidates
  Commands commands{showing(page.app.state, &Shown::capacity, 12.0)};
  apply(page.app.state, commands);
  REQUIRE(page.app.state.derived().plan);
  CHECK_FALSE(page.app.state.derived().plan->possible);
  CHECK(need_in_words(page.app.state).find("Even all 6 robots") != std::string::npos);
}

TEST_CASE("a capacity is planned for anew only when the plan can change", "[view][capacity]") {
  Page page;
  AppState& state = page.app.state;
  Commands commands{showing(state, &Shown::capacity, 12.0)};
  apply(state, commands);
  REQUIRE(state.derived().plan);
  std::uint64_t plans = computed().plans;
  for (const Key& key : {Key{"c"}, {"h"}, {"a"}, {"f"}, {"r"}, {"l"}, {"t"}, {"t", false, true}}) {
    page.press(key);
    INFO(key.name);
    CHECK(computed().plans == plans);
  }
  // A drag announces nothing.
  Settings lighter = settings(state);
  lighter.weight = 90;
  commands = {SetSettings{lighter, true}};
  apply(state, commands);
  CHECK(computed().plans == plans);
  commands = {EndEdit{}};
  apply(state, commands);
  CHECK(computed().plans == ++plans);
  CHECK(state.derived().plan == plan_capacity(*state.derived().placement, 12));
  for (const auto change :
       {+[](Settings& s) { s.method = Method::circle; }, +[](Settings& s) { s.min_ratio = 0.5; },
        +[](Settings& s) { s.weight = 100; }}) {
    Settings changed = settings(state);
    change(changed);
    commands = {SetSettings{changed}};
    apply(state, commands);
    CHECK(computed().plans == ++plans);
    CHECK(state.derived().plan == plan_capacity(*state.derived().placement, 12));
  }
  commands = {showing(state, &Shown::capacity, 13.0)};
  apply(state, commands);
  CHECK(computed().plans == ++plans);
  CHECK(state.derived().plan == plan_capacity(*state.derived().placement, 13));
  commands = {showing(state, &Shown::capacity, std::nullopt)};
  apply(state, commands);
  CHECK_FALSE(state.derived().plan);
}

TEST_CASE("the heat map's bands are the polygon where the tipping force says so", "[view]") {
  for (const char* name : {"kidney-table", "horseshoe", "puzzle-piece"}) {
    const Document shape =
        document(asset(std::string(EVENLIFT_ASSETS_DIR "/polygons/") + name + ".txt"));
    const Result<Placement> placed = place(shape);
    REQUIRE(placed.ok());
    const std::vector<HeatBand> bands = heat_bands(*placed, triangulate(placed->vertices()));
    REQUIRE(bands.size() == std::size(heat_levels) + 2);
    double before = area_of(shape.vertices) * (1 + 1e-9);
    for (const HeatBand& band : bands) {
      double area = 0;
      for (std::size_t i = 0; i < band.triangles.size(); i += 3) {
        const Vec2 &a = band.triangles[i], &b = band.triangles[i + 1], &c = band.triangles[i + 2];
        area += std::abs(cross(b - a, c - a)) / 2;
        // Well inside the band, no smaller force tips it.
        const Vec2 middle = (a + b + c) / 3;
        const double force = tipping_force(placed->lifting_base, placed->centre_of_mass, 1, middle);
        CHECK(force >= std::min(band.share, 1e9) * (1 - 1e-6));
      }
      CHECK(area <= before);
      before = area * (1 + 1e-9);
    }
    CHECK(std::abs(before - placed->coverage * area_of(shape.vertices)) <
          1e-6 * area_of(shape.vertices));
  }
}

namespace {

// Counts the placements and traces of the following code.
struct Count {
  Computed before = computed();
  std::uint64_t placements() const { return computed().placements - before.placements; }
  std::uint64_t traces() const { return computed().traces - before.traces; }
};

Document changed(const AppState& state, const char* lines) {
  const Result<Changeable> result = with_settings({last_good(state)}, lines);
  REQUIRE(result.ok());
  return result->document;
}

}  // namespace

TEST_CASE("each action places the polygon once, however it comes in", "[view]") {
  Page page;
  page.frame();
  AppState& state = page.app.state;
  {
    const Count count;
    Result<Opened> read = read_document("(0,0)\n(300,0)\n(300,200)\n(0,200)\n");
    REQUIRE(read);
    page.app.commands.push_back(OpenDocument{std::move(read).value()});
    settle(page.app);
    page.frame();
    CHECK(count.placements() == 1);
    CHECK(count.traces() == 0);
  }
  {
    const Count count;
    const Document two = changed(state, "teams=2");
    CHECK_FALSE(edit_by_script(state, two));
    CHECK(count.placements() == 1);
  }
  {
    const Count count;
    page.press({"z", true});
    CHECK(count.placements() == 1);
  }
  {
    page.press({"d"});
    const Count count;
    for (const Vec2& corner : Points{{10, 10}, {250, 20}, {240, 180}}) page.click(corner);
    CHECK(count.placements() == 0);
    page.press({"Enter"});
    REQUIRE(state.work.document().vertices.size() == 3);
    CHECK(count.placements() == 1);
  }
  {
    const Count count;
    page.press({"k"});
    CHECK(count.placements() == 1);  // of the other method
    page.press({"t"});
    CHECK(count.placements() == 3);  // of both
  }
  {
    const Count count;
    const Document refused = changed(state, "com=9999,9999");
    CHECK(edit_by_script(state, refused));
    CHECK(count.placements() == 1);
  }
}

TEST_CASE("a lesson is traced once when it is opened, and its steps compute nothing", "[view]") {
  Page page;
  AppState& state = page.app.state;
  {
    const Count count;
    const Document at = changed(state, "step=5");
    CHECK_FALSE(edit_by_script(state, at));
    CHECK(state.view.walkthrough.at == 5);
    CHECK(count.placements() == 0);
    CHECK(count.traces() == 1);
  }
  {
    const Count count;
    for (const char* change : {"step=9", "step=2", "step=none"}) {
      const Document to = changed(state, change);
      CHECK_FALSE(edit_by_script(state, to));
    }
    CHECK_FALSE(walkthrough_is_open(state));
    CHECK_FALSE(shown(state).step);
    CHECK(count.placements() + count.traces() == 0);
  }
  {
    const Count count;
    const Document both = changed(state, "teams=2\nstep=3");
    CHECK_FALSE(edit_by_script(state, both));
    CHECK(state.view.walkthrough.at == 3);
    CHECK(count.placements() == 1);
    CHECK(count.traces() == 1);
  }
  {
    const Count count;
    const std::string text = "title: One stop\npolygon: l\nteams: 2\n\n[team 2]\nDone.\n";
    CHECK_FALSE(open_lesson(state, text, l_shape));
    CHECK(words_of_stop(state) == "Done.");
    CHECK(count.placements() == 1);
    CHECK(count.traces() == 1);
  }
}

TEST_CASE("what is shown is changed without computing anything, and is no step of undo", "[view]") {
  Page page;
  page.frame();
  AppState& state = page.app.state;
  const std::uint64_t revision = state.derived().revision;
  const Count count;
  for (const char* key : {"h", "c", "a", "r", "l", "f"}) {
    page.press({key});
    page.frame();
  }
  CHECK(count.placements() + count.traces() == 0);
  CHECK(state.derived().revision ==
        revision);  // nothing that depends on the placement is recomputed
  CHECK_FALSE(state.work.history.can_undo());
  const Overlays switched{true, false, false, false, false, true};
  CHECK(shown(state).overlays == switched);
  CHECK(decode_link(encode_link(last_good(state)).value())->shown.overlays == switched);
  // Undo covers edits, not what is shown.
  page.press({"t"});
  page.press({"z", true});
  CHECK(settings(state).teams == 3u);
  CHECK(shown(state).overlays == switched);
  // The same by a script.
  const std::uint64_t placements = count.placements();
  const Document none = changed(state, "overlays=none");
  CHECK_FALSE(edit_by_script(state, none));
  CHECK(shown(state).overlays == none.shown.overlays);
  CHECK(shown(state).overlays == none.shown.overlays);
  CHECK(count.placements() == placements);
  CHECK_FALSE(state.work.history.can_undo());
}

TEST_CASE("no way leads to a method beside itself", "[view]") {
  Page page;
  AppState& state = page.app.state;
  const auto parted = [&] {
    return !state.work.second_method || *state.work.second_method != settings(state).method;
  };
  page.press({"k"});
  REQUIRE(state.work.second_method == Method::circle);
  page.press({"m"});  // takes over the compared method: the two change sides
  CHECK(settings(state).method == Method::circle);
  CHECK(state.work.second_method == Method::area);
  REQUIRE(state.derived().second);
  CHECK(state.derived().second->settings.method == Method::area);
  page.press({"z", true});
  CHECK(parted());
  const Document edited = changed(state, "metric=distance");
  Commands commands{Compare{Method::distance}};
  apply(state, commands);
  CHECK_FALSE(edit_by_script(state, edited));
  CHECK(parted());
  commands = {Compare{Method::distance}};
  apply(state, commands);
  CHECK_FALSE(state.work.second_method);
  commands = {Compare{Method::area}};
  apply(state, commands);
  page.open(document(l_shape));
  CHECK(parted());
  for (int i = 0; i < 12; ++i) {
    page.press({i % 3 ? "m" : "k"});
    CHECK(parted());
  }
}

// More vertices than fit onto a stack of 8 MB when drawn; tests/page/recovery.test.mjs goes to the
// limit.
TEST_CASE("very large polygons are drawn, in outline and filled, and as what is refused",
          "[view][thorough]") {
  constexpr int n = 400000;
  Document large;
  for (int i = 0; i < n; ++i) {
    const double a = 2 * 3.14159265358979 * i / n;
    const double r = 4e5 + 5e4 * std::sin(9 * a);
    large.vertices.emplace_back(r * std::cos(a), r * std::sin(a));
  }
  Page page;
  page.open(large);
  const auto drawn = [&](double ratio) {
    page.app.state.session.screen.ratio = ratio;
    page.frame();
    return ImGui::GetDrawData()->TotalVtxCount;
  };
  // The drawing depends on visible detail, not on vertices.
  for (const double ratio : {1.0, 1.25, 1.5, 2.0, 3.0}) {
    const int vertices = drawn(ratio);
    CHECK(vertices > 10000);
    CHECK(vertices < 600000);
  }
  page.app.commands.push_back(MoveVertex{0, Vec2(-6e5, 3)});
  page.app.commands.push_back(EndEdit{});
  settle(page.app);
  REQUIRE(page.app.state.derived().refusal);
  for (const double ratio : {1.0, 3.0}) CHECK(drawn(ratio) > 10000);
}

TEST_CASE("rows of pixels fill what triangles fill, and the heat map's bands alike", "[view]") {
  const auto filled = [](const RowFill& rows) {
    double area = 0;
    for (const RowSpan& span : rows.spans) {
      CHECK(span.left < span.right);
      area += static_cast<double>(span.right - span.left) * static_cast<double>(rows.height);
    }
    return area;
  };
  for (const char* name : {"kidney-table", "horseshoe", "labyrinth", "gear"}) {
    INFO(name);
    const Points polygon =
        document(asset(std::string(EVENLIFT_ASSETS_DIR "/polygons/") + name + ".txt")).vertices;
    const Rect window{0, 0, 800, 600};
    const Camera camera = fit(polygon, {20, 20, 780, 580});
    const double whole = area_of(polygon) * camera.scale * camera.scale;
    CHECK(filled(fill_rows(polygon, {}, camera, window, 0.5)) == Approx(whole).epsilon(0.003));
    // Half outside the window: only the visible half is filled, and the other is the rest.
    const Camera aside = pan(camera, {-400, 0});
    const RowFill half = fill_rows(polygon, {}, aside, window, 0.5);
    const RowFill rest = fill_rows(polygon, {}, pan(camera, {400, 0}), window, 0.5);
    CHECK(filled(half) + filled(rest) == Approx(whole).epsilon(0.003));
    CHECK(filled(half) > whole / 10);
    CHECK(filled(rest) > whole / 10);
    for (const RowSpan& span : half.spans) {
      const Vec2 middle(static_cast<double>(span.left + span.right) / 2,
                        static_cast<double>(span.top) + 0.25);
      CHECK(inside(polygon, aside.to_world(middle)));
    }
  }
}

TEST_CASE("bands of a large polygon are the regions where the tipping force says so", "[view]") {
  const Document shape = document(asset(EVENLIFT_ASSETS_DIR "/polygons/kidney-table.txt"));
  const Result<Placement> result = place(shape);
  REQUIRE(result);
  const std::vector<HeatBand> bands = heat_bands(*result, {});
  REQUIRE(bands.size() == std::size(heat_levels) + 2);
  CHECK(bands[0].region.empty());  // all of it
  for (std::size_t i = 1; i < bands.size(); ++i) {
    CHECK(area_of(bands[i].region) > 0);
    for (const Vec2& corner : bands[i].region) {
      const Vec2 within = corner + (result->centre_of_mass - corner) * 1e-6;
      const double force = tipping_force(result->lifting_base, result->centre_of_mass, 1, within);
      CHECK(force >= std::min(bands[i].share, 1e9) * (1 - 1e-6));
    }
  }
}

TEST_CASE("the hint at the foot stands between the tools of the view and the panel",
          "[view][layout]") {
  Page page;
  AppState& state = page.app.state;
  state.session.screen.height = 800;
  for (const Tool tool : {Tool::parts, Tool::draw, Tool::transform, Tool::mark}) {
    state.view.tool = tool;
    std::size_t longest = 0;
    for (int width = 900; width <= 1800; width += 50) {
      state.session.screen.width = width;
      page.frame();
      const Layout where = layout(state);
      const std::string text = shown_hint(state, where);
      CHECK(static_cast<double>(text_size(Face::label, text).x) <=
            where.free.right - where.tools.right - 32);
      CHECK(hint(state).starts_with(text));
      CHECK(text.size() >= longest);
      longest = text.size();
    }
    CHECK(longest == hint(state).size());
  }
}

TEST_CASE("an edge that is typed begins with its length, and ends where length and angle say",
          "[view][draw]") {
  Page page;
  AppState& state = page.app.state;
  give(state, SetTool{Tool::draw});
  give(state, AddPoint{{10, 20}});
  give(state, TypeEdge{.degrees = 90.0, .place = true});
  CHECK(state.session.notice.text == "Also type the length of the edge.");
  CHECK(state.view.drawing.points.size() == 1);
  give(state, TypeEdge{.length = 30.0, .place = true});
  REQUIRE(state.view.drawing.points.size() == 2);
  CHECK(length(state.view.drawing.points[1] - Vec2(10, 50)) < 1e-9);
}

TEST_CASE(
    "a vertex that was moved out of sight comes back into view, and one in sight moves nothing",
    "[view]") {
  Page page;
  page.frame();
  const auto move = [&](const Vec2& to) {
    page.app.commands.push_back(MoveVertex{0, to});
    page.app.commands.push_back(EndEdit{});
    settle(page.app);
    page.frame();
  };
  const Vec2 first = page.app.state.work.document().vertices[0];
  const double scale = page.app.state.view.camera.scale;
  move(first + Vec2(1, 1));
  CHECK(page.app.state.view.camera.scale == scale);
  move(first - Vec2(5000, 0));
  CHECK(page.app.state.view.camera.scale < scale);
  const Vec2 spot =
      page.app.state.view.camera.to_screen(page.app.state.work.document().vertices[0]);
  CHECK(layout(page.app.state).free.contains(spot));
}
