// Reads drawings and tables as polygons. web/kit/import.js loads this WebAssembly module for a text
// that the program itself does not read.
#include <emscripten/emscripten.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "evenlift/formats.h"
#include "evenlift/import.h"
#include "evenlift/link.h"
#include "evenlift/output/json_text.h"
#include "evenlift/output/words.h"
#include "page/hand_over.h"

namespace {

using namespace evenlift;
using view::hand_over;

// Enough for a small picture.
constexpr std::size_t most_points = 512;

Import& imported() {
  static Import last;
  return last;
}

// An empty shape if the index is invalid.
const ImportedShape& shape(int index) {
  static const ImportedShape none;
  const auto at = static_cast<std::size_t>(index);
  return at < imported().shapes.size() ? imported().shapes[at] : none;
}

// [[x, y], …]
std::string thinned(const Points& vertices) {
  const std::size_t step = (vertices.size() + most_points - 1) / most_points;
  std::vector<std::string> points;
  for (std::size_t i = 0; i < vertices.size(); i += std::max<std::size_t>(step, 1))
    points.push_back(json::pair(vertices[i]));
  return json::array(points);
}

}  // namespace

extern "C" {

// `tolerance` is the greatest distance between curves and edges; 0 means the default. Returns why
// the text was refused, or an empty text; then the functions below return its contents.
EMSCRIPTEN_KEEPALIVE const char* import_read(const char* text, double tolerance) {
  ImportOptions options;
  if (tolerance != 0) options.tolerance = tolerance;
  imported() = {};
  Result<Import> read = read_shapes(text, options);
  if (!read) return hand_over(sentence(read.error()));
  imported() = std::move(read).value();
  return hand_over({});
}

EMSCRIPTEN_KEEPALIVE const char* import_format() { return hand_over(imported().format); }
EMSCRIPTEN_KEEPALIVE const char* import_unit() { return hand_over(imported().unit); }

// A JSON array.
EMSCRIPTEN_KEEPALIVE const char* import_notes() {
  std::vector<std::string> notes;
  for (const std::string& note : imported().notes) notes.push_back(json::text(note));
  return hand_over(json::array(notes));
}

// Whether a person should confirm the choice, because open lines are larger than any shape.
EMSCRIPTEN_KEEPALIVE int import_is_doubtful() { return imported().doubtful ? 1 : 0; }

// The lines that do not close, each as [[x, y], …].
EMSCRIPTEN_KEEPALIVE const char* import_left_open() {
  std::vector<std::string> lines;
  for (const Points& line : imported().left_open) lines.push_back(thinned(line));
  return hand_over(json::array(lines));
}

EMSCRIPTEN_KEEPALIVE int import_count() { return static_cast<int>(imported().shapes.size()); }

// For the shape with this index, from 0: name, description, the greatest distance between edges and
// curves (0 without curves) and, for a small picture, the outline as [[x, y], …] and the holes,
// each in this form.
EMSCRIPTEN_KEEPALIVE const char* import_name(int index) { return hand_over(shape(index).name); }
EMSCRIPTEN_KEEPALIVE const char* import_describe(int index) {
  return hand_over(describe(shape(index)));
}
EMSCRIPTEN_KEEPALIVE double import_tolerance(int index) {
  return shape(index).tolerance.value_or(0);
}
EMSCRIPTEN_KEEPALIVE const char* import_outline(int index) {
  return hand_over(thinned(shape(index).document.vertices));
}
EMSCRIPTEN_KEEPALIVE const char* import_holes(int index) {
  std::vector<std::string> holes;
  for (const Points& hole : shape(index).document.holes) holes.push_back(thinned(hole));
  return hand_over(json::array(holes));
}

// The text to open: a link, if settings are requested, the import has some or a unit of length, and
// the link is not too long; otherwise the polygon in the thesis's format.
EMSCRIPTEN_KEEPALIVE const char* import_text(int index, int with_settings) {
  const Document& document = shape(index).document;
  const bool has_unit = document.shown.units.length != LengthUnit::none;
  if (with_settings && (imported().has_settings || has_unit)) {
    const Result<std::string> link = encode_link(document);
    if (link) return hand_over(*link);
  }
  return hand_over(write_thesis(document));
}

}  // extern "C"
