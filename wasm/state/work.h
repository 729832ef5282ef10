// What somebody works on: the document with its undo, and what undo brings back with it.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "evenlift/document.h"
#include "state/history.h"

namespace evenlift::view {

// What the robots' size, the edges that must not be touched and the goal were before a method that
// has no use for them.
struct SetAside {
  std::optional<RobotSize> robot;
  std::optional<std::vector<EdgePart>> no_go;
  std::optional<Goal> goal;
};

struct Work {
  // What is being edited; it may be refused.
  const Document& document() const { return document_; }
  // For a change on which the robots' places may depend: the document is placed anew.
  Document& edit() {
    ++edits_;
    return document_;
  }
  // For a change of what is shown, which places nothing.
  Shown& show() { return document_.shown; }
  std::uint64_t edits() const { return edits_; }  // how often it was edited

  History history;
  bool edit_open = false;               // a drag is under way; it will be one step of undo
  std::optional<Method> second_method;  // the method shown beside the document's
  SetAside aside;
  std::optional<Backdrop> backdrop;
  std::uint32_t pictures = 0;  // that were laid behind since the start

 private:
  Document document_;
  std::uint64_t edits_ = 0;
};

// What undo keeps beside the document.
inline Beside beside(const Work& work) { return {work.second_method, work.backdrop}; }

}  // namespace evenlift::view
