// Each promise is tested for all methods with a metric, including future ones.
#pragma once

#include <algorithm>
#include <iterator>
#include <vector>

#include "evenlift/document.h"

namespace evenlift::testing {

inline std::vector<Method> metrics() {
  std::vector<Method> found;
  std::copy_if(std::begin(all_methods), std::end(all_methods), std::back_inserter(found),
               selects_candidates);
  return found;
}

}  // namespace evenlift::testing
