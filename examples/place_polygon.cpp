// Places six robots under an L-shaped plate of 30 kg, and prints the place and the load of each.
#include <cstdio>

#include "evenlift/placement.h"

int main() {
  evenlift::Document plate;
  plate.vertices = {{0, 0}, {4, 0}, {4, 1.5}, {1.5, 1.5}, {1.5, 3}, {0, 3}};
  plate.settings.teams = 3;
  plate.settings.weight = 30;

  const evenlift::Result<evenlift::Placement> placement = evenlift::place(plate);
  if (!placement) {
    std::fprintf(stderr, "%s\n", placement.error().message.c_str());
    return 1;
  }
  for (const evenlift::Team& team : placement->teams) {
    const evenlift::Robot &r1 = team.robots[0], &r2 = team.robots[1];
    const evenlift::Vec2 &a = r1.point.position, &b = r2.point.position;
    std::printf("(%.2f, %.2f) bears %.2f, (%.2f, %.2f) bears %.2f\n", a.x, a.y, r1.load, b.x,
                b.y, r2.load);
  }
  std::printf("coverage %.0f %%, %s\n", 100 * placement->coverage,
              placement->closure.form_closure ? "form closure" : "no form closure");
}
