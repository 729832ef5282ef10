#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "app/opening.h"
#include "edits/undo.h"
#include "evenlift/generate.h"
#include "evenlift/link.h"
#include "kit/catch.h"
#include "panels/summary.h"
#include "state/layout.h"
#include "state/screen.h"
#include "view/view_page.h"
#include "walkthrough/walkthrough.h"

using namespace evenlift;
using namespace evenlift::view;
using namespace view_page;

namespace {

struct Moment {
  std::string words;
  Progress known;
  std::size_t figures;
  bool operator==(const Moment&) const = default;
};

Moment moment(const AppState& state) {
  return {summary(state), state.view.walkthrough.known, state.view.walkthrough.figures.size()};
}

std::string link(const AppState& state) {
  const Result<std::string> link = encode_link(state.work.document());
  REQUIRE(link);
  return *link;
}

// As a control would.
template <class Change>
void set(Page& page, const Change& change) {
  Settings changed = settings(page.app.state);
  change(changed);
  give(page.app.state, SetSettings{std::move(changed)});
}

const std::string square = "(0,0)\n(200,0)\n(200,200)\n(0,200)\n";
const std::string on_a_square =
    "title: A square\npolygon: square\nteams: 2\n\n[centre]\nHere it balances.\n\n[end]\nDone.\n";

void go(Page& page, std::uint32_t step) {
  page.app.commands.push_back(GoToStep{step});
  settle(page.app);
}

}  // namespace

TEST_CASE("the lesson forward and back is the same at every step", "[view][lesson]") {
  Page page;
  page.press({"b"});
  page.press({"u"});
  const std::uint32_t count = timeline(page.app.state).count;
  REQUIRE(count > 20);
  std::vector<Moment> forward;
  for (std::uint32_t k = 0; k < count; ++k) {
    CHECK(page.app.state.work.document().shown.step == k);
    forward.push_back(moment(page.app.state));
    page.frame();
    if (k + 1 < count) page.press({"ArrowRight"});
  }
  CHECK(action_for(page.app.state, {"ArrowRight"}) == nullptr);  // at the end the browser has the
                                                                 // key
  for (std::uint32_t k = count; k-- > 0;) {
    CHECK(moment(page.app.state) == forward[k]);
    if (k > 0) page.press({"ArrowLeft"});
  }
  go(page, count / 2);
  CHECK(moment(page.app.state) == forward[count / 2]);
}

TEST_CASE("every step of every sample draws, and asks for no frame of its own",
          "[view][lesson][thorough]") {
  Page page;
  for (const auto& path : assets()) {
    INFO(path.string());
    page.open(document(asset(path)));
    page.press({"b"});
    page.press({"u"});
    const std::uint32_t count = timeline(page.app.state).count;
    // All steps of small ones, for others some of each chapter.
    for (std::uint32_t k = 0; k < count; k += 1 + count / 60) {
      go(page, k);
      page.frame();
      CHECK_FALSE(page.app.state.view.walkthrough.caption.empty());
    }
    page.press({"End"});
    for (int i = 0; i < 4; ++i) page.frame();
    CHECK_FALSE(settle(page.app));
    page.press({"b"});
    CHECK_FALSE(walkthrough_is_open(page.app.state));
  }
}

TEST_CASE("main steps are shown first, and a step that is none unfolds all", "[view][lesson]") {
  Page page;
  page.press({"b"});
  const Walkthrough& walk = page.app.state.view.walkthrough;
  const std::uint32_t all = walk.trace->size();
  CHECK(timeline(page.app.state).count == walk.main.size());
  for (const std::uint32_t step : walk.main) {
    CHECK(walk.at == step);
    if (step != walk.main.back()) page.press({"ArrowRight"});
  }
  page.press({"Home"});
  page.press({"PageDown"});
  CHECK(walk.detail.step.chapter == Chapter::vertex_chords);
  CHECK(timeline(page.app.state).at == 2);
  go(page, 1);
  CHECK(timeline(page.app.state).count == all);
  page.press({"u"});
  CHECK(walk.at == 0);
  CHECK(timeline(page.app.state).count == walk.main.size());
}

