#include "ui/fonts.h"

#include <utility>

namespace evenlift::view {
namespace {

constexpr unsigned char regular[] = {
#include "Inter-Regular.otf.inc"
};
constexpr unsigned char semibold[] = {
#include "Inter-SemiBold.otf.inc"
};

// Kept for as long as Dear ImGui may read them.
std::vector<unsigned char> given_regular, given_semibold;

FontData data_of(const std::vector<unsigned char>& bytes) {
  return {bytes.data(), static_cast<int>(bytes.size())};
}

}  // namespace

FontData regular_font() {
  return given_regular.empty() ? FontData{regular, sizeof regular} : data_of(given_regular);
}
FontData semibold_font() {
  return given_semibold.empty() ? FontData{semibold, sizeof semibold} : data_of(given_semibold);
}

void give_fonts(std::vector<unsigned char> regular_bytes,
                std::vector<unsigned char> semibold_bytes) {
  given_regular = std::move(regular_bytes);
  given_semibold = std::move(semibold_bytes);
}

}  // namespace evenlift::view
