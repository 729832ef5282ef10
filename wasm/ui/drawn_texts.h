// What the view writes, so that tests can check its language and its room.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace evenlift::view {

struct DrawnText {
  std::string text;  // as drawn
  bool has_room;
};

// Adds each drawn text to the record, until it is called with null.
void record_texts(std::vector<DrawnText>* record);

void note_drawn(std::string_view text);
// A text of this width was drawn where there is this room.
void note_room(std::string_view text, float width, float room);

}  // namespace evenlift::view