TEST_CASE("every position of the timeline has a place of its own, where it is found again",
          "[view][lesson]") {
  Page page(asset(EVENLIFT_ASSETS_DIR "/polygons/stone-slab.txt"));
  page.press({"b"});
  for (int i = 0; i < 2; ++i) {
    const auto parts = chapter_parts(page.app.state);
    std::size_t chapters = 0;
    for (std::uint32_t c = 0; c < chapter_count; ++c)
      chapters +=
          page.app.state.view.walkthrough.trace->chapter_begin(static_cast<Chapter>(c)).has_value();
    CHECK(chapters > 5);
    CHECK(parts.size() == chapters);
    const std::uint32_t count = timeline(page.app.state).count;
    double before = -1;
    for (std::uint32_t k = 0; k < count; ++k) {
      const double share = share_of(parts, k);
      CHECK(share > before);
      CHECK(position_at(parts, share) == k);
      before = share;
    }
    CHECK(share_of(parts, 0) == 0);
    CHECK(before == 1);
    for (std::size_t c = 0; c < parts.size(); ++c)
      CHECK(share_of(parts, parts[c].first) ==
            static_cast<double>(c) / static_cast<double>(parts.size()));
    page.press({"u"});
  }
}

TEST_CASE("presenting shows the drawing and the words alone, and Escape ends it before the lesson",
          "[view][lesson]") {
  Page page;
  page.press({"b"});
  const double panel = layout(page.app.state).panel.width();
  CHECK(panel > 0);
  const auto seen = [&] {  // CSS pixels
    return page.app.state.view.camera.scale * page.app.state.session.screen.zoom;
  };
  const double scale = seen(), width = page.app.state.session.screen.width;
  page.press({"P"});
  CHECK(page.app.state.view.presenting);
  CHECK(layout(page.app.state).panel.width() == 0);
  CHECK(page.app.state.session.screen.zoom > 1.4);  // letters, discs and buttons are larger by this
  page.frame();
  CHECK(seen() > 0.85 * scale);  // and the drawing is hardly smaller
  set_canvas(page.app.state, 1920, 1080, 2);
  CHECK(page.app.state.session.screen.zoom > 2);
  CHECK(page.app.state.session.screen.ratio == 2 * page.app.state.session.screen.zoom);
  set_canvas(page.app.state, 390, 844, 3);
  CHECK(page.app.state.session.screen.zoom == 1);
  set_canvas(page.app.state, width, 800, 1);
  page.frame();
  page.press({"Escape"});
  CHECK_FALSE(page.app.state.view.presenting);
  CHECK(page.app.state.session.screen.zoom == 1);
  CHECK(page.app.state.session.screen.width == width);
  CHECK(walkthrough_is_open(page.app.state));
}

TEST_CASE(
    "presenting without a lesson enlarges the tool with its settings, and a lesson in it begins enlarged",
    "[view][lesson]") {
  Page page;
  set_canvas(page.app.state, 1920, 1080, 1);
  page.press({"P"});
  CHECK(page.app.state.view.presenting);
  CHECK_FALSE(walkthrough_is_open(page.app.state));
  const double zoom = page.app.state.session.screen.zoom;
  CHECK(zoom == 2);
  CHECK(layout(page.app.state).panel.width() > 0);
  CHECK(layout(page.app.state).toolbar.width() > 0);
  page.press({"b"});
  CHECK(layout(page.app.state).panel.width() == 0);
  CHECK(page.app.state.session.screen.zoom > zoom);  // the steps have the whole screen
  page.press({"b"});
  CHECK(page.app.state.view.presenting);
  CHECK(page.app.state.session.screen.zoom == zoom);
  page.press({"Escape"});
  CHECK_FALSE(page.app.state.view.presenting);
  CHECK(page.app.state.session.screen.zoom == 1);
}

