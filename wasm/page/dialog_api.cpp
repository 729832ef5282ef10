// For the page's windows (web/windows): samples, coordinates, files. Edits are commands, so each is
// one step of undo. A function that may refuse returns the reason as a sentence, or an empty text.
#include <emscripten/emscripten.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "actions/actions.h"
#include "app/app.h"
#include "derive/derive.h"
#include "edits/vertices.h"
#include "evenlift/formats.h"
#include "evenlift/link.h"
#include "evenlift/numbers.h"
#include "evenlift/output/json_text.h"
#include "evenlift/output/weighing_words.h"
#include "evenlift/output/words.h"
#include "evenlift/polygon.h"
#include "evenlift/stands.h"
#include "evenlift/supports.h"
#include "evenlift/wording.h"
#include "page/page_api.h"
#include "page/sdl_input.h"
#include "state/work.h"
#include "tools/pick.h"

namespace evenlift::view {
namespace {

// The text of another polygon, or of the open one after it was edited.
std::string open_with_these_settings(std::string_view text, bool same_object) {
  Result<Document> read = evenlift::read_polygon(text);
  if (!read) return sentence(read.error());
  const Work& work = app().state.work;
  const auto edited = [&] {
    Document document = with_settings_of(*read, work.document());
    return opened(std::move(document));
  };
  Result<Opened> polygon = same_object ? edited() : opened_after(*read, work);
  if (!polygon) return sentence(polygon.error());
  Commands commands;
  commands.push_back(OpenDocument{std::move(polygon).value()});
  carry_out(std::move(commands));
  return {};
}

// As the formats write it; otherwise nothing, with the reason in `problem`.
std::optional<double> typed_number(std::string_view text, std::string& problem) {
  constexpr std::string_view blank = " \t\n\r";
  const std::size_t first = text.find_first_not_of(blank);
  text = first == std::string_view::npos
             ? std::string_view()
             : text.substr(first, text.find_last_not_of(blank) - first + 1);
  const std::optional<double> value = read_number(text);
  if (value) return value;
  if (text.empty())
    problem = say("A number is missing");
  else
    problem = say("“{text}” is not a number", {text.substr(0, 40)});
  return std::nullopt;
}

std::optional<double> coordinate(std::string_view text, std::string& problem) {
  const std::optional<double> value = typed_number(text, problem);
  if (!value || std::abs(*value) <= max_coordinate) return value;
  problem = say("Coordinates go from −1,000,000,000 to 1,000,000,000");
  return std::nullopt;
}

std::string points_json(const Points& points, std::size_t from, std::size_t to) {
  std::vector<std::string> all;
  for (std::size_t i = from; i < to; ++i) all.push_back(json::pair(points[i]));
  return json::array(all);
}

// In the form of page_outline().
std::string outline_of(const Result<Document>& document) {
  if (!document) return {};
  const Result<PolygonWithHoles> object = object_of(*document);
  if (!object) return {};
  const Points& vertices = document->vertices;
  std::vector<json::Member> members{
      {"centre", json::pair(document->centre_of_mass.value_or(object->centroid()))},
      {"vertices", points_json(vertices, 0, vertices.size())}};
  std::vector<std::string> holes;
  for (const Points& hole : document->holes) holes.push_back(points_json(hole, 0, hole.size()));
  if (!holes.empty()) members.emplace_back("holes", json::array(holes));
  return json::object(members);
}

int index_of(const std::optional<std::size_t>& vertex) {
  return vertex ? static_cast<int>(*vertex) : -1;
}

// The part that begins at `first`: from and up to these numbers.
std::pair<std::size_t, std::size_t> part_of(std::size_t size, int first, int count) {
  const std::size_t from = std::min(static_cast<std::size_t>(std::max(first, 0)), size);
  return {from, std::min(from + static_cast<std::size_t>(std::max(count, 0)), size)};
}

}  // namespace
}  // namespace evenlift::view

using namespace evenlift::view;
namespace json = evenlift::json;
using evenlift::Document;
using evenlift::read_thesis;
using evenlift::Result;
using evenlift::say;
using evenlift::translated;
using evenlift::Vec2;

