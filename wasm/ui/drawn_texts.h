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

// From now on, adds drawn texts to the record; null ends this.
void record_texts(std::vector<DrawnText>* record);

// Records a drawn text.
void note_drawn(std::string_view text);
// Records a text whose width is greater than the room for it, both in pixels. Other texts are not
// recorded.
void note_room(std::string_view text, float width, float room);

}  // namespace evenlift::view