TEST_CASE("an edit during the lesson keeps the place, and undo is of the edit", "[view][lesson]") {
  Page page;
  page.press({"b"});
  const auto team = page.app.state.view.walkthrough.trace->find(StepKind::team, 1);
  REQUIRE(team);
  go(page, *team);
  page.drag(page.app.state.work.document().vertices[2], Vec2(390, 170));
  const Walkthrough& walk = page.app.state.view.walkthrough;
  CHECK(walk.detail.step.kind == StepKind::team);
  CHECK(walk.detail.step.item == 1);
  CHECK(page.app.state.work.document().shown.step == walk.at);
  CHECK(page.app.state.work.document().vertices != document(l_shape).vertices);
  page.press({"z", true});
  CHECK(page.app.state.work.document().vertices == document(l_shape).vertices);
  CHECK(page.app.state.view.walkthrough.detail.step.kind == StepKind::team);
  CHECK(page.app.state.view.walkthrough.detail.step.item == 1);
  CHECK_FALSE(page.app.state.work.history.can_undo());  // stepping is not an edit
}

TEST_CASE("the link carries the step, and opens there", "[view][lesson]") {
  Page page;
  page.press({"b"});
  go(page, 17);
  const Result<std::string> link = encode_link(last_good(page.app.state));
  REQUIRE(link);
  const std::string words = summary(page.app.state);
  page.press({"b"});
  CHECK_FALSE(shown(page.app.state).step);
  Result<Opened> read = read_link(*link);
  REQUIRE(read);
  page.app.commands.push_back(OpenDocument{std::move(read).value()});
  settle(page.app);
  CHECK(walkthrough_is_open(page.app.state));
  CHECK(summary(page.app.state) == words);
}

TEST_CASE("a step that there is not is refused by name, and told of a link", "[view][lesson]") {
  Page page;
  Document far = page.app.state.work.document();
  far.shown.step = 99999;
  const auto problem = edit_by_script(page.app.state, far);
  REQUIRE(problem);
  CHECK(problem->message.starts_with("must be less than "));
  CHECK_FALSE(walkthrough_is_open(page.app.state));
  page.open(far);
  CHECK(page.app.state.session.notice.text.starts_with("This lesson has no step 100000"));
  CHECK(timeline(page.app.state).at + 1 == timeline(page.app.state).count);
  CHECK(page.app.state.view.walkthrough.detail.step.kind == StepKind::result);
}

TEST_CASE("predicting stops before each choice, and tells whether the guess was right",
          "[view][lesson]") {
  Page page(asset(EVENLIFT_ASSETS_DIR "/polygons/puzzle-piece.txt"));
  page.press({"b"});
  page.press({"u"});
  page.press({"q"});
  int asked = 0, right = 0;
  std::array<int, 2> of_kind{};
  while (action_for(page.app.state, {"ArrowRight"})) {
    const std::uint32_t before = page.app.state.view.walkthrough.at;
    page.press({"ArrowRight"});
    if (!page.app.state.view.walkthrough.ask) continue;
    CHECK(page.app.state.view.walkthrough.at == before);  // not shown yet
    const Ask ask = *page.app.state.view.walkthrough.ask;
    // No choice of the previous question is left.
    CHECK_FALSE(page.app.state.view.walkthrough.answered);
    CHECK(page.app.state.view.walkthrough.verdict.empty());
    CHECK_FALSE(page.app.state.view.walkthrough.asked);
    CHECK_FALSE(ask.text.empty());
    CHECK(ask.choices.size() > 1);
    CHECK(ask.choices.size() <= 6);
    CHECK(std::count(ask.choices.begin(), ask.choices.end(), ask.question.answer) == 1);
    CHECK(ask.choices[ask.pointed] != ask.question.answer);  // the pointed choice does not give the
                                                             // answer away
    page.frame();
    ++asked;
    ++of_kind[ask.question.kind == QuestionKind::winning_chord];
    const bool honest = asked % 2 == 0;
    std::uint32_t answer = ask.question.answer;
    if (!honest && ask.choices.size() > 1)
      answer = ask.choices[0] == answer ? ask.choices[1] : ask.choices[0];
    page.app.commands.push_back(Guess{answer});
    settle(page.app);
    CHECK(page.app.state.view.walkthrough.at == ask.step);
    CHECK(page.app.state.view.walkthrough.was_right == (answer == ask.question.answer));
    right += page.app.state.view.walkthrough.was_right;
    page.frame();
  }
  CHECK(asked > 3);
  for (const int n : of_kind) CHECK(n <= static_cast<int>(most_questions));
  CHECK_FALSE(page.app.state.view.walkthrough.guesses.told.empty());  // the others were shown
  CHECK(right > 0);
  CHECK(right < asked);
  // Each question counts once, although it is asked again.
  CHECK(page.app.state.view.walkthrough.guesses.right == static_cast<std::uint32_t>(right));
  page.press({"Home"});
  for (int again = 0; again < 3 && action_for(page.app.state, {"ArrowRight"});) {
    page.press({"ArrowRight"});
    const auto& ask = page.app.state.view.walkthrough.ask;
    if (!ask) continue;
    page.app.commands.push_back(Guess{ask->question.answer});
    settle(page.app);
    ++again;
  }
  CHECK(page.app.state.view.walkthrough.guesses.right == static_cast<std::uint32_t>(right));
}

