// A document together with what place() says of it. Validating a document and placing it is one
// step; its result is carried along to where it is shown, so that nothing is computed twice.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "evenlift/placement.h"
#include "evenlift/trace.h"

namespace evenlift::view {

struct Opened {
  Document document;
  Placement placement;
  std::optional<Trace> trace;  // if somebody had to look at it already
};

// Places the document, or says why it is refused. The cost of place().
Result<Opened> opened(Document document);

// The document that a link, or a link or a polygon's text, holds, placed; else the first error.
Result<Opened> read_link(std::string_view link);
Result<Opened> read_document(std::string_view text);

// The same without placing it.
Result<Document> parse_document(std::string_view text);

// The view computes by these alone. They count, so that a test can hold it to one placement for an
// action, and to none for what changes nothing but the picture.
Result<Placement> compute_placement(const Document& document);
Result<Trace> compute_trace(const Placement& placement);
struct Computed {
  std::uint64_t placements = 0, traces = 0;
};
Computed computed();  // since the start

}  // namespace evenlift::view
