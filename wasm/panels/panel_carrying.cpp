// The conditions under which the object is carried, behind a button that opens them.
#include <algorithm>
#include <cmath>
#include <string>

#include "actions/actions.h"
#include "evenlift/numbers.h"
#include "evenlift/output/carrying_words.h"
#include "panels/length_row.h"
#include "panels/panels.h"
#include "panels/summary.h"
#include "widgets/buttons.h"
#include "widgets/cards.h"
#include "widgets/fields.h"
#include "widgets/text.h"

namespace evenlift::view {
namespace {

constexpr LengthRow height{
    Setting::com_height, "Height of C",
    "Height of the centre of mass, of the object with its cargo, above the plane in "
    "which the robots lift",
    "Height of the centre of mass"};
constexpr LengthRow uneven{Setting::uneven, "Uneven by",
                           "How much the ground, or a robot's height, is off at most",
                           "Unevenness of the ground"};

// A ratio with a fixed step.
struct RatioRow {
  double Carrying::*member;
  Setting setting;
  double step;
  const char *id, *label, *about, *spoken;
  std::string (*text)(double value);
};
const RatioRow ratios[] = {
    {&Carrying::slope, Setting::slope, 0.01, "slope", "Slope",
     "Greatest slope, in any direction, of the plane in which the robots lift: the ground's, "
     "unless they level the object; type 8%, 4.6deg or 0.08",
     "Greatest slope", [](double value) { return slope_in_words(value); }},
    {&Carrying::acceleration, Setting::acceleration, 0.05, "acceleration", "Braked at",
     "Greatest acceleration along the ground in any direction, in g", "Greatest acceleration, in g",
     [](double value) { return plain(value) + "\u00A0g"; }},
};

void draw_ratio(const Ui& ui, const RatioRow& row) {
  Carrying changed = shown(ui.state).carrying;
  double& value = changed.*row.member;
  const SettingRange& range = row_of(row.setting).range;
  const int by = stepper(ui, row.id, row.text(value), labelled(ui, row.label, row.about),
                         {.can_lower = value > range.least,
                          .can_raise = value < range.most,
                          .label = row.spoken,
                          .setting = row.id,
                          .exact = shortest(value)});
  if (by == 0) return;
  const double steps = std::round(1 / row.step);
  value = std::clamp((std::round(value * steps) + by) / steps, range.least, range.most);
  ui.push(showing(ui.state, &Shown::carrying, changed));
}

const OptionalRow give{Setting::give,
                       "Robots give way",
                       "By how much a robot gives way under its mean load: its springs, tyres or "
                       "rubber. Without it, uneven ground can do its worst",
                       "Length by which a robot gives way",
                       "not known",
                       "no give",
                       "Not known"};
const OptionalRow extra{Setting::extra,
                        "Another load",
                        "A further weight that may stand on the object, such as a person or a box",
                        "Weight of another load",
                        "none",
                        "no extra",
                        "None"};

// Shows or hides an overlay that explains these numbers.
void draw_show(const Ui& ui, bool Overlays::*overlay, ActionId toggle, const char* show,
               const char* hide) {
  const bool on = shown(ui.state).overlays.*overlay;
  if (flat_button(ui, show, on ? hide : show, ImGui::GetContentRegionAvail().x))
    action(toggle).run(ui.state, ui.commands);
}

void draw_carrying_rows(const Ui& ui) {
  const Carrying& now = shown(ui.state).carrying;
  draw_length(ui, height);
  for (const RatioRow& row : ratios) draw_ratio(ui, row);
  draw_length(ui, uneven);
  draw_optional(ui, give);
  draw_optional(ui, extra);
  const std::string words = carrying_words(ui.state);
  if (!words.empty()) text_block(Face::label, ui.theme.second_text, words);
  if (now.com_height > 0)
    draw_show(ui, &Overlays::tilt, ActionId::toggle_tilt, "Show the slopes", "Hide the slopes");
  if (now.extra)
    draw_show(ui, &Overlays::load, ActionId::toggle_load, "Show where it may stand",
              "Hide where it may stand");
}

}  // namespace

void draw_carrying_button(const Ui& ui, float width) {
  const bool open = ui.state.view.carrying_open;
  if (flat_button(ui, "carrying", open ? "Hide carrying" : "Carrying", width))
    ui.push(SetSectionOpen{&View::carrying_open, !open});
  if (ImGui::IsItemHovered()) tip(ui, "Slopes, starts, uneven ground and another load");
}

void draw_carrying(const Ui& ui, float head) {
  const bool open = ui.state.view.carrying_open;
  if (open) draw_carrying_rows(ui);
  show_opened(ui, "carrying is open", open, head);
}

}  // namespace evenlift::view