TEST_CASE("a question is asked over what is known before it, and about its own pair",
          "[view][lesson]") {
  Page page(asset(EVENLIFT_ASSETS_DIR "/polygons/stone-slab.txt"));
  const std::string text =
      "title: Two pairs\npolygon: stone-slab\nteams: 3\npredict: yes\n\n"
      "[pair 1]\nThe first pair.\n\n[pair 7]\nThe seventh.\n\n[scores 3]\nThe third team.\n";
  REQUIRE_FALSE(
      open_lesson(page.app.state, text, asset(EVENLIFT_ASSETS_DIR "/polygons/stone-slab.txt")));
  const Walkthrough& walk = page.app.state.view.walkthrough;
  page.press({"ArrowRight"});
  REQUIRE(walk.ask);
  CHECK(walk.at != walk.ask->step);  // the answer is not shown yet
  const EdgePair& asked = walk.trace->pairs[6];
  CHECK_FALSE(walk.figures.empty());
  for (const Figure& figure : walk.figures) {
    CHECK((figure.kind == FigureKind::edge || figure.kind == FigureKind::section));
    CHECK((figure.item == asked.a || figure.item == asked.b));
  }
  CHECK(words_of_stop(page.app.state).empty());
  CHECK(walk.caption.empty());
  page.frame();

  page.press({"q"});  // without predictions the step is shown again
  CHECK_FALSE(walk.ask);
  CHECK(words_of_stop(page.app.state) == "The first pair.");
  CHECK_FALSE(walk.caption.empty());
  page.press({"q"});

  page.press({"ArrowRight"});
  REQUIRE(walk.ask);
  page.press({"ArrowRight"});
  CHECK(words_of_stop(page.app.state) == "The seventh.");
  page.press({"ArrowRight"});
  REQUIRE(walk.ask);
  CHECK(walk.known.teams == 2);  // not the preceding step's, which had none
  CHECK(walk.base.size() == 4);
  CHECK(walk.figures.empty());
}

