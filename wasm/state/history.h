// Undo and redo without limit. It keeps whole documents; those that differ only in their settings
// share their vertices.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "evenlift/document.h"

namespace evenlift::view {

class History {
 public:
  // Remembers the document as it was before an edit. Nothing can be redone after that.
  void record(const Document& before);

  // How many edits can be undone.
  std::size_t depth() const { return past_.size(); }
  bool can_undo() const { return !past_.empty(); }
  bool can_redo() const { return !future_.empty(); }

  // The document before the last edit (after the last undone one), given the one of now; call only
  // if can_undo() (can_redo()).
  Document undo(const Document& now);
  Document redo(const Document& now);

 private:
  struct Entry {
    std::shared_ptr<const Points> vertices;
    std::optional<Vec2> centre_of_mass;
    Settings settings;
  };
  Entry remember(const Document& document) const;
  static Document recall(const Entry& entry);
  static Document step(std::vector<Entry>& from, std::vector<Entry>& to, Entry now);

  std::vector<Entry> past_, future_;
};

}  // namespace evenlift::view
