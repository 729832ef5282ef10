// What a person, a key or another page can ask for: data, applied between drawing (update.h).
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "state/browser.h"
#include "state/opened.h"
#include "state/state.h"

namespace evenlift::view {

// Edits of the document, each a step of undo. While `live`, further live edits belong to the same
// step, until EndEdit.
struct SetSettings {
  Settings settings;
  bool live = false;
};
struct MoveVertex {
  std::size_t vertex;
  Vec2 to;
};  // live
struct MoveCentre {
  Vec2 to;
};                        // live
struct ReleaseCentre {};  // back to the centroid
struct InsertVertex {
  std::size_t edge;
  Vec2 at;
};  // and selects it
struct RemoveVertex {
  std::size_t vertex;
};
struct OpenDocument {
  Opened opened;  // applying the command moves it out
};
struct SetWhole {
  Points vertices;
  std::optional<Vec2> centre_of_mass;
  bool live = false;
};
struct EndEdit {};
struct Undo {};
struct Redo {};

// The rest leaves the polygon and its placement alone.
struct Show {
  Overlays overlays;
};
struct SetTool {
  Tool tool;
};
struct GripWhole {};  // remembers the polygon as it is, for SetWhole
struct AddPoint {
  Vec2 at;
};
struct TakePointBack {};
struct PutPointBack {};
struct FinishDrawing {};  // opens it, or says what is wrong with it
struct SetDrawCursor {
  std::optional<Vec2> at;
};
struct SetSnap {
  Snap snap;
};
struct OpenLesson {};  // where it was left
struct CloseLesson {};
struct GoToStep {
  std::uint32_t step;
};
struct MoveSteps {
  int by;  // of the ready-made lesson's stops, if there is one
};
struct MoveChapters {
  int by;
};
struct SetPlaying {
  bool playing;
};
struct SetSpeed {
  double speed;
};
struct SetPredict {
  bool on;
};
struct Guess {
  std::uint32_t answer;
};
struct PointAtChoice {
  std::size_t choice;  // among those of the question
};
struct AskWhy {
  Vec2 at;
};
struct Measure {
  std::uint32_t candidate;
};
struct HoverFigure {
  std::optional<std::size_t> figure;
};
struct LeaveScript {};  // on in the whole trace, at the same step
struct Compare {
  std::optional<Method> method;
};
struct SetCapacity {
  std::optional<double> capacity;
};
struct SetMotion {
  bool on;
};
struct SelectVertex {
  std::optional<std::size_t> vertex;
};
struct SetHover {
  Pick pick;
};
struct SetHeld {
  Pick pick;
};
struct SetCamera {
  Camera camera;
};
struct FitView {};
struct ZoomView {
  double factor;
};  // about the middle
struct SetPanelOpen {
  bool open;
};
struct SetHelpOpen {
  bool open;
};
struct ListIsOpen {
  bool open;
};  // the panels tell what they find
struct CloseList {};
struct SetSheet {
  Sheet sheet;
};
struct MeasureSheet {
  double closed_height;
};
struct CopyLink {};
struct OpenDialog {
  browser::Dialog dialog;
};
struct ShowNotice {
  Notice notice;
};

using Command =
    std::variant<SetSettings, MoveVertex, MoveCentre, ReleaseCentre, InsertVertex, RemoveVertex,
                 OpenDocument, SetWhole, EndEdit, Undo, Redo, Show, SetTool, GripWhole, AddPoint,
                 TakePointBack, PutPointBack, FinishDrawing, SetDrawCursor, SetSnap, Compare,
                 SetCapacity, SetMotion, OpenLesson, CloseLesson, GoToStep, MoveSteps, MoveChapters,
                 SetPlaying, SetSpeed, SetPredict, Guess, PointAtChoice, AskWhy, Measure,
                 HoverFigure, LeaveScript, SelectVertex, SetHover, SetHeld, SetCamera, FitView,
                 ZoomView, SetPanelOpen, SetHelpOpen, ListIsOpen, CloseList, SetSheet, MeasureSheet,
                 CopyLink, OpenDialog, ShowNotice>;
using Commands = std::vector<Command>;

}  // namespace evenlift::view
