// Apart from small_polygons.cpp, which programs use without the oracle.
#include "shapes/small_polygons.h"

namespace small_polygons {
namespace {

using Attempt = Case (*)(std::uint64_t number, std::uint64_t attempt);

Case first_valid(Attempt attempt_at, std::uint64_t number) {
  for (std::uint64_t attempt = 0;; ++attempt) {
    Case c = attempt_at(number, attempt);
    if (oracle::refusal(c.problem) == oracle::Refusal::none) return c;
  }
}

}  // namespace

Case make_case(std::uint64_t number) { return first_valid(attempt_case, number); }

Case make_plain_case(std::uint64_t number) { return first_valid(attempt_plain_case, number); }

}  // namespace small_polygons
