#include "update.h"

#include <algorithm>
#include <utility>

#include "browser.h"
#include "evenlift/formats.h"
#include "evenlift/link.h"
#include "format.h"
#include "layout.h"

namespace evenlift::view {
namespace {

constexpr double largest_zoom =
    1000;  // times the view that fits: screen coordinates stay fit for floats
constexpr double smallest_zoom = 0.05;

void show(AppState& state, Notice notice) {
  if (notice.text != state.notice.text) browser::announce(notice.text);
  state.notice = std::move(notice);
}

// Takes over what place() says of the document.
void adopt(AppState& state, Result<Placement> placement) {
  ++state.revision;
  const std::string before = state.refusal ? sentence(*state.refusal) : std::string();
  if (placement) {
    state.placement = std::move(placement).value();
    state.placed = state.document;
    state.refusal.reset();
  } else {
    state.refusal = placement.error();
  }
  show(state, {});
  const std::string now = state.refusal ? sentence(*state.refusal) : std::string();
  if (now != before) browser::announce(now);
  browser::document_changed();
}

void recompute(AppState& state) { adopt(state, place(state.document)); }

// A selection or a grip on something that an undo or a new document took away is none.
void drop_stale_picks(AppState& state) {
  const std::size_t count = state.document.vertices.size();
  if (state.selected && *state.selected >= count) state.selected.reset();
  for (Pick* pick : {&state.hover, &state.held}) {
    const bool of_polygon = pick->kind == Pick::Kind::vertex || pick->kind == Pick::Kind::edge;
    if (of_polygon && pick->index >= count) *pick = {};
  }
}

void begin_edit(AppState& state, bool live) {
  if (live && state.edit_open) return;
  state.history.record(state.document);
  state.edit_open = live;
}

void fit_view(AppState& state) { state.camera_follows = state.fit_due = true; }

void open(AppState& state, Document document) {
  begin_edit(state, false);
  state.document = std::move(document);
  state.selected.reset();
  state.hover = state.held = {};
  fit_view(state);
  recompute(state);
}

// Whether the camera shows all of the points, and not from afar.
bool well_shown(const AppState& state) {
  const Screen& screen = state.screen;
  const double best = fit(state.document.vertices, layout(state).room).scale;
  if (state.camera.scale < best * 0.4) return false;
  const Rect window{0, 0, screen.width, screen.height};
  return std::all_of(state.document.vertices.begin(), state.document.vertices.end(),
                     [&](const Vec2& p) { return window.contains(state.camera.to_screen(p)); });
}

void step_back(AppState& state, Document document) {
  const bool other_shape = document.vertices.size() != state.document.vertices.size();
  state.edit_open = false;
  state.document = std::move(document);
  if (other_shape) state.selected.reset();
  drop_stale_picks(state);
  if (state.camera_follows && !well_shown(state)) state.fit_due = true;
  recompute(state);
}

void zoom_view(AppState& state, const Vec2& about, double factor) {
  const double fitting = fit(state.document.vertices, layout(state).room).scale;
  state.camera = zoom(state.camera, about, factor, fitting * smallest_zoom, fitting * largest_zoom);
  state.camera_follows = false;
}

struct Applier {
  AppState& state;

