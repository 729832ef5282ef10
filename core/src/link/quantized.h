// The coordinates of a polygon as a share link writes them: integers of a scale, and what each is
// expected to be.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "evenlift/vec.h"
#include "link/quantizer.h"

namespace evenlift {

// What the number of a coordinate is expected to be, from those of the vertices before.
enum class Guess : std::uint8_t {
  nothing,   // 0
  previous,  // the same as the last
  line,      // straight on from the last two
  repeat     // the step of four vertices ago again, as along a comb
};
inline constexpr Guess all_guesses[] = {Guess::nothing, Guess::previous, Guess::line,
                                        Guess::repeat};

// A way to write vertices; the writer tries some and takes the shortest.
struct Way {
  Scale scale{0};
  Guess guess = Guess::nothing;
};

// A coordinate: its number, or that the scale has none for it. Then its number is the guess.
struct Cell {
  double value = 0;
  std::int64_t number = 0;
  bool off_scale = false;
};
using Cells = std::vector<std::array<Cell, 2>>;

// The guess for vertex i from those before it. Wraps around beyond 64 bits. O(1).
inline std::uint64_t guess_number(Guess guess, const Cells& cells, std::size_t i,
                                  std::size_t axis) {
  const auto back = [&](std::size_t steps) {
    return static_cast<std::uint64_t>(cells[i - steps][axis].number);
  };
  if (i == 0 || guess == Guess::nothing) return 0;
  if (guess == Guess::line && i >= 2) return 2 * back(1) - back(2);
  if (guess == Guess::repeat && i >= 5) return back(1) + back(4) - back(5);
  return back(1);
}

// The vertices on the scale. O(n).
Cells cells_on(const Scale& scale, const Points& vertices);

}  // namespace evenlift
