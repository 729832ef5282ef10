// The step in words, numbers and code, and the questions from and to the learner.
#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "actions/actions.h"
#include "evenlift/output/words.h"
#include "evenlift/wording.h"
#include "panels/panels.h"
#include "walkthrough/walkthrough.h"
#include "widgets/buttons.h"
#include "widgets/fields.h"
#include "widgets/text.h"

namespace evenlift::view {
namespace {

constexpr std::size_t most_shown = 12;  // of the preceding steps
constexpr float code_height = 210;
constexpr std::size_t most_ranked = 10;  // candidates

float full_width() { return ImGui::GetContentRegionAvail().x; }

void space(float height) { ImGui::Dummy(ImVec2(0, height)); }

void draw_box(Colour ground, Colour colour, Face face, const std::string& text) {
  const float pad = 10, width = full_width();
  const std::vector<std::string_view> lines = broken_lines(face, text, width - 2 * pad);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 high(at.x + width, at.y + height_of(face, lines) + 2 * pad);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, high, ground.packed(), 8);
  draw_lines(list, face, ImVec2(at.x + pad, at.y + pad), colour, lines);
  ImGui::Dummy(ImVec2(width, high.y - at.y));
}

struct Faces {
  Face words, second, strong, formula, label;
};
constexpr Faces in_panel{Face::text, Face::text, Face::strong, Face::text, Face::label};
constexpr Faces in_a_row{Face::text, Face::label, Face::strong, Face::label, Face::label};
constexpr Faces in_little_room{Face::text, Face::label, Face::strong_label, Face::label,
                               Face::label};
constexpr Faces for_a_room{Face::large, Face::text, Face::verdict, Face::text, Face::label};

struct ChoiceName {
  std::string id, words;
};

ChoiceName choice_name(const Ask& ask, std::uint32_t choice) {
  const auto numbered = [&](const char* id, const char* pattern) {
    return ChoiceName{id + std::to_string(choice + 1), say(pattern, {choice + 1})};
  };
  switch (ask.question.kind) {
    case QuestionKind::winning_chord:
    case QuestionKind::coming_candidate:
      return numbered("Candidate ", "Candidate {candidate}");
    case QuestionKind::even_chord:
      return numbered("Chord ", "Chord {chord}");
    case QuestionKind::leaving_team:
      return numbered("Team ", "Team {team}");
    case QuestionKind::nearer_end:
      break;
  }
  const char* end = choice == 0 ? "The first end" : "The second end";
  return {end, say(end)};
}

// Side by side if height is scarce.
void draw_choices(const Ui& ui, const Ask& ask, bool beside) {
  const float width = full_width(), gap = 6;
  if (ask.choices.size() <= 3) {
    const auto n = static_cast<float>(ask.choices.size());
    for (std::size_t i = 0; i < ask.choices.size(); ++i) {
      if (beside && i > 0) ImGui::SameLine(0, gap);
      const auto [id, words] = choice_name(ask, ask.choices[i]);
      if (flat_button(ui, id.c_str(), words.c_str(), beside ? (width - (n - 1) * gap) / n : width))
        ui.push(Guess{ask.choices[i]});
    }
    return;
  }
  const auto n = static_cast<int>(ask.choices.size());
  const auto pointed = static_cast<int>(ask.pointed);
  const float taking = beside ? text_size(Face::text, "This one").x + 32 : width;
  const int by =
      stepper(ui, "choice", choice_name(ask, ask.choices[ask.pointed]).words,
              beside ? std::min(width - taking - gap, 320.0f) : width, {.label = "Choice"});
  if (by != 0) ui.push(PointAtChoice{static_cast<std::size_t>((pointed + by + n) % n)});
  if (beside) ImGui::SameLine(0, gap);
  if (flat_button(ui, "take", "This one", taking, true, true))
    ui.push(Guess{ask.choices[ask.pointed]});
}

void draw_question(const Ui& ui, const Faces& faces) {
  const Walkthrough& walk = ui.state.view.walkthrough;
  if (!walk.ask) return;
  space(4);
  text_block(faces.strong, ui.theme.accent, walk.ask->text);
  text_block(faces.label, ui.theme.second_text,
             "Press it in the drawing, or choose here. Next shows the answer.");
  draw_choices(ui, *walk.ask, false);
}

void draw_answers(const Ui& ui, const Faces& faces) {
  const Walkthrough& walk = ui.state.view.walkthrough;
  if (!walk.verdict.empty()) {
    const Colour colour = walk.was_right ? ui.theme.hull_text : ui.theme.amber;
    draw_box(ui.theme.well, colour, faces.strong, walk.verdict);
  }
  if (!walk.why.empty()) {
    const bool robot = walk.trace->balanced();
    text_line(Face::strong_label, ui.theme.second_text,
              walk.why_taken ? (robot ? "Why does a robot stand here?" : "Why this one?")
              : robot        ? "Why does no robot stand here?"
                             : "Why not this one?");
    draw_box(ui.theme.well, ui.theme.text, faces.words, walk.why);
  }
}

void draw_words(const Ui& ui, const Faces& faces) {
  const Walkthrough& walk = ui.state.view.walkthrough;
  const std::string words = words_of_stop(ui.state);
  if (!words.empty()) {
    const AsTyped typed;
    text_block(faces.words, ui.theme.text, words);
  }
  // Before an audience, a step without its formula shows only the lesson's words.
  const bool once = ui.state.view.presenting && !words.empty() && !ui.state.view.formal_open;
  if (!walk.caption.empty() && !once)
    text_block(walk.script ? faces.second : faces.words,
               walk.script ? ui.theme.second_text : ui.theme.text, walk.caption);
}

void draw_formula(const Ui& ui, const Faces& faces) {
  const Walkthrough& walk = ui.state.view.walkthrough;
  if (walk.formula.empty() || !ui.state.view.formal_open) return;
  draw_box(ui.theme.well, ui.theme.text, faces.formula, walk.formula);
  if (const std::string_view letters = formula_letters(*walk.trace, walk.detail); !letters.empty())
    text_block(faces.label, ui.theme.second_text, std::string(letters));
}

// A step explains itself in words. The formula and the algorithm are shown on request: with them, a
// first step would look like a lecture.
void draw_formal_button(const Ui& ui, const char* show, const char* hide) {
  const bool open = ui.state.view.formal_open;
  if (flat_button(ui, "formula", open ? hide : show, full_width()))
    ui.push(SetSectionOpen{&View::formal_open, !open});
}

void draw_left_out(const Ui& ui, const Faces& faces) {
  if (const std::string more = left_out_in_words(ui.state); !more.empty())
    text_block(faces.label, ui.theme.second_text, more);
}

}  // namespace

