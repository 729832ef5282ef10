// Everything that the user, a key or another page can ask for. A command is data, which update.h
// applies between two frames.
#pragma once

#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "state/effects.h"
#include "state/opened.h"
#include "state/state.h"
#include "state/view_state.h"

namespace evenlift::view {

// Edits of the document: one step of undo each. Consecutive live edits form one step, until
// EndEdit. MoveVertex and MoveCentre are always live.
struct SetSettings {
  Settings settings;
  bool live = false;
};
struct SetMethod {
  Method method;
};
struct MoveVertex {
  std::size_t vertex;  // or a weight: the number of a handle (handles.h)
  Vec2 to;
};
struct MoveCentre {
  Vec2 to;
};
struct ReleaseCentre {};  // back to the centroid
// Of the outline or of a hole; also selects the vertex.
struct InsertVertex {
  std::size_t edge;
  Vec2 at;
};
struct RemoveVertex {  // the last three of a hole go with the hole
  std::size_t vertex;  // or a weight, as above
};
struct AddWeight {  // also selects it
  Vec2 at;
};
struct SetCargo {  // as typed
  std::size_t item;
  Cargo cargo;
};
struct OpenDocument {
  Opened opened;  // applying the command moves it out
};
struct SetPolygon {
  PolygonGrip shape;
  bool live = false;
};
struct EndEdit {};
struct Undo {};
struct Redo {};

// Moves a balanced robot along the outline, and its neighbours follow; or a team, with the robot,
// along its range; or the robot freely, with the method `given`. Always live.
struct MoveRobot {
  std::size_t robot;  // counted team after team
  Vec2 to;
};
struct PlaceYourself {  // beneath the object, to play with
  std::size_t robots = 4;
};
struct CloseTask {};   // restores what was open before
struct SetChallenge {  // the page keeps its own answers to itself
  bool on;
};
struct AddRobot {  // or where it adds most to the lifting base
  std::optional<Vec2> at;
};
struct PutRobot {  // exactly at a place, as typed
  std::size_t robot;
  Vec2 at;
};
struct RemoveRobot {  // from 0, or the last
  std::optional<std::size_t> robot;
};
struct EvenOut {};      // moves two or three given robots to equal loads
struct ResetRobots {};  // back to where the method placed them

// Of the search with this number (Given::Found). Without `robots`, it cannot continue.
struct TakeRobots {
  std::uint64_t number;
  std::optional<std::string> robots;
  bool ended = true;
};

// The worker's choice for the document with this number (Given::Chosen).
struct TakeChoice {
  std::uint64_t number;
  std::optional<std::vector<double>> choice;
};

// The other commands change neither the polygon nor its placement. SetShown is one step of undo,
// unless only overlays differ.
struct SetShown {
  Shown shown;
  bool live = false;
};
template <class Value>
SetShown showing(const AppState& state, Value Shown::*member, std::type_identity_t<Value> value,
                 bool live = false) {
  SetShown changed{shown(state), live};
  changed.shown.*member = std::move(value);
  return changed;
}
struct SetTool {
  Tool tool;
};
struct GripPolygon {};  // for SetPolygon
struct AddPoint {
  Vec2 at;
};
struct TakePointBack {};
struct PutPointBack {};
struct FinishDrawing {};  // or reports its error
struct MovePoint {        // a placed one
  std::size_t point;
  Vec2 to;
};
struct SetDrawCursor {
  std::optional<Vec2> at;
  std::optional<Vec2> pointer;  // in pixels, if the pointer moved it
  bool by_keys = false;
};
// The next edge's typed length and angle in degrees; a missing value stays. With `place`, also
// places the edge's end.
struct TypeEdge {
  std::optional<double> length, degrees;
  bool place = false;
};
struct WithdrawEdge {};  // forgets both values
struct SetSnap {
  Snap snap;
};
struct OpenWalkthrough {};  // where the user left it
struct CloseWalkthrough {};
struct GoToStep {
  std::uint32_t step;
};
struct MoveSteps {
  int by;  // stops of the lesson, if one is open
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
  std::size_t choice;  // an index into Ask::choices
};
struct AskWhy {
  std::optional<Vec2> at;  // without a place, withdraws the question
};
struct Measure {
  std::uint32_t candidate;
};
struct HoverFigure {
  std::optional<std::size_t> figure;
};
// Opens the card that explains why a robot stands there or why a candidate was not chosen; without
// a part, closes it.
struct Explain {
  std::optional<Pick> of;
};
struct ShowInLesson {
  std::uint32_t step;
};
struct LeaveScript {};  // continues without the lesson's words
// The drawing and a large caption, in full screen.
struct SetPresenting {
  bool on;
};
// Of the trace, or only the main ones; leaves the lesson.
struct ShowAllSteps {
  bool all;
};
struct Compare {
  std::optional<Method> method;
};
// By the number from 0; without one, all robots work again.
struct Fail {
  std::optional<std::size_t> robot;
};
struct SetLoadModel {
  LoadModel model;
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
// About a place on the screen, or about the middle of the area for the polygon.
struct ZoomView {
  double factor;
  std::optional<Vec2> about{};
};
struct SetPanelOpen {
  bool open;
};
// Of the settings.
struct SetSectionOpen {
  bool View::*section;
  bool open;
};
// A stroke of the brush that begins on a no-go part erases; any other marks.
struct SetErases {
  bool erases;
};
// The panels report an open list of choices.
struct ListIsOpen {
  bool open;
};
struct CloseList {};
struct SetSheet {
  Sheet sheet;
};
struct MeasureSheet {
  double closed_height;
};
struct MeasureNotice {
  double height;
};
struct CopyLink {};
// In the field of a control.
struct TypeValue {
  const char* control;
};
struct OpenDialog {
  Dialog dialog;
};
struct OpenPage {};     // of an <iframe>, in a new tab
struct LayOutAgain {};  // part of a panel moved, so another frame is needed
struct ShowNotice {
  Notice notice;
};
struct EndNotice {};  // unless it reports a problem

// Facts from the page around the view, or from the last visit. They are not steps of undo.
struct SetCanvas {
  double css_width, css_height, css_ratio;
};
struct SetPreferences {
  bool dark, reduced_motion, finger;
};
struct SetTouch {  // whether the pointer is a finger, and whether it rests and asks
  bool on, asking;
};
// What a window of the page covers of the canvas, in CSS pixels.
struct CoverScreen {
  double left, right, foot;
};
// For a card of the page at the foot of the drawing, in CSS pixels; 0 without one.
struct MakeRoom {
  double height;
};
// Behind the drawing, for tracing.
struct LayPicture {
  Vec2 low, high;
};
struct TakePictureAway {};
struct SetMeasuring {
  bool on;
};
struct KeepMotion {
  bool on;
};
struct KeepComparison {
  Method method;
};
struct ForgetSteps {};
struct AddStep {
  bool redo;
  History::Kept step;
};

using AnyCommand = std::variant<
    SetSettings, SetMethod, MoveVertex, MoveCentre, ReleaseCentre, InsertVertex, RemoveVertex,
    AddWeight, SetCargo, OpenDocument, SetPolygon, EndEdit, MoveRobot, PlaceYourself, CloseTask,
    SetChallenge, AddRobot, PutRobot, RemoveRobot, EvenOut, ResetRobots, Undo, Redo, SetShown,
    SetTool, GripPolygon, AddPoint, MovePoint, TakePointBack, PutPointBack, FinishDrawing,
    SetDrawCursor, TypeEdge, WithdrawEdge, SetSnap, Compare, Fail, SetLoadModel, SetMotion,
    OpenWalkthrough, CloseWalkthrough, GoToStep, MoveSteps, MoveChapters, SetPlaying, SetSpeed,
    SetPredict, Guess, PointAtChoice, AskWhy, Measure, HoverFigure, Explain, ShowInLesson,
    LeaveScript, ShowAllSteps, SetPresenting, SelectVertex, SetHover, SetHeld, SetCamera, FitView,
    ZoomView, SetPanelOpen, SetSectionOpen, SetErases, ListIsOpen, CloseList, SetSheet,
    MeasureSheet, MeasureNotice, CopyLink, TypeValue, OpenDialog, OpenPage, LayOutAgain, TakeRobots,
    TakeChoice, ShowNotice, EndNotice, SetCanvas, SetPreferences, SetTouch, CoverScreen, MakeRoom,
    LayPicture, TakePictureAway, SetMeasuring, KeepMotion, KeepComparison, ForgetSteps, AddStep>;
// Its special members are compiled once (command.cpp): written out in every file that makes a
// command, they were half of the time of compiling the panels.
class Command {
 public:
  template <class Kind>
  requires(!std::is_same_v<Kind, Command>) Command(Kind kind)
      : command_(std::in_place_type<Kind>, std::move(kind)) {}
  Command(const Command& other);
  Command(Command&& other) noexcept;
  Command& operator=(const Command& other);
  Command& operator=(Command&& other) noexcept;
  ~Command();

  AnyCommand& kind() { return command_; }

 private:
  AnyCommand command_;
};
using Commands = std::vector<Command>;

}  // namespace evenlift::view
