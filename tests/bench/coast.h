#pragma once

#include "bench/bench.h"
#include "evenlift/document.h"
#include "evenlift/random.h"

namespace evenlift::bench {

// 20,480 vertices: each side of a pentagon is bent in its middle, by up to a sixth of its length,
// and so on.
inline Document coast() {
  Rng rng(seed);
  Document document;
  document.vertices = {{1000, 0}, {309, 951}, {-809, 588}, {-809, -588}, {309, -951}};
  for (int level = 0; level < 12; ++level) {
    Points finer;
    for (std::size_t i = 0; i < document.vertices.size(); ++i) {
      const Vec2 &a = document.vertices[i],
                 &b = document.vertices[(i + 1) % document.vertices.size()];
      finer.push_back(a);
      const double bend = (rng.uniform() - 0.5) / 3;
      finer.push_back(0.5 * (a + b) + bend * left_normal(b - a));
    }
    document.vertices = std::move(finer);
  }
  return document;
}

}  // namespace evenlift::bench
