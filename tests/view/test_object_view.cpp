#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "edits/vertices.h"
#include "evenlift/output/words.h"
#include "evenlift/placement.h"
#include "evenlift/plane.h"
#include "evenlift/polygon_with_holes.h"
#include "marks/marks.h"
#include "picture/canvas_view.h"
#include "picture/scene.h"
#include "picture/triangulate.h"
#include "state/derived.h"
#include "tools/pick.h"
#include "view/view_page.h"

using namespace view_page;

namespace {

Points square(const Vec2& middle, double half) {
  return {middle + Vec2(-half, -half), middle + Vec2(half, -half), middle + Vec2(half, half),
          middle + Vec2(-half, half)};
}

Points star(const Vec2& middle, double size, int points) {
  Points ring;
  for (int i = 0; i < 2 * points; ++i) {
    const double a = 3.14159265358979 * i / points, r = i % 2 == 0 ? size : size * 0.4;
    ring.push_back(middle + r * Vec2(std::cos(a), std::sin(a)));
  }
  return ring;
}

// 400 by 300, with three holes; two have vertices on one line.
Document plate() {
  Document document{{{0, 0}, {400, 0}, {400, 300}, {0, 300}}, std::nullopt};
  document.holes = {square({80, 80}, 40), star({300, 160}, 70, 7), square({80, 220}, 40)};
  return document;
}

Document loaded_plate() {
  Document document = plate();
  document.settings.cargo = {
      {{200, 240}, 60, "motor"}, {{200, 40}, 15, ""}, {{350, 40}, 0.01, "tag"}};
  return document;
}

PolygonWithHoles object(const Document& document) {
  const Result<PolygonWithHoles> result = object_of(document);
  REQUIRE(result);
  return *result;
}

double area_of(const Points& corners, const std::vector<std::uint32_t>& triangles) {
  double area = 0;
  for (std::size_t i = 0; i < triangles.size(); i += 3)
    area += std::abs(cross(corners[triangles[i + 1]] - corners[triangles[i]],
                           corners[triangles[i + 2]] - corners[triangles[i]])) /
            2;
  return area;
}

// A pixel of the last frame.
struct Pixel {
  double channels[3];
  bool is(const Colour& colour, double tolerance = 1.5) const {
    for (int i = 0; i < 3; ++i)
      if (std::abs(channels[i] - (colour.rgb >> (16 - 8 * i) & 0xFF)) > tolerance) return false;
    return true;
  }
  void draw(ImU32 packed, double opacity) {
    const double share = opacity * (packed >> IM_COL32_A_SHIFT & 0xFF) / 255.0;
    const int shifts[] = {IM_COL32_R_SHIFT, IM_COL32_G_SHIFT, IM_COL32_B_SHIFT};
    for (int i = 0; i < 3; ++i) channels[i] += share * ((packed >> shifts[i] & 0xFF) - channels[i]);
  }
};

Vec2 point(const ImVec2& p) { return {static_cast<double>(p.x), static_cast<double>(p.y)}; }

// How opaque the texture of letters and lines is.
double texture_at(const Vec2& uv) {
  const ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  const auto index = [](double share, int size) {
    return std::clamp(static_cast<int>(share * size), 0, size - 1);
  };
  const unsigned texel = atlas.TexPixelsRGBA32[index(uv.y, atlas.TexHeight) * atlas.TexWidth +
                                               index(uv.x, atlas.TexWidth)];
  return (texel >> IM_COL32_A_SHIFT & 0xFF) / 255.0;
}

Pixel pixel_at(const Colour& ground, const Vec2& at) {
  Pixel pixel{};
  pixel.draw(ground.packed(), 1);
  const ImDrawData& drawn = *ImGui::GetDrawData();
  for (int n = 0; n < drawn.CmdListsCount; ++n) {
    const ImDrawList& list = *drawn.CmdLists[n];
    for (const ImDrawCmd& command : list.CmdBuffer) {
      for (unsigned i = 0; i + 2 < command.ElemCount; i += 3) {
        const auto corner = [&](unsigned k) -> const ImDrawVert& {
          const unsigned index = list.IdxBuffer[static_cast<int>(command.IdxOffset + i + k)];
          return list.VtxBuffer[static_cast<int>(index + command.VtxOffset)];
        };
        const ImDrawVert &a = corner(0), &b = corner(1), &c = corner(2);
        const Vec2 p = point(a.pos), q = point(b.pos), r = point(c.pos);
        const double turn = cross(q - p, r - p), of_b = cross(at - p, r - p) / turn,
                     of_c = cross(q - p, at - p) / turn, of_a = 1 - of_b - of_c;
        if (turn == 0 || !(of_a > 0 && of_b > 0 && of_c > 0)) continue;
        const Vec2 uv = of_a * point(a.uv) + of_b * point(b.uv) + of_c * point(c.uv);
        const auto alpha = [](const ImDrawVert& v) { return v.col >> IM_COL32_A_SHIFT & 0xFF; };
        const double most = std::max({alpha(a), alpha(b), alpha(c)});
        if (most == 0) continue;
        // A line's fringe fades outwards.
        const double fade = (of_a * alpha(a) + of_b * alpha(b) + of_c * alpha(c)) / most;
        const ImU32 colour = alpha(a) == most ? a.col : alpha(b) == most ? b.col : c.col;
        pixel.draw(colour, texture_at(uv) * fade);
      }
    }
  }
  return pixel;
}

// What is drawn on a page.
struct Looked {
  explicit Looked(Page& page)
      : colours(theme(page.app.state)),
        places(layout(page.app.state)),
        view{page.app.state,
             colours,
             places,
             &*page.app.state.derived().placement,
             page.app.scene,
             page.app.state.view.camera,
             page.app.state.session.screen.area(),
             false} {}
  const Theme& colours;
  Layout places;
  CanvasView view;
};

}  // namespace

