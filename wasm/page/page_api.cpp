#include "page/page_api.h"

#include <emscripten/emscripten.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>

#include "actions/actions.h"
#include "app/opening.h"
#include "app/update.h"
#include "edits/undo.h"
#include "edits/vertices.h"
#include "evenlift/formats.h"
#include "evenlift/link.h"
#include "evenlift/output/json.h"
#include "evenlift/output/json_text.h"
#include "evenlift/output/poses.h"
#include "evenlift/output/svg.h"
#include "evenlift/output/words.h"
#include "evenlift/settings.h"
#include "page/sdl_input.h"
#include "panels/summary.h"
#include "state/layout.h"
#include "state/method.h"
#include "tools/drawing.h"
#include "ui/controls.h"

namespace evenlift::view {
namespace {

const char* no_error() { return ""; }

void open_undoably(Opened opened) {
  Commands commands;
  commands.push_back(OpenDocument{std::move(opened)});
  carry_out(std::move(commands));
}

std::string link_or_nothing(const Document& document) {
  Result<std::string> link = encode_link(document);
  return link ? std::move(link).value() : std::string();
}

// `number` counts from 1; nothing for 0.
std::optional<Method> method_of(int number) {
  if (number < 1 || number > static_cast<int>(std::size(all_methods))) return std::nullopt;
  return all_methods[number - 1];
}

// As JSON, in whole CSS pixels.
std::string in_css_pixels(const Rect& place) {
  const double zoom = app().state.session.screen.zoom;
  const auto whole = [&](double value) { return std::trunc(value * zoom); };
  return place_json({whole(place.left), whole(place.top), whole(place.right), whole(place.bottom)},
                    1);
}

}  // namespace

App& app() {
  static App the_app;
  return the_app;
}

bool settle() {
  App& a = app();
  const bool changed = settle(a);
  browser::carry_out(std::exchange(a.state.session.effects, {}));
  return changed;
}

void carry_out(Commands commands) {
  std::move(commands.begin(), commands.end(), std::back_inserter(app().commands));
  settle();
  browser::request_frame();
}

void carried_out() {
  conclude(app().state);
  frame_view(app().state);
  settle();
  browser::request_frame();
}

}  // namespace evenlift::view

using namespace evenlift::view;
using evenlift::Document;
using evenlift::Method;
using evenlift::Result;
using evenlift::Shown;
namespace json = evenlift::json;

