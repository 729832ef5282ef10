// Full names of length units.
#pragma once

#include "evenlift/document.h"

namespace evenlift {

// The unit's full name, such as "millimetres"; empty for LengthUnit::none.
inline const char* in_full(LengthUnit unit) {
  switch (unit) {
    case LengthUnit::m:
      return "metres";
    case LengthUnit::cm:
      return "centimetres";
    case LengthUnit::mm:
      return "millimetres";
    case LengthUnit::in:
      return "inches";
    case LengthUnit::none:
      break;
  }
  return "";
}

}  // namespace evenlift