TEST_CASE("triangles fill an object and none of its holes", "[view]") {
  std::vector<Document> documents{plate(), loaded_plate()};
  for (const int across : {1, 3, 8}) {  // a grid of holes with vertices at equal heights
    Document grid{square({0, 0}, 50), std::nullopt};
    const double step = 100.0 / across;
    for (int i = 0; i < across * across; ++i) {
      const int row = i / across, column = i % across;
      const Vec2 middle(-50 + step * (column + 0.5), -50 + step * (row + 0.5));
      grid.holes.push_back(i % 2 == 0 ? square(middle, 0.3 * step) : star(middle, 0.4 * step, 3));
    }
    documents.push_back(grid);
  }
  for (const Document& document : documents) {
    for (const bool reversed : {false, true}) {
      Points outline = document.vertices;
      if (reversed) std::reverse(outline.begin(), outline.end());
      const PolygonWithHoles solid = object(document);
      const Points corners = joined(outline, document.holes);
      const auto triangles = triangulate(outline, document.holes);
      CHECK(area_of(corners, triangles) == Approx(solid.area()).epsilon(1e-9));
      for (std::size_t i = 0; i < triangles.size(); i += 3) {
        const Vec2 middle =
            (corners[triangles[i]] + corners[triangles[i + 1]] + corners[triangles[i + 2]]) / 3;
        CHECK_FALSE(solid.hole_around(middle));
      }
    }
  }
}

TEST_CASE("the scene of an object follows its holes", "[view]") {
  Page page;
  page.open(plate());
  page.frame();
  const Scene& scene = page.app.scene;
  CHECK(area_of(scene.corners, scene.triangles) == Approx(object(plate()).area()).epsilon(1e-9));
  Document fewer = plate();
  fewer.holes.pop_back();
  REQUIRE_FALSE(edit_by_script(page.app.state, fewer));
  page.frame();
  CHECK(area_of(scene.corners, scene.triangles) == Approx(object(fewer).area()).epsilon(1e-9));
}

TEST_CASE("rows of pixels fill an object and none of its holes", "[view]") {
  const Document document = plate();
  const PolygonWithHoles solid = object(document);
  const Rect window{0, 0, 800, 600};
  const Camera camera = fit(document.vertices, {20, 20, 780, 580});
  const RowFill rows = fill_rows(document.vertices, document.holes, camera, window, 0.5);
  double area = 0;
  for (const RowSpan& span : rows.spans) {
    area += static_cast<double>(span.right - span.left) * static_cast<double>(rows.height);
    const Vec2 middle(static_cast<double>(span.left + span.right) / 2,
                      static_cast<double>(span.top) + 0.25);
    CHECK_FALSE(solid.hole_around(camera.to_world(middle)));
  }
  CHECK(area == Approx(solid.area() * camera.scale * camera.scale).epsilon(0.003));
}

