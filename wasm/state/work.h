// The document with its undo, and what undo restores with it.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "evenlift/document.h"
#include "state/history.h"

namespace evenlift::view {

// What the present method does not support, from a former one.
struct SetAside {
  std::optional<RobotSize> robot;
  std::optional<std::vector<EdgePart>> no_go;
  std::optional<Goal> goal;
};

struct Work {
  // It may be refused.
  const Document& document() const { return document_; }
  // For a change that may affect the robots' places: the document is placed again.
  Document& edit() {
    ++edits_;
    return document_;
  }
  // For a change that places nothing.
  Shown& show() { return document_.shown; }
  std::uint64_t edits() const { return edits_; }

  History history;
  bool edit_open = false;               // a drag is under way, which becomes one step of undo
  std::optional<Method> second_method;  // beside the document's
  SetAside aside;
  std::optional<Backdrop> backdrop;
  std::uint32_t pictures = 0;  // put behind the drawing since the start

 private:
  Document document_;
  std::uint64_t edits_ = 0;
};

inline Beside beside(const Work& work) { return {work.second_method, work.backdrop}; }

}  // namespace evenlift::view
