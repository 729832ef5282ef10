// Everything that the user, a worker or the page around the view can ask for. A command is data,
// and apply() (app/update.h) carries it out between two frames.
#pragma once

#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "state/derived.h"
#include "state/session.h"
#include "state/state.h"
#include "state/view_state.h"

namespace evenlift::view {

// Edits of the document. Each is one step of undo, but consecutive live edits form one step, until
// EndEdit. MoveVertex and MoveCentre are always live.
struct SetSettings {
  Settings settings;
  bool live = false;
};
struct SetMethod {
  Method method;
};
struct MoveVertex {
  std::size_t vertex;  // the number of a handle (handles.h): a vertex or a weight
  Vec2 to;
};
struct MoveCentre {
  std::optional<Vec2> to;  // nothing for the centroid
};
struct ReleaseCentre {};  // puts the centre of mass back to the centroid
// Inserts a vertex in an edge of the outline or of a hole, and selects it.
struct InsertVertex {
  std::size_t edge;
  Vec2 at;
};
// Removes a vertex, a weight, or a hole of three vertices.
struct RemoveVertex {
  std::size_t vertex;  // the number of a handle (handles.h)
};
struct AddWeight {  // adds a weight and selects it
  Vec2 at;
};
struct SetCargo {  // changes a weight to the typed values
  std::size_t item;
  Cargo cargo;
};
struct OpenDocument {
  Opened opened;  // moved out when the command is applied
};
struct SetPolygon {
  PolygonGrip shape;
  bool live = false;
};
struct EndEdit {};
struct Undo {};
struct Redo {};

// Moves a robot; always live. A balanced robot moves along the outline, and its neighbours follow.
// A robot of a team moves the team along its range. With the method `given`, the robot moves
// freely.
struct MoveRobot {
  std::size_t robot;  // the number from 0, team after team
  Vec2 to;
};
struct PlaceYourself {  // puts robots beneath the object, for the user to move
  std::size_t robots = 4;
};
struct CloseTask {};  // restores the document that was open before the task
struct SetChallenge {
  bool on;  // in a challenge, the page does not show its own answers
};
struct AddRobot {
  std::optional<Vec2> at;  // nothing: where the robot adds most to the lifting base
};
struct PutRobot {  // puts a robot exactly at a typed place
  std::size_t robot;
  Vec2 at;
};
struct RemoveRobot {
  std::optional<std::size_t> robot;  // the number from 0; nothing: the last robot
};
struct EvenOut {};    // moves two or three given supports so that all loads become equal
struct SetReadings {  // of all robots, which then give the weight and C
  Document document;
};
struct NameRobot {
  std::size_t robot;
  std::string name;
};
struct TakeOver {};     // makes what the readings told the object's, without readings
struct ResetRobots {};  // moves the robots back to where the method placed them

// Reports a result of the search with this number (Given::Found). If `robots` is missing, the
// search cannot continue.
struct TakeRobots {
  std::uint64_t number;
  std::optional<std::string> robots;
  bool ended = true;
  bool cut_short = false;
};

// Reports the worker's choice for the document with this number (Given::Chosen).
struct TakeChoice {
  std::uint64_t number;
  std::optional<std::vector<double>> choice;
};

// The commands below change neither the polygon nor its placement, unless they say so. SetShown is
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
struct GripPolygon {};  // notes the polygon as it is, for the SetPolygon commands that follow
struct AddPoint {
  Vec2 at;
};
struct TakePointBack {};
struct PutPointBack {};
// Opens the drawn polygon or cuts the drawn hole, or reports why that is impossible.
struct FinishDrawing {};
struct MovePoint {  // moves a placed point of the drawing
  std::size_t point;
  Vec2 to;
};
struct SetDrawCursor {
  std::optional<Vec2> at;
  std::optional<Vec2> pointer;  // the pointer in pixels, if it moved the cursor
  bool by_keys = false;
};
// Sets the next edge's typed length, and its angle in degrees; a missing value changes nothing.
// With `place`, this command also places the edge's end.
struct TypeEdge {
  std::optional<double> length, degrees;
  bool place = false;
};
struct WithdrawEdge {};  // forgets the typed length and angle
struct SetSnap {
  Snap snap;
};
struct OpenWalkthrough {};  // opens the walkthrough where the user left it
struct CloseWalkthrough {};
struct GoToStep {
  std::uint32_t step;
};
struct MoveSteps {
  int by;  // a number of steps, or of stops if a lesson is open
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
  std::optional<Vec2> at;  // nothing: withdraws the question
};
struct Measure {
  std::uint32_t candidate;
};
struct HoverFigure {
  std::optional<std::size_t> figure;
};
// Opens the card that explains why a robot stands where it does, or why a candidate was not chosen.
// Without a part, this command closes the card.
struct Explain {
  std::optional<Pick> of;
};
struct ShowInLesson {
  std::uint32_t step;
};
struct LeaveScript {};  // continues without the lesson's words
// Begins or ends presentation mode: the drawing and a large caption, in full screen.
struct SetPresenting {
  bool on;
};
// If `all`, shows all steps of the trace, and sets an open lesson aside. Otherwise shows only the
// stops of that lesson again or, without a lesson, the main steps.
struct ShowAllSteps {
  bool all;
};
struct Compare {
  std::optional<Method> method;
};
// Lets a robot fail, or lets all robots work again.
struct Fail {
  std::optional<std::size_t> robot;  // the number from 0; nothing: all work
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
// Zooms about a place on the screen, or about the middle of the area into which FitView fits the
// polygon.
struct ZoomView {
  double factor;
  std::optional<Vec2> about{};
};
struct SetPanelOpen {
  bool open;
};
// Opens or closes a section of the panel.
struct SetSectionOpen {
  bool View::*section;
  bool open;
};
// Explains this mark, or none.
struct ExplainMark {
  std::optional<PictureMark> mark{};
};
// No field is asked for any more (TypeValue).
struct ForgetField {};
struct SetDrawerOpen {
  Drawer drawer;
  bool open;
};
// Sets whether the brush erases no-go parts, or adds them. A stroke that begins on a no-go part
// erases.
struct SetErases {
  bool erases;
};
// Reports whether a list of choices is open in the panels.
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
// Moves the keyboard focus to a control's field, so that the user can type a value.
struct TypeValue {
  const char* control;
};
struct OpenDialog {
  Dialog dialog;
};
struct OpenPage {};     // opens the page of an <iframe> in a new tab
struct LayOutAgain {};  // asks for another frame, since something still moves
struct ShowNotice {
  Notice notice;
};
struct EndNotice {};  // ends the notice, unless it reports a problem

// Facts from the page around the view, or from the last visit. They are not steps of undo.
struct SetCanvas {
  double css_width, css_height, css_ratio;
};
struct SetPreferences {
  bool dark, reduced_motion, finger;
};
// `on`: the pointer is a finger; `asking`: the finger rests in order to ask about the part under
// it.
struct SetTouch {
  bool on, asking;
};
// Reports how much of the canvas a window of the page covers at each side, in CSS pixels.
struct CoverScreen {
  double left, right, foot;
};
// Makes room for a card of the page at the foot of the drawing.
struct MakeRoom {
  double height;  // of the card, in CSS pixels; 0 without a card
};
// Lays a picture behind the drawing, for tracing.
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
    SetChallenge, AddRobot, PutRobot, RemoveRobot, EvenOut, SetReadings, NameRobot, TakeOver,
    ResetRobots, Undo, Redo, SetShown, SetTool, GripPolygon, AddPoint, MovePoint, TakePointBack,
    PutPointBack, FinishDrawing, SetDrawCursor, TypeEdge, WithdrawEdge, SetSnap, Compare, Fail,
    SetLoadModel, SetMotion, OpenWalkthrough, CloseWalkthrough, GoToStep, MoveSteps, MoveChapters,
    SetPlaying, SetSpeed, SetPredict, Guess, PointAtChoice, AskWhy, Measure, HoverFigure, Explain,
    ShowInLesson, LeaveScript, ShowAllSteps, SetPresenting, SelectVertex, SetHover, SetHeld,
    SetCamera, FitView, ZoomView, SetPanelOpen, SetSectionOpen, ExplainMark, ForgetField,
    SetDrawerOpen, SetErases, ListIsOpen, CloseList, SetSheet, MeasureSheet, MeasureNotice,
    CopyLink, TypeValue, OpenDialog, OpenPage, LayOutAgain, TakeRobots, TakeChoice, ShowNotice,
    EndNotice, SetCanvas, SetPreferences, SetTouch, CoverScreen, MakeRoom, LayPicture,
    TakePictureAway, SetMeasuring, KeepMotion, KeepComparison, ForgetSteps, AddStep>;
// One command, which its copies share. What would copy or destroy any of the kinds is compiled only
// once, in command.cpp: compiled in every file that makes a command, it took half of the panels'
// compile time.
class Command {
 public:
  template <class Kind>
  requires(!std::is_same_v<Kind, Command>) Command(Kind kind)
      : command_(owned(new AnyCommand(std::in_place_type<Kind>, std::move(kind)))) {}

  AnyCommand& kind() { return *command_; }

 private:
  static std::shared_ptr<AnyCommand> owned(AnyCommand* command);

  std::shared_ptr<AnyCommand> command_;
};
using Commands = std::vector<Command>;

}  // namespace evenlift::view
