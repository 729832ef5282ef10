#include "app/opening.h"

#include <optional>
#include <utility>

#include "app/conclude.h"
#include "edits/open_document.h"
#include "evenlift/link.h"
#include "evenlift/output/words.h"
#include "state/opened.h"

namespace evenlift::view {
namespace {

std::optional<Document> work_before(std::string_view work) {
  Result<Document> before = parse_document(work);
  if (!before) return std::nullopt;
  return std::move(before).value();
}

bool open_work(AppState& state, const LastVisit& visit) {
  if (visit.work.empty()) return false;
  Result<Opened> work = read_document(visit.work);
  if (!work) return false;
  start_with(state, std::move(work).value(), std::nullopt);
  conclude(state);
  if (Result<Document> draft = decode_link(visit.draft)) {
    resume_draft(state, std::move(draft).value());
    conclude(state);
  }
  return true;
}

}  // namespace

std::string open_page(AppState& state, const LastVisit& visit, std::string_view sample) {
  std::string problem;
  if (!visit.link.empty()) {
    if (Result<Opened> linked = read_link(visit.link)) {
      start_with(state, std::move(linked).value(), work_before(visit.work));
      conclude(state);
      return {};
    } else {
      problem = sentence(linked.error());
    }
  }
  if (!open_work(state, visit)) {
    start_with(state, std::move(read_document(sample)).value(), std::nullopt);
    conclude(state);
  }
  return problem;
}

}  // namespace evenlift::view