TEST_CASE("a challenge does not tell which end is more even before it asks", "[view][lesson]") {
  Page page(asset(EVENLIFT_ASSETS_DIR "/polygons/puzzle-piece.txt"));
  page.press({"b"});
  page.press({"u"});
  const Walkthrough& walk = page.app.state.view.walkthrough;
  std::uint32_t pair = 0;
  double longest = 0;  // no question if both ends look the same
  for (std::uint32_t i = 0; i < walk.trace->pairs.size(); ++i) {
    const PairDetail detail = look_at_pair(*walk.trace, i);
    const double section = length(detail.a[1] - detail.a[0]);
    if (section <= longest || !is_choice(*walk.trace, *walk.trace->find(StepKind::outcome, i)))
      continue;
    longest = section;
    pair = i;
  }
  const std::uint32_t step = *walk.trace->find(StepKind::sections, pair);
  const auto shows_ends = [&] {
    return std::any_of(walk.figures.begin(), walk.figures.end(),
                       [](const Figure& figure) { return figure.kind == FigureKind::section_end; });
  };
  go(page, step);
  CHECK(walk.caption.find("load ratio") != std::string::npos);
  CHECK_FALSE(walk.formula.empty());
  CHECK(shows_ends());

  page.press({"q"});  // at once, although the step stays
  CHECK(walk.caption.find("load ratio") == std::string::npos);
  CHECK(walk.formula.empty());
  CHECK_FALSE(shows_ends());
  CHECK_FALSE(walk.figures.empty());
  page.press({"ArrowRight"});
  REQUIRE(walk.ask);
  page.app.commands.push_back(Guess{walk.ask->question.answer});
  settle(page.app);
  page.press({"ArrowLeft"});  // a guessed answer is not hidden
  CHECK(walk.at == step);
  CHECK(walk.caption.find("load ratio") != std::string::npos);
  CHECK(shows_ends());
}

TEST_CASE("why not this one: a click on a chord or anywhere is answered", "[view][lesson]") {
  Page page;
  page.press({"b"});
  const auto scores = page.app.state.view.walkthrough.trace->find(StepKind::scores, 1);
  REQUIRE(scores);
  go(page, *scores);
  const auto& candidates = page.app.state.derived().placement->candidates;
  REQUIRE(candidates.size() > 2);
  page.click(Vec2(120, 80));
  CHECK_FALSE(page.app.state.view.walkthrough.why.empty());
  const std::string first = page.app.state.view.walkthrough.why;
  page.click(Vec2(330, 60));
  CHECK_FALSE(page.app.state.view.walkthrough.why.empty());
  CHECK(page.app.state.view.walkthrough.why != first);
  CHECK(page.app.state.view.walkthrough.asked.has_value());
  page.press({"ArrowRight"});
  CHECK(page.app.state.view.walkthrough.why.empty());
}

TEST_CASE(
    "why not this one: Escape takes the question back before it leaves the lesson, and a click beside the object asks nothing",
    "[view][lesson]") {
  Page page;
  page.press({"b"});
  const Walkthrough& walk = page.app.state.view.walkthrough;
  go(page, *walk.trace->find(StepKind::scores, 1));
  page.click(Vec2(120, 80));
  REQUIRE_FALSE(walk.why.empty());
  page.press({"Escape"});
  CHECK(walk.why.empty());
  CHECK_FALSE(walk.asked);
  REQUIRE(walkthrough_is_open(page.app.state));
  page.click(Vec2(120, 80));
  REQUIRE_FALSE(walk.why.empty());
  page.click(Vec2(390, 290));  // in the L's notch, away from candidates
  CHECK(walk.why.empty());
  page.press({"Escape"});
  CHECK_FALSE(walkthrough_is_open(page.app.state));
}

TEST_CASE("while a question waits, a press near its choice answers it, though a vertex is there",
          "[view][lesson]") {
  Page page(asset(EVENLIFT_ASSETS_DIR "/polygons/snowflake.txt"));
  page.press({"b"});
  AppState& state = page.app.state;
  const Walkthrough& walk = state.view.walkthrough;
  page.app.commands.push_back(SetPredict{true});
  settle(page.app);
  while (!(walk.ask && walk.ask->question.kind == QuestionKind::winning_chord))
    page.press({"ArrowRight"});
  const Ask ask = *walk.ask;
  const auto& candidates = state.derived().placement->candidates;
  const auto at_vertex = [&](std::uint32_t c) {
    const Points& vertices = state.work.document().vertices;
    return std::find(vertices.begin(), vertices.end(), candidates[c].chord.r1.position) !=
           vertices.end();
  };
  const auto chosen = std::find_if(ask.choices.begin(), ask.choices.end(), at_vertex);
  REQUIRE(chosen != ask.choices.end());
  page.click(candidates[*chosen].chord.r1.position);
  CHECK_FALSE(walk.ask);
  CHECK_FALSE(state.view.selected);
  CHECK(walk.at == ask.step);
}

