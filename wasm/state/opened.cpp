#include "state/opened.h"

#include <utility>

#include "evenlift/formats.h"
#include "evenlift/link.h"

namespace evenlift::view {
namespace {

Computed so_far;

Result<Opened> opened(Result<Document> document) {
  if (!document) return document.error();
  return view::opened(std::move(document).value());
}

}  // namespace

Result<Placement> compute_placement(const Document& document,
                                    const std::optional<Placement>& before) {
  ++so_far.placements;
  if (before && before->vertices() == document.vertices)
    return place(before->polygon, document.centre_of_mass, document.settings, Effort::start,
                 document.moved);
  return place(document, Effort::start);
}

Result<Trace> compute_trace(const Placement& placement, HistoryLength length) {
  ++so_far.traces;
  return make_trace(placement, length);
}

Computed computed() { return so_far; }

Result<Opened> opened(Document document) {
  // A lesson shows teams where they were found.
  if (document.settings.step) document.moved.teams.clear();
  Result<Placement> placement = compute_placement(document);
  if (!placement) return placement.error();
  return Opened{std::move(document), std::move(placement).value(), std::nullopt};
}

Result<Document> parse_document(std::string_view text) {
  return looks_like_link(text) ? decode_link(text) : read_polygon(text);
}

Result<Opened> read_link(std::string_view link) { return opened(decode_link(link)); }
Result<Opened> read_document(std::string_view text) { return opened(parse_document(text)); }

}  // namespace evenlift::view