TEST_CASE("rows of pixels fill a ring that touches itself, as the boundary of an object does",
          "[view]") {
  const Document document = plate();
  const PolygonWithHoles solid = object(document);
  const Rect window{0, 0, 800, 600};
  const Camera camera = fit(document.vertices, {20, 20, 780, 580});
  const auto spans = [&](const Points& ring, const std::vector<Points>& holes) {
    std::vector<std::pair<float, float>> found;
    for (const RowSpan& span : fill_rows(ring, holes, camera, window, 0.5).spans)
      found.emplace_back(span.left, span.right);
    return found;
  };
  CHECK(spans(solid.boundary(), {}) == spans(document.vertices, document.holes));
}

TEST_CASE("the heat map leaves the holes out", "[view]") {
  const Document document = plate();
  const Result<Placement> placed = place(document);
  REQUIRE(placed);
  const std::vector<HeatBand> bands =
      heat_bands(*placed, triangulate(document.vertices, document.holes));
  REQUIRE(bands.size() > 2);
  const auto area_of_band = [&](const HeatBand& band) {
    double area = 0;
    for (std::size_t i = 0; i < band.triangles.size(); i += 3) {
      const Vec2 &a = band.triangles[i], &b = band.triangles[i + 1], &c = band.triangles[i + 2];
      area += std::abs(cross(b - a, c - a)) / 2;
      CHECK_FALSE(placed->object.hole_around((a + b + c) / 3));
    }
    return area;
  };
  CHECK(area_of_band(bands.front()) == Approx(placed->object.area()).epsilon(1e-9));
  CHECK(area_of_band(bands.back()) ==
        Approx(placed->coverage * placed->object.area()).epsilon(1e-6));
}

TEST_CASE("a hole shows the ground, whatever is drawn over the object", "[view]") {
  Page page;
  page.app.state.view.motion = false;
  page.open(plate());
  AppState& state = page.app.state;
  const Vec2 in_hole(287, 163), in_object(190, 163);  // inside the lifting base, away from marks
  const auto look = [&](const Vec2& world) {
    page.frame();
    page.frame();
    return pixel_at(theme(state).ground, state.view.camera.to_screen(world));
  };
  REQUIRE(object(plate()).hole_around(in_hole));
  for (const bool dark : {false, true}) {
    state.session.screen.dark = dark;
    for (const bool base : {false, true}) {
      for (const bool tipping : {false, true}) {
        Commands commands{showing(state, &Shown::overlays,
                                  Overlays{.chords = false,
                                           .lifting_base = base,
                                           .clockwise = false,
                                           .counterclockwise = false,
                                           .tipping = tipping})};
        apply(state, commands);
        INFO("dark " << dark << ", base " << base << ", tipping " << tipping);
        CHECK(look(in_hole).is(theme(state).ground));
        CHECK(look(in_object).is(theme(state).object) == (!base && !tipping));
      }
    }
    give(state, OpenWalkthrough{});
    for (const int step : {0, 1000000}) {
      give(state, GoToStep{static_cast<std::uint32_t>(step)});
      CHECK(look(in_hole).is(theme(state).ground));
    }
    give(state, CloseWalkthrough{});
  }
}

TEST_CASE("a hole that does not fit is marked, and a refused outline shows all of its holes",
          "[view]") {
  Page page;
  page.open(plate());
  AppState& state = page.app.state;
  give(state, SetCamera{fit({{-200, -50}, {500, 350}}, {250, 100, 900, 700})});
  page.frame();
  const auto amber_at = [&](const Vec2& world) {
    return pixel_at(theme(state).ground, state.view.camera.to_screen(world))
        .is(theme(state).amber, 3);
  };
  const Vec2 on_moved(-97, 120), on_left(97, 180);
  CHECK_FALSE(amber_at(on_moved));
  state.work.edit().holes[0] = square({-80, 80}, 40);
  conclude(state);
  page.frame();
  CHECK_FALSE(state.derived().refusal);
  CHECK(state.derived().placement->left_out ==
        std::vector<Misplaced>{{Misplaced::Kind::hole, 0, {}}});
  CHECK(amber_at(on_moved));
  CHECK_FALSE(amber_at(on_left));
  std::swap(state.work.edit().vertices[0], state.work.edit().vertices[1]);  // edges cross
  conclude(state);
  page.frame();
  REQUIRE(state.derived().refusal);
  CHECK(amber_at(on_moved));
  CHECK(amber_at(on_left));
}

