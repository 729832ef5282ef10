// Any bytes as the page's texts in storage, which any script of its origin or other version may
// have written. Bytes 0 separate the address's fragment, the work, the refused draft, the drawing
// and the preferences. The page must open with a placement, and keep texts that open the same
// document.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/opening.h"
#include "app/update.h"
#include "evenlift/formats.h"
#include "evenlift/link.h"
#include "fuzz/fuzz.h"
#include "kit/random_documents.h"
#include "state/derived.h"
#include "tools/drawing.h"

namespace {

using namespace evenlift;
using namespace evenlift::view;

std::vector<std::string_view> parted(std::string_view text) {
  std::vector<std::string_view> parts;
  for (int i = 0; i < 5; ++i) {
    const std::size_t end = text.find('\0');
    parts.push_back(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return parts;
}

constexpr std::string_view sample = "(0,0)\n(400,0)\n(400,150)\n(150,150)\n(150,300)\n(0,300)\n";

// Like page_resume_drawing().
void resume_drawing(AppState& state, std::string_view text) {
  const auto kept = read_drawing(text);
  if (!kept || kept->points.empty()) return;
  Commands commands{SetTool{kept->is_hole ? Tool::hole : Tool::draw}};
  for (const Vec2& p : kept->points) commands.push_back(AddPoint{p});
  apply(state, commands);
  const auto again = read_drawing(drawing_text(state.view.drawing, kept->is_hole));
  fuzz::require(again.has_value() &&
                testing::same_vertices(again->points, state.view.drawing.points));
}

// Like page_keep().
void keep_preferences(std::string_view text) {
  const Kept kept = read_kept(text);
  fuzz::require(read_kept(kept_text(kept)).motion == kept.motion);
}

// What the page would keep opens the same document.
void require_kept(const AppState& state) {
  const Result<Document> from_text = parse_document(write_thesis(last_good(state)));
  fuzz::require(from_text.ok() && testing::same_polygon(*from_text, last_good(state)));
  const Result<std::string> link = encode_link(last_good(state));
  if (!link) return;
  const Result<Document> from_link = parse_document(*link);
  fuzz::require(from_link.ok() && testing::same_document(*from_link, last_good(state)));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::vector<std::string_view> parts = parted(fuzz::text_of(data, size));
  AppState state;
  open_page(state, {parts[0], parts[1], parts[2]}, sample);
  fuzz::require(state.derived().placement.has_value());
  keep_preferences(parts[4]);
  require_kept(state);
  resume_drawing(state, parts[3]);
  fuzz::require(state.derived().placement.has_value());
  // After all undos, a placement remains.
  Commands undo{Undo{}};
  apply(state, undo);
  fuzz::require(state.derived().placement.has_value());
  return 0;
}
