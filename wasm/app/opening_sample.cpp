#include "app/opening.h"

namespace evenlift::view {

std::string_view opening_sample() {
  return
#include "opening_sample.inc"
      ;
}

}  // namespace evenlift::view
