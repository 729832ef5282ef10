// Two robots lift a beam of 20 kg at the two ends of a chord through its centre of mass. The left
// one moves towards the middle: by the law of the lever it carries more and more of the weight.
#include <cstdio>

#include "evenlift/loads.h"

int main() {
  const double half = 2;  // metres from the centre of mass to each end of the beam
  for (double arm = half; arm >= 0.5; arm -= 0.5) {
    evenlift::Chord chord;
    chord.r1.position = {-arm, 0};
    chord.r2.position = {half, 0};
    chord.arm1 = arm;
    chord.arm2 = half;
    chord.ratio = arm / half;
    const evenlift::Team team = evenlift::distribute_weight({chord}, 20)[0];
    std::printf("%.1f m and %.1f m: %4.1f kg and %4.1f kg\n", arm, half, team.robots[0].load,
                team.robots[1].load);
  }
}
