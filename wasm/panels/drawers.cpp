#include "panels/drawers.h"

#include <algorithm>
#include <iterator>

#include "actions/actions.h"
#include "evenlift/numbers.h"
#include "evenlift/output/carrying_words.h"
#include "evenlift/output/words.h"
#include "evenlift/wording.h"
#include "panels/panels.h"
#include "state/method.h"
#include "widgets/buttons.h"
#include "widgets/fields.h"
#include "widgets/text.h"

namespace evenlift::view {
namespace {

bool is_balanced(const AppState& s) { return settings(s).method == Method::balanced; }
bool is_given(const AppState& s) { return settings(s).method == Method::given; }
bool is_random(const AppState& s) { return settings(s).method == Method::random; }
bool chooses(const AppState& s) { return selects_candidates(settings(s).method); }
bool has_goal(const AppState& s) { return is_balanced(s) || chooses(s); }
bool has_sizes(const AppState& s) { return takes_sizes(settings(s).method); }
bool keeps_sizes(const AppState& s) {
  return !has_sizes(s) && (s.work.aside.robot.value_or(RobotSize{}) != RobotSize{} ||
                           !s.work.aside.no_go.value_or(std::vector<EdgePart>{}).empty());
}

// Holes and weights need an object that is not refused, and a walkthrough shows another one.
bool can_draw(const AppState& s) {
  return s.derived().placement && !s.derived().refusal && !walkthrough_is_open(s);
}

std::string percent_text(const AppState&, double value) { return slope_in_words(value); }
std::string g_text(const AppState&, double value) {
  return value == 0 ? say("none") : significant(value, 3) + "\u00A0g";
}
std::string plain_text(const AppState&, double value) { return plain(value); }

// With the digits of the ratio: 0.07 is 7%, although 100 times 0.07 is not 7.
std::string exact_percentage(double ratio) {
  constexpr double digits = 1e13;
  const double percentage = std::round(100 * ratio * digits) / digits;
  return shortest(percentage / 100 == ratio ? percentage : 100 * ratio) + "%";
}

constexpr DrawerRow height_of_c(Drawer drawer,
                                std::string (*told)(const AppState&, const DrawerRow&)) {
  return {.drawer = drawer,
          .setting = Setting::com_height,
          .label = "Height of C",
          .about =
              "Height of the centre of mass, of the object with its cargo, above the plane in "
              "which the robots lift",
          .draw = draw_length,
          .told = told,
          .spoken = "Height of the centre of mass",
          .text = length_text};
}

// clang-format off
constexpr DrawerRow rows[] = {
    {.drawer = Drawer::object, .setting = Setting::com, .label = "Centre of mass",
     .about = "Drag it in the drawing, or type x and y; the default is the centroid",
     .draw = draw_centre, .told = told_centre},
    {.drawer = Drawer::object, .setting = Setting::com_radius, .label = "C uncertainty",
     .about = "The centre of mass may be anywhere within this distance of its shown place",
     .draw = draw_length, .told = told_setting, .spoken = "Uncertainty of the centre of mass",
     .text = length_text},
    {.drawer = Drawer::object, .draw = draw_uncertainty_words},
    height_of_c(Drawer::object, told_setting),
    {.drawer = Drawer::object, .setting = Setting::unit, .label = "Units",
     .about = "Labels of lengths and weights; no number changes",
     .draw = draw_units, .told = told_units},
    {.drawer = Drawer::object, .setting = Setting::cargo, .label = "Cargo",
     .about = "Weights on the object, such as a motor; each is part of the load",
     .draw = draw_cargo, .told = told_cargo, .offered = can_draw},
    {.drawer = Drawer::object, .label = "Holes", .about = "Openings through the object",
     .draw = draw_holes, .told = told_holes, .offered = can_draw},

    {.drawer = Drawer::robots, .setting = Setting::capacity, .label = "A robot carries",
     .about = "The greatest load of one robot; type it to see the number of robots needed",
     .draw = draw_capacity, .told = told_setting, .text = weight_text,
     .without = "no limit", .unset_id = "any", .unset = "No limit"},
    {.drawer = Drawer::robots, .setting = Setting::min_ratio, .label = "Min. load ratio",
     .about = "The least load ratio of a team's two robots; 1 is even",
     .draw = draw_min_ratio, .told = told_min_ratio, .text = plain_text},
    {.drawer = Drawer::robots, .setting = Setting::seed, .label = "Seed",
     .about = "Another seed places other teams at random",
     .draw = draw_seed, .told = told_setting, .offered = is_random},
    {.drawer = Drawer::robots, .setting = Setting::goal, .label = "Goal",
     .draw = draw_goal, .told = told_goal, .offered = has_goal},
    {.drawer = Drawer::robots, .setting = Setting::survive, .label = "Survive",
     .about = "The object should stay steady if any robots, up to this number, fail",
     .draw = draw_survive, .told = told_setting, .offered = is_balanced},
    {.drawer = Drawer::robots, .setting = Setting::robot_radius, .label = "Radius",
     .about = "Radius of the robot's round body",
     .draw = draw_radius, .told = told_setting, .offered = has_sizes, .text = length_text},
    {.drawer = Drawer::robots, .setting = Setting::robot_reach, .label = "Reach",
     .about = "Length of the arm, from the body's rim to the contact with the object",
     .draw = draw_length, .told = told_setting, .offered = has_sizes,
     .spoken = "Reach of a robot's arm", .text = length_text},
    {.drawer = Drawer::robots, .setting = Setting::robot_depth, .label = "Hand's depth",
     .about = "How far the hand reaches under the object to lift it",
     .draw = draw_length, .told = told_setting, .offered = has_sizes,
     .spoken = "Depth of a robot's hand", .text = length_text},
    {.drawer = Drawer::robots, .setting = Setting::robot_width, .label = "Hand's width",
     .about = "Along the edge; the hand must not project past a corner",
     .draw = draw_length, .told = told_setting, .offered = has_sizes,
     .spoken = "Width of a robot's hand", .text = length_text},
    {.drawer = Drawer::robots, .setting = Setting::robot_gap, .label = "Gap",
     .about = "Free distance between two robots",
     .draw = draw_length, .told = told_setting, .offered = has_sizes,
     .spoken = "Gap between two robots", .text = length_text},
    {.drawer = Drawer::robots, .setting = Setting::no_go, .label = "No-go edges",
     .about = "Edges, or parts of them, that robots must not touch, such as 3,5:0.25-0.75; or none",
     .draw = draw_no_go, .told = told_no_go, .offered = has_sizes},
    {.drawer = Drawer::robots, .draw = draw_left_of_boundary, .offered = has_sizes},
    {.drawer = Drawer::robots, .draw = draw_sizes_kept, .told = told_sizes_kept, .offered = keeps_sizes},
    {.drawer = Drawer::robots, .setting = Setting::accuracy, .label = "Accuracy",
     .about = "Robots may be off their places by this: what is found still holds",
     .draw = draw_length, .told = told_setting, .spoken = "How far robots may be off their places",
     .text = length_text, .member = &Settings::accuracy,
     .usual = "Default: exact, but you are told how far robots may be off"},
    {.drawer = Drawer::robots, .setting = Setting::clear, .label = "Clear of corners",
     .about = "A hold does not rely on robots nearer to a corner than this",
     .draw = draw_length, .told = told_setting, .spoken = "Distance of holds from corners",
     .text = length_text, .member = &Settings::clear,
     .usual = "Default: 2 % of the object's radius"},
    {.drawer = Drawer::robots, .setting = Setting::positions, .label = "Positions",
     .about = "Where on two edges a team may stand",
     .draw = draw_positions, .told = told_positions, .offered = chooses},
    {.drawer = Drawer::robots, .setting = Setting::apart, .label = "Keep apart",
     .about = "Robots should be at least this far from each other",
     .draw = draw_length, .told = told_setting, .offered = is_balanced,
     .spoken = "Least distance between robots", .text = length_text, .member = &Settings::apart,
     .usual = "Default: 12 % of the object's radius"},
    {.drawer = Drawer::robots, .setting = Setting::snap, .label = "Snap",
     .about = "Robots within this distance of the outline stand at the edge",
     .draw = draw_length, .told = told_setting, .offered = is_given,
     .spoken = "Snap distance of robots", .text = length_text, .member = &Settings::snap,
     .usual = "Default: 1/10,000 of the object's size"},

    {.drawer = Drawer::carrying, .setting = Setting::slope, .label = "Slope",
     .about = "Greatest slope, in any direction, of the plane in which the robots lift: the ground's, "
              "unless they level the object; type 8 or 8%, or 4.6°",
     .draw = draw_ratio, .told = told_setting, .spoken = "Greatest slope", .text = percent_text,
     .exact = exact_percentage, .step = 0.01},
    height_of_c(Drawer::carrying, nullptr),  // a slope tips nothing without it
    {.drawer = Drawer::carrying, .setting = Setting::acceleration, .label = "Braked at",
     .about = "Greatest acceleration along the ground in any direction, in g, or with its unit: 2 m/s2",
     .draw = draw_ratio, .told = told_setting, .spoken = "Greatest acceleration, in g",
     .text = g_text, .exact = shortest, .step = 0.05},
    {.drawer = Drawer::carrying, .setting = Setting::dynamic, .label = "Dynamic factor",
     .about = "Factor on the greatest loads before they meet a capacity: a crane's lift 1.1 to 1.3",
     .draw = draw_ratio, .told = told_setting, .text = plain_text, .exact = shortest, .step = 0.05},
    {.drawer = Drawer::carrying, .setting = Setting::weight_doubt, .label = "Weight off by",
     .about = "How far the weight may be off, either way, as a part of it",
     .draw = draw_ratio, .told = told_setting, .spoken = "How far the weight may be off",
     .text = percent_text, .exact = exact_percentage, .step = 0.01},
    {.drawer = Drawer::carrying, .setting = Setting::uneven, .label = "Uneven by",
     .about = "How much the ground, or a robot's height, is off at most",
     .draw = draw_length, .told = told_setting, .spoken = "Unevenness of the ground",
     .text = length_text},
    {.drawer = Drawer::carrying, .setting = Setting::give, .label = "Robots give way",
     .about = "By how much a robot gives way under its mean load: its springs, tyres or "
              "rubber. Without it, uneven ground can do its worst",
     .draw = draw_optional, .told = told_setting, .spoken = "Length by which a robot gives way",
     .text = length_text, .without = "not known", .unset_id = "no give", .unset = "Not known"},
    {.drawer = Drawer::carrying, .setting = Setting::extra, .label = "Another load",
     .about = "A further weight that may stand on the object, such as a person or a box",
     .draw = draw_optional, .told = told_setting, .spoken = "Weight of another load",
     .text = weight_text, .without = "none", .unset_id = "no extra", .unset = "None"},
    {.drawer = Drawer::carrying, .draw = draw_carrying_words},

    {.drawer = Drawer::weighing, .setting = Setting::reading_error, .label = "Readings off by",
     .about = "How far a reading may be off: a part of each, such as 1%, or a weight",
     .draw = draw_text, .told = told_setting},
    {.drawer = Drawer::weighing, .setting = Setting::level_error, .label = "Level within",
     .about = "How far from level the robots' lifting points may be while you read, such as 1% or 0.5°",
     .draw = draw_text, .told = told_setting},
    {.drawer = Drawer::weighing, .setting = Setting::tilted, .label = "Second: slope",
     .about = "A second weighing on a known slope tells the height of C: its slope, such as 5°",
     .draw = draw_text},
    {.drawer = Drawer::weighing, .setting = Setting::heading, .label = "Second: uphill",
     .about = "The direction uphill, such as 1,0 or 90°",
     .draw = draw_text},
    {.drawer = Drawer::weighing, .setting = Setting::readings_tilted, .label = "Second: readings",
     .about = "What the robots read on that slope, in their order, with spaces between",
     .draw = draw_text, .told = told_setting},

    {.drawer = Drawer::show, .setting = Setting::overlays, .draw = draw_overlays, .told = told_overlays},
    {.drawer = Drawer::show, .label = "Loads shown",
     .about = "The assumption behind the loads in the drawing and the table",
     .draw = draw_model, .told = told_model},

    {.drawer = Drawer::compare, .label = "Compare with",
     .about = "Shows the same object under a second method beside the first",
     .draw = draw_compare, .told = told_compare},
};
// clang-format on

bool can_compare(const AppState& s) { return !walkthrough_is_open(s) && !stays_by_hand(s); }
bool can_show(const AppState& s) { return !walkthrough_is_open(s); }

struct DrawerHead {
  const char *name, *contents;  // the contents are shown while all is as usual
  bool (*offered)(const AppState&) = nullptr;
};
// In the order of Drawer.
constexpr DrawerHead heads[] = {
    {"Object", "C, its height, units, cargo, holes"},
    {"Robots", "capacity, accuracy, size, goal"},
    {"Carrying", "slope, braking, uneven ground"},
    {"Weighing", "errors, and a second weighing", when::is_weighed},
    {"Show", "lifting base, chords, tipping", can_show},
    {"Compare", "another method, the optimum", can_compare},
};
static_assert(std::size(heads) == drawer_count);

bool is_offered(const AppState& state, const DrawerRow& row) {
  return !row.offered || row.offered(state);
}

std::string line_of(const AppState& state, Drawer drawer) {
  std::string line;
  for (const DrawerRow& row : rows) {
    if (row.drawer != drawer || !row.told || !is_offered(state, row)) continue;
    const std::string told = row.told(state, row);
    if (!told.empty()) line += (line.empty() ? "" : " · ") + told;
  }
  return line;
}

void draw_head(const Ui& ui, Drawer drawer, bool open) {
  constexpr float line_at = 100, chevron = 20;
  const DrawerHead& head = heads[static_cast<std::size_t>(drawer)];
  const std::string line = line_of(ui.state, drawer);
  const std::string spoken = line.empty() ? head.name : say("{drawer}: {line}", {head.name, line});
  const Area a = area(ui, ImVec2(ImGui::GetContentRegionAvail().x, ui.control()),
                      toggle_control(head.name, spoken.c_str(), open));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (a.hovered || a.active)
    list.AddRectFilled(ImVec2(a.low.x - 6, a.low.y), ImVec2(a.high.x + 6, a.high.y),
                       ui.theme.well.packed(), 7);
  const auto at = [&](float x, Face face) {
    return ImVec2(a.low.x + x, a.middle().y - text_size(face, "C").y / 2);
  };
  draw_text(list, Face::text, at(0, Face::text), ui.theme.text, head.name);
  const float room = a.high.x - a.low.x - line_at - chevron;
  if (!open)
    draw_text(
        list, Face::label, at(line_at, Face::label),
        line.empty() ? ui.theme.second_text : ui.theme.accent,
        cut_off(Face::label, line.empty() ? std::string(translated(head.contents)) : line, room));
  draw_icon(list, open ? Icon::up : Icon::down, ImVec2(a.high.x - 8, a.middle().y), 12,
            ui.theme.second_text);
  if (a.hovered && !open && !line.empty()) tip(ui, line.c_str());
  if (a.pressed) ui.push(SetDrawerOpen{drawer, !open});
}

// A key that asks for a field opens its drawer.
bool has_wanted_field(const AppState& state, Drawer drawer) {
  return std::any_of(std::begin(rows), std::end(rows), [&](const DrawerRow& row) {
    return row.drawer == drawer && row.setting && is_offered(state, row) &&
           id_of(*row.setting) == state.session.wanted_field;
  });
}

}  // namespace

std::string id_of(Setting setting) {
  std::string id(name(setting));
  std::replace(id.begin(), id.end(), '_', ' ');
  return id;
}

std::string told_setting(const AppState& state, const DrawerRow& row) {
  static const Document usual;
  const std::string text = text_of(*row.setting, state.work.document());
  if (text == text_of(*row.setting, usual)) return {};
  const std::optional<double> number = row.text ? read_number(text) : std::nullopt;
  return say("{setting} {value}", {row.label, number ? row.text(state, *number) : as_read(text)});
}

void draw_drawers(const Ui& ui) {
  for (std::size_t i = 0; i < drawer_count; ++i) {
    const auto drawer = static_cast<Drawer>(i);
    if (heads[i].offered && !heads[i].offered(ui.state)) continue;
    const bool open = ui.state.view.open_drawers[i];
    const float from = ImGui::GetCursorPosY();
    draw_head(ui, drawer, open);
    if (!open && !ui.state.session.wanted_field.empty() && has_wanted_field(ui.state, drawer))
      ui.push(SetDrawerOpen{drawer, true});
    if (open) {
      ImGui::PushID(heads[i].name);  // the height of C is in two drawers
      for (const DrawerRow& row : rows)
        if (row.drawer == drawer && is_offered(ui.state, row)) row.draw(ui, row);
      ImGui::PopID();
      ImGui::Dummy(ImVec2(0, 4));
    }
    show_opened(ui, heads[i].name, open, from);
  }
  if (!ui.state.session.wanted_field.empty()) ui.push(ForgetField{});
}

}  // namespace evenlift::view
