#include "page/page_api.h"
#include "page/hand_over.h"

#include <emscripten/emscripten.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>

#include "actions/actions.h"
#include "app/opening.h"
#include "app/opening_sample.h"
#include "app/set_settings.h"
#include "app/update.h"
#include "edits/backdrop.h"
#include "edits/draw_polygon.h"
#include "edits/placing.h"
#include "edits/sight.h"
#include "edits/try_edit.h"
#include "evenlift/formats.h"
#include "evenlift/link.h"
#include "evenlift/numbers.h"
#include "evenlift/output/json.h"
#include "evenlift/output/poses.h"
#include "evenlift/output/svg.h"
#include "evenlift/output/words.h"
#include "evenlift/settings.h"
#include "panels/summary.h"
#include "state/browser.h"
#include "state/layout.h"
#include "state/notice.h"
#include "tools/drawing.h"
#include "ui/controls.h"

namespace evenlift::view {
namespace {

const char* no_error() { return ""; }

void open_undoably(Opened opened) {
  AppState& state = app().state;
  Commands commands;
  commands.push_back(OpenDocument{std::move(opened)});
  apply(state, commands);
  frame_view(state);
  browser::request_frame();
}

std::string link_or_nothing(const Document& document) {
  Result<std::string> link = encode_link(document);
  return link ? std::move(link).value() : std::string();
}

// A place on the screen as `left top right bottom`.
std::string in_css_pixels(const Rect& place) {
  std::string text;
  for (const double value : {place.left, place.top, place.right, place.bottom})
    text += std::to_string(static_cast<int>(value * app().state.screen.zoom)) + ' ';
  return text;
}

}  // namespace

App& app() {
  static App the_app;
  return the_app;
}

void carry_out(Commands commands) {
  App& a = app();
  std::move(commands.begin(), commands.end(), std::back_inserter(a.commands));
  settle(a);
  browser::request_frame();
}

}  // namespace evenlift::view

using namespace evenlift::view;
using evenlift::CapacityInJson;
using evenlift::Document;
using evenlift::FailurePlan;
using evenlift::Method;
using evenlift::Result;
using evenlift::Shown;