TEST_CASE("the disc of a weight tells its share of the total weight", "[view]") {
  Page page;
  page.open(loaded_plate());
  page.frame();
  const Looked looked(page);
  const std::vector<Cargo>& cargo = page.app.state.work.document().settings.cargo;
  std::vector<CargoDisc> discs = cargo_discs(looked.view);
  REQUIRE(discs.size() == cargo.size());
  CHECK(std::pow(discs[0].radius / discs[1].radius, 2) ==
        Approx(cargo[0].weight / cargo[1].weight).epsilon(1e-9));
  CHECK(discs[2].radius == 5);  // pixels
  for (std::size_t i = 0; i < discs.size(); ++i) {
    CHECK(length(discs[i].middle - looked.view.camera.to_screen(cargo[i].at)) < 1e-6);
    CHECK(discs[i].radius < 50);
  }
  // From far away, discs cover little of the object.
  give(page.app.state, SetCamera{zoom(page.app.state.view.camera, {0, 0}, 0.25, 1e-6, 1e6)});
  const Looked far(page);
  discs = cargo_discs(far.view);
  CHECK(discs[0].radius < 0.2 * 400 * far.view.camera.scale);
  CHECK(discs[2].radius == 5);
  page.open(plate());
  page.frame();
  CHECK(cargo_discs(Looked(page).view).empty());
}

TEST_CASE("labels of weights are their names, or else the weights, clear of the loads", "[view]") {
  Page page;
  page.app.state.view.motion = false;
  page.open(loaded_plate());
  page.frame();
  const Looked looked(page);
  const std::vector<CargoLabel> labels = labels_of_cargo(looked.view);
  REQUIRE(labels.size() == 3);
  CHECK(labels[0].text == "motor");
  CHECK(labels[1].text == given_weight(15, {}));
  CHECK(labels[2].text == "tag");
  const auto size = robot_size(pairs_of(looked.view.placement->teams));
  Occupied occupied = occupied_by_marks(looked.view, mark_reach(size));
  const auto loads = load_labels(looked.view, size, looked.view.report(), occupied);
  CHECK(loads.size() == 6);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    for (const LoadLabel& load : loads) CHECK_FALSE(load.box.overlaps(labels[i].box));
    for (std::size_t j = 0; j < i; ++j) CHECK_FALSE(labels[j].box.overlaps(labels[i].box));
    for (const CargoDisc& disc : cargo_discs(looked.view))
      CHECK_FALSE(labels[i].box.contains(disc.middle));
  }
}

TEST_CASE("cargo moves C away from the object's own centre of mass, at the end of a line",
          "[view]") {
  Page page;
  page.open(loaded_plate());
  AppState& state = page.app.state;
  const Placement& placement = *state.derived().placement;
  REQUIRE(length(placement.centre_of_mass - placement.own_centre) * state.view.camera.scale > 30);
  page.frame();
  const auto look = [&](const Vec2& world) {
    return pixel_at(theme(state).ground,
                    state.view.camera.to_screen(world) + Vec2(0.5, 0.5));  // as lines are drawn
  };
  CHECK(look(placement.own_centre).is(theme(state).object));  // hollow
  const Vec2 on_line = 0.55 * placement.own_centre + 0.45 * placement.centre_of_mass;
  CHECK(look(on_line).is(theme(state).chord, 8));
}

TEST_CASE("a hovered weight is emphasised", "[view]") {
  Page page;
  page.open(loaded_plate());
  AppState& state = page.app.state;
  page.frame();
  const auto rim = [&] {
    const CargoDisc disc = cargo_discs(Looked(page).view)[0];
    return pixel_at(theme(state).ground, disc.middle - Vec2(disc.radius * 0.6, disc.radius * 0.8));
  };
  CHECK(rim().is(theme(state).chord, 8));
  give(state, SetHover{{Pick::Kind::cargo, 0, 0, {200, 240}}});
  // The pointer stays, so that the frame sets no other part.
  ImGui::NewFrame();
  (void)draw_frame(page.app);
  ImGui::Render();
  CHECK(rim().is(theme(state).accent_on_object, 8));
}

