// Effects, messages, and kept steps.
#include <algorithm>
#include <optional>
#include <set>
#include <string>

#include "actions/actions.h"
#include "kit/catch.h"
#include "state/layout.h"
#include "state/work.h"
#include "view/view_page.h"

using namespace evenlift;
using namespace evenlift::view;
using namespace view_page;

TEST_CASE("steps of undo that were kept outside come back in their order, with all that they hold",
          "[view][history]") {
  History history;
  Document now = document(l_shape);
  history.record(now, {}, Edit::weight);
  now.settings.weight = 437;
  history.record(now, {Method::circle}, Edit::vertex_moved);
  now.vertices[0] = Vec2(0.1, -3e-7);
  history.record(now, {}, Edit::method);
  now.settings.method = Method::random;
  now = history.undo(now, {Method::area}).document;

  History again;
  for (std::size_t i = 2; i-- > 0;) again.add(false, history.kept(false, i).value());
  again.add(true, history.kept(true, 0).value());
  CHECK_FALSE(history.kept(false, 2));
  CHECK_FALSE(history.kept(true, 1));
  CHECK(again.depth() == 2);
  CHECK(again.undoes() == Edit::vertex_moved);
  CHECK(again.redoes() == Edit::method);
  const History::Recalled done = again.redo(now);
  CHECK(done.document.settings.method == Method::random);
  CHECK(done.beside == view::Beside{Method::area});
  CHECK(again.undo(done.document).document.vertices == now.vertices);
  const History::Recalled moved = again.undo(now);
  CHECK(moved.document.vertices == document(l_shape).vertices);
  CHECK(moved.document.settings.weight == 437);
  CHECK(moved.beside == view::Beside{Method::circle});
  CHECK(moved.edit == Edit::vertex_moved);
  CHECK(again.undo(moved.document).document.settings.weight == 100);
  CHECK_FALSE(again.can_undo());
}

TEST_CASE(
    "a kept link that cannot be read adds no step, and a polygon too large for a link has none",
    "[view][history]") {
  History history;
  history.add(false, {Edit::opened, {}, "1.nonsense"});
  CHECK_FALSE(history.can_undo());
  Document large;
  for (std::size_t i = 0; i <= max_link_vertices; ++i)
    large.vertices.emplace_back(static_cast<double>(i), static_cast<double>(i * i % 7919));
  history.record(large);
  REQUIRE(history.kept(false, 0));
  CHECK(history.kept(false, 0)->link.empty());
}

TEST_CASE("a lesson is left by steps that were kept outside, too", "[view][history][lesson]") {
  const Document mine = document(l_shape);
  Document lessons = document("(0,0)\n(200,0)\n(200,200)\n(0,200)\n");
  for (const bool edited : {false, true}) {
    INFO(edited);
    History history;
    history.record(mine, {}, Edit::weight);
    history.record(mine, {Method::circle}, Edit::lesson_opened);
    if (edited) history.record(lessons, {}, Edit::teams);
    History again;
    for (std::size_t i = history.depth(); i-- > 0;)
      again.add(false, history.kept(false, i).value());
    CHECK(again.lesson_opened() == (edited ? 1U : 0U));
    const std::optional<History::Recalled> before = again.leave_lesson(lessons);
    REQUIRE(before);
    CHECK(before->document.vertices == mine.vertices);
    CHECK(before->beside == view::Beside{Method::circle});
    CHECK(again.undoes() == (edited ? Edit::lesson_left : Edit::weight));
    if (edited) CHECK(again.undo(mine).document.vertices == lessons.vertices);
  }
}

TEST_CASE("no lesson is left where another object was opened since", "[view][history][lesson]") {
  const Document mine = document(l_shape);
  for (const Edit since : {Edit::opened, Edit::drawn, Edit::lesson_left}) {
    History history;
    history.record(mine, {}, Edit::lesson_opened);
    history.record(mine, {}, since);
    history.record(mine, {}, Edit::seed);
    CHECK_FALSE(history.lesson_opened());
    CHECK(history.lesson_opened(2) == 2U);
    CHECK_FALSE(history.leave_lesson(mine));
    CHECK(history.depth() == 3);
  }
}

TEST_CASE("what could be redone before a lesson can be redone after it",
          "[view][history][lesson]") {
  History history;
  Document now = document(l_shape);
  history.record(now, {}, Edit::weight);
  now.settings.weight = 437;
  now = history.undo(now).document;
  history.record(now, {}, Edit::lesson_opened);
  CHECK_FALSE(history.can_redo());
  REQUIRE(history.leave_lesson(now));
  REQUIRE(history.can_redo());
  CHECK(history.redo(now).document.settings.weight == 437);
}

TEST_CASE("after another edit nothing can be done again", "[view][history]") {
  History history;
  Document now = document(l_shape);
  history.record(now, {}, Edit::weight);
  now.settings.weight = 437;
  now = history.undo(now).document;
  REQUIRE(history.can_redo());
  history.record(now, {}, Edit::teams);
  CHECK_FALSE(history.can_redo());
  CHECK(history.depth() == 1);
  CHECK(history.undoes() == Edit::teams);
}