void draw_walkthrough_step(const Ui& ui) {
  const Walkthrough& walk = ui.state.view.walkthrough;
  const float button = ui.layout.wide ? ui.control() : 0;  // in the corner
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 8));
  if (walk.script) {
    const AsTyped typed;
    text_block(Face::strong_label, ui.theme.accent, walk.script->lesson.title, button);
  }
  text_block(Face::verdict, ui.theme.text, std::string(title(walk.detail.step.chapter)),
             walk.script ? 0 : button);
  text_line(Face::label, ui.theme.second_text, say("Step {place}", {place_in_words(ui.state)}));
  draw_words(ui, in_panel);
  if (!asks_of_other_robots(ui.state)) draw_formula(ui, in_panel);  // its robots are not drawn
  draw_left_out(ui, in_panel);
  draw_answers(ui, in_panel);
  draw_question(ui, in_panel);
  draw_formal_button(ui, "Show formula and algorithm", "Hide formula and algorithm");
  ImGui::PopStyleVar();
}

// For a closed sheet, an <iframe> or presentation mode: a box of constant height, in which longer
// text scrolls. A question replaces the words; its buttons are below the box unless that would
// leave less than two lines.
void draw_walkthrough_briefly(const Ui& ui, float height) {
  const Walkthrough& walk = ui.state.view.walkthrough;
  constexpr float little = 120;
  const Faces& faces = ui.state.view.presenting ? for_a_room
                       : height < little        ? in_little_room
                                                : in_a_row;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 4));
  const float row = ui.control() + 4, two_lines = 40;
  const bool apart = walk.ask && height - row >= two_lines;
  begin_scrolling_box(ui, "told", apart ? height - row : height);
  const int moment = static_cast<int>(2 * walk.at + (walk.ask ? 1 : 0));
  if (in_last_frame("moment", moment, -1) != moment) ImGui::SetScrollY(0);
  const std::string name =
      walk.script ? walk.script->lesson.title : std::string(title(walk.detail.step.chapter));
  text_block(Face::strong_label, ui.theme.second_text,
             say("{chapter} · step {place}", {name, place_in_words(ui.state)}));
  if (walk.ask) {
    text_block(faces.strong, ui.theme.accent, walk.ask->text);
    if (!apart) draw_choices(ui, *walk.ask, true);
  } else {
    draw_answers(ui, faces);
    draw_words(ui, faces);
    draw_formula(ui, faces);
    draw_left_out(ui, faces);
    if (!walk.formula.empty()) draw_formal_button(ui, "Show the formula", "Hide the formula");
  }
  end_scrolling_box(ui);
  if (apart) draw_choices(ui, *walk.ask, true);
  ImGui::PopStyleVar();
}

