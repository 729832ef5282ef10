// The loads under a square of 80 kg.
#include <evenlift/placement.h>

#include <cstdio>

int main() {
  evenlift::Document square;
  square.vertices = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  square.settings.teams = 2;
  square.settings.weight = 80;
  const auto placement = evenlift::place(square);
  if (!placement) return 1;
  for (const double load : evenlift::planned_loads(placement->teams)) std::printf("%g\n", load);
}
