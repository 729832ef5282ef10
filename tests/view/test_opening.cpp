#include <string>

#include "app/opening.h"
#include "app/update.h"
#include "evenlift/link.h"
#include "kit/catch.h"
#include "state/derived.h"

using namespace evenlift;
using namespace evenlift::view;

namespace {

const std::string sample = "(0,0)\n(400,0)\n(400,150)\n(150,150)\n(150,300)\n(0,300)\n";
const std::string triangle = "(0,0)\n(4,0)\n(0,3)\n";
const std::string square = "(0,0)\n(2,0)\n(2,2)\n(0,2)\n";
// Its edges cross: refused.
const std::string unliftable = "(0,0)\n(2,2)\n(2,0)\n(0,2)\n";

std::string link_of(const std::string& text) {
  return encode_link(parse_document(text).value()).value();
}

std::size_t corners(const AppState& state) { return state.derived().placement->vertices().size(); }

}  // namespace

TEST_CASE("without work or a link the page opens on the sample, with nothing to undo",
          "[view][opening]") {
  AppState state;
  CHECK(open_page(state, {}, sample).empty());
  CHECK(corners(state) == 6);
  CHECK_FALSE(state.work.history.can_undo());
}

TEST_CASE("a link is opened one undo after the work", "[view][opening]") {
  AppState state;
  const std::string link = link_of(triangle);
  CHECK(open_page(state, {link, square, {}}, sample).empty());
  CHECK(corners(state) == 3);
  Commands commands{Undo{}};
  apply(state, commands);
  CHECK(corners(state) == 4);
}

TEST_CASE("a link that cannot be read leaves the work open, with its draft, and says why",
          "[view][opening]") {
  AppState state;
  const std::string draft = link_of(unliftable);
  CHECK_FALSE(open_page(state, {"nonsense", square, draft}, sample).empty());
  CHECK(corners(state) == 4);
  CHECK(state.derived().refusal.has_value());
}

TEST_CASE("damaged work is passed over for the sample", "[view][opening]") {
  AppState state;
  CHECK(open_page(state, {{}, "(0,0)\nnonsense", "nonsense"}, sample).empty());
  CHECK(corners(state) == 6);
  CHECK_FALSE(state.derived().refusal.has_value());
}