namespace {

// A bar between two points, of which the left part `share` (0 .. 1) is filled.
void draw_score_bar(const Ui& ui, ImVec2 from, ImVec2 to, double share, Colour colour) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float width = (to.x - from.x) * static_cast<float>(std::clamp(share, 0.0, 1.0));
  list.AddRectFilled(ImVec2(from.x, from.y - 3), ImVec2(to.x, to.y + 3), ui.theme.well.packed(), 3);
  list.AddRectFilled(ImVec2(from.x, from.y - 3), ImVec2(from.x + width, to.y + 3), colour.packed(),
                     3);
}

// While a candidate in the ranking is hovered, the drawing shows its measurement.
void draw_ranked(const Ui& ui, const TeamScores& scores, std::size_t place, double best) {
  const std::uint32_t c = scores.ranking[place];
  const Score& score = scores.of_candidate[c];
  const std::optional<std::uint32_t>& measured = ui.state.view.walkthrough.measured;
  const bool first = place == 0;
  const float width = full_width(), height = ui.control() > 40 ? 36.0f : 24.0f;
  ImGui::PushID(static_cast<int>(c));
  const std::string id = std::to_string(place + 1) + ".  Candidate " + std::to_string(c + 1);
  const std::string name = say("{place}.  Candidate {candidate}", {place + 1, c + 1});
  const auto [at, high, pressed, hovered] = pressable_row(ui, id.c_str(), name, width, height);
  if (pressed || (hovered && measured != c)) ui.push(Measure{c});
  ImGui::PopID();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (measured == c) list.AddRectFilled(at, high, ui.theme.well.packed(), 6);
  const std::string value = (score.exact ? "" : "≤ ") + amount(score.value, best);
  const float middle = (at.y + high.y) / 2, top = middle - text_size(Face::label, name).y / 2;
  const float from = at.x + width * 0.46f;
  draw_score_bar(ui, ImVec2(from, middle), ImVec2(from + width * 0.26f, middle), score.value / best,
                 first ? ui.theme.hull_outline : ui.theme.quiet);
  draw_text(list, first ? Face::strong_label : Face::label, ImVec2(at.x + 6, top), ui.theme.text,
            name);
  draw_text(list, Face::label, ImVec2(high.x - 6 - text_size(Face::label, value).x, top),
            first ? ui.theme.text : ui.theme.second_text, value);
}

const char* title_of_ranking(Rule rule) {
  return rule == Rule::score          ? "Candidates by score"
         : rule == Rule::longest_even ? "Even candidates by length"
         : rule == Rule::longest      ? "Candidates by length"
                                      : "Candidates by load ratio";
}

