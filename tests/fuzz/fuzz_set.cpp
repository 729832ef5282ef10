// Any bytes as lines of window.evenlift.set(): refused with the setting's name, or a document with
// settings in range that place() answers.
#include <algorithm>
#include <cstdint>

#include "app/update.h"
#include "evenlift/placement.h"
#include "evenlift/settings.h"
#include "fuzz/fuzz.h"
#include "kit/random_documents.h"

namespace {

using namespace evenlift;

Document document() {
  Document d;
  d.vertices = {{0, 0}, {400, 0}, {400, 150}, {150, 150}, {150, 300}, {0, 300}};
  return d;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view lines = fuzz::text_of(data, size);
  const Result<view::Changeable> changed = view::with_settings({document()}, lines);
  if (!changed) {
    fuzz::require(!changed.error().message.empty());
    return 0;
  }
  fuzz::require(!check_settings(changed->document.settings, changed->document.shown));
  // Setting the same again changes nothing.
  const Result<view::Changeable> again = view::with_settings(*changed, lines);
  fuzz::require(again.ok() && again->failed == changed->failed &&
                testing::same_document(again->document, changed->document));
  // The benchmarks time a million robots.
  Document few = changed->document;
  if (few.settings.teams) few.settings.teams = std::min<std::uint32_t>(*few.settings.teams, 1000);
  const Result<Placement> placement = place(few);
  fuzz::require(placement.ok() || !placement.error().message.empty());
  return 0;
}
