#include "scene.h"

#include "triangulate.h"

namespace evenlift::view {

void follow(Scene& scene, const AppState& state) {
  if (scene.revision == state.revision || !state.placement) return;
  const bool same_polygon = !scene.shapes.empty() && scene.shapes[0].role == Role::object &&
                            scene.shapes[0].points == state.placement->vertices;
  // Overlays are the document's even while it is refused; the placement is the last good one.
  scene.shapes = make_picture(*state.placement, state.document.settings.overlays);
  if (!same_polygon) scene.triangles = triangulate(state.placement->vertices);
  scene.coverage = place_coverage(*state.placement, scene.coverage.at);
  scene.revision = state.revision;
}

}  // namespace evenlift::view
