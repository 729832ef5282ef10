// Apart from small_polygons.cpp, which programs without the oracle use as well.
#include "small_polygons.h"

namespace small_polygons {

Case make_case(std::uint64_t number) {
  for (std::uint64_t attempt = 0;; ++attempt) {
    Case c = attempt_case(number, attempt);
    if (oracle::refusal(c.problem) == oracle::Refusal::none) return c;
  }
}

}  // namespace small_polygons
