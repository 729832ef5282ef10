// Unlimited undo and redo. Documents are kept whole; those that differ only in settings share their
// vertices. The page keeps the newest steps in the browser.
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

// The browser keeps these numbers, so a new kind goes at the end. A setting without a kind has the
// number of its record in links (SettingRow), counted from `edit_of_records`.
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

// "moved a vertex". O(settings).
std::string in_words(Edit edit);

// O(settings).
Edit edit_of(const SettingRow& row);

// `shown` with the overlays and the step of `other`, which undo leaves unchanged. O(1).
Shown seen_as(Shown shown, const Shown& other);

// Whether another object replaced the open one. O(1).
bool is_other_object(Edit edit);

// Behind the drawing, for tracing. The page draws it; the view knows its position.
struct Backdrop {
  Vec2 low, high;             // its corners, in polygon coordinates
  std::uint32_t picture = 0;  // its number since the start
  bool traced = false;        // the open polygon was drawn on it
  bool operator==(const Backdrop&) const = default;
  double width() const { return high.x() - low.x(); }
};

// What undo restores in addition to the document.
struct Beside {
  std::optional<Method> second_method;
  std::optional<Backdrop> backdrop;  // not kept in the browser, as the picture is not
  bool operator==(const Beside&) const = default;
};

class History {
 public:
  // Also clears redo.
  void record(const Document& before, const Beside& beside = {}, Edit edit = Edit::settings);

  // Of edits that can be undone.
  std::size_t depth() const { return past_.size(); }
  bool can_undo() const { return !past_.empty(); }
  bool can_redo() const { return !future_.empty(); }

  // What undo() would undo and redo() would redo. Precondition: can_undo() (can_redo()).
  Edit undoes() const { return past_.back().edit; }
  Edit redoes() const { return future_.back().edit; }

  // The document before the last edit (after the last undone one). Precondition: can_undo()
  // (can_redo()).
  struct Recalled {
    Document document;
    Beside beside;
    Edit edit;
  };
  Recalled undo(const Document& now, const Beside& beside = {});
  Recalled redo(const Document& now, const Beside& beside = {});

  // Leaves the open lesson and returns what was open before it; nothing without one. Without edits
  // since, the history forgets the lesson. Otherwise leaving it is another step, which can be
  // undone.
  std::optional<Recalled> leave_lesson(const Document& now, const Beside& beside = {});

  // The index, as for kept(), of the step that opened a lesson, if the object before the newest
  // `later` steps belongs to it; otherwise nothing. O(steps).
  std::optional<std::size_t> lesson_opened(std::size_t later = 0) const;

  // For storage outside: index i is the step that i + 1 undos (redos) lead to, if it exists. The
  // link is empty if the document is too large for one. The first time O(n), then O(bytes).
  struct Kept {
    Edit edit = Edit::settings;
    Beside beside;
    std::string link;
  };
  std::optional<Kept> kept(bool redo, std::size_t index);

  // As the newest step to undo (redo). Ignores an unreadable link. O(n).
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
  std::vector<Entry> future_before_lesson_;  // when the last lesson was opened
};

}  // namespace evenlift::view
