// What the view writes, for tests: whether all of it is in the reader's language, and has room.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace evenlift::view {

struct DrawnText {
  std::string text;  // as it is drawn
  bool has_room;
};

// Adds each text that is drawn from now on to the record, until it is called with null.
void record_texts(std::vector<DrawnText>* record);

void note_drawn(std::string_view text);
// A text with this width was drawn where there is this room.
void note_room(std::string_view text, float width, float room);

}  // namespace evenlift::view
