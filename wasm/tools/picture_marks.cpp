#include "tools/picture_marks.h"

#include <iterator>

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
bool has_base(const AppState& s) { return shown(s).overlays.lifting_base && stands(s); }
bool has_coverage(const AppState& s) { return has_base(s) && placement_of(s).loads; }
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
};
// In the order of PictureMark.
constexpr MarkRow rows[] = {
    {stands,
     "A disc is a robot. Its ring shows its load as a share of the greatest load; as many strokes as the number of its team (a broad one counts five) are on its outer side."},
    {has_centre,
     "C is the centre of mass: the object would balance on this point. It can be dragged."},
    {has_triangle, "The black triangle is a knife edge: set on its tip, the object would balance."},
    {has_slide,
     "The arrow: the object can slide this way, since no robot touches it so as to stop that."},
    {has_coverage,
     "The coverage: the share of the object that can be pressed down on without tipping it, if robots push back and none is overloaded."},
    {has_base,
     "Dark green: the part of the lifting base beyond the object. Nothing can press down on it."},
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

std::string mark_in_words(PictureMark mark) {
  return say(rows[static_cast<std::size_t>(mark)].words);
}

}  // namespace evenlift::view
