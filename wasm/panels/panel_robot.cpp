// The robots' size and the no-go edges, behind a button that opens them.
#include <algorithm>
#include <cmath>
#include <string>

#include "actions/actions.h"
#include "evenlift/output/words.h"
#include "evenlift/settings.h"
#include "evenlift/wording.h"
#include "panels/length_row.h"
#include "panels/panels.h"
#include "state/method.h"
#include "widgets/buttons.h"
#include "widgets/cards.h"
#include "widgets/fields.h"
#include "widgets/sliders.h"
#include "widgets/text.h"

namespace evenlift::view {
namespace {

constexpr LengthRow rows[] = {
    {Setting::robot_reach, "Reach",
     "Length of the arm, from the body's rim to the contact with the object",
     "Reach of a robot's arm"},
    {Setting::robot_depth, "Hand's depth", "How far the hand reaches under the object to lift it",
     "Depth of a robot's hand"},
    {Setting::robot_width, "Hand's width",
     "Along the edge; the hand must not project past a corner", "Width of a robot's hand"},
    {Setting::robot_gap, "Gap", "Free distance between two robots", "Gap between two robots"},
};

// The slider ends at a tenth of the object's size: larger robots rarely fit, but can be typed.
void draw_radius(const Ui& ui) {
  Settings changed = settings(ui.state);
  const double radius = changed.robot.radius, size = size_of_object(ui.state),
               coarse = first_length(size), most = std::floor(size / 10 / coarse) * coarse;
  const Units& units = shown(ui.state).units;
  const float width = labelled(ui, "Radius", "Radius of the robot's round body"),
              number = units.length == LengthUnit::none ? 60.0f : 84.0f;
  const SliderResult moved = slider(ui, "radius", "Radius of a robot, as a slider",
                                    std::min(radius, most), 0, most, coarse / 10, width - number);
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

// No-go edges, typed or painted.
void draw_marks_row(const Ui& ui) {
  const float width = labelled(
      ui, "No-go edges",
      "Edges, or parts of them, that robots must not touch, such as 3,5:0.25-0.75; or none");
  text_field(ui, "no go", "No-go edges", "no_go", no_go_text(settings(ui.state).no_go), width);
  const bool marks = ui.state.view.tool == Tool::mark;
  if (flat_button(ui, "mark edges", marks ? "Finish marking" : "Mark no-go parts",
                  ImGui::GetContentRegionAvail().x))
    action(ActionId::mark).run(ui.state, ui.commands);
}

std::string left_in_words(const Placement& placement) {
  std::string marked = no_go_in_words(placement.settings.no_go);
  if (!marked.empty()) marked += ' ';
  double all = 0, lost = 0;
  for (std::size_t edge = 0; edge < placement.polygon().size(); ++edge)
    all += length(placement.polygon().edge_end(edge) - placement.polygon().edge_start(edge));
  for (const UnusablePart& part : placement.stands->unusable())
    lost += part.part.to - part.part.from;
  if (lost == 0) return marked + say("The whole boundary can be used.");
  return marked + say("{share} of the boundary can be used. Point at the rest to see why not.",
                      {percentage(std::clamp(1 - lost / all, 0.0, 1.0))});
}

void draw_size_rows(const Ui& ui) {
  const AppState& state = ui.state;
  draw_radius(ui);
  for (const LengthRow& row : rows) draw_length(ui, row);
  draw_marks_row(ui);
  if (state.derived().placement && state.derived().placement->stands && !state.derived().refusal)
    text_block(Face::label, ui.theme.second_text, left_in_words(*state.derived().placement));
}

}  // namespace

void draw_robot_size(const Ui& ui) {
  // The button stays even if the method does not use it, so that nothing below moves.
  const bool useful = takes_sizes(settings(ui.state).method);
  const bool open = useful && ui.state.view.robot_open;
  const float head = ImGui::GetCursorPosY();
  const bool kept =
      !useful && (ui.state.work.aside.robot.value_or(RobotSize{}) != RobotSize{} ||
                  !ui.state.work.aside.no_go.value_or(std::vector<EdgePart>{}).empty());
  const char* label = kept   ? "Robots are points; their size is kept"
                      : open ? "Hide the robots' size"
                             : "Robots' size and no-go edges";
  if (flat_button(ui, "robot size", label, ImGui::GetContentRegionAvail().x, useful))
    ui.push(SetSectionOpen{&View::robot_open, !open});
  if (open) draw_size_rows(ui);
  show_opened(ui, "robot size is open", open, head);
}

}  // namespace evenlift::view