TEST_CASE("while a hole is drawn, the pointer is over its vertices and not over the object's",
          "[view]") {
  Page page;
  page.open(plate());
  AppState& state = page.app.state;
  give(state, SetHover{{Pick::Kind::vertex, 2, 0, {400, 300}}});
  CHECK(is_hovered(state, Pick::Kind::vertex, 2));
  give(state, SetTool{Tool::hole});
  give(state, SetHover{{Pick::Kind::vertex, 2, 0, {150, 150}}});
  CHECK_FALSE(is_hovered(state, Pick::Kind::vertex, 2));
}

TEST_CASE(
    "a hole that would cross another is refused before it is closed, and then closed elsewhere",
    "[view]") {
  Page page;
  page.open(plate());
  AppState& state = page.app.state;
  const auto draw = [&](const Points& ring) {
    give(state, SetTool{Tool::hole});
    for (const Vec2& point : ring) give(state, AddPoint{point});
    give(state, SetDrawCursor{ring.front(), {}, true});
  };
  draw(square({120, 120}, 20));  // over a corner of the first hole
  REQUIRE(state.view.drawing.refusal);
  CHECK(state.view.drawing.refusal->place.ring == 4);
  CHECK(state.view.drawing.refusal->place.other_ring == 1);
  give(state, FinishDrawing{});
  CHECK(state.work.document().holes.size() == 3);
  draw(square({180, 150}, 20));
  CHECK_FALSE(state.view.drawing.refusal);
  give(state, FinishDrawing{});
  CHECK(state.work.document().holes.size() == 4);
  CHECK(state.view.tool == Tool::parts);
  give(state, Undo{});
  CHECK(state.work.document().holes.size() == 3);
}

TEST_CASE(
    "vertices of the outline, of holes, and weights are numbered, named, moved and removed alike",
    "[view]") {
  Page page;
  page.open(loaded_plate());
  AppState& state = page.app.state;
  const auto now = [&]() -> const Document& { return state.work.document(); };
  CHECK(count_vertices(now()) == 4 + 4 + 14 + 4);
  CHECK(name_of(now(), 3) == "Vertex 4");
  CHECK(name_of(now(), 4) == "Hole 1, vertex 1");
  CHECK(name_of(now(), 4 + 4 + 14 + 3) == "Hole 3, vertex 4");
  CHECK(name_of(now(), count_vertices(now())) == "Weight 1, motor");
  CHECK(name_of(now(), count_vertices(now()) + 1) == "Weight 2");
  CHECK(name_of(now(), count_handles(now())).empty());

  give(state, MoveVertex{4, {30, 30}});
  give(state, EndEdit{});
  CHECK(now().holes[0][0] == Vec2(30, 30));
  give(state, MoveVertex{count_vertices(now()), {210, 240}});
  give(state, EndEdit{});
  CHECK(now().settings.cargo[0].at == Vec2(210, 240));
  give(state, InsertVertex{7, {40, 60}});  // on the edge that closes the first hole
  CHECK(now().holes[0].size() == 5);
  CHECK(now().holes[0].back() == Vec2(40, 60));
  CHECK(state.view.selected == 8);

  for (const std::size_t left : {std::size_t{4}, std::size_t{3}}) {
    give(state, RemoveVertex{4});
    CHECK(now().holes[0].size() == left);
  }
  give(state, RemoveVertex{4});  // of a triangle, all go
  CHECK(now().holes.size() == 2);
  give(state, RemoveVertex{count_vertices(now())});
  CHECK(now().settings.cargo.size() == 2);
  CHECK(now().vertices.size() == 4);
  CHECK_FALSE(state.derived().refusal);
}

TEST_CASE("a typed weight that is none changes nothing, and says what it must be", "[view]") {
  Page page;
  page.open(loaded_plate());
  AppState& state = page.app.state;
  const std::vector<Cargo> before = state.work.document().settings.cargo;
  for (const Cargo& wrong : {Cargo{{1, 1}, 0, ""}, Cargo{{1, 1}, 1, std::string(61, 'x')},
                             Cargo{{2e9, 1}, 1, ""}, Cargo{{1, 1}, 1, "\n"}}) {
    give(state, SetCargo{0, wrong});
    CHECK(state.session.notice.kind == Notice::Kind::problem);
    CHECK(state.work.document().settings.cargo == before);
  }
}

