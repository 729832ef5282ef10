// The size of the robots and what they may not touch, behind a row that opens it.
#include <algorithm>
#include <cmath>
#include <string>

#include "actions/actions.h"
#include "evenlift/output/words.h"
#include "evenlift/settings_text.h"
#include "panels/panels.h"
#include "state/method.h"
#include "widgets/buttons.h"
#include "widgets/cards.h"
#include "widgets/fields.h"
#include "widgets/sliders.h"
#include "widgets/text.h"

namespace evenlift::view {
namespace {

struct SizeRow {
  double RobotSize::*value;
  const char *label, *about, *id, *spoken, *setting;
};
constexpr SizeRow rows[] = {
    {&RobotSize::reach, "Reach", "Of the arm, from the body's rim to where it touches the object",
     "robot reach", "Reach of a robot's arm", "robot_reach"},
    {&RobotSize::depth, "Hand's depth", "How far the hand goes beneath the object, where it lifts",
     "robot depth", "Depth of a robot's hand", "robot_depth"},
    {&RobotSize::width, "Hand's width", "Along the edge; it must not stick out at a corner",
     "robot width", "Width of a robot's hand", "robot_width"},
    {&RobotSize::gap, "Gap", "That stays free between two robots", "robot gap",
     "Gap between two robots", "robot_gap"},
};

double size_of_object(const Ui& ui) {
  return ui.state.placement ? ui.state.placement->polygon.diagonal() : 100;
}

// A step of a size: a hundredth of the object, rounded to one digit.
double step_of(const Ui& ui) {
  return std::pow(10.0, std::floor(std::log10(size_of_object(ui) / 50)));
}

// Up to a tenth of the object, which few places have room for; more can be typed.
void draw_radius(const Ui& ui) {
  Settings changed = settings(ui.state);
  const double radius = changed.robot.radius, coarse = step_of(ui), step = coarse / 10;
  const double most = std::floor(size_of_object(ui) / 10 / coarse) * coarse;
  const Units& units = changed.units;
  const float width = labelled(ui, "Radius", "Of the robot's round body"),
              number = units.length == LengthUnit::none ? 60.0f : 84.0f;
  const SliderResult moved = slider(ui, "radius", "Radius of a robot, as a slider",
                                    std::min(radius, most), 0, most, step, width - number);
  ImGui::SameLine(0, 0);
  number_field(ui, "robot radius", "Radius of a robot", "robot_radius",
               with_length_unit(plain(moved.changed ? moved.value : radius), units), number,
               ui.theme.text);
  if (moved.changed) {
    changed.robot.radius = moved.value;
    ui.push(SetSettings{changed, true});
  }
  if (moved.released) ui.push(EndEdit{});
}

void draw_row(const Ui& ui, const SizeRow& row) {
  Settings changed = settings(ui.state);
  double& value = changed.robot.*(row.value);
  const float width = labelled(ui, row.label, row.about);
  const int by = stepper(ui, row.id, with_length_unit(plain(value), changed.units), width,
                         {.can_lower = value > 0,
                          .can_raise = value < max_coordinate,
                          .label = row.spoken,
                          .setting = row.setting});
  if (by == 0) return;
  const double first = step_of(ui);
  const double stepped_to = by > 0 ? (value < first ? first : stepped(value, by))
                                   : (value > first ? stepped(value, by) : 0);
  value = stepped_to < first ? 0 : stepped_to;
  ui.push(SetSettings{changed});
}

// Typed for those who do not paint them.
void draw_marks_row(const Ui& ui) {
  const float width =
      labelled(ui, "No-go edges", "Edges that must not be touched, such as 3,5:0.25-0.75; or none");
  text_field(ui, "no go", "Edges that no robot may touch", "no_go",
             no_go_text(settings(ui.state).no_go), width);
  const bool marks = ui.state.tool == Tool::mark;
  if (flat_button(ui, "mark edges", marks ? "Done with marking" : "Mark them with a brush",
                  ImGui::GetContentRegionAvail().x))
    action(ActionId::mark).run(ui.state, ui.commands);
}

// What is marked, and how much of the boundary is left.
std::string left_in_words(const Placement& placement) {
  std::string marked = no_go_in_words(placement.settings.no_go);
  if (!marked.empty()) marked += ' ';
  double all = 0, lost = 0;
  for (std::size_t edge = 0; edge < placement.polygon.size(); ++edge)
    all += length(placement.polygon.edge_end(edge) - placement.polygon.edge_start(edge));
  for (const UnusablePart& part : placement.stands->unusable())
    lost += part.part.to - part.part.from;
  if (lost == 0) return marked + "All of the boundary can be used.";
  return marked + percentage(std::clamp(1 - lost / all, 0.0, 1.0)) +
         " of the boundary can be used. Point at the rest to see why not.";
}

void draw_size_rows(const Ui& ui) {
  const AppState& state = ui.state;
  draw_radius(ui);
  for (const SizeRow& row : rows) draw_row(ui, row);
  draw_marks_row(ui);
  if (state.placement && state.placement->stands && !state.refusal)
    text_block(Face::label, ui.theme.second_text, left_in_words(*state.placement));
}

}  // namespace

void draw_robot_size(const Ui& ui) {
  // The row stays where the method has no use for it, so that what is below does not move.
  const bool useful = takes_sizes(settings(ui.state).method);
  const bool open = useful && ui.state.robot_open;
  const float head = ImGui::GetCursorPosY();
  const bool kept = !useful && (ui.state.aside.robot.value_or(RobotSize{}) != RobotSize{} ||
                                !ui.state.aside.no_go.value_or(std::vector<EdgePart>{}).empty());
  const char* label = kept   ? "Robots are points; their size is kept"
                      : open ? "Hide the robots' size"
                             : "Robots' size and no-go edges";
  if (flat_button(ui, "robot size", label, ImGui::GetContentRegionAvail().x, useful))
    ui.push(SetRobotOpen{!open});
  if (open) draw_size_rows(ui);
  show_opened("robot size is open", open, head);
}

}  // namespace evenlift::view
