// Requests of any size, and the processor time that they may take (docs/performance.md).
#pragma once

#include <cstdint>
#include <string>

namespace bounds {

// A request as JSON (docs/requests.md) for a generated polygon, in words for people, and its bound.
struct Case {
  std::string request, text;
  double most_seconds;  // of a processor, natively
};

// A request of any kind. At most 1,000 vertices and 64 robots are placed within 10 s, others within
// 60 s; with a capacity, whose plans place other numbers of robots, within three times as much.
Case make_case(std::uint64_t number);

struct Outcome {
  std::string wrong;  // empty if the request is answered within its bound
  bool refused = false;
};
Outcome answer(const Case& c);

}  // namespace bounds