// `line` begins with two spaces for each level.
void draw_code_line(const Ui& ui, std::string_view line, bool current) {
  float indent = 8;
  while (line.substr(0, 2) == "  ") {
    line.remove_prefix(2);
    indent += 14;
  }
  const float width = full_width(), room = width - indent - 6;
  const std::vector<std::string_view> lines = broken_lines(Face::label, line, room);
  const float height = height_of(Face::label, lines) + 6;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (current) {
    const ImVec2 high(at.x + width, at.y + height);
    list.AddRectFilled(at, high, ui.theme.accent.at(0.16f).packed(), 6);
    list.AddRectFilled(at, ImVec2(at.x + 3, high.y), ui.theme.accent.packed(), 2);
  }
  draw_lines(list, Face::label, ImVec2(at.x + indent, at.y + 3),
             current ? ui.theme.text : ui.theme.second_text, lines);
  ImGui::Dummy(ImVec2(width, height));
}

}  // namespace

// The eligible candidates, the best first.
void draw_walkthrough_ranking(const Ui& ui) {
  const TeamScores& scores = *ui.state.view.walkthrough.detail.scores;
  text_line(Face::strong_label, ui.theme.second_text, title_of_ranking(scores.rule));
  const double best = std::max(scores.of_candidate[scores.ranking[0]].value, 1e-300);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
  std::size_t eligible = 0;
  for (std::size_t i = 0; i < scores.ranking.size(); ++i) {
    if (!scores.of_candidate[scores.ranking[i]].eligible) continue;
    if (eligible++ < most_ranked) draw_ranked(ui, scores, i, best);
  }
  ImGui::PopStyleVar();
  if (eligible > most_ranked)
    text_line(Face::label, ui.theme.second_text,
              say("and {candidates} more", {eligible - most_ranked}));
}

// In a box that scrolls to the current line, so that the caption above does not move.
void draw_walkthrough_code(const Ui& ui) {
  const Walkthrough& walk = ui.state.view.walkthrough;
  const auto lines = pseudo_code(settings(ui.state));
  const std::uint32_t current = pseudo_line(*walk.trace, walk.detail);
  text_line(Face::strong_label, ui.theme.second_text, "The algorithm");
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
  begin_scrolling_box(ui, "lines", code_height);
  const int line = static_cast<int>(current);
  const bool moved = in_last_frame("line", line, -1) != line;
  for (std::uint32_t i = 0; i < lines.size(); ++i) {
    draw_code_line(ui, lines[i], i == current);
    if (i == current && moved) {
      ImGui::SetScrollHereY(0.4f);
      ui.push(LayOutAgain{});
    }
  }
  end_scrolling_box(ui);
  ImGui::PopStyleVar();
}

void draw_walkthrough_history(const Ui& ui) {
  const std::vector<Visited>& visited = ui.state.view.walkthrough.visited;
  text_line(Face::strong_label, ui.theme.second_text, "Seen before");
  const float width = full_width();
  const std::size_t from = visited.size() - 1;
  for (std::size_t i = from; i-- > 0 && from - i <= most_shown;) {
    const Visited& v = visited[i];
    // Numbered as on the timeline; a step that is not on it has no number.
    const auto position = position_of(ui.state, v.step);
    const std::string number = position ? std::to_string(*position + 1) : std::string("–");
    const std::string text = number + "  " + v.caption;
    const std::vector<std::string_view> lines = broken_lines(Face::label, text, width);
    const std::string name = "Visited " + std::to_string(i);
    const auto [at, high, pressed, hovered] = pressable_row(
        ui, name.c_str(), say("Step {place}", {text}), width, height_of(Face::label, lines) + 4);
    draw_lines(*ImGui::GetWindowDrawList(), Face::label, ImVec2(at.x, at.y + 2),
               hovered ? ui.theme.text : ui.theme.second_text, lines);
    if (pressed) ui.push(GoToStep{v.step});
  }
}

}  // namespace evenlift::view
