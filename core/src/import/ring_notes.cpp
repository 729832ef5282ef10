#include "import/ring_notes.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "evenlift/angles.h"
#include "evenlift/wording.h"

namespace evenlift {
namespace {

// Nearer to the equator widths are right within 0.5 %.
constexpr double low_latitude = 5;

// Numbers beyond these are not degrees, whatever the text says.
bool can_be_degrees(const Box& box) {
  return box.low.x >= -360 && box.high.x <= 360 && box.low.y >= -90 && box.high.y <= 90;
}

// Names the factor at the middle latitude.
std::string degrees_note(std::string_view note, const Box& box) {
  const double latitude = (box.low.y + box.high.y) / 2;
  const double shrinking = cosine(latitude * pi / 180);
  if (std::abs(latitude) > low_latitude && shrinking > 1e-3)
    return say("{note}: at latitude {latitude} widths come out {factor} times too large",
               {note, short_number(latitude), short_number(1 / shrinking)});
  return std::string(note);
}

}  // namespace

void RingNotes::drop_repeated(Points& ring) {
  const auto end = std::unique(ring.begin(), ring.end());
  repeated += static_cast<std::size_t>(std::distance(end, ring.end()));
  ring.erase(end, ring.end());
}

void RingNotes::add_to(Gathering& gathering) const {
  if (heights > 0) gathering.note("coordinates beyond x and y were left out");
  if (repeated > 0)
    gathering.note(say(repeated == 1
                           ? "{count} vertex at the place of the one before it was left out"
                           : "{count} vertices at the place of the one before them were left out",
                       {repeated}));
  if (!are_degrees || gathering.import.shapes.empty()) return;
  const Box box = box_of(gathering.import.shapes);
  if (!can_be_degrees(box) || gathering.projects()) return;
  gathering.import.in_degrees = true;
  gathering.note(degrees_note(in_degrees, box));
}

Box box_of(const std::vector<ImportedShape>& shapes) {
  Points corners;
  for (const ImportedShape& shape : shapes) {
    if (shape.document.vertices.empty()) continue;
    const Box box = bounding_box(shape.document.vertices);
    corners.push_back(box.low);
    corners.push_back(box.high);
  }
  return bounding_box(corners);
}

bool is_in_degrees(double code) {
  static constexpr double codes[] = {4326, 4979, 4258, 4269, 4267, 4283, 4230, 4171, 4612, 4674};
  return std::find(std::begin(codes), std::end(codes), code) != std::end(codes);
}

}  // namespace evenlift
