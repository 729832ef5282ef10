#include "actions/nudge.h"

#include "actions/when.h"
#include "state/layout.h"
#include "tools/drawing.h"
#include "tools/handles.h"
#include "tools/transform.h"

namespace evenlift::view {

void move_cursor(const AppState& s, Commands& out, int x, int y, bool finely) {
  const Drawing& d = s.view.drawing;
  Vec2 at = d.cursor ? *d.cursor
            : !d.points.empty()
                ? d.points.back()
                : nearest_dot(s.view.camera, s.view.camera.to_world(layout(s).free.middle()));
  const bool begins = !d.cursor && d.points.empty();  // the first press shows the cursor
  if (!begins) {
    const double step = finely ? 1 / s.view.camera.scale : grid_step(s.view.camera);
    const Vec2 wanted = at + Vec2(x * step, y * step);
    const Vec2 to =
        finely ? rounded_finely(s.view.camera, wanted) : nearest_dot(s.view.camera, wanted);
    if (x != 0)
      at.x = to.x;
    else
      at.y = to.y;
  }
  out.push_back(SetDrawCursor{at, {}, true});
}

void nudge(const AppState& s, Commands& out, int x, int y) {
  if (when::drawing(s)) return move_cursor(s, out, x, y, false);
  if (when::transforming(s)) return out.push_back(moved_polygon(s, x, y));
  if (when::on_robot(s)) {
    const Vec2 along = Vec2(x, y) * (grid_step(s.view.camera) / 10);
    out.push_back(
        MoveRobot{*s.derived().explanation->robot, s.derived().explanation->of.at + along});
    return out.push_back(EndEdit{});
  }
  const double step = grid_step(s.view.camera) / (s.view.snap.grid ? 1 : 10);
  const Vec2 to = place_of(s.work.document(), *s.view.selected) + Vec2(x * step, y * step);
  out.push_back(MoveVertex{*s.view.selected, snapped(s, to)});
  out.push_back(EndEdit{});
}

}  // namespace evenlift::view
