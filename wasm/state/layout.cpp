#include "state/layout.h"

#include <algorithm>
#include <vector>

#include "state/method.h"

namespace evenlift::view {
namespace {

constexpr double panel_width = 360, rail_width = 48;
// The width of a card beside the drawing, and the least width of a screen or a frame for it.
constexpr double card_width = 320, least_width = 900, least_width_of_frame = 600;
// Below these heights the view tools are in the toolbar's menu: they would cover the object.
constexpr double least_height_for_tools = 480, least_height_beside_sheet = 640;
// With less height for the picture, the sheet shows only the main facts.
constexpr double least_room = 165;
constexpr double knob = 36;           // above or below the frame around the polygon, to turn it
constexpr double caption_above = 34;  // of the lower or upper of two pictures
// A sheet with its handle and the player's row, or the verdict's headline and one row (panels.cpp).
constexpr double brief_row = 88, brief_verdict = 152;
// A sheet with its handle alone.
constexpr double handle_alone = 32;
// In presentation mode: the least height for a card below the words or beside the drawing, and the
// share of the height for the words above a card.
constexpr double least_height_for_both = 480, share_of_words = 0.45;

double bar_height(const Layout& l) { return l.control + 2 * l.bar_padding; }

// Of a tool's bar below the toolbar, with its margins.
double tool_bar_height(const Layout& l) { return l.control + 24; }

// Leaves room around the polygon for robots and their loads.
Rect room_in(const Rect& free, double beside, double above, double below) {
  constexpr double little = 150;  // with less height, loads are only at the sides
  const double x = std::min(beside, free.width() / 6),
               most = free.height() / (free.height() < little ? 6 : 4);
  return {free.left + x, free.top + std::min(above, most), free.right - x,
          free.bottom - std::min(below, most)};
}

// A window at the left or the foot makes the drawing smaller; one at the right only by what it
// covers beyond the panel.
void make_room_for_window(Layout& l, const Screen& screen) {
  constexpr double least = 135;  // width that the drawing keeps
  const double most = std::max(0.0, l.free.width() - least);
  const double left = std::min(screen.window_left, most);
  const double beyond_panel = l.free.right - (screen.width - screen.window_right);
  const double right = std::clamp(beyond_panel, 0.0, most - left);
  for (Rect* rect : {&l.free, &l.player}) {
    rect->left += left;
    rect->right -= right;
  }
  const double tools = std::min(left, std::max(0.0, l.free.right - l.margin - l.tools.right));
  l.tools.left += tools;
  l.tools.right += tools;
  l.free.bottom = std::min(l.free.bottom, screen.height - screen.window_foot);
}

// With presented steps, a card is below the words: the drawing keeps its size.
bool seats_card_below_words(const AppState& state) {
  const Screen& screen = state.session.screen;
  return presents_steps(state) && screen.width > screen.height &&
         screen.height >= least_height_for_both;
}

// The card of a presented task, or of one in a frame wider than high: the drawing keeps its height.
bool seats_card_beside(const AppState& state) {
  const Screen& screen = state.session.screen;
  const bool has_room = screen.embed ? screen.width >= least_width_of_frame
                                     : state.view.presenting && screen.width >= least_width &&
                                           screen.height >= least_height_for_both;
  return has_room && state.view.task && !walkthrough_is_open(state) && screen.width > screen.height;
}

// Where a panel at the right begins, or else the screen ends.
double right_end(const Layout& l, const Screen& screen) {
  return screen.embed ? screen.width : l.panel.left;
}

void make_room_for_card(Layout& l, const AppState& state) {
  const Screen& screen = state.session.screen;
  if (!(screen.foot > 0) || seats_card_below_words(state)) return;
  if (seats_card_beside(state))
    l.free.right = std::min(l.free.right, right_end(l, screen) - l.margin - card_width);
  else
    l.free.bottom -= screen.foot;
}

// Two pictures share what a card leaves free.
void split(Layout& l, const AppState& state, bool compared, double beside, double above,
           double below) {
  make_room_for_window(l, state.session.screen);
  make_room_for_card(l, state);
  l.first = l.free;
  if (!compared) {
    l.room = room_in(l.free, beside, above, below);
    return;
  }
  l.second = l.free;
  if (l.wide)
    l.first.right = l.second.left = l.free.middle().x;
  else
    l.first.bottom = l.second.top = l.free.middle().y;
  l.caption = l.wide ? 64 : caption_above;
  Rect below_caption = l.first;
  below_caption.top += l.caption;
  l.room = room_in(below_caption, beside * 0.8, above, l.wide ? below : below * 0.8);
}

// At the foot of the free area, below the view tools.
void seat_player(Layout& l, double right, double height) {
  l.player = {l.margin, l.free.bottom - l.margin - height, right, l.free.bottom - l.margin};
  l.tools.top -= height + l.margin;
  l.tools.bottom -= height + l.margin;
  l.free.bottom -= height + l.margin;
}

// One card at the foot: the step's words and one row of buttons, or else the result. Its height is
// constant.
Layout embedded(const AppState& state) {
  const Screen& screen = state.session.screen;
  Layout l;
  l.margin = 8;
  l.control = screen.finger ? 44 : 32;
  l.bar_padding = 4;
  l.wide = screen.width >= 640;
  l.free = screen.area();
  const double most = l.control + (l.wide ? 150 : 170);
  constexpr double two_lines = 40;  // of the result
  seat_player(l, screen.width - l.margin,
              walkthrough_is_open(state) ? std::min(screen.height * 0.44, most)
                                         : std::max(l.control, two_lines) + 2 * l.bar_padding);
  split(l, state, false, 72, 44, 48);
  return l;
}

// Presented steps: the words beside the drawing, or below it on an upright screen.
Layout presenting(const AppState& state) {
  const Screen& screen = state.session.screen;
  Layout l;
  l.control = 44;
  l.wide = screen.width > screen.height;
  if (!l.wide) l.margin = 8;
  l.free = screen.area();
  if (l.wide) {
    const double left = screen.width - l.margin - std::clamp(screen.width * 0.38, 240.0, 420.0);
    l.player = {left, l.margin, screen.width - l.margin, screen.height - l.margin};
    l.free.right = left;
  } else {
    seat_player(l, screen.width - l.margin, screen.height * 0.42);
  }
  if (seats_card_below_words(state) && screen.foot > 0)
    l.player.bottom = screen.height - screen.foot - l.margin / 2;
  split(l, state, false, 64, 44, 56);
  return l;
}

Layout wide(const AppState& state) {
  Layout l;
  const Screen& screen = state.session.screen;
  l.control = screen.finger ? 44 : 32;
  l.low = screen.height < least_height_for_tools;
  if (l.low) l.margin = 8;
  const double width = state.view.panel_open ? panel_width : rail_width + l.control - 32;
  l.panel = {screen.width - l.margin - width, l.margin, screen.width - l.margin,
             screen.height - l.margin};
  l.toolbar = {l.margin, l.margin, l.panel.left - l.margin, l.margin + bar_height(l)};
  // A walkthrough has no tool that adds robots.
  const double tools_width = (walkthrough_is_open(state) ? 5 * l.control + 8 : 6 * l.control + 10) +
                             zoom_width + 2 + 13 + 16;
  const double foot = screen.height - l.margin;
  l.tools = {l.margin, foot - bar_height(l), l.margin + tools_width, foot};
  if (l.low) l.tools = {l.margin, foot, l.margin, foot};
  l.free = {0, l.toolbar.bottom, l.panel.left, screen.height};
  if (walkthrough_is_open(state))
    seat_player(l, l.panel.left - l.margin, (l.low ? 1 : 2) * l.control + 24);
  // The tool's bar covers nothing of the object.
  const bool traces = state.work.backdrop && draws(state.view.tool);  // room_for_backdrop()
  if (state.view.tool != Tool::parts && state.view.tool != Tool::draw && !traces)
    l.free.top += tool_bar_height(l) + (state.view.tool == Tool::transform ? knob : 0);
  // A frame's corners are farther out than robots, and must be clear of the view tools.
  const double below = state.view.tool == Tool::transform ? 108 : 84;
  split(l, state, state.work.second_method.has_value(), 88, 68, below);
  return l;
}

// Leaves enough room for the drawing.
double half_sheet_height(const Screen& screen) { return screen.height * 0.47; }

double closed_sheet_height(const AppState& state) {
  // The same at every step of a walkthrough, so that the drawing does not move; longer words
  // scroll.
  const double height = walkthrough_is_open(state) ? 296 : state.session.closed_sheet_height;
  return std::min(height, half_sheet_height(state.session.screen));
}

bool has_bar(const AppState& state) {
  return state.view.tool != Tool::parts && !draws(state.view.tool);
}

bool asks_for_room(const AppState& state) {
  return state.session.screen.foot > 0 || has_bar(state) || state.work.second_method;
}

// The height of one picture above a closed sheet on a narrow screen.
double room_above(const Layout& l, const AppState& state, double sheet) {
  const Screen& screen = state.session.screen;
  double room = screen.height - bar_height(l) - 2 * l.margin - sheet - screen.foot;
  if (has_bar(state)) room -= tool_bar_height(l) + (state.view.tool == Tool::transform ? knob : 0);
  return state.work.second_method ? room / 2 - caption_above : room;
}

// Whether a task is open that is solved by dragging robots or C alone.
bool does_without_sheet(const AppState& state) {
  if (!state.view.task || walkthrough_is_open(state) || state.view.tool != Tool::parts)
    return false;
  const std::vector<Movable>& may = state.view.task->lesson.task->may;
  return std::all_of(may.begin(), may.end(), [](Movable part) {
    return part == Movable::robots || part == Movable::centre;
  });
}

Layout narrow(const AppState& state) {
  Layout l;
  const Screen& screen = state.session.screen;
  l.wide = false;
  l.control = 44;
  l.margin = 8;
  l.bar_padding = 2;
  const double most = half_sheet_height(screen);
  double height = closed_sheet_height(state);
  l.brief = state.view.sheet == Sheet::closed && asks_for_room(state) &&
            room_above(l, state, height) < least_room;
  if (l.brief) height = std::min(height, walkthrough_is_open(state) ? brief_row : brief_verdict);
  // The card of a task has its goals, and the drawing needs the room.
  l.bare = state.view.sheet == Sheet::closed && does_without_sheet(state);
  if (l.bare) height = handle_alone;
  if (state.view.sheet == Sheet::half) height = most;
  if (state.view.sheet == Sheet::full) height = screen.height - bar_height(l) - 3 * l.margin;
  l.panel = {0, screen.height - height, screen.width, screen.height};
  // A fully open sheet ends above a card of the page, which is then at the foot of the screen.
  if (state.view.sheet == Sheet::full && screen.card > 0)
    l.panel.bottom -= std::min(screen.card + 2 * l.margin, height / 2);
  l.toolbar = {l.margin, l.margin, screen.width - l.margin, l.margin + bar_height(l)};
  // A fully open sheet covers the drawing for a moment, and does not move it.
  const double below = std::min(height, most);
  l.free = {0, l.toolbar.bottom, screen.width, screen.height - below};
  if (has_bar(state)) l.free.top += tool_bar_height(l);
  const double tools_height = 3 * 44 + 2 * 2 + 4;
  l.tools = {screen.width - l.margin - 48, l.panel.top - l.margin - tools_height,
             screen.width - l.margin, l.panel.top - l.margin};
  // Beside an open sheet, or over one of two pictures, the tools would cover robots; a window would
  // cover the tools.
  l.low = screen.height < least_height_beside_sheet;
  if (l.low || state.view.sheet != Sheet::closed || state.work.second_method ||
      screen.window_foot > 0)
    l.tools = {l.tools.right, l.tools.bottom, l.tools.right, l.tools.bottom};
  split(l, state, state.work.second_method.has_value(), 60, 52, 52);
  // Left of the tools: a frame's corner cannot be grabbed under them.
  if (state.view.tool == Tool::transform && l.tools.height() > 0)
    l.room.right = std::max(l.room.middle().x, l.tools.left - 54);
  return l;
}

Layout in_mode(const AppState& state) {
  const Screen& screen = state.session.screen;
  if (presents_steps(state)) return presenting(state);
  if (screen.embed) return embedded(state);
  // A phone on its side counts as wide: a sheet would leave no room for the drawing.
  const bool side = screen.width >= 900 || (screen.width >= 640 && screen.width > screen.height);
  return side ? wide(state) : narrow(state);
}

}  // namespace

bool has_half_sheet(const AppState& state) {
  return half_sheet_height(state.session.screen) - closed_sheet_height(state) > 24;
}

namespace {

Rect seat_of_card(const AppState& state, const Layout& l) {
  constexpr double least = 520;  // width beside the view tools
  const double left = l.free.left + l.margin, right = l.free.right - l.margin;
  if (seats_card_below_words(state)) {
    const double height = state.session.screen.height;
    return {l.player.left, l.player.top + share_of_words * height, l.player.right,
            height - l.margin};
  }
  if (seats_card_beside(state)) {
    const Screen& screen = state.session.screen;
    const double end = right_end(l, screen) - l.margin;
    return {end - card_width, l.toolbar.bottom + l.margin, end,
            (screen.embed ? l.player.top : screen.height) - l.margin};
  }
  if (state.session.screen.embed || presents_steps(state) || state.session.screen.window_foot > 0)
    return {left, l.free.top, right, l.free.bottom + state.session.screen.foot - l.margin};
  if (!l.wide && state.view.sheet == Sheet::full)
    return {left, l.panel.top + (state.session.screen.height - l.panel.top) / 2, right,
            state.session.screen.height - l.margin};
  if (!l.wide) return {left, l.free.top, l.tools.left - l.margin, l.tools.bottom};
  if (right - l.tools.right - l.margin >= least)
    return {l.tools.right + l.margin, l.free.top, right, l.tools.bottom};
  return {left, l.free.top, right, l.tools.top - l.margin / 2};
}

Rect inset(const Rect& r, double by) {
  return {r.left + by, r.top + by, r.right - by, r.bottom - by};
}

// The notice covers no bar, no unfinished drawing and no presented words; it is above a card of the
// page. On a fully open sheet it is at the foot, since the verdict is at the head.
Rect seat_of_notice(const AppState& state, const Layout& l) {
  constexpr double gap = 8, least_height = 100, widest = 560;
  if (!l.wide && state.view.sheet == Sheet::full && !presents_steps(state) &&
      !state.session.screen.embed)
    return {l.margin, l.panel.middle().y, state.session.screen.width - l.margin,
            l.panel.bottom - gap};
  const bool beside = presents_steps(state) || seats_card_beside(state);
  const Rect seat = beside ? inset(l.free, gap) : seat_of_card(state, l);
  const double middle = seat.middle().x, half = std::min(seat.width(), widest) / 2,
               head = l.toolbar.bottom + 12;
  const double foot = std::min(seat.bottom, l.free.bottom - gap);
  return {middle - half, head, middle + half, std::max(foot, head + least_height)};
}

// A notice of several lines would cover robots at the foot of the lower picture, so the polygon
// makes room, unless the user moved the view. If that is not enough, the notice moves down over the
// sheet.
void make_room_for_notice(const AppState& state, Layout& l) {
  if (state.session.notice.text.empty()) return;
  constexpr double robot = 16;
  const bool two = l.second.width() > 0;
  const bool over_sheet = !l.wide && state.view.sheet == Sheet::closed &&
                          state.session.screen.foot == 0 && !presents_steps(state) &&
                          !state.session.screen.embed;
  const double lowest = l.room.bottom + (two ? l.second.bottom - l.first.bottom : 0);
  const double covered =
      std::max(0.0, lowest + robot - (l.notice.bottom - state.session.notice_height));
  const double made = state.view.camera_follows
                          ? std::min(covered, l.room.height() * (over_sheet ? 0.4 : 0.75))
                          : 0;
  l.room.bottom -= made;
  if (!over_sheet) return;
  // It covers only the sheet's handle or else the whole first sentence.
  constexpr double handle = 28, first_sentence = 104;
  double down = covered - made;
  if (down > handle) down = std::max(down, first_sentence);
  down = std::min(down, l.panel.bottom - l.margin - l.notice.bottom);
  l.notice.top += down;
  l.notice.bottom += down;
}

}  // namespace

Layout layout(const AppState& state) {
  Layout l = in_mode(state);
  l.notice = seat_of_notice(state, l);
  make_room_for_notice(state, l);
  return l;
}

namespace {

// How far sized robots extend beyond the object. Robots larger than it may be cut off.
double stands_out(const Settings& settings, double size) {
  const RobotSize& robot = settings.robot;
  if (!takes_sizes(settings.method) || !(robot.radius > 0)) return 0;
  return std::min(2 * robot.radius + robot.reach, size);
}

// For a traced picture: below the drawing tool's bar, which has a second row on a narrow screen
// (drawing_bar.cpp).
Rect room_for_backdrop(const Layout& l) {
  const double rows = l.wide || l.low ? 1 : 2, bar = 8 + rows * (l.control + 8) + 8;
  Rect room = l.room;
  if (!l.wide)  // no loads are beside the picture yet
    room = {l.free.left + l.margin, l.free.top, l.free.right - l.margin, l.free.bottom - l.margin};
  room.top = std::min(std::max(room.top, l.free.top + bar + l.margin), room.bottom - 1);
  return room;
}

// As large as possible without reaching the view tools.
Camera camera_of_backdrop(const Backdrop& picture, const Layout& l) {
  const Rect room = room_for_backdrop(l);
  const Points box{picture.low, picture.high};
  Camera largest = fit(box, room);
  const Vec2 corner = largest.to_screen(Vec2(picture.high.x, picture.low.y));  // lower right
  if (corner.x <= l.tools.left || corner.y <= l.tools.top) return largest;
  Rect beside = room, above = room;
  beside.right = l.tools.left - l.margin;
  above.bottom = l.tools.top - l.margin;
  const Camera first = fit(box, beside), second = fit(box, above);
  return first.scale >= second.scale ? first : second;
}

}  // namespace

Camera fitting_camera(const AppState& state) {
  const Layout l = layout(state);
  if (state.work.backdrop && draws(state.view.tool))
    return camera_of_backdrop(*state.work.backdrop, l);
  const Rect& room = l.room;
  const Points& vertices = state.work.document().vertices;
  const std::optional<Vec2>& centre = state.work.document().centre_of_mass;
  if (vertices.empty()) return fit(vertices, room);
  Box box = bounding_box(vertices);
  if (centre) box = {componentwise_min(box.low, *centre), componentwise_max(box.high, *centre)};
  const double out = stands_out(settings(state), box.diagonal());
  return fit({box.low - Vec2(out, out), box.high + Vec2(out, out)}, room);
}

Rect card_seat(const AppState& state) { return seat_of_card(state, layout(state)); }

}  // namespace evenlift::view