  void operator()(const SetSettings& c) const {
    if (c.settings == state.document.settings) return;
    begin_edit(state, c.live);
    state.document.settings = c.settings;
    recompute(state);
  }
  void operator()(const MoveVertex& c) const {
    if (c.vertex >= state.document.vertices.size() || state.document.vertices[c.vertex] == c.to)
      return;
    begin_edit(state, true);
    state.document.vertices[c.vertex] = c.to;
    recompute(state);
  }
  void operator()(const MoveCentre& c) const {
    if (state.document.centre_of_mass == c.to) return;
    begin_edit(state, true);
    state.document.centre_of_mass = c.to;
    recompute(state);
  }
  void operator()(const ReleaseCentre&) const {
    if (!state.document.centre_of_mass) return;
    begin_edit(state, false);
    state.document.centre_of_mass.reset();
    recompute(state);
  }
  void operator()(const InsertVertex& c) const {
    Points& vertices = state.document.vertices;
    if (c.edge >= vertices.size()) return;
    begin_edit(state, false);
    vertices.insert(vertices.begin() + static_cast<std::ptrdiff_t>(c.edge) + 1, c.at);
    state.selected = c.edge + 1;
    recompute(state);
  }
  void operator()(const RemoveVertex& c) const {
    Points& vertices = state.document.vertices;
    if (c.vertex >= vertices.size()) return;
    if (vertices.size() <= 3) {
      show(state, {Notice::Kind::problem, "A polygon needs at least 3 vertices."});
      return;
    }
    begin_edit(state, false);
    vertices.erase(vertices.begin() + static_cast<std::ptrdiff_t>(c.vertex));
    state.selected.reset();
    state.hover = state.held = {};
    recompute(state);
  }
  void operator()(const OpenDocument& c) const { open(state, c.document); }
  void operator()(const EndEdit&) const { state.edit_open = false; }
  void operator()(const Undo&) const {
    if (state.history.can_undo()) step_back(state, state.history.undo(state.document));
  }
  void operator()(const Redo&) const {
    if (state.history.can_redo()) step_back(state, state.history.redo(state.document));
  }

  void operator()(const SelectVertex& c) const {
    state.selected = c.vertex;
    drop_stale_picks(state);
  }
  void operator()(const SetHover& c) const { state.hover = c.pick; }
  void operator()(const SetHeld& c) const { state.held = c.pick; }
  void operator()(const SetCamera& c) const {
    const double fitting = fit(state.document.vertices, layout(state).room).scale;
    state.camera = c.camera;
    state.camera.scale =
        std::clamp(c.camera.scale, fitting * smallest_zoom, fitting * largest_zoom);
    state.camera_follows = false;
  }
  void operator()(const FitView&) const { fit_view(state); }
  void operator()(const ZoomView& c) const {
    zoom_view(state, layout(state).room.middle(), c.factor);
  }
  void operator()(const SetPanelOpen& c) const { state.panel_open = c.open; }
  void operator()(const SetHelpOpen& c) const { state.help_open = c.open; }
  void operator()(const ListIsOpen& c) const {
    state.list_open = c.open;
    state.close_list = state.close_list && c.open;
  }
  void operator()(const CloseList&) const { state.close_list = true; }
  void operator()(const SetSheet& c) const { state.sheet = c.sheet; }
  void operator()(const MeasureSheet& c) const { state.closed_sheet_height = c.closed_height; }
  void operator()(const CopyLink&) const {
    const Result<std::string> link = encode_link(state.placed);
    if (link) {
      browser::copy_address(*link);
    } else {
      show(state, {Notice::Kind::problem, sentence(link.error()) + "."});
    }
  }
  void operator()(const OpenDialog& c) const { browser::open_dialog(c.dialog); }
  void operator()(const ShowNotice& c) const { show(state, c.notice); }
};

}  // namespace

bool apply(AppState& state, Commands& commands) {
  if (commands.empty()) return false;
  for (const Command& command : commands) std::visit(Applier{state}, command);
  commands.clear();
  return true;
}

void frame_view(AppState& state) {
  if (!state.camera_follows || state.edit_open) return;
  const Rect room = layout(state).room;
  if (!state.fit_due && room == state.fitted) return;
  state.camera = fit(state.document.vertices, room);
  state.fitted = room;
  state.fit_due = false;
}

Result<Document> read_link(std::string_view link) {
  Result<Document> document = decode_link(link);
  if (!document) return document;
  const Result<Placement> placement = place(*document);
  if (!placement) return placement.error();
  return document;
}

Result<Document> read_document(std::string_view text) {
  if (looks_like_link(text)) return read_link(text);
  Result<Document> document = read_polygon(text);
  if (!document) return document;
  const Result<Placement> placement = place(*document);
  if (!placement) return placement.error();
  return document;
}

void start_with(AppState& state, Document document, const std::optional<Document>& work) {
  state.document = work ? *work : document;
  fit_view(state);
  recompute(state);
  if (work) open(state, std::move(document));
}

std::optional<InputError> try_edit(AppState& state, const Document& edited) {
  Result<Placement> placement = place(edited);
  if (!placement) return placement.error();
  begin_edit(state, false);
  state.document = edited;
  adopt(state, std::move(placement));
  return std::nullopt;
}

}  // namespace evenlift::view
