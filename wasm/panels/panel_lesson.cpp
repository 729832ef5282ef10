// The lesson beside the drawing: what this step is about, in words, numbers and code; and what the
// learner asks or is asked.
#include <algorithm>

#include "actions/actions.h"
#include "evenlift/output/words.h"
#include "panels/panels.h"
#include "state/browser.h"
#include "ui/widgets.h"
#include "walkthrough/walkthrough.h"

namespace evenlift::view {
namespace {

constexpr std::size_t most_shown = 12;  // of the history
constexpr float code_height = 210;
constexpr std::size_t most_ranked = 10;  // candidates

float full_width() { return ImGui::GetContentRegionAvail().x; }

void space(float height) { ImGui::Dummy(ImVec2(0, height)); }

// Words on a ground of their own.
void draw_box(Colour ground, Colour colour, Face face, const std::string& text) {
  const float pad = 10, width = full_width();
  const ImVec2 size = text_size(face, text, width - 2 * pad), at = ImGui::GetCursorScreenPos();
  const ImVec2 high(at.x + width, at.y + size.y + 2 * pad);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, high, ground.packed(), 8);
  draw_text(list, face, ImVec2(at.x + pad, at.y + pad), colour, text, width - 2 * pad);
  ImGui::Dummy(ImVec2(width, size.y + 2 * pad));
}

std::string choice_name(const Ask& ask, std::uint32_t choice) {
  if (ask.question.kind == QuestionKind::winning_chord)
    return "Candidate " + std::to_string(choice + 1);
  return choice == 0 ? "The first end" : "The second end";
}

void draw_question(const Ui& ui) {
  const LessonState& lesson = ui.state.lesson;
  if (!lesson.ask) return;
  const Ask& ask = *lesson.ask;
  space(4);
  text_block(Face::strong, ui.theme.accent, ask.text);
  text_block(Face::label, ui.theme.second_text,
             "Press it in the drawing, or choose here. Next shows the answer.");
  const float width = full_width();
  if (ask.choices.size() <= 3) {
    for (const std::uint32_t choice : ask.choices) {
      const std::string name = choice_name(ask, choice);
      if (flat_button(ui, name.c_str(), name.c_str(), width)) ui.push(Guess{choice});
    }
    return;
  }
  const auto n = static_cast<int>(ask.choices.size());
  const auto pointed = static_cast<int>(ask.pointed);
  const int by =
      stepper(ui, "choice", choice_name(ask, ask.choices[ask.pointed]), true, true, width);
  if (by != 0) ui.push(PointAtChoice{static_cast<std::size_t>((pointed + by + n) % n)});
  if (flat_button(ui, "take", "This one", width, true, true))
    ui.push(Guess{ask.choices[ask.pointed]});
}

void draw_answers(const Ui& ui) {
  const LessonState& lesson = ui.state.lesson;
  if (!lesson.verdict.empty()) {
    const Colour colour = lesson.was_right ? ui.theme.hull_text : ui.theme.amber;
    draw_box(ui.theme.well, colour, Face::strong, lesson.verdict);
  }
  if (!lesson.why.empty()) {
    text_line(Face::strong_label, ui.theme.second_text, "Why not this one?");
    draw_box(ui.theme.well, ui.theme.text, Face::text, lesson.why);
  }
}

}  // namespace

namespace {

void draw_words(const Ui& ui) {
  const LessonState& lesson = ui.state.lesson;
  if (const std::string words = words_of_stop(ui.state); !words.empty())
    text_block(Face::text, ui.theme.text, words);
  text_block(Face::text, lesson.script ? ui.theme.second_text : ui.theme.text, lesson.caption);
}

std::string place_in_words(const AppState& state) {
  const Timeline now = timeline(state);
  return std::to_string(now.at + 1) + " of " + std::to_string(now.count);
}

}  // namespace

void draw_lesson_step(const Ui& ui) {
  const LessonState& lesson = ui.state.lesson;
  const float button = ui.layout.wide ? ui.control() : 0;  // in the corner
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 8));
  if (lesson.script)
    text_block(Face::strong_label, ui.theme.accent, lesson.script->lesson.title, button);
  text_block(Face::verdict, ui.theme.text, std::string(title(lesson.detail.step.chapter)),
             lesson.script ? 0 : button);
  text_line(Face::label, ui.theme.second_text, "Step " + place_in_words(ui.state));
  draw_words(ui);
  if (!lesson.formula.empty()) draw_box(ui.theme.well, ui.theme.text, Face::label, lesson.formula);
  draw_answers(ui);
  draw_question(ui);
  ImGui::PopStyleVar();
}

// The same where there is little room: a closed sheet, an <iframe>.
void draw_lesson_briefly(const Ui& ui) {
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 4));
  text_line(Face::strong_label, ui.theme.second_text,
            std::string(title(ui.state.lesson.detail.step.chapter)) + " · step " +
                place_in_words(ui.state));
  draw_words(ui);
  draw_answers(ui);
  draw_question(ui);
  ImGui::PopStyleVar();
}

