#include "tools/picture_marks.h"

#include <algorithm>
#include <iterator>

#include "evenlift/hull.h"
#include "evenlift/output/words.h"
#include "evenlift/wording.h"

namespace evenlift::view {
namespace {

const Placement& placement_of(const AppState& s) { return shown_placement(s); }

bool stands(const AppState& s) { return !placement_of(s).teams.empty(); }
bool has_centre(const AppState&) { return true; }
bool has_triangle(const AppState& s) { return is_one_team(settings(s).method); }
bool has_slide(const AppState& s) {
  const Closure& closure = placement_of(s).closure;
  return stands(s) && closure.translation_free && closure.translation && is_about_hold(s);
}
// In green, and so that a press within it tips nothing.
bool has_base(const AppState& s) {
  const Overlays& overlays = shown(s).overlays;
  return overlays.lifting_base && !overlays.tipping && !overlays.load &&
         placement_of(s).lifting_base.size() >= 3 && placement_of(s).loads && !shown_report(s).tips;
}
// Whether a part of the base is certainly beyond the object, whatever lies above its holes.
bool has_base_beyond(const AppState& s) {
  if (!has_base(s)) return false;
  const Placement& placement = placement_of(s);
  const double outline = placement.polygon().area(), object = placement.object.area(),
               above = placement.coverage * object + (outline - object);
  return signed_area(placement.lifting_base) > above + 1e-3 * outline;
}
bool has_clockwise(const AppState& s) {
  return shown(s).overlays.clockwise && stands(s) && placement_of(s).closure.clockwise.exists;
}
bool has_counterclockwise(const AppState& s) {
  return shown(s).overlays.counterclockwise && stands(s) &&
         placement_of(s).closure.counterclockwise.exists;
}

struct MarkRow {
  bool (*is_there)(const AppState&);
  const char* words;
  const char* of_one_team = nullptr;  // for balanced robots and those placed by hand, if it differs
  const char* with_cargo = nullptr;   // if it differs
};
// In the order of PictureMark.
constexpr MarkRow rows[] = {
    {stands,
     "A disc is a robot. Its ring shows its load as a share of the greatest load; strokes on its outer side tell its team.",
     "A disc is a robot. Its ring shows its load as a share of the greatest load."},
    {has_centre,
     "C is the centre of mass: the object would balance on this point. It can be dragged.", nullptr,
     "C is the centre of mass of the object with its cargo: together they would balance on this point."},
    {has_triangle, "The black triangle is a knife edge: set on its tip, the object would balance."},
    {has_slide,
     "The arrow: the object can slide this way, since no robot touches it so as to stop that."},
    {has_base,
     "The coverage: the share of the object that can be pressed down on without tipping it, if robots push back and none is overloaded."},
    {has_base_beyond,
     "Dark green: the part of the lifting base beyond the object, where nothing can be pressed down."},
    {has_base,
     "Green: the lifting base, with robots at its corners. A press down within it does not tip the object, if robots push back and none is overloaded."},
    {has_clockwise,
     "Red hatching: the object can still turn clockwise about these points. Robots at its corners do not count."},
    {has_counterclockwise,
     "Blue hatching: the object can still turn counter-clockwise about these points. Robots at its corners do not count."},
};
static_assert(std::size(rows) == static_cast<std::size_t>(PictureMark::end_of_marks));

}  // namespace

std::vector<PictureMark> marks_in_picture(const AppState& state) {
  std::vector<PictureMark> marks;
  if (!state.derived().placement || state.derived().refusal) return marks;
  for (std::size_t i = 0; i < std::size(rows); ++i)
    if (rows[i].is_there(state)) marks.push_back(static_cast<PictureMark>(i));
  return marks;
}

std::optional<PictureMark> explained_mark(const AppState& state) {
  if (!state.view.explained || state.view.tool != Tool::parts || walkthrough_is_open(state))
    return std::nullopt;
  const std::vector<PictureMark> marks = marks_in_picture(state);
  const bool is_there = std::find(marks.begin(), marks.end(), *state.view.explained) != marks.end();
  return is_there ? state.view.explained : std::nullopt;
}

std::string mark_in_words(const AppState& state, PictureMark mark) {
  const MarkRow& row = rows[static_cast<std::size_t>(mark)];
  const bool one_team = is_one_team(settings(state).method), cargo = !settings(state).cargo.empty();
  return say(one_team && row.of_one_team ? row.of_one_team
             : cargo && row.with_cargo   ? row.with_cargo
                                         : row.words);
}

}  // namespace evenlift::view