TEST_CASE("chapter by chapter leads to each beginning, forward and back", "[view][lesson]") {
  Page page;
  page.press({"b"});
  AppState& state = page.app.state;
  std::vector<std::uint32_t> beginnings = {timeline(state).at};
  for (move_chapters(state, 1); timeline(state).at != beginnings.back(); move_chapters(state, 1))
    beginnings.push_back(timeline(state).at);
  REQUIRE(beginnings.size() > 4);
  // The last of them is the end.
  for (std::size_t i = beginnings.size() - 1; i-- > 0;) {
    move_chapters(state, -1);
    CHECK(timeline(state).at == beginnings[i]);
  }
  move_chapters(state, -1);
  CHECK(timeline(state).at == 0);
}

TEST_CASE("playing turns over by itself and stops at the end", "[view][lesson]") {
  Page page;
  page.press({"b"});
  page.app.commands.push_back(SetSpeed{32});
  page.press({" "});
  double now = 0;
  for (int i = 0; i < 10000 && page.app.state.view.walkthrough.playing; ++i) {
    turn_over(page.app.state, now);
    now += 0.1;
  }
  CHECK_FALSE(page.app.state.view.walkthrough.playing);
  CHECK(timeline(page.app.state).at + 1 == timeline(page.app.state).count);
  CHECK(page.app.state.view.walkthrough.detail.step.kind == StepKind::result);
}

TEST_CASE("after a hole has changed, the words of a lesson no longer apply", "[view][lesson]") {
  Page page;
  CHECK_FALSE(open_lesson(page.app.state, "title: One\npolygon: l\nteams: 2\n\n[centre]\nHere.\n",
                          "POLYGON ((0 0, 9 0, 9 9, 0 9), (1 1, 3 1, 3 3))"));
  CHECK(words_of_stop(page.app.state) == "Here.");
  give(page.app.state, MoveVertex{5, {4, 1}});
  CHECK_FALSE(script_is_true(page.app.state));
  CHECK(words_of_stop(page.app.state).starts_with("You changed the shape"));
  give(page.app.state, EndEdit{});
  give(page.app.state, Undo{});
  CHECK(words_of_stop(page.app.state) == "Here.");
}

TEST_CASE("a ready-made lesson shows its own stops and words, and can be left for all steps",
          "[view][lesson]") {
  Page page;
  const std::string text =
      "title: Two stops\npolygon: l\nteams: 2\n\n[centre]\nHere it balances.\n\n[team 2]\nDone.\n";
  CHECK_FALSE(open_lesson(page.app.state, text, l_shape));
  CHECK(timeline(page.app.state).count == 2);
  CHECK(words_of_stop(page.app.state) == "Here it balances.");
  page.press({"ArrowRight"});
  CHECK(words_of_stop(page.app.state) == "Done.");
  CHECK(page.app.state.view.walkthrough.detail.step.kind == StepKind::team);
  page.frame();
  page.press({"u"});
  CHECK(timeline(page.app.state).count > 20);
  CHECK(page.app.state.view.walkthrough.detail.step.kind == StepKind::team);
  page.press({"u"});  // and back
  CHECK(timeline(page.app.state).count == 2);
  CHECK(words_of_stop(page.app.state) == "Done.");
  page.press({"u"});
  page.press({"b"});
  page.press({"b"});  // leaving the walkthrough leaves the lesson
  page.press({"u"});
  CHECK(words_of_stop(page.app.state).empty());

  const Moment before = moment(page.app.state);
  const auto wrong =
      open_lesson(page.app.state, "title: x\npolygon: l\n\n[team 9]\nNo.\n", l_shape);
  REQUIRE(wrong);
  CHECK(wrong->place.kind == Place::Kind::line);
  CHECK(moment(page.app.state) == before);  // nothing changed
}