// Every candidate with its score, the best first; the one pointed at is measured in the drawing.
void draw_lesson_ranking(const Ui& ui) {
  const LessonState& lesson = ui.state.lesson;
  const std::optional<TeamScores>& scores = lesson.detail.scores;
  const char* what = scores->rule == Rule::score          ? "Candidates by score"
                     : scores->rule == Rule::longest_even ? "Even candidates by length"
                                                          : "Candidates by load ratio";
  text_line(Face::strong_label, ui.theme.second_text, what);
  const double best = std::max(scores->of_candidate[scores->ranking[0]].value, 1e-300);
  const float width = full_width(), height = ui.control() > 40 ? 36.0f : 24.0f;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
  for (std::size_t i = 0; i < scores->ranking.size() && i < most_ranked; ++i) {
    const std::uint32_t c = scores->ranking[i];
    const Score& score = scores->of_candidate[c];
    if (!score.eligible) continue;
    ImGui::PushID(static_cast<int>(c));
    const ImVec2 at = ImGui::GetCursorScreenPos(), high(at.x + width, at.y + height);
    const bool pressed = ImGui::InvisibleButton("ranked", ImVec2(width, height));
    if (pressed || (ImGui::IsItemHovered() && lesson.measured != c)) ui.push(Measure{c});
    ImGui::PopID();
    if (lesson.measured == c) list.AddRectFilled(at, high, ui.theme.well.packed(), 6);
    const std::string name = std::to_string(i + 1) + ".  Candidate " + std::to_string(c + 1);
    const std::string value = (score.exact ? "" : "≤ ") + amount(score.value, best);
    const float share = static_cast<float>(std::clamp(score.value / best, 0.0, 1.0));
    const float middle = (at.y + high.y) / 2, half = text_size(Face::label, name).y / 2;
    const float from = at.x + width * 0.46f, room = width * 0.26f;
    list.AddRectFilled(ImVec2(from, middle - 3), ImVec2(from + room, middle + 3),
                       ui.theme.well.packed(), 3);
    list.AddRectFilled(ImVec2(from, middle - 3), ImVec2(from + room * share, middle + 3),
                       (i == 0 ? ui.theme.hull_outline : ui.theme.quiet).packed(), 3);
    draw_text(list, i == 0 ? Face::strong_label : Face::label, ImVec2(at.x + 6, middle - half),
              ui.theme.text, name);
    draw_text(list, Face::label,
              ImVec2(high.x - 6 - text_size(Face::label, value).x, middle - half),
              i == 0 ? ui.theme.text : ui.theme.second_text, value);
  }
  ImGui::PopStyleVar();
  if (scores->ranking.size() > most_ranked)
    text_line(Face::label, ui.theme.second_text,
              "and " + std::to_string(scores->ranking.size() - most_ranked) + " more");
}

void draw_lesson_code(const Ui& ui) {
  const LessonState& lesson = ui.state.lesson;
  const auto lines = pseudo_code(settings(ui.state).method);
  const std::uint32_t current = pseudo_line(*lesson.trace, lesson.detail);
  text_line(Face::strong_label, ui.theme.second_text, "The algorithm");
  // In a box that scrolls to its line: the caption above stays where it is.
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
  ImGui::BeginChild("lines", ImVec2(full_width(), code_height));
  scroll_by_finger(ui);
  ImGuiStorage& seen = *ImGui::GetStateStorage();
  const ImGuiID line_id = ImGui::GetID("line");
  const bool moved = seen.GetInt(line_id, -1) != static_cast<int>(current);
  seen.SetInt(line_id, static_cast<int>(current));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float width = full_width();
  for (std::uint32_t i = 0; i < lines.size(); ++i) {
    std::string_view line = lines[i];
    float indent = 8;
    while (line.substr(0, 2) == "  ") {
      line.remove_prefix(2);
      indent += 14;
    }
    const float room = width - indent - 6;
    const ImVec2 at = ImGui::GetCursorScreenPos(), size = text_size(Face::label, line, room);
    if (i == current) {
      const ImVec2 high(at.x + width, at.y + size.y + 6);
      list.AddRectFilled(at, high, ui.theme.accent.at(0.16f).packed(), 6);
      list.AddRectFilled(at, ImVec2(at.x + 3, high.y), ui.theme.accent.packed(), 2);
    }
    draw_text(list, Face::label, ImVec2(at.x + indent, at.y + 3),
              i == current ? ui.theme.text : ui.theme.second_text, line, room);
    ImGui::Dummy(ImVec2(width, size.y + 6));
    if (i == current && moved) {
      ImGui::SetScrollHereY(0.4f);
      browser::request_frame();
    }
  }
  ImGui::EndChild();
  ImGui::PopStyleVar();
}

void draw_lesson_history(const Ui& ui) {
  const std::vector<Visited>& visited = ui.state.lesson.visited;
  text_line(Face::strong_label, ui.theme.second_text, "Seen before");
  const float width = full_width();
  const std::size_t from = visited.size() - 1;
  for (std::size_t i = from; i-- > 0 && from - i <= most_shown;) {
    const Visited& v = visited[i];
    const std::string text = std::to_string(v.step + 1) + "  " + v.caption;
    const ImVec2 at = ImGui::GetCursorScreenPos(), size = text_size(Face::label, text, width);
    ImGui::PushID(static_cast<int>(i));
    const bool pressed = tapped(ui, ImGui::InvisibleButton("visited", ImVec2(width, size.y + 4)));
    ImGui::PopID();
    const bool hovered = ImGui::IsItemHovered();
    if (hovered) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    draw_text(*ImGui::GetWindowDrawList(), Face::label, ImVec2(at.x, at.y + 2),
              hovered ? ui.theme.text : ui.theme.second_text, text, width);
    if (pressed) ui.push(GoToStep{v.step});
  }
}

}  // namespace evenlift::view