extern "C" {

// --- Samples and text

// The settings with which other objects are placed, as lines name=value.
EMSCRIPTEN_KEEPALIVE const char* page_settings_for_others() {
  return hand_over(settings_for_others(app().state.work.document()));
}

// All settings stay; robots placed by hand do with an edited text, and with a sample do not.
EMSCRIPTEN_KEEPALIVE const char* page_open_sample(const char* text) {
  return hand_over(open_with_these_settings(text, false));
}
EMSCRIPTEN_KEEPALIVE const char* page_apply_text(const char* text) {
  return hand_over(open_with_these_settings(text, true));
}

// For a small picture: {"centre": [x, y], "vertices": [[x, y], …]} and, if it has any, "holes",
// each like the vertices. Empty if the text cannot be read.
EMSCRIPTEN_KEEPALIVE const char* page_outline(const char* text) {
  return hand_over(outline_of(read_thesis(text)));
}

// The outline when the polygon was opened or drawn, before all later edits; empty if it was then
// too large for a link.
EMSCRIPTEN_KEEPALIVE const char* page_origin() {
  AppState& state = app().state;
  std::optional<std::string> before;
  for (std::size_t i = 0;; ++i) {
    std::optional<History::Kept> step = state.work.history.kept(false, i);
    if (step && step->edit == Edit::lesson_left) {  // the same polygon was open before the lesson
      i = state.work.history.lesson_opened(i + 1).value_or(i);
      step = state.work.history.kept(false, i);
    } else if (!step || is_other_object(step->edit)) {
      break;
    }
    before = step->link;
  }
  return hand_over(outline_of(before ? evenlift::decode_link(*before)
                                     : Result<Document>(state.derived().placed)));
}

// --- Coordinates of the document, also while it is refused

// Of the outline and of all holes, in the order of handles.h.
EMSCRIPTEN_KEEPALIVE int page_vertex_count() {
  return static_cast<int>(count_vertices(app().state.work.document()));
}

// From `first` on: [[x, y], …].
EMSCRIPTEN_KEEPALIVE const char* page_vertices(int first, int count) {
  evenlift::Points vertices;
  for_each_ring(app().state.work.document(), [&](const evenlift::Points& ring, std::size_t) {
    vertices.insert(vertices.end(), ring.begin(), ring.end());
  });
  const auto [from, to] = part_of(vertices.size(), first, count);
  return hand_over(points_json(vertices, from, to));
}

// In the thesis's format.
EMSCRIPTEN_KEEPALIVE const char* page_document_text() {
  return hand_over(evenlift::write_thesis(app().state.work.document()));
}

// "12", or "H2 · 3" for the third vertex of the second hole.
EMSCRIPTEN_KEEPALIVE const char* page_vertex_name(int vertex) {
  const auto handle = handle_of(app().state.work.document(), static_cast<std::size_t>(vertex));
  if (vertex < 0 || !handle) return hand_over({});
  const std::string index = std::to_string(handle->index + 1);
  return hand_over(handle->ring == 0 ? index : say("H{hole} · {vertex}", {handle->ring, index}));
}

// [x, y]: the given one, or the last centroid; and whether it was given.
EMSCRIPTEN_KEEPALIVE const char* page_centre() {
  const AppState& state = app().state;
  return hand_over(json::pair(
      state.work.document().centre_of_mass.value_or(state.derived().placement->own_centre)));
}
EMSCRIPTEN_KEEPALIVE int page_centre_is_given() {
  return app().state.work.document().centre_of_mass ? 1 : 0;
}

// Why the polygon is refused, or empty.
EMSCRIPTEN_KEEPALIVE const char* page_refusal() {
  const AppState& state = app().state;
  return hand_over(state.derived().refusal ? sentence(*state.derived().refusal) : std::string());
}

// Of a vertex, or of the centre of mass if `vertex` is -1. `axis` is 0 for x and 1 for y.
EMSCRIPTEN_KEEPALIVE const char* page_set_coordinate(int vertex, std::size_t axis,
                                                     const char* text) {
  const AppState& state = app().state;
  const evenlift::Document& document = state.work.document();
  std::string problem;
  const std::optional<double> value = coordinate(text, problem);
  if (!value) return hand_over(std::move(problem));
  if (vertex >= static_cast<int>(count_vertices(document)))
    return hand_over(say("This vertex no longer exists"));
  Vec2 to = vertex < 0 ? document.centre_of_mass.value_or(state.derived().placement->own_centre)
                       : place_of(document, static_cast<std::size_t>(vertex));
  to[axis] = *value;
  if (vertex < 0)
    carry_out({EndEdit{}, MoveCentre{to}, EndEdit{}});
  else
    carry_out({EndEdit{}, MoveVertex{static_cast<std::size_t>(vertex), to}, EndEdit{}});
  return hand_over({});
}

EMSCRIPTEN_KEEPALIVE void page_release_centre() { carry_out({ReleaseCentre{}}); }

// The settings of the last good placement, for the window of experiments.
EMSCRIPTEN_KEEPALIVE double page_min_ratio() {
  return app().state.derived().placed.settings.min_ratio;
}
EMSCRIPTEN_KEEPALIVE double page_weight() { return app().state.derived().placed.settings.weight; }
EMSCRIPTEN_KEEPALIVE const char* page_weight_unit() {
  return hand_over(std::string(name(shown(app().state).units.weight)));
}

// Whether robots may stand anywhere: they have no size, and there are no no-go edges.
EMSCRIPTEN_KEEPALIVE int page_robots_are_points() {
  return stands_anywhere(app().state.derived().placed.settings) ? 1 : 0;
}

EMSCRIPTEN_KEEPALIVE int page_is_drawing() { return draws(app().state.view.tool) ? 1 : 0; }

// Of coordinates and distances; "none" without one.
EMSCRIPTEN_KEEPALIVE const char* page_length_unit() {
  return hand_over(std::string(name(shown(app().state).units.length)));
}

// In the middle of the edge that begins at this vertex.
EMSCRIPTEN_KEEPALIVE void page_insert_vertex(int after) {
  const evenlift::Document& document = app().state.work.document();
  if (after < 0 || after >= static_cast<int>(count_vertices(document))) return;
  const auto edge = static_cast<std::size_t>(after);
  const Vec2 middle = place_of(document, edge) / 2 + evenlift::view::after(document, edge) / 2;
  carry_out({InsertVertex{edge, middle}});
}

EMSCRIPTEN_KEEPALIVE void page_remove_vertex(int vertex) {
  if (vertex >= 0) carry_out({RemoveVertex{static_cast<std::size_t>(vertex)}});
}

EMSCRIPTEN_KEEPALIVE void page_select_vertex(int vertex) {
  SelectVertex select;
  if (vertex >= 0) select.vertex = static_cast<std::size_t>(vertex);
  carry_out({select});
}

// -1 without one.
EMSCRIPTEN_KEEPALIVE int page_selected_vertex() { return index_of(app().state.view.selected); }
EMSCRIPTEN_KEEPALIVE int page_hovered_vertex() {
  const AppState& state = app().state;
  const Pick& pick = state.view.held.kind != Pick::Kind::none ? state.view.held : state.view.hover;
  return pick.kind == Pick::Kind::vertex ? static_cast<int>(pick.index) : -1;
}

// --- The weights on the object

EMSCRIPTEN_KEEPALIVE int page_weight_count() {
  return static_cast<int>(settings(app().state).cargo.size());
}

// From `first` on: [[x, y, weight, name], …].
EMSCRIPTEN_KEEPALIVE const char* page_weights(int first, int count) {
  const std::vector<evenlift::Cargo>& cargo = settings(app().state).cargo;
  const auto [from, to] = part_of(cargo.size(), first, count);
  std::vector<std::string> rows;
  for (std::size_t i = from; i < to; ++i)
    rows.push_back(json::array({json::number(cargo[i].at.x), json::number(cargo[i].at.y),
                                json::number(cargo[i].weight), json::text(cargo[i].name)}));
  return hand_over(json::array(rows));
}

// Sets x, y, the weight or, as `column` 3, the name.
EMSCRIPTEN_KEEPALIVE const char* page_set_weight(int item, int column, const char* text) {
  const std::vector<evenlift::Cargo>& cargo = settings(app().state).cargo;
  if (item < 0 || item >= static_cast<int>(cargo.size()))
    return hand_over(say("This weight no longer exists"));
  evenlift::Cargo changed = cargo[static_cast<std::size_t>(item)];
  std::string problem;
  const std::optional<double> value = column < 2    ? coordinate(text, problem)
                                      : column == 2 ? typed_number(text, problem)
                                                    : std::nullopt;
  if (column < 3 && !value) return hand_over(std::move(problem));
  if (column < 2)
    changed.at[static_cast<std::size_t>(column)] = *value;
  else if (column == 2)
    changed.weight = *value;
  else
    changed.name = text;
  if (problem = problem_of(changed); !problem.empty()) return hand_over(std::move(problem));
  carry_out({EndEdit{}, SetCargo{static_cast<std::size_t>(item), changed}, EndEdit{}});
  return hand_over({});
}

// In the middle of the object.
EMSCRIPTEN_KEEPALIVE void page_add_weight() {
  carry_out({AddWeight{own_centre(app().state)}, EndEdit{}});
}

EMSCRIPTEN_KEEPALIVE void page_remove_weight(int item) {
  const evenlift::Document& document = app().state.work.document();
  if (item >= 0) carry_out({RemoveVertex{weight_handle(document, static_cast<std::size_t>(item))}});
}

EMSCRIPTEN_KEEPALIVE void page_select_weight(int item) {
  SelectVertex select;
  const evenlift::Document& document = app().state.work.document();
  if (item >= 0) select.vertex = weight_handle(document, static_cast<std::size_t>(item));
  carry_out({select});
}

// -1 without one.
EMSCRIPTEN_KEEPALIVE int page_hovered_weight() {
  const AppState& state = app().state;
  const Pick& pick = state.view.held.kind != Pick::Kind::none ? state.view.held : state.view.hover;
  return pick.kind == Pick::Kind::cargo ? static_cast<int>(pick.index) : -1;
}

// --- The robots, as supports (edits/vertices.h), with their planned loads

EMSCRIPTEN_KEEPALIVE int page_robot_count() {
  return static_cast<int>(supports_now(app().state).size());
}

// From `first` on: [[x, y, name, reading, "16.7 kg"], …].
EMSCRIPTEN_KEEPALIVE const char* page_robots(int first, int count) {
  const AppState& state = app().state;
  const evenlift::Points robots = supports_now(state);
  const auto [from, to] = part_of(robots.size(), first, count);
  const auto& placement = *state.derived().placement;
  const std::vector<double> loads = planned_loads(placement.teams);
  const std::vector<double>& readings = settings(state).weighed.readings;
  std::vector<std::string> rows;
  std::vector<std::string> of_supports(robots.size(), "–");  // a support that is left out has none
  for (std::size_t i = 0; placement.loads && i < loads.size(); ++i)
    of_supports[placement.support_of(i)] =
        load_in_words(loads[i], placement.loads->max, shown(state).units);
  for (std::size_t i = from; i < to; ++i) {
    const std::string& load = of_supports[i];
    const std::string reading = i < readings.size() ? json::number(readings[i]) : json::text("");
    rows.push_back(json::array({json::number(robots[i].x), json::number(robots[i].y),
                                json::text(evenlift::name_of_support(settings(state), i)), reading,
                                json::text(load)}));
  }
  return hand_over(json::array(rows));
}

}  // extern "C"