extern "C" {

// --- Start

// Returns why the link could not be read, or an empty text.
EMSCRIPTEN_KEEPALIVE const char* page_start(const char* fragment, const char* work,
                                            const char* draft, int embed) {
  AppState& state = app().state;
  state.session.screen.embed = embed != 0;
  const std::string problem = open_page(state, {fragment, work, draft}, opening_sample());
  carried_out();
  return hand_over(problem);
}

// --- window.evenlift

EMSCRIPTEN_KEEPALIVE const char* page_state() {
  const AppState& state = app().state;
  const evenlift::ShownPlacement of(*state.derived().placement, state.work.document().shown);
  evenlift::Report report = state.derived().report;
  // The second number of balanced robots takes a search of its own.
  const bool plans = report.if_one_fails || of.placement.settings.method != Method::balanced;
  if (!plans && of.shown.capacity)
    report.plan = evenlift::plan_capacity(
        of.placement, evenlift::limit_of(*of.shown.capacity, of.shown.carrying));
  evenlift::complete(report, of,
                     {.models = true, .failures = failing(state) != nullptr, .plans = plans});
  report.known.plans = true;
  return hand_over(evenlift::placement_json({of, report}, true, failing(state) != nullptr));
}

// Returns why the text was refused, or an empty text.
EMSCRIPTEN_KEEPALIVE const char* page_load(const char* text) {
  Result<Opened> document = read_document(text);
  if (!document) return hand_over(sentence(document.error()));
  open_undoably(std::move(document).value());
  return no_error();
}

// Like page_load(), for the link in an address's fragment.
EMSCRIPTEN_KEEPALIVE const char* page_open_link(const char* fragment) {
  Result<Opened> document = read_link(fragment);
  if (!document) return hand_over(sentence(document.error()));
  open_undoably(std::move(document).value());
  return no_error();
}

// `changes` has lines `name=value`. Makes all changes; or makes none and returns why.
EMSCRIPTEN_KEEPALIVE const char* page_set(const char* changes) {
  AppState& state = app().state;
  if (state.derived().elsewhere.under_way) {
    place_now(state);
    carried_out();
  }
  const Result<Changeable> changed =
      with_settings({last_good(state), state.view.load_model}, changes);
  if (!changed) return hand_over(sentence(changed.error()));
  const std::optional<std::uint64_t>& failed = changed->failed;
  if (const auto error = try_edit(state, changed->document, failed.value_or(0)))
    return hand_over(sentence(*error));
  carried_out();
  Commands commands{SetLoadModel{changed->load_model}};
  if (failed) commands.push_back(Fail{*failed > 0 ? std::optional(*failed - 1) : std::nullopt});
  carry_out(std::move(commands));
  return no_error();
}

EMSCRIPTEN_KEEPALIVE const char* page_link() {
  return hand_over(link_or_nothing(last_good(app().state)));
}
// Removes a link's step, so that a challenge starts at its beginning; returns other text unchanged.
EMSCRIPTEN_KEEPALIVE const char* page_without_step(const char* text) {
  Result<Document> document = evenlift::decode_link(text);
  if (!document || !document->shown.step) return hand_over(text);
  document->shown.step.reset();
  return hand_over(link_or_nothing(*document));
}

// --- Challenges: the object of a link with robots that the visitor places

// A link to the object of this link (or, without one, to a sample) with this number of robots to
// place. Other text, and a link with robots placed by hand, stay unchanged.
EMSCRIPTEN_KEEPALIVE const char* page_as_challenge(const char* text, int robots) {
  Result<Document> document =
      *text ? evenlift::decode_link(text) : evenlift::read_thesis(opening_sample());
  if (!document || document->settings.method == Method::given || robots < 1) return hand_over(text);
  document->shown.step.reset();
  Result<Opened> object = opened(*document);
  if (!object) return hand_over(text);
  const evenlift::Placement& placement = object->placement;
  document->settings = with_method(document->settings, Method::given, 1);
  document->settings.supports =
      evenlift::supports_to_place(placement.object, placement.centre_of_mass,
                                  static_cast<std::size_t>(robots), document->settings);
  return hand_over(link_or_nothing(*document));
}

// A link to the object alone, which does not show where robots should stand.
EMSCRIPTEN_KEEPALIVE const char* page_challenge_link() {
  Document document = last_good(app().state);
  evenlift::Settings settings;
  settings.weight = document.settings.weight;
  settings.teams = evenlift::view::usual_robots_to_place / 2;
  document.settings = settings;
  document.moved = {};
  document.shown.step.reset();
  document.shown.support_capacities.clear();
  return hand_over(link_or_nothing(document));
}

EMSCRIPTEN_KEEPALIVE void page_set_challenge(int on) { carry_out({SetChallenge{on != 0}}); }

// Puts the robots beneath the object again, and hides the page's own answer.
EMSCRIPTEN_KEEPALIVE void page_try_again(int robots) {
  if (robots < 1) return;
  carry_out({EndEdit{}, SetChallenge{true}, Compare{},
             PlaceYourself{static_cast<std::size_t>(robots)}, EndEdit{}});
}
EMSCRIPTEN_KEEPALIVE void page_show_answer() {
  carry_out({SetChallenge{false}, Compare{Method::balanced}});
}

// The scores of the robots and, if the second picture shows them, of balanced robots: an array of
// {"robots", "most", "spread", "covered", "numbers": [most, spread, covered, held]}.
EMSCRIPTEN_KEEPALIVE const char* page_scores() {
  const AppState& state = app().state;
  std::vector<std::string> scores;
  for (const bool answer : {false, true}) {
    const auto& placement = answer ? state.derived().second : state.derived().placement;
    if (!placement || (answer && placement->settings.method != Method::balanced)) continue;
    const evenlift::Reported of({*placement, shown(state)},
                                answer ? state.derived().second_report : state.derived().report);
    const ScoreInWords score = score_of(of);
    const auto& loads = placement->loads;
    scores.push_back(json::object(
        {{"robots", json::text(score.robots)},
         {"most", json::text(score.most)},
         {"spread", json::text(score.spread)},
         {"covered", json::text(score.covered)},
         {"numbers", json::numbers({loads ? loads->max : 0, loads ? loads->spread : 0,
                                    placement->coverage, of.report.held ? 1.0 : 0.0})}}));
  }
  return hand_over(json::array(scores));
}

EMSCRIPTEN_KEEPALIVE const char* page_svg() {
  const AppState& state = app().state;
  return hand_over(evenlift::placement_svg({*state.derived().placement, shown(state)},
                                           link_or_nothing(last_good(state))));
}
// For a file with this ending: ".csv", ".json" or ".yaml".
EMSCRIPTEN_KEEPALIVE const char* page_poses(const char* ending) {
  const auto format = evenlift::pose_format_of_file(ending);
  const AppState& state = app().state;
  return hand_over(format ? poses_text({*state.derived().placement, shown(state)}, *format)
                          : std::string());
}
EMSCRIPTEN_KEEPALIVE const char* page_text() {
  return hand_over(evenlift::write_thesis(app().state.derived().placed));
}

EMSCRIPTEN_KEEPALIVE double page_screen_x(double x, double y) {
  return app().state.view.camera.to_screen({x, y}).x * app().state.session.screen.zoom;
}
EMSCRIPTEN_KEEPALIVE double page_screen_y(double x, double y) {
  return app().state.view.camera.to_screen({x, y}).y * app().state.session.screen.zoom;
}
EMSCRIPTEN_KEEPALIVE double page_world_x(double x, double y) {
  return app().state.view.camera.to_world(evenlift::Vec2(x, y) / app().state.session.screen.zoom).x;
}
EMSCRIPTEN_KEEPALIVE double page_world_y(double x, double y) {
  return app().state.view.camera.to_world(evenlift::Vec2(x, y) / app().state.session.screen.zoom).y;
}

// --- The page around the canvas

// The link of a refused document; otherwise empty.
EMSCRIPTEN_KEEPALIVE const char* page_draft() {
  const AppState& state = app().state;
  return hand_over(state.derived().refusal ? link_or_nothing(state.work.document())
                                           : std::string());
}

// The polygon being drawn, as text for storage, which page_resume_drawing() reads.
EMSCRIPTEN_KEEPALIVE const char* page_drawing() {
  const evenlift::view::View& view = app().state.view;
  return hand_over(drawing_text(view.drawing, view.tool == Tool::hole));
}
EMSCRIPTEN_KEEPALIVE void page_resume_drawing(const char* text) {
  const auto kept = read_drawing(text);
  if (!kept || kept->points.empty()) return;
  Commands commands{SetTool{kept->is_hole ? Tool::hole : Tool::draw}};
  for (const evenlift::Vec2& p : kept->points) commands.push_back(AddPoint{p});
  carry_out(std::move(commands));
}

EMSCRIPTEN_KEEPALIVE const char* page_summary() { return hand_over(summary(app().state)); }

EMSCRIPTEN_KEEPALIVE const char* page_percentage(double share) {
  return hand_over(evenlift::percentage(share));
}

EMSCRIPTEN_KEEPALIVE const char* page_link_lacks() {
  return hand_over(link_lacks_in_words(app().state));
}
EMSCRIPTEN_KEEPALIVE const char* page_news() { return hand_over(news(app().state)); }

EMSCRIPTEN_KEEPALIVE void page_preferences(int dark, int reduced_motion, int coarse_pointer) {
  carry_out({SetPreferences{dark != 0, reduced_motion != 0, coarse_pointer != 0}});
}

// The preferences that the browser stores apart from the document; page_keep() reads them.
EMSCRIPTEN_KEEPALIVE const char* page_kept() {
  const AppState& state = app().state;
  return hand_over(kept_text({state.view.motion}));
}

EMSCRIPTEN_KEEPALIVE void page_keep(const char* lines) {
  carry_out({KeepMotion{read_kept(lines).motion}});
}

// A step for storage (History::kept()): {"edit", "method", "link"}. Method 0 means none; a document
// that is too large has an empty link. Empty if there is no such step.
EMSCRIPTEN_KEEPALIVE const char* page_kept_step(int redo, int index) {
  const std::optional<History::Kept> kept =
      app().state.work.history.kept(redo != 0, static_cast<std::size_t>(std::max(index, 0)));
  if (!kept) return hand_over({});
  const std::optional<evenlift::Method>& method = kept->beside.second_method;
  return hand_over(
      json::object({{"edit", std::to_string(static_cast<int>(kept->edit))},
                    {"method", std::to_string(method ? static_cast<int>(*method) + 1 : 0)},
                    {"link", json::text(kept->link)}}));
}

// The second method's number for storage, from 1, or 0 without one. page_compare() restores it
// without a step of undo.
EMSCRIPTEN_KEEPALIVE int page_compared() {
  const std::optional<evenlift::Method>& method = app().state.work.second_method;
  return method ? static_cast<int>(*method) + 1 : 0;
}
EMSCRIPTEN_KEEPALIVE void page_compare(int method) {
  if (const auto second = method_of(method)) carry_out({KeepComparison{*second}});
}

// Clears the history, or adds the step that will be undone or redone next.
EMSCRIPTEN_KEEPALIVE void page_forget_steps() { carry_out({ForgetSteps{}}); }
EMSCRIPTEN_KEEPALIVE void page_add_step(int redo, int edit, int method, const char* link) {
  carry_out({AddStep{redo != 0, {static_cast<Edit>(edit), {method_of(method), {}}, link}}});
}

// What a window of the page covers of the canvas, in CSS pixels.
EMSCRIPTEN_KEEPALIVE void page_cover(double left, double right, double foot) {
  carry_out({CoverScreen{left, right, foot}});
}

// The place for a card, whether or not there is one.
EMSCRIPTEN_KEEPALIVE const char* page_card_seat() {
  return hand_over(in_css_pixels(card_seat(app().state)));
}

// The open list's place, which a card would cover; empty if none is open.
EMSCRIPTEN_KEEPALIVE const char* page_open_list() {
  return hand_over(open_list() ? in_css_pixels(*open_list()) : std::string());
}

// For a card of this height at the foot of the drawing; 0 undoes that.
EMSCRIPTEN_KEEPALIVE void page_make_room(double height) {
  const Screen before = app().state.session.screen;
  app().commands.push_back(MakeRoom{height});
  settle();
  const Screen& now = app().state.session.screen;
  if (now.foot != before.foot || now.card != before.card) browser::request_frame();
}

// Puts the picture behind the canvas, in polygon coordinates; removes it if a size is 0.
EMSCRIPTEN_KEEPALIVE void page_backdrop(double left, double bottom, double width, double height) {
  if (width > 0 && height > 0)
    carry_out({LayPicture{{left, bottom}, {left + width, bottom + height}}});
  else
    carry_out({TakePictureAway{}});
}

// The picture's place: {"left", "bottom", "width"}, or empty.
EMSCRIPTEN_KEEPALIVE const char* page_backdrop_place() {
  const std::optional<Backdrop>& picture = app().state.work.backdrop;
  if (!picture) return hand_over({});
  return hand_over(json::object({{"left", json::number(picture->low.x)},
                                 {"bottom", json::number(picture->low.y)},
                                 {"width", json::number(picture->width())}}));
}

// Returns why the width is impossible, or an empty text.
EMSCRIPTEN_KEEPALIVE const char* page_scale_backdrop(double width) {
  const std::string problem = scale_picture(app().state, width);
  carried_out();
  return hand_over(problem);
}

// Presses go to the picture while its scale is being set.
EMSCRIPTEN_KEEPALIVE void page_measuring(int on) { carry_out({SetMeasuring{on != 0}}); }

// `kind` is a Notice::Kind.
EMSCRIPTEN_KEEPALIVE void page_notice(const char* text, int kind) {
  carry_out({ShowNotice{{static_cast<Notice::Kind>(kind), text}}});
}

EMSCRIPTEN_KEEPALIVE void page_end_notice() { carry_out({EndNotice{}}); }

// A key named as in KeyboardEvent.key. Returns whether the page used it; if not, the browser
// handles it.
EMSCRIPTEN_KEEPALIVE int page_key(const char* name, int command, int shift) {
  App& a = app();
  const Action* action = action_for(a.state, {name, command != 0, shift != 0});
  if (!action) return 0;
  action->run(a.state, a.commands);
  settle();
  browser::request_frame();
  return 1;
}

}  // extern "C"
