#include "ui/fonts.h"

namespace evenlift::view {
namespace {

constexpr unsigned char regular[] = {
#include "Inter-Regular.otf.inc"
};
constexpr unsigned char semibold[] = {
#include "Inter-SemiBold.otf.inc"
};

}  // namespace

FontData regular_font() { return {regular, sizeof regular}; }
FontData semibold_font() { return {semibold, sizeof semibold}; }

}  // namespace evenlift::view
