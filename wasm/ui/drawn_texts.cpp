#include "ui/drawn_texts.h"

#include "evenlift/wording.h"

namespace evenlift::view {
namespace {

std::vector<DrawnText>* recorded = nullptr;

}  // namespace

void record_texts(std::vector<DrawnText>* record) { recorded = record; }

void note_drawn(std::string_view text) {
  if (recorded) recorded->push_back({std::string(text), true});
}

void note_room(std::string_view text, float width, float room) {
  constexpr float rounding = 0.5f;
  if (recorded && width > room + rounding)
    recorded->push_back({std::string(translated(text)), false});
}

}  // namespace evenlift::view
