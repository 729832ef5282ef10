// Undo and redo without limit. It keeps whole documents; those that differ only in their settings
// share their vertices. The page keeps the newest steps in the browser.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "evenlift/document.h"
#include "evenlift/settings.h"
#include "evenlift/vec.h"

namespace evenlift::view {

// What an edit did. The browser keeps these numbers, so a new one goes to the end. A setting that
// has none here has that of its record in links (SettingRow), counted from `edit_of_records` on.
enum class Edit : std::uint32_t {
  opened,
  drawn,
  settings,
  teams,
  method,
  min_ratio,
  weight,
  seed,
  vertex_moved,
  vertex_added,
  vertex_removed,
  centre_moved,
  centre_released,
  whole,
  capacity,
  comparison,
  lesson_left,
  robots,
  goal,
  com_radius,
  positions,
  robot_size,
  marks,
  robots_moved,
  robots_reset,
  lesson_opened
};
inline constexpr std::size_t edit_count = 26, edit_of_records = 100;

// "moved a vertex". O(settings).
std::string in_words(Edit edit);

// The edit that changes a setting. O(settings).
Edit edit_of(const SettingRow& row);

// What is shown, with the overlays and the step of another: these are no edit, and undo leaves
// them. O(1).
Shown seen_as(Shown shown, const Shown& other);

// Whether another object took the place of the one that was open. O(1).
bool is_other_object(Edit edit);

// A picture that lies behind the drawing, to be traced. The page draws it; the view knows where it
// lies.
struct Backdrop {
  Vec2 low, high;             // its corners, in polygon coordinates
  std::uint32_t picture = 0;  // which one it is, counted from the start
  bool traced = false;        // the open polygon was drawn on it
  bool operator==(const Backdrop&) const = default;
  double width() const { return high.x() - low.x(); }
};

// What undo brings back besides the document.
struct Beside {
  std::optional<Method> second_method;
  std::optional<Backdrop> backdrop;  // not kept in the browser, as the picture is not
  bool operator==(const Beside&) const = default;
};

class History {
 public:
  // Remembers the document as it was before an edit. Nothing can be redone after that.
  void record(const Document& before, const Beside& beside = {}, Edit edit = Edit::settings);

  // How many edits can be undone.
  std::size_t depth() const { return past_.size(); }
  bool can_undo() const { return !past_.empty(); }
  bool can_redo() const { return !future_.empty(); }

  // The edit that undo() (redo()) would take back (do again); call only if can_undo() (can_redo()).
  Edit undoes() const { return past_.back().edit; }
  Edit redoes() const { return future_.back().edit; }

  // The document before the last edit (after the last undone one), given the one of now; call only
  // if can_undo() (can_redo()).
  struct Recalled {
    Document document;
    Beside beside;
    Edit edit;
  };
  Recalled undo(const Document& now, const Beside& beside = {});
  Recalled redo(const Document& now, const Beside& beside = {});

  // Leaves the lesson whose object is open: what was open before it; nothing if no lesson was
  // opened. If nothing was edited since, the history is as if the lesson had not been opened.
  // Otherwise leaving it is one more step, which undo takes back.
  std::optional<Recalled> leave_lesson(const Document& now, const Beside& beside = {});

  // The index, as for kept(), of the step that opened the lesson whose object was open before the
  // newest `later` steps; nothing if that was no lesson's. O(steps).
  std::optional<std::size_t> lesson_opened(std::size_t later = 0) const;

  // A step to be kept outside: the one that so many undos (redos) lead to, from 0; nothing if there
  // is none. A document that is too large for a link has none. The first time O(n), then O(bytes).
  struct Kept {
    Edit edit = Edit::settings;
    Beside beside;
    std::string link;
  };
  std::optional<Kept> kept(bool redo, std::size_t index);

  // Adds such a step as the newest one to be undone (redone). Does nothing with a link that cannot
  // be read. O(n).
  void add(bool redo, const Kept& kept);
  void clear();

 private:
  struct Entry {
    std::shared_ptr<const Points> vertices;
    Document rest;  // without them
    Beside beside;
    Edit edit = Edit::settings;
    std::string link;  // once it was written
  };
  Entry remember(const Document& document, const Beside& beside, Edit edit) const;
  static Document recall(const Entry& entry);
  Recalled step(std::vector<Entry>& from, std::vector<Entry>& to, const Document& now,
                const Beside& beside);

  std::vector<Entry> past_, future_;
  std::vector<Entry> future_before_lesson_;  // what could be redone when the last lesson was opened
};

}  // namespace evenlift::view
