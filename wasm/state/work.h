// The work: the document, its history, and the values that undo restores with the document.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "evenlift/document.h"
#include "state/history.h"

namespace evenlift::view {

// Settings kept from a former method because the present method does not support them (method.h).
struct SetAside {
  std::optional<RobotSize> robot;
  std::optional<std::vector<EdgePart>> no_go;
  std::optional<Goal> goal;
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
