#include "evenlift/vec.h"

#include <cmath>

namespace evenlift {

double length(const Vec2& a) { return std::sqrt(a.x() * a.x() + a.y() * a.y()); }

}  // namespace evenlift
