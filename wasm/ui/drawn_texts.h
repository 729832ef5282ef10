// Records the texts that the view draws, so that tests can check their language and their room.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace evenlift::view {

struct DrawnText {
  std::string text;  // as drawn
  bool has_room;     // the text fits its place
};

// From now on, adds drawn texts to the record; null ends the recording.
void record_texts(std::vector<DrawnText>* record);

void note_drawn(std::string_view text);
// Records the text only if its width is greater than the room for it, both in pixels.
void note_room(std::string_view text, float width, float room);

}  // namespace evenlift::view
