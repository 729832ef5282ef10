// Everything that the user, a key or another page can ask for. A command is data; update.h applies
// it between two frames.
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

// Edits of the document. Each is one step of undo; consecutive live edits form one step, until
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
struct ReleaseCentre {};  // the centre of mass is the centroid again
// Inserts a vertex on an edge of the outline or of a hole, and selects it.
struct InsertVertex {
  std::size_t edge;
  Vec2 at;
};
struct RemoveVertex {  // the last three of a hole go with the hole
  std::size_t vertex;  // or a weight: the number of a handle
};
struct AddWeight {  // on the object, and selects it
  Vec2 at;
};
struct SetCargo {  // one weight, as typed
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

// Moves a balanced robot along the outline, and its neighbours follow; or moves a team, with the
// robot, along its range; or moves the robot freely, with the method `given`. Always live.
struct MoveRobot {
  std::size_t robot;  // counted team after team
  Vec2 to;
};
struct PlaceYourself {  // robots beneath the object, to play with
  std::size_t robots = 4;
};
struct CloseTask {};   // brings back what was open before it
struct SetChallenge {  // whether the page keeps its own answers to itself
  bool on;
};
struct AddRobot {  // at a place, or where it adds most to the lifting base
  std::optional<Vec2> at;
};
struct PutRobot {  // exactly at a place, as typed
  std::size_t robot;
  Vec2 at;
};
struct RemoveRobot {  // by its number from 0, or the last
  std::optional<std::size_t> robot;
};
struct EvenOut {};      // moves two or three given robots so that all carry the same load
struct ResetRobots {};  // back to where the method placed them

// The result of the search with this number (Given::Found). Without `robots`, the search cannot
// continue.
struct TakeRobots {
  std::uint64_t number;
  std::optional<std::string> robots;
  bool ended = true;
};

// What the worker chose for the document with this number (Given::Chosen).
struct TakeChoice {
  std::uint64_t number;
  std::optional<std::vector<double>> choice;
};

// The other commands change neither the polygon nor its placement. SetShown changes what is shown:
// one step of undo, unless only overlays differ.
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
struct GripPolygon {};  // remembers the present polygon for SetPolygon
struct AddPoint {
  Vec2 at;
};
struct TakePointBack {};
struct PutPointBack {};
struct FinishDrawing {};  // opens the drawn polygon, or reports its error
struct MovePoint {        // a placed point
  std::size_t point;
  Vec2 to;
};
struct SetDrawCursor {
  std::optional<Vec2> at;
  std::optional<Vec2> pointer;  // in pixels, if the pointer moved it
  bool by_keys = false;
};
// The typed length of the next edge and its typed angle in degrees; a missing value stays. On
// request, also places the edge's end.
struct TypeEdge {
  std::optional<double> length, degrees;
  bool place = false;
};
struct WithdrawEdge {};  // forgets the typed length and angle
struct SetSnap {
  Snap snap;
};
struct OpenWalkthrough {};  // at the step where the user left it
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
// Opens the card that explains why a robot stands where it does or why a candidate was not chosen;
// without a part, closes it.
struct Explain {
  std::optional<Pick> of;
};
struct ShowInLesson {
  std::uint32_t step;
};
struct LeaveScript {};  // continues the walkthrough without the lesson's words
// Presentation mode: the drawing and a large caption, in full screen.
struct SetPresenting {
  bool on;
};
// Shows all steps of the trace, or only the main ones, and leaves the lesson.
struct ShowAllSteps {
  bool all;
};
struct Compare {
  std::optional<Method> method;
};
// Lets a robot fail, by its number from 0; without a number, all robots work again.
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
// Zooms about a place on the screen; without one, about the middle of the area for the polygon.
struct ZoomView {
  double factor;
  std::optional<Vec2> about{};
};
struct SetPanelOpen {
  bool open;
};
// Opens or closes a section of the settings.
struct SetSectionOpen {
  bool View::*section;
  bool open;
};
// A stroke of the brush that begins on a no-go part erases; any other marks.
struct SetErases {
  bool erases;
};
// The panels report whether a list of choices is open.
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
// Begins typing in the field of a control.
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

// Facts from the page around the view, or kept from the last visit. These commands are not steps of
// undo.
struct SetCanvas {
  double css_width, css_height, css_ratio;
};
struct SetPreferences {
  bool dark, reduced_motion, finger;
};
struct SetTouch {  // whether the pointer is a finger now, and whether it rests and asks
  bool on, asking;
};
// A window of the page covers this much of the canvas at the left, at the right and at the foot, in
// CSS pixels.
struct CoverScreen {
  double left, right, foot;
};
// A card of the page is at the foot of the drawing. Its height is in CSS pixels; 0 means no card.
struct MakeRoom {
  double height;
};
// Puts a picture behind the drawing, for tracing.
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
// One command of any kind. Its special members are compiled once (command.cpp): written out in every
// file that makes a command, they were half of the time of compiling the panels.
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
