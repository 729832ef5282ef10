// The history, and the work that it holds.
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

// --- Unlimited undo and redo. Documents are kept whole; documents that differ only in settings share
// their vertices. The page keeps the newest steps in the browser.

// The kinds of edits. The browser keeps their numbers, so a new kind goes at the end. For a setting
// without a kind, the number is `edit_of_records` + SettingRow::record of this setting.
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
  lesson_opened,
  hole_drawn,
  hole_removed,
  weight_added,
  weight_moved,
  weight_changed,
  weight_removed
};
inline constexpr std::size_t edit_count = 32, edit_of_records = 100;

// Returns the edit in words, such as "moved a vertex". O(settings).
std::string in_words(Edit edit);

// Returns the kind of a change of this setting. O(settings).
Edit edit_of(const SettingRow& row);

// Returns `shown` with the overlays and the step of `other`, which undo must not change. O(1).
Shown seen_as(Shown shown, const Shown& other);

// Returns whether this edit replaced the open object by another one. O(1).
bool is_other_object(Edit edit);

// A picture behind the drawing, which the user can draw over. The page draws the picture; the view
// knows its position.
struct Backdrop {
  Vec2 low, high;             // its corners, in polygon coordinates
  std::uint32_t picture = 0;  // the picture's number, counted since the start
  bool traced = false;        // the present polygon was drawn on the picture
  bool operator==(const Backdrop&) const = default;
  double width() const { return high.x - low.x; }
};

// What undo restores in addition to the document.
struct Beside {
  std::optional<Method> second_method;
  std::optional<Backdrop> backdrop;  // not kept in the browser, since the picture is not
  bool operator==(const Beside&) const = default;
};

class History {
 public:
  // Records an edit of the document `before`, and clears redo.
  void record(const Document& before, const Beside& beside = {}, Edit edit = Edit::settings);

  // Returns the number of edits that can be undone.
  std::size_t depth() const { return past_.size(); }
  bool can_undo() const { return !past_.empty(); }
  bool can_redo() const { return !future_.empty(); }

  // undoes() returns the edit that undo() would undo, and redoes() the one that redo() would redo.
  // Precondition: can_undo() (can_redo()).
  Edit undoes() const { return past_.back().edit; }
  Edit redoes() const { return future_.back().edit; }

  // undo() returns the document before the last edit, and redo() the document after the edit undone
  // last. Precondition: can_undo() (can_redo()).
  struct Recalled {
    Document document;
    Beside beside;
    Edit edit;
  };
  Recalled undo(const Document& now, const Beside& beside = {});
  Recalled redo(const Document& now, const Beside& beside = {});

  // Leaves the open lesson and returns the document that was open before it; nothing if no lesson
  // is open. If the lesson was not edited, the history forgets the lesson. Otherwise leaving the
  // lesson is another step, which can be undone.
  std::optional<Recalled> leave_lesson(const Document& now, const Beside& beside = {});

  // Finds the lesson that was open before the newest `later` steps (0: the present lesson). Returns
  // the index, as for kept(), of the step that opened it, or nothing if none was open. O(steps).
  std::optional<std::size_t> lesson_opened(std::size_t later = 0) const;

  // A step in the form that the browser stores. For index i, kept() returns the step that i + 1
  // undos (redos) reach, or nothing if there are fewer steps. The link is empty if the document is
  // too large for a link. The first call for a step costs O(n), and later ones O(bytes).
  struct Kept {
    Edit edit = Edit::settings;
    Beside beside;
    std::string link;
  };
  std::optional<Kept> kept(bool redo, std::size_t index);

  // Adds a step as the next one to undo (redo). Ignores a step whose link is unreadable. O(n).
  void add(bool redo, const Kept& kept);
  void clear();

 private:
  struct Entry {
    std::shared_ptr<const Points> vertices;
    Document rest;  // without the vertices
    Beside beside;
    Edit edit = Edit::settings;
    std::string link;  // empty until first needed
  };
  Entry remember(const Document& document, const Beside& beside, Edit edit) const;
  static Document recall(const Entry& entry);
  Recalled step(std::vector<Entry>& from, std::vector<Entry>& to, const Document& now,
                const Beside& beside);

  std::vector<Entry> past_, future_;
  std::vector<Entry> future_before_lesson_;  // `future_` when the last lesson was opened
};

// --- The work: the document, its history, and the values that undo restores with the document.

// Settings kept from a former method because the present method does not support them (method.h).
struct SetAside {
  std::optional<RobotSize> robot;
  std::optional<std::vector<EdgePart>> no_go;
  std::optional<Goal> goal;
  std::optional<Method> method;  // before the robots were placed by hand
};

struct Work {
  // Returns the present document. It may be invalid, and then has no placement.
  const Document& document() const { return document_; }
  // Returns the document for a change that may affect the robots' places. derive() then computes
  // the placement again.
  Document& edit() {
    ++edits_;
    return document_;
  }
  // Returns the part of the document whose changes need no new placement.
  Shown& show() { return document_.shown; }
  // Returns the number of calls of edit().
  std::uint64_t edits() const { return edits_; }

  History history;
  bool edit_open = false;               // a drag is under way; it becomes one step of undo
  std::optional<Method> second_method;  // compared with the document's method
  SetAside aside;
  std::optional<Backdrop> backdrop;
  std::uint32_t pictures = 0;  // the number of pictures put behind the drawing since the start

 private:
  Document document_;
  std::uint64_t edits_ = 0;
};

// Returns the values that undo restores in addition to the document. O(1).
inline Beside beside(const Work& work) { return {work.second_method, work.backdrop}; }

}  // namespace evenlift::view
