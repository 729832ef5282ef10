#include "panels/summary.h"

#include <algorithm>
#include <utility>

#include "evenlift/output/carrying_words.h"
#include "evenlift/output/robustness_words.h"
#include "evenlift/output/verdict.h"
#include "evenlift/output/weighing_words.h"
#include "evenlift/output/words.h"
#include "evenlift/wording.h"
#include "tools/drawing.h"
#include "walkthrough/walkthrough.h"

namespace evenlift::view {

bool is_overloaded(const AppState& state) { return !state.derived().report.overloaded.empty(); }

bool is_overloaded(const AppState& state, std::size_t robot) {
  return shown_report(state).is_overloaded(robot);
}

namespace {

// The placement with all its robots.
Reported whole(const AppState& state) {
  return {{*state.derived().placement, shown(state)}, state.derived().report};
}

Mood mood_of(const Judgement& judgement, const Placement& placement) {
  if (judgement.kind == VerdictKind::good) return Mood::good;
  const bool bad = judgement.kind == VerdictKind::bad && !placement.teams.empty();
  return bad ? Mood::falls : Mood::not_quite;
}

Verdict of_placement(const AppState& state, Words words) {
  const Placement& placement = *state.derived().placement;
  const Reported now = whole(state);
  const bool brief = words == Words::in_panel && placement.settings.cargo.empty();
  const std::string loads = loads_in_words(now, brief ? TellWeight::no : TellWeight::yes),
                    news = worst_news_in_words(now), if_uneven = if_uneven_in_words(now);
  std::vector<std::string> detail;
  const auto add = [&](const std::string& sentence) {
    if (!sentence.empty()) detail.push_back(sentence);
  };
  if (!news.empty()) add(loads);
  for (const std::string& left_out : left_out_in_words(placement)) add(left_out);
  if (words == Words::of_program) add(if_uneven);
  add(detail_in_words(now));
  if (words == Words::in_panel) add(if_uneven);
  for (const std::string& misfit : misfits_in_words(now)) add(misfit);
  add(cut_short_in_words(placement));
  if (!placement.teams.empty() && !placement.goal_reached)
    add(say("So the goal to hold is not reached."));
  std::string text;
  for (const std::string& sentence : detail) text += (text.empty() ? "" : " ") + sentence;
  return {mood_of(judge(now), placement), news.empty() ? loads : news, std::move(text)};
}

Verdict of_failure(const AppState& state, const Failure& failure) {
  const Reported rest({failure.placement, shown(state)}, failure.report);
  const bool tips = failure.rest && !failure.rest->stays;
  return {mood_of(state, failure.rest), failure_words(state, failure.robot),
          tips ? closure_in_words(rest) : rest_in_words(rest)};
}

bool presses_by_finger(const AppState& state) {
  return state.session.screen.touch || state.session.screen.finger;
}

Verdict of_measuring(const AppState& state) {
  return {Mood::drawing, say("Two points set the scale."),
          say(presses_by_finger(state)
                  ? "Tap two points of the picture, then type the distance between them."
                  : "Click two points of the picture, then type the distance between them.")};
}

struct DrawingWords {
  const char *begin, *few, *tap, *click, *by_keys, *refused, *closes;
};

const DrawingWords& drawing_words(const AppState& state) {
  static constexpr DrawingWords shape{"Draw a shape.",
                                      "A shape needs at least three.",
                                      "Tap the first vertex to close the shape.",
                                      "Click the first vertex to close the shape.",
                                      "Enter on the first vertex closes the shape.",
                                      "The shape cannot be closed: {reason}.",
                                      "On the first vertex: Enter closes the shape."},
      hole{"Draw a hole.",
           "A hole needs at least three.",
           "Tap the first vertex to close the hole.",
           "Click the first vertex to close the hole.",
           "Enter on the first vertex closes the hole.",
           "The hole cannot be closed: {reason}.",
           "On the first vertex: Enter closes the hole."};
  return state.view.tool == Tool::hole ? hole : shape;
}

Verdict of_drawing(const AppState& state) {
  const std::size_t n = state.view.drawing.points.size();
  const bool finger = presses_by_finger(state);
  const DrawingWords& words = drawing_words(state);
  if (n == 0)
    return {Mood::drawing, say(words.begin),
            say(finger ? "Tap to place its first vertex."
                       : "Click to place its first vertex, or use the arrow keys and Enter.")};
  const auto crossed = crossings(state.view.drawing.points);
  return {Mood::drawing, say("{vertices} so far.", {count_of(n, "vertex", "vertices")}),
          !crossed.empty()
              ? say("Edges {edge} and {other} cross. Move a vertex, or remove the last one.",
                    {crossed.front().first + 1, crossed.front().second + 1})
          : n < 3 ? say(words.few)
          : state.view.drawing.refusal
              ? say("It cannot be closed yet: {reason}. Move a vertex, or remove the last one.",
                    {sentence(*state.view.drawing.refusal)})
              : say(state.view.drawing.by_keys ? words.by_keys
                    : finger                   ? words.tap
                                               : words.click)};
}

std::string robots_in_words(const Placement& placement) {
  const bool given = placement.settings.method == Method::given,
             holds = goal_of(placement.settings) == Goal::hold;
  const std::string robots = count_of(count_robots(placement.teams), "robot", "robots");
  std::string text = " ";
  text += given ? say("{robots}, placed by hand.", {robots})
                : say(holds ? "{robots} of {requested} requested, method balanced, goal hold."
                            : "{robots} of {requested} requested, method balanced, goal cover.",
                      {robots, placement.settings.robots});
  if (placement.teams.empty()) return text;
  const TeamInWords team = team_in_words(placement, 0, place_decimals(placement));
  for (std::size_t i = 0; i < team.at.size(); ++i)
    text += " " + say("Robot {robot} at {place}.", {placement.called(i), team.at[i]});
  return text;
}

// Empty for many robots: the list would be too long to listen to.
std::string loads_while_failing(const Failure& failure, const Units& units) {
  constexpr std::size_t most = 24;
  const std::vector<LoadRange>& loads = failure.report.loads;
  std::string text;
  if (!failure.rest || !failure.rest->stays || loads.size() > most) return text;
  for (std::size_t i = 0; i < loads.size(); ++i) {
    if (i == failure.robot) continue;
    text +=
        " " + say("Robot {robot} carries {load}.",
                  {failure.placement.number_of(i),
                   load_in_words(failure.report.model, loads[i], failure.report.greatest, units)});
  }
  return text;
}

// The last vertex, and the cursor if keys move it.
std::string news_of_drawing(const AppState& state) {
  const Drawing& drawing = state.view.drawing;
  const DrawingWords& words = drawing_words(state);
  std::string lines;
  if (!drawing.points.empty())
    lines += say("Vertex {vertex} at {place}.",
                 {drawing.points.size(), given_point(drawing.points.back())}) +
             '\n';
  if (!drawing.by_keys || !drawing.cursor)
    return drawing.points.empty()
               ? say("By keys: arrow keys move a cursor, and Enter places a vertex there.") + '\n'
               : lines;
  if (closes(state, state.view.camera.to_screen(*drawing.cursor)))
    return lines +
           (drawing.refusal ? say(words.refused, {sentence(*drawing.refusal)})
                            : say(words.closes)) +
           '\n';
  const std::string cursor = given_point(*drawing.cursor);
  lines += drawing.points.empty()
               ? say("Cursor at {place}.", {cursor})
               : say("Cursor at {place}, the edge {edge}.",
                     {cursor, edge_in_words(state, drawing.points.back(), *drawing.cursor)});
  return lines + '\n';
}

}  // namespace

ScoreInWords score_of(const Reported& reported) {
  const Placement& placement = reported.placement;
  const Units& units = reported.shown.units;
  const auto load = [&](double value) { return load_in_words(value, placement.loads->max, units); };
  return {std::to_string(count_robots(placement.teams)),
          placement.loads ? load(placement.loads->max) : std::string(),
          placement.loads ? load(placement.loads->spread) : std::string(),
          percentage(placement.coverage), reported.report.held ? "held" : "not held"};
}

std::string score(const AppState& state) {
  const Placement& placement = *state.derived().placement;
  const ScoreInWords of = score_of(whole(state));
  const std::string robots = count_of(count_robots(placement.teams), "robot", "robots");
  if (of.most.empty())
    return say("{robots} · it falls · {coverage} covered · {held}", {robots, of.covered, of.held});
  return say("{robots} · at most {load} · spread {spread} · {coverage} covered · {held}",
             {robots, of.most, of.spread, of.covered, of.held});
}

std::string need_in_words(const AppState& state, bool with_overloaded) {
  if (!state.derived().placement || !shown_report(state).has_capacities) return {};
  const Failure* failure = failing(state);
  // What tips carries nothing.
  const bool only_needs = !with_overloaded || (failure && failure->rest && !failure->rest->stays);
  return only_needs ? needs_in_words(reported(state)) : capacity_in_words(reported(state));
}

std::string model_words(const AppState& state) {
  return state.derived().placement ? model_in_words(whole(state)) : std::string();
}

std::string uncertainty_words(const AppState& state) {
  return state.derived().placement ? uncertainty_in_words(whole(state)) : std::string();
}

std::string carrying_words(const AppState& state) {
  const Derived& facts = state.derived();
  if (!facts.placement || facts.refusal || !facts.placement->loads) return {};
  std::string text;
  for (const std::string& sentence : {given_in_part_in_words(whole(state)),
                                      tilt_in_words(whole(state)), extra_in_words(whole(state))})
    if (!sentence.empty()) text += (text.empty() ? "" : " ") + sentence;
  return text;
}

std::string weighing_words(const AppState& state) {
  const Derived& facts = state.derived();
  return facts.placement && !facts.refusal ? weighing_in_words(whole(state)) : std::string();
}

Mood mood_of(const AppState& state, const std::optional<RestOfRobots>& rest) {
  if (!rest || !rest->stays) return Mood::falls;
  return rest->clear && !overloads(whole(state), rest) ? Mood::good : Mood::not_quite;
}

std::string failure_words(const AppState& state, std::size_t robot) {
  const Derived& facts = state.derived();
  const bool fails = facts.failure && facts.failure->robot == robot;
  if (!fails && robot >= facts.report.failures.size()) return {};
  return failure_in_words(whole(state), robot,
                          fails ? facts.failure->rest : facts.report.failures[robot]);
}

Verdict verdict(const AppState& state, Words words) {
  if (state.view.measuring) return of_measuring(state);
  if (draws(state.view.tool)) return of_drawing(state);
  if (state.derived().refusal) {
    return {Mood::refused, sentence(*state.derived().refusal) + ".",
            state.derived().placement ? say("The last result is shown dimmed.") : ""};
  }
  if (!state.derived().placement) return {Mood::refused, say("Nothing is open."), ""};
  if (const Failure* failure = failing(state)) return of_failure(state, *failure);
  Verdict v = of_placement(state, words);
  // In a task, what it asks for decides.
  if (state.derived().attempt && state.derived().attempt->kept) v.mood = Mood::good;
  v.searching = state.derived().search.under_way && !state.derived().placement->search_ended;
  const bool waits = state.work.edit_open && !state.derived().placement->search_ended &&
                     settings(state).method == Method::balanced;
  if (waits && !v.searching)
    v.detail += " " + say("The search for better places begins when you let go.");
  if (v.searching)
    v.detail += state.derived().placement->teams.empty()
                    ? say("The search is under way.")
                    : " " + say("The search for better places continues.");
  return v;
}

std::string presumed_in_words(const AppState& state) {
  const bool shown = state.derived().placement && !state.derived().refusal &&
                     !state.view.measuring && !draws(state.view.tool) &&
                     !state.derived().placement->teams.empty();
  if (!shown) return {};
  if (failing(state))
    return "Loads are those of equally stiff and level robots, at rest; at a sudden failure they "
           "swing beyond this";
  if (state.derived().placement->settings.method == Method::given)
    return "Loads are those of equally stiff robots on even ground; stability assumes robots that "
           "push back (stiff, or at a fixed height) and no overload";
  return "Loads assume controlled forces; stability assumes robots that push back (stiff, or at a "
         "fixed height) and no overload";
}

std::string summary(const AppState& state) {
  const Verdict v = verdict(state);
  if (walkthrough_is_open(state) && !state.derived().refusal) return walkthrough_in_words(state);
  std::string text = v.headline;
  if (!v.detail.empty()) text += " " + v.detail;
  // Robots of the former shape would be mistaken for those of the new one.
  if (state.derived().refusal || !state.derived().placement || draws(state.view.tool)) return text;
  if (const Failure* failure = failing(state))
    return text + loads_while_failing(*failure, shown(state).units);
  for (const std::string& more : {need_in_words(state, !is_overloaded(state)), model_words(state),
                                  uncertainty_words(state), carrying_words(state)})
    if (!more.empty()) text += " " + more;
  const Placement& placement = *state.derived().placement;
  const Settings& settings = placement.settings;
  if (is_one_team(settings.method)) return text + robots_in_words(placement);
  text +=
      " " + say("{teams} of {requested} requested, method {method}, minimum load ratio {ratio}.",
                {count_of(placement.teams.size(), "team", "teams"), placement.requested_teams,
                 method_in_words(settings.method), plain(settings.min_ratio)});
  // A hundred teams would be too long to listen to; the JSON has all.
  const std::size_t named = std::min<std::size_t>(placement.teams.size(), 12);
  const int decimals = place_decimals(placement);
  for (std::size_t i = 0; i < named; ++i) {
    const TeamInWords team = team_in_words(placement, i, decimals);
    text +=
        " " + say("Team {team} at {place} and {other_place}: {load} and {other_load}, load ratio "
                  "{ratio}.",
                  {i + 1, team.at[0], team.at[1], team.loads[0],
                   with_weight_unit(team.loads[1], shown(state).units), team.ratio});
  }
  return text;
}

std::string weight_unit(const AppState& state) {
  return std::string(name(shown(state).units.weight));
}

std::string link_lacks_in_words(const AppState& state) {
  if (draws(state.view.tool) && !state.view.drawing.points.empty())
    return say(
        "The shape that you are drawing is not closed yet: the link holds the previous one.");
  if (state.derived().refusal)
    return say("The shape on the screen is refused: the link holds the last valid one.");
  std::string lacking;
  for (const auto& [lacks, what] :
       {std::pair(state.view.load_model != LoadModel::plan, "the choice of loads"),
        {failing(state) != nullptr, "the failed robot"},
        {state.work.second_method.has_value(), "the comparison"}})
    if (lacks)
      lacking = lacking.empty() ? say("It does not hold {part}", {what})
                                : say("{sentence}, nor {part}", {lacking, what});
  return lacking.empty() ? lacking : lacking + ".";
}

std::string news(const AppState& state) {
  std::string lines;
  const Points& vertices = state.work.document().vertices;
  if (state.view.selected && *state.view.selected < vertices.size())
    lines += say("Vertex {vertex} of {vertices}, {place}.",
                 {*state.view.selected + 1, vertices.size(),
                  point_in_words(vertices[*state.view.selected], coordinate_decimals(vertices))}) +
             '\n';
  if (state.view.tool == Tool::transform)
    lines += std::string(translated("The whole shape is selected: arrow keys move it, [ and ] turn "
                                    "it, { and } scale it.")) +
             '\n';
  if (draws(state.view.tool)) lines += news_of_drawing(state);
  // Elsewhere a notice reports it.
  const bool bar = state.view.tool != Tool::parts || state.view.selected;
  if (bar && state.view.snap.grid) lines += say("Points snap to the grid.") + '\n';
  if (bar && state.view.snap.axis) lines += say("Points snap to the axis.") + '\n';
  for (const auto& [overlay, name] : {std::pair(&Overlays::lifting_base, "the lifting base"),
                                      {&Overlays::chords, "chords"},
                                      {&Overlays::candidates, "candidates"},
                                      {&Overlays::clockwise, "free clockwise turns"},
                                      {&Overlays::counterclockwise, "free counter-clockwise turns"},
                                      {&Overlays::tipping, "the force that tips"},
                                      {&Overlays::halo, "the tipping distance"},
                                      {&Overlays::tilt, "the slopes at which it tips"},
                                      {&Overlays::load, "where a further load may stand"}})
    lines +=
        say(shown(state).overlays.*overlay ? "Shown: {overlay}." : "Hidden: {overlay}.", {name}) +
        '\n';
  if (!state.work.second_method) return lines;
  const std::string method = method_in_words(*state.work.second_method);
  if (!state.derived().second) return lines + say("Compared with {method}.", {method}) + '\n';
  const Reported second = reported(state, true);
  return lines + say("Compared with {method}: {result}", {method, loads_in_words(second)}) + " " +
         detail_in_words(second) + '\n';
}

}  // namespace evenlift::view