extern "C" {

// --- Start

// Returns why the link could not be read, or nothing.
EMSCRIPTEN_KEEPALIVE const char* page_start(const char* fragment, const char* work,
                                            const char* draft, int embed) {
  AppState& state = app().state;
  state.screen.embed = embed != 0;
  const std::string problem = open_page(state, {fragment, work, draft}, opening_sample());
  frame_view(state);
  browser::request_frame();
  return hand_over(problem);
}

// --- window.evenlift

EMSCRIPTEN_KEEPALIVE const char* page_state() {
  const AppState& state = app().state;
  std::optional<CapacityInJson> capacity;
  const Shown& shown = state.placed.shown;
  std::optional<FailurePlan> spare = state.plan_due ? std::nullopt : state.spare;
  if (shown.capacity && !spare && state.placement->settings.method != Method::balanced)
    spare = plan_for_failures(*state.placement, *shown.capacity);
  if (shown.capacity)
    capacity = CapacityInJson{*shown.capacity,
                              state.plan && !state.plan_due
                                  ? *state.plan
                                  : plan_capacity(*state.placement, *shown.capacity),
                              spare};
  return hand_over(
      placement_json({*state.placement, shown}, true, capacity, failing(state) != nullptr));
}

// Returns why it was refused, or nothing.
EMSCRIPTEN_KEEPALIVE const char* page_load(const char* text) {
  Result<Opened> document = read_document(text);
  if (!document) return hand_over(sentence(document.error()));
  open_undoably(std::move(document).value());
  return no_error();
}

// The same for the fragment of an address, which is a link or empty.
EMSCRIPTEN_KEEPALIVE const char* page_open_link(const char* fragment) {
  Result<Opened> document = read_link(fragment);
  if (!document) return hand_over(sentence(document.error()));
  open_undoably(std::move(document).value());
  return no_error();
}

// `changes` has a line `name=value` for each setting. Makes all changes; or none, and returns why.
EMSCRIPTEN_KEEPALIVE const char* page_set(const char* changes) {
  AppState& state = app().state;
  const Result<Changeable> changed = with_settings({state.placed, state.load_model}, changes);
  if (!changed) return hand_over(sentence(changed.error()));
  const std::optional<std::uint64_t>& failed = changed->failed;
  if (const auto error = try_edit(state, changed->document, failed.value_or(0)))
    return hand_over(sentence(*error));
  Commands commands{SetLoadModel{changed->load_model}};
  if (failed) commands.push_back(Fail{*failed > 0 ? std::optional(*failed - 1) : std::nullopt});
  carry_out(std::move(commands));
  return no_error();
}

EMSCRIPTEN_KEEPALIVE const char* page_link() {
  return hand_over(link_or_nothing(app().state.placed));
}
// A link without the step of a lesson, so that a challenge begins at its beginning; any other text as it is.
EMSCRIPTEN_KEEPALIVE const char* page_without_step(const char* text) {
  Result<Document> document = evenlift::decode_link(text);
  if (!document || !document->shown.step) return hand_over(text);
  document->shown.step.reset();
  return hand_over(link_or_nothing(*document));
}
EMSCRIPTEN_KEEPALIVE const char* page_svg() {
  const AppState& state = app().state;
  return hand_over(evenlift::placement_svg({*state.placement, state.placed.shown},
                                           link_or_nothing(state.placed)));
}
// The robots' poses, for a file with this ending: ".csv", ".json" or ".yaml".
EMSCRIPTEN_KEEPALIVE const char* page_poses(const char* ending) {
  const auto format = evenlift::pose_format_of_file(ending);
  const AppState& state = app().state;
  return hand_over(format ? poses_text({*state.placement, state.placed.shown}, *format)
                          : std::string());
}
EMSCRIPTEN_KEEPALIVE const char* page_text() {
  return hand_over(evenlift::write_thesis(app().state.placed));
}

EMSCRIPTEN_KEEPALIVE double page_screen_x(double x, double y) {
  return app().state.camera.to_screen({x, y}).x() * app().state.screen.zoom;
}
EMSCRIPTEN_KEEPALIVE double page_screen_y(double x, double y) {
  return app().state.camera.to_screen({x, y}).y() * app().state.screen.zoom;
}
EMSCRIPTEN_KEEPALIVE double page_world_x(double x, double y) {
  return app().state.camera.to_world(evenlift::Vec2(x, y) / app().state.screen.zoom).x();
}
EMSCRIPTEN_KEEPALIVE double page_world_y(double x, double y) {
  return app().state.camera.to_world(evenlift::Vec2(x, y) / app().state.screen.zoom).y();
}

// --- The page around the canvas

// The link of a document that is refused; nothing if it is not refused.
EMSCRIPTEN_KEEPALIVE const char* page_draft() {
  const AppState& state = app().state;
  return hand_over(state.refusal ? link_or_nothing(state.document) : std::string());
}

// The polygon that is being drawn, as text to be kept; and back.
EMSCRIPTEN_KEEPALIVE const char* page_drawing() {
  return hand_over(drawing_text(app().state.drawing));
}
EMSCRIPTEN_KEEPALIVE void page_resume_drawing(const char* text) {
  const std::optional<evenlift::Points> points = read_drawing(text);
  if (!points || points->empty()) return;
  Commands commands{SetTool{Tool::draw}};
  for (const evenlift::Vec2& p : *points) commands.push_back(AddPoint{p});
  apply(app().state, commands);
  browser::request_frame();
}

EMSCRIPTEN_KEEPALIVE const char* page_summary() { return hand_over(summary(app().state)); }

EMSCRIPTEN_KEEPALIVE const char* page_link_lacks() {
  return hand_over(link_lacks_in_words(app().state));
}
EMSCRIPTEN_KEEPALIVE const char* page_news() { return hand_over(news(app().state)); }

EMSCRIPTEN_KEEPALIVE void page_preferences(int dark, int reduced_motion, int coarse_pointer) {
  Screen& screen = app().state.screen;
  screen.dark = dark != 0;
  screen.reduced_motion = reduced_motion != 0;
  screen.finger = coarse_pointer != 0;
  browser::request_frame();
}

// The preferences that the browser keeps besides the document; and back.
EMSCRIPTEN_KEEPALIVE const char* page_kept() {
  const AppState& state = app().state;
  return hand_over(kept_text({state.motion}));
}

EMSCRIPTEN_KEEPALIVE void page_keep(const char* lines) {
  AppState& state = app().state;
  state.motion = read_kept(lines).motion;
  browser::request_frame();
}

// The step that so many undos, or redos, lead to, to be kept: `EDIT METHOD LINK`, where the
// method 0 is none, and a document that is too large has no link. Nothing if there is no such step.
EMSCRIPTEN_KEEPALIVE const char* page_kept_step(int redo, int index) {
  const std::optional<History::Kept> kept =
      app().state.history.kept(redo != 0, static_cast<std::size_t>(std::max(index, 0)));
  if (!kept) return hand_over({});
  const std::optional<evenlift::Method>& method = kept->beside.second_method;
  return hand_over(std::to_string(static_cast<int>(kept->edit)) + ' ' +
                   std::to_string(method ? static_cast<int>(*method) + 1 : 0) + ' ' + kept->link);
}

// The method that the document is compared with, counted from 1, or 0; to be kept. And back, which is no step of undo.
EMSCRIPTEN_KEEPALIVE int page_compared() {
  const std::optional<evenlift::Method>& method = app().state.second_method;
  return method ? static_cast<int>(*method) + 1 : 0;
}
EMSCRIPTEN_KEEPALIVE void page_compare(int method) {
  AppState& state = app().state;
  if (method < 1 || method > static_cast<int>(std::size(evenlift::all_methods))) return;
  const evenlift::Method second = evenlift::all_methods[method - 1];
  if (second == settings(state).method || state.second_method || state.tool == Tool::draw) return;
  state.second_method = second;
  follow_up(state);
  ++state.revision;
  browser::request_frame();
}

// And the steps back: begins a history anew, or adds the newest step to be undone or redone.
EMSCRIPTEN_KEEPALIVE void page_forget_steps() {
  AppState& state = app().state;
  state.history.clear();
  if (state.walkthrough.script) state.walkthrough.script->depth = 0;
}
EMSCRIPTEN_KEEPALIVE void page_add_step(int redo, int edit, int method, const char* link) {
  History::Kept kept;
  kept.edit = static_cast<Edit>(edit);
  if (method > 0 && method <= static_cast<int>(std::size(evenlift::all_methods)))
    kept.beside.second_method = evenlift::all_methods[method - 1];
  kept.link = link;
  AppState& state = app().state;
  state.history.add(redo != 0, kept);
  // The last step that opened something says whether a lesson did, and from where on undo leaves it.
  if (redo == 0 && is_other_object(kept.edit)) {
    Walkthrough& walk = state.walkthrough;
    walk.of_lesson = walk.trace && (walk.script || kept.edit == Edit::lesson_opened);
    if (walk.script) walk.script->depth = state.history.depth();
  }
  browser::request_frame();
}

// How much of the canvas a window of the page covers at its left, at its right and at its foot, in CSS pixels.
EMSCRIPTEN_KEEPALIVE void page_cover(double left, double right, double foot) {
  AppState& state = app().state;
  Screen& screen = state.screen;
  screen.window_left = std::clamp(left / screen.zoom, 0.0, screen.width);
  screen.window_right = std::clamp(right / screen.zoom, 0.0, screen.width);
  screen.window_foot = std::clamp(foot / screen.zoom, 0.0, screen.height);
  frame_view(state);
  browser::request_frame();
}

// Where a card may stand at the foot of the drawing. It does not depend on whether there is one.
EMSCRIPTEN_KEEPALIVE const char* page_card_seat() {
  return hand_over(in_css_pixels(card_seat(app().state)));
}

// Where a list is open, which a card would cover; or nothing.
EMSCRIPTEN_KEEPALIVE const char* page_open_list() {
  return hand_over(open_list() ? in_css_pixels(*open_list()) : std::string());
}

// Makes room for a card of this height there; 0 ends that.
EMSCRIPTEN_KEEPALIVE void page_make_room(double height) {
  AppState& state = app().state;
  height /= state.screen.zoom;
  const double before = std::exchange(state.screen.foot, 0);
  const double card_before = std::exchange(state.screen.card, height);
  if (height > 0)
    state.screen.foot = std::max(0.0, layout(state).free.bottom - card_seat(state).bottom + height);
  if (state.screen.foot == before && height == card_before) return;
  frame_view(state);
  browser::request_frame();
}

// A picture lies behind the canvas, at these polygon coordinates; without width there is none.
EMSCRIPTEN_KEEPALIVE void page_backdrop(double left, double bottom, double width, double height) {
  AppState& state = app().state;
  if (width > 0 && height > 0)
    lay_behind(state, {left, bottom}, {left + width, bottom + height});
  else
    take_picture_away(state);
  browser::request_frame();
}

// Where it lies now: `LEFT BOTTOM WIDTH`, or nothing.
EMSCRIPTEN_KEEPALIVE const char* page_backdrop_place() {
  const std::optional<Backdrop>& picture = app().state.backdrop;
  if (!picture) return hand_over({});
  return hand_over(evenlift::shortest(picture->low.x()) + ' ' +
                   evenlift::shortest(picture->low.y()) + ' ' +
                   evenlift::shortest(picture->width()));
}

// Makes it so wide. Returns why it cannot be, or nothing.
EMSCRIPTEN_KEEPALIVE const char* page_scale_backdrop(double width) {
  const std::string problem = scale_picture(app().state, width);
  browser::request_frame();
  return hand_over(problem);
}

// Whether presses go to that picture, whose scale is being set.
EMSCRIPTEN_KEEPALIVE void page_measuring(int on) {
  app().state.measuring = on != 0;
  browser::summary_changed();
  browser::request_frame();
}

EMSCRIPTEN_KEEPALIVE void page_notice(const char* text, int problem) {
  Commands commands{ShowNotice{{problem ? Notice::Kind::problem : Notice::Kind::info, text}}};
  apply(app().state, commands);
  browser::request_frame();
}

// It was there long enough to be read.
EMSCRIPTEN_KEEPALIVE void page_end_notice() {
  end_notice(app().state);
  browser::request_frame();
}

// Handles a key, as KeyboardEvent.key names it. Returns whether the page used it; if not, it is the
// browser's.
EMSCRIPTEN_KEEPALIVE int page_key(const char* name, int command, int shift) {
  App& a = app();
  const Action* action = action_for(a.state, {name, command != 0, shift != 0});
  if (!action) return 0;
  action->run(a.state, a.commands);
  settle(a);
  browser::request_frame();
  return 1;
}

}  // extern "C"