TEST_CASE("closing a lesson brings back what was open before it, with its settings and its undo",
          "[view][lesson]") {
  Page page;
  AppState& state = page.app.state;
  set(page, [](Settings& s) { s.teams = 1; });
  set(page, [](Settings& s) { s.method = Method::distance; });
  set(page, [](Settings& s) { s.weight = 250; });
  page.press({"z", true});
  give(state, showing(state, &Shown::overlays, {.candidates = true}));
  give(state, Compare{Method::circle});
  page.press({"z", true});
  page.press({"k"});
  page.press({"z", true});
  const std::string before = link(state);
  const std::size_t depth = state.work.history.depth();
  REQUIRE(state.work.history.can_redo());

  const auto close = [&](const char* key) {
    page.press({"ArrowRight"});
    page.press({key});
    CHECK_FALSE(walkthrough_is_open(state));
    CHECK(link(state) == before);
    CHECK(state.work.history.depth() == depth);
    CHECK(state.work.history.can_redo());
    CHECK(state.session.notice.text.empty());
    CHECK(state.view.walkthrough.at == 0);
    CHECK_FALSE(state.view.walkthrough.predict);
  };
  REQUIRE_FALSE(open_lesson(state, on_a_square, square));
  CHECK(state.work.history.undoes() == Edit::lesson_opened);
  CHECK(state.work.document().vertices.size() == 4);
  close("b");
  REQUIRE_FALSE(open_lesson(state, on_a_square, square));
  close("Escape");
  // With all steps around it, and after its words were left, it is still the lesson's object.
  REQUIRE_FALSE(open_lesson(state, on_a_square, square));
  page.press({"u"});
  close("b");
  REQUIRE_FALSE(open_lesson(state, on_a_square, square));
  give(state, LeaveScript{});
  close("b");
  page.press({"z", true});
  CHECK(settings(state).method == Method::area);  // one undo, of the edit before the lesson
}

TEST_CASE("closing a lesson brings the comparison back, which the lesson does not show",
          "[view][lesson]") {
  Page page;
  AppState& state = page.app.state;
  give(state, Compare{Method::circle});
  REQUIRE_FALSE(open_lesson(state, on_a_square, square));
  CHECK_FALSE(state.work.second_method);
  CHECK_FALSE(state.derived().second);
  page.press({"b"});
  CHECK(state.work.second_method == Method::circle);
  CHECK(state.derived().second);
  REQUIRE_FALSE(open_lesson(state, on_a_square, square));
  page.press({"z", true});
  CHECK(state.work.second_method == Method::circle);
  CHECK(state.derived().second);
}

TEST_CASE("what was edited in a lesson is one undo away when it is closed", "[view][lesson]") {
  Page page;
  AppState& state = page.app.state;
  const std::string before = link(state);
  REQUIRE_FALSE(open_lesson(state, on_a_square, square));
  set(page, [](Settings& s) { s.teams = 1; });
  give(state, MoveCentre{Vec2(90, 110)});
  give(state, EndEdit{});
  page.press({"Escape"});
  CHECK(link(state) == before);
  CHECK(state.session.notice.text ==
        "Your work from before the lesson is back. Undo shows the lesson's object as you left it.");
  page.press({"z", true});
  CHECK(state.work.document().vertices.size() == 4);
  CHECK(state.work.document().centre_of_mass == Vec2(90, 110));
  CHECK(settings(state).teams == 1);
  CHECK_FALSE(walkthrough_is_open(state));
  page.press({"z", true});
  CHECK_FALSE(state.work.document().centre_of_mass);
  page.press({"z", true});
  page.press({"z", true});
  CHECK(link(state) == before);
  CHECK_FALSE(state.work.history.can_undo());
  for (int i = 0; i < 4; ++i) page.press({"z", true, true});
  CHECK(link(state) == before);
  CHECK_FALSE(state.work.history.can_redo());
}