TEST_CASE("the tips of undo and redo say what they would do", "[view][history]") {
  Page page;
  AppState& state = page.app.state;
  CHECK(tip(action(ActionId::undo), state) == "Undo (Ctrl+Z)");
  page.press({"t"});
  page.app.commands.push_back(RemoveVertex{0});
  settle(page.app);
  CHECK(tip(action(ActionId::undo), state) == "Undo: removed a vertex (Ctrl+Z)");
  page.press({"z", true});
  CHECK(tip(action(ActionId::undo), state) == "Undo: changed the number of teams (Ctrl+Z)");
  CHECK(tip(action(ActionId::redo), state) == "Redo: removed a vertex (Ctrl+Shift+Z)");
  CHECK(tip(action(ActionId::fit), state) == "Show the whole object (0)");
  page.press({"d"});
  CHECK(tip(action(ActionId::redo), state) == "Redo (Ctrl+Shift+Z)");
}

TEST_CASE("every edit has words of its own", "[view][history]") {
  std::set<std::string> words;
  for (std::size_t i = 0; i < edit_count; ++i) words.insert(in_words(static_cast<Edit>(i)));
  CHECK(words.size() == edit_count);
}

TEST_CASE("each setting that is changed alone is named, also after it was kept",
          "[view][history]") {
  for (const SettingRow& row : all_settings())
    if (!row.edit.empty()) CHECK(in_words(edit_of(row)) == "changed " + std::string(row.edit));
  // Steps kept by 1.0.0 keep their meaning.
  CHECK(in_words(static_cast<Edit>(3)) == "changed the number of teams");
  CHECK(in_words(static_cast<Edit>(22)) == "changed the no-go edges");
  // Without its own number, a setting uses that of its record in links.
  const SettingRow later{.setting = Setting::apart,
                         .name = "later",
                         .subject = "a later one",
                         .edit = "a later one",
                         .record = 77};
  CHECK(static_cast<std::size_t>(edit_of(later)) == edit_of_records + 77);
  const std::size_t apart = edit_of_records + row_of(Setting::apart).record;
  CHECK(in_words(static_cast<Edit>(apart)) == "changed the goal or its limits");
  for (const int unknown : {-1, 32, 100, 999})
    CHECK(in_words(static_cast<Edit>(unknown)) == "changed settings");
}

TEST_CASE("capacity and comparison are steps of undo and redo", "[view][history]") {
  Page page;
  AppState& state = page.app.state;
  const auto run = [&](Command command) {
    page.app.commands.push_back(std::move(command));
    settle(page.app);
  };
  run(showing(state, &Shown::capacity, 20));
  run(Compare{Method::circle});
  run(showing(state, &Shown::capacity, 30));
  run(showing(state, &Shown::capacity, 30));  // no change, no step
  CHECK(state.work.history.depth() == 3);
  run(Undo{});
  CHECK(shown(state).capacity == 20.0);
  CHECK(state.derived().plan == plan_capacity(*state.derived().placement, 20));
  CHECK(state.work.second_method == Method::circle);
  CHECK(state.derived().second);
  run(Undo{});
  CHECK_FALSE(state.work.second_method);
  CHECK_FALSE(state.derived().second);
  run(Undo{});
  CHECK_FALSE(shown(state).capacity);
  CHECK_FALSE(state.derived().plan);
  for (int i = 0; i < 3; ++i) run(Redo{});
  CHECK(shown(state).capacity == 30.0);
  CHECK(state.work.second_method == Method::circle);
}

TEST_CASE("the list of keys has each key of the table once, group after group", "[view][keys]") {
  const std::vector<const Action*> list = key_list(false);
  std::set<const Action*> expected;
  for (const Action& a : actions())
    if (*a.shown) expected.insert(&a);
  CHECK(std::set<const Action*>(list.begin(), list.end()) == expected);
  CHECK(list.size() == expected.size());
  for (std::size_t i = 1; i < list.size(); ++i) CHECK(list[i - 1]->group <= list[i]->group);
  CHECK(list.back()->group == Group::help);
}

TEST_CASE("the drawing makes room for what the page lays over it", "[view][layout]") {
  Page page;
  AppState& state = page.app.state;
  for (const auto& [width, height] :
       {std::pair{320, 568}, {390, 844}, {844, 390}, {820, 1180}, {1440, 900}, {3840, 2160}}) {
    state.session.screen.width = width;
    state.session.screen.height = height;
    const Layout before = layout(state);
    const Rect seat = card_seat(state);
    CHECK(seat.width() > 200);
    state.session.screen.foot = 100;
    CHECK(layout(state).free.bottom == before.free.bottom - 100);
    // Above a card, the polygon's margins shrink with the space, but the polygon keeps half of it.
    const Rect room = layout(state).room, free = layout(state).free;
    CHECK(room.bottom <= free.bottom - std::min(48.0, free.height() / 4));
    CHECK(room.bottom - room.top >= free.height() / 2);
    state.session.screen.foot = 0;
    state.session.screen.window_left = 440;
    CHECK(layout(state).room.width() >= std::min(before.room.width(), 90.0));
    if (before.wide) CHECK(card_seat(state).left >= std::min(440.0, before.room.width() - 120));
    state.session.screen.window_left = 0;
    state.session.screen.window_foot = height / 2.0;  // the card is above the window
    CHECK(layout(state).free.bottom <= height / 2.0);
    CHECK(card_seat(state).bottom <= height / 2.0);
    state.session.screen.window_foot = 0;
    CHECK(layout(state).free == before.free);
  }
}