TEST_CASE("a new width of the picture scales all that was traced on it", "[view]") {
  AppState state;
  Document traced = document("(0,0)\n(400,0)\n(400,300)\n(0,300)\n");
  traced.settings.cargo = {{{100, 200}, 5, ""}};
  traced.centre_of_mass = Vec2(200, 100);
  begin(state, placed(traced));
  state.work.backdrop = Backdrop{{0, 0}, {800, 600}, 1, true};
  CHECK(scale_picture(state, 1600).empty());
  const Document& now = state.work.document();
  CHECK(now.vertices[2] == Vec2(800, 600));
  CHECK(now.settings.cargo[0].at == Vec2(200, 400));
  CHECK(now.centre_of_mass == Vec2(400, 200));
  CHECK(state.work.backdrop->high == Vec2(1600, 1200));
}

TEST_CASE("another polygon keeps the settings, but not those of its edges and lengths", "[view]") {
  Document before = document("(0,0)\n(400,0)\n(400,300)\n(0,300)\n");
  before.settings.teams = 2;
  before.settings.no_go = {{3, 0, 1}};
  before.shown.com_radius = 5;
  Work work;
  work.edit() = before;
  const Result<Opened> after = opened_after(document("(0,0)\n(40,0)\n(0,30)\n"), work);
  REQUIRE(after);
  CHECK(after->document.settings.teams == 2);
  CHECK(after->document.settings.no_go.empty());
  CHECK(after->document.shown.com_radius == 0);
}

TEST_CASE("an unfinished drawing that another tool replaces comes back with one undo", "[view]") {
  AppState state;
  begin(state, placed(document("(0,0)\n(400,0)\n(400,300)\n(0,300)\n")));
  frame_view(state);
  const Points corners = {{500, 0}, {600, 0}, {600, 90}, {520, 130}};
  const std::size_t depth = state.work.history.depth();
  for (const Tool other : {Tool::hole, Tool::weight, Tool::parts, Tool::draw}) {
    give(state, SetTool{Tool::draw});
    for (const Vec2& corner : corners) give(state, AddPoint{corner});
    give(state, SetTool{other});
    CHECK(state.session.notice.undo == "Go on drawing");
    CHECK(state.view.drawing.points.empty());
    give(state, Undo{});
    CHECK(state.view.tool == Tool::draw);
    CHECK(state.view.drawing.points == corners);
    CHECK(state.work.history.depth() == depth);
    give(state, TakePointBack{});
    CHECK(state.view.drawing.points.size() == 3);
    give(state, SetTool{Tool::parts});
    give(state, Undo{});
    give(state, SetTool{Tool::parts});
  }
  SECTION("but not once the object was edited") {
    give(state, MoveVertex{0, Vec2(-5, 0)});
    give(state, EndEdit{});
    give(state, Undo{});
    CHECK(state.view.tool == Tool::parts);
    CHECK(state.work.document().vertices[0] == Vec2(0, 0));
  }
  SECTION("nor once it was finished") {
    give(state, Undo{});
    give(state, FinishDrawing{});
    CHECK(state.work.document().vertices == Points(corners.begin(), corners.begin() + 3));
    give(state, Undo{});
    CHECK(state.work.document().vertices[1] == Vec2(400, 0));
    CHECK(state.view.tool == Tool::parts);
  }
}

TEST_CASE("the problem of a refused value goes with the next edit, whatever it changes", "[view]") {
  AppState state;
  begin(state, placed(document("(0,0)\n(400,0)\n(400,300)\n(0,300)\n")));
  for (const bool shown_only : {true, false}) {
    give(state, ShowNotice{{Notice::Kind::problem, "The slope must be a ratio."}});
    if (shown_only) {
      Shown changed = shown(state);
      changed.carrying.slope = 0.3;
      give(state, SetShown{changed});
    } else {
      Settings changed = settings(state);
      changed.weight = 7;
      give(state, SetSettings{changed});
    }
    CHECK(state.session.notice.text.empty());
  }
}