TEST_CASE("from a lesson opened in a lesson one close or one undo leads back to the drawing",
          "[view][lesson]") {
  for (const bool edited : {false, true}) {
    for (const char* key : {"b", "z"}) {
      INFO(edited << ' ' << key);
      Page page;
      AppState& state = page.app.state;
      set(page, [](Settings& s) { s.weight = 77; });
      const std::string before = link(state);
      REQUIRE_FALSE(open_lesson(state, on_a_square, square));
      if (edited) set(page, [](Settings& s) { s.teams = 1; });
      for (int i = 0; i < 2; ++i)
        REQUIRE_FALSE(open_lesson(state, "title: L\npolygon: l\n\n[centre]\nC.\n", l_shape));
      page.press({key, *key == 'z'});
      CHECK_FALSE(walkthrough_is_open(state));
      CHECK(link(state) == before);
      page.press({"z", true});
      CHECK(state.work.document().vertices.size() == (edited ? 4U : 6U));
      CHECK(settings(state).weight == 100);
    }
  }
}

TEST_CASE("an undo in a lesson leaves it with all steps shown, too", "[view][lesson]") {
  Page page;
  AppState& state = page.app.state;
  const std::string before = link(state);
  REQUIRE_FALSE(open_lesson(state, on_a_square, square));
  page.press({"u"});
  page.press({"z", true});
  CHECK_FALSE(walkthrough_is_open(state));
  CHECK(link(state) == before);
  page.press({"z", true, true});
  CHECK(state.work.document().vertices.size() == 4);
  // Taking over the lesson's object like this keeps it.
  page.press({"b"});
  page.press({"b"});
  CHECK(state.work.document().vertices.size() == 4);
}

TEST_CASE(
    "a script leaves a lesson as a person does, and its other changes are those that it names",
    "[view][lesson]") {
  Page page;
  AppState& state = page.app.state;
  give(state, showing(state, &Shown::com_radius, 7));
  const std::string before = link(state);
  REQUIRE_FALSE(open_lesson(state, on_a_square, square));
  Document left = state.work.document();
  left.shown.step.reset();
  CHECK_FALSE(edit_by_script(state, left));
  CHECK(link(state) == before);
  REQUIRE_FALSE(open_lesson(state, on_a_square, square));
  left.shown.capacity = 30;
  CHECK_FALSE(edit_by_script(state, left));
  CHECK(state.work.document().vertices.size() == 6);
  CHECK(shown(state).capacity == 30.0);
  CHECK(shown(state).com_radius == 7);
}

TEST_CASE("what the user opened in a lesson stays when its steps are closed", "[view][lesson]") {
  Page page;
  AppState& state = page.app.state;
  REQUIRE_FALSE(open_lesson(state, on_a_square, square));
  page.open(document("(0,0)\n(90,0)\n(0,90)\n"));
  page.press({"b"});
  page.press({"b"});
  CHECK(state.work.document().vertices.size() == 3);
}

TEST_CASE("in an article the object of a lesson stays when it is closed", "[view][lesson]") {
  Page page;
  AppState& state = page.app.state;
  state.session.screen.embed = true;
  REQUIRE_FALSE(open_lesson(state, on_a_square, square));
  give(state, CloseWalkthrough{});
  CHECK_FALSE(walkthrough_is_open(state));
  CHECK(state.work.document().vertices.size() == 4);
  CHECK(settings(state).teams == 2);
}

TEST_CASE("tens of thousands of candidates are drawn, in the picture and in the lesson",
          "[view][lesson]") {
  const Result<Points> comb = generate(Family::comb, 700, 1);
  REQUIRE(comb);
  Document many;
  many.vertices = *comb;
  many.shown.overlays.candidates = true;
  Page page;
  page.open(many);
  CHECK(page.app.state.derived().placement->candidates.size() > 10000);
  page.frame();
  page.press({"b"});
  go(page, page.app.state.view.walkthrough.trace->find(StepKind::candidates, 0).value());
  page.frame();
}