namespace {

std::string name_robot(std::size_t robot, const char* text) {
  Document named;
  named.settings.support_names = {text};
  const std::string name = text_of(evenlift::Setting::support_names, named);
  if (const auto wrong = read_setting(evenlift::Setting::support_names, name, named))
    return sentence(*wrong);
  const auto& read = named.settings.support_names;
  carry_out({EndEdit{}, NameRobot{robot, read.empty() ? std::string() : read[0]}, EndEdit{}});
  return {};
}

}  // namespace

extern "C" {

// Changes one coordinate or, as axis 2, the name. Robots of other methods are taken over.
EMSCRIPTEN_KEEPALIVE const char* page_set_robot(int robot, std::size_t axis, const char* text) {
  const AppState& state = app().state;
  evenlift::Points robots = supports_now(state);
  if (robot < 0 || robot >= static_cast<int>(robots.size()))
    return hand_over(say("This robot no longer exists"));
  if (axis == 2) return hand_over(name_robot(static_cast<std::size_t>(robot), text));
  std::string problem;
  const std::optional<double> value = coordinate(text, problem);
  if (!value) return hand_over(std::move(problem));
  Vec2& to = robots[static_cast<std::size_t>(robot)];
  to[axis] = *value;
  evenlift::Settings moved = settings(state);
  moved.supports = {to};
  const auto placed = place_supports(state.derived().placement->object, moved);
  if (!placed) return hand_over(std::string(translated(placed.error().message)));
  carry_out({EndEdit{}, PutRobot{static_cast<std::size_t>(robot), to}, EndEdit{}});
  return hand_over({});
}

// What all robots read, with spaces between; "none" without readings. They give the weight and C, in
// place of those that were given. Robots of other methods are taken over.
EMSCRIPTEN_KEEPALIVE const char* page_set_readings(const char* text) {
  AppState& state = app().state;
  if (!state.derived().placement) return hand_over({});
  Document weighed = state.work.document();
  weighed.settings = evenlift::view::taken_over(weighed.settings, *state.derived().placement);
  weighed.moved = {};
  if (const auto wrong = read_setting(evenlift::Setting::readings, text, weighed))
    return hand_over(sentence(*wrong));
  if (!weighed.settings.weighed.readings.empty()) {
    weighed.centre_of_mass.reset();
    weighed.settings.weight = evenlift::Settings{}.weight;
  }
  if (const auto placed = place(weighed, evenlift::Effort::whole, evenlift::Misfitting::left_out);
      !placed)
    return hand_over(std::string(translated(placed.error().message)));
  carry_out({EndEdit{}, SetReadings{std::move(weighed)}, EndEdit{}});
  return hand_over({});
}

// What the readings tell, and what is said if they do not fit: two texts, both empty without readings.
EMSCRIPTEN_KEEPALIVE const char* page_weighed() {
  const AppState& state = app().state;
  const auto& placement = state.derived().placement;
  if (!placement || state.derived().refusal || !placement->weighing)
    return hand_over(json::texts({"", ""}));
  const evenlift::Reported of({*placement, shown(state)}, state.derived().report);
  return hand_over(json::texts({weighed_in_words(of), misfit_of_readings(of)}));
}
EMSCRIPTEN_KEEPALIVE void page_take_over() { carry_out({TakeOver{}}); }

EMSCRIPTEN_KEEPALIVE void page_add_robot() { carry_out({AddRobot{}}); }

EMSCRIPTEN_KEEPALIVE void page_remove_robot(int robot) {
  if (robot >= 0) carry_out({RemoveRobot{static_cast<std::size_t>(robot)}});
}

// Rings a robot as if under the pointer; and the robot under the pointer, or -1.
EMSCRIPTEN_KEEPALIVE void page_point_at_robot(int robot) {
  const AppState& state = app().state;
  if (robot < 0 || robot >= static_cast<int>(supports_now(state).size())) return;
  const evenlift::Placement& placement = *state.derived().placement;
  const auto support = static_cast<std::size_t>(robot);
  Pick pick{Pick::Kind::left_out, support, 0, supports_now(state)[support]};
  for (std::size_t i = 0; i < count_robots(placement.teams); ++i) {
    if (placement.support_of(i) != support) continue;
    const auto [team, end] = find_robot(placement.teams, i);
    pick = {Pick::Kind::robot, team, static_cast<int>(end),
            placement.teams[team].robots[end].point.position};
  }
  carry_out({SetHover{pick}});
}
EMSCRIPTEN_KEEPALIVE int page_hovered_robot() {
  const AppState& state = app().state;
  const Pick& pick = state.view.held.kind != Pick::Kind::none ? state.view.held : state.view.hover;
  if (pick.kind == Pick::Kind::left_out) return static_cast<int>(pick.index);
  if (pick.kind != Pick::Kind::robot || pick.second || !state.derived().placement) return -1;
  const auto& teams = state.derived().placement->teams;
  if (teams.empty()) return -1;
  const std::size_t robot =
      pick.index * teams.front().robots.size() + static_cast<std::size_t>(pick.end);
  return static_cast<int>(state.derived().placement->support_of(robot));
}

// --- Sharing and saving: the last document that was not refused

EMSCRIPTEN_KEEPALIVE const char* page_wkt() {
  return hand_over(evenlift::write_wkt(app().state.derived().placed));
}
EMSCRIPTEN_KEEPALIVE const char* page_geojson() {
  return hand_over(evenlift::write_geojson(app().state.derived().placed));
}

// Why there is no link, or empty.
EMSCRIPTEN_KEEPALIVE const char* page_link_problem() {
  const Result<std::string> link = evenlift::encode_link(last_good(app().state));
  return hand_over(link ? std::string() : sentence(link.error()));
}

// --- Keys

// The actions with a key: [{"group", "key", "label"}, …].
EMSCRIPTEN_KEEPALIVE const char* page_keys() {
  std::vector<std::string> keys;
  for (const Action* action : key_list(app().state.session.screen.embed))
    keys.push_back(json::object({{"group", std::to_string(static_cast<int>(action->group))},
                                 {"key", json::text(action->shown)},
                                 {"label", json::text(action->label)}}));
  return hand_over(json::array(keys));
}

}  // extern "C"
