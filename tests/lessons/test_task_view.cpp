#include "app/opening.h"
#include "kit/catch.h"
#include "view/view_page.h"

using namespace evenlift;
using namespace evenlift::view;
using namespace view_page;

namespace {

const std::string task_text =
    "title: T\npolygon: l\nrequire: robots>=4\nmove: teams\n\n[task]\nMore robots.\n";

}  // namespace

TEST_CASE("a task that is written is previewed in one step of undo, which never takes other work",
          "[view][task]") {
  Page page;
  page.open(document("(0,0)\n(7,0)\n(7,7)\n(0,7)\n"));
  AppState& state = page.app.state;
  const Points before = state.work.document().vertices;
  CHECK_FALSE(open_lesson(state, task_text, l_shape, LessonStart::preview));
  const std::size_t depth = state.work.history.depth();
  CHECK_FALSE(open_lesson(state, task_text, l_shape, LessonStart::preview));
  CHECK(state.work.history.depth() == depth);
  give(state, Undo{});
  CHECK_FALSE(state.view.task);
  CHECK(state.work.document().vertices == before);
  // The next preview does not take work that was opened over one.
  CHECK_FALSE(open_lesson(state, task_text, l_shape, LessonStart::preview));
  page.open(document("(0,0)\n(9,0)\n(9,9)\n(0,9)\n"));
  const Points square = state.work.document().vertices;
  CHECK_FALSE(open_lesson(state, task_text, l_shape, LessonStart::preview));
  give(state, Undo{});
  CHECK(state.work.document().vertices == square);
}

TEST_CASE("leaving a task brings back what was open before it", "[view][task]") {
  Page page;
  page.open(document("(0,0)\n(7,0)\n(7,7)\n(0,7)\n"));
  AppState& state = page.app.state;
  const Points before = state.work.document().vertices;
  CHECK_FALSE(open_lesson(state, task_text, l_shape));
  REQUIRE(state.view.task);
  CHECK(state.view.challenge);
  give(state, CloseTask{});
  CHECK_FALSE(state.view.task);
  CHECK_FALSE(state.view.challenge);
  CHECK(state.work.document().vertices == before);
}
