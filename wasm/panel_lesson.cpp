// The lesson beside the drawing: what this step is about, in words, numbers and code; and what the
// learner asks or is asked.
#include <algorithm>

#include "actions.h"
#include "format.h"
#include "lesson.h"
#include "panels.h"
#include "widgets.h"

namespace evenlift::view {
namespace {

constexpr std::size_t most_shown = 12;  // of the history

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

void draw_lesson_step(const Ui& ui) {
  const AppState& state = ui.state;
  const LessonState& lesson = state.lesson;
  const Timeline now = timeline(state);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 8));
  if (lesson.script)
    text_block(Face::strong_label, ui.theme.accent, lesson.script->lesson.title,
               ui.layout.wide ? ui.control() : 0);
  text_block(Face::verdict, ui.theme.text, std::string(title(lesson.detail.step.chapter)),
             ui.layout.wide && !lesson.script ? ui.control() - 8 : 0);
  text_line(Face::label, ui.theme.second_text,
            "Step " + std::to_string(now.at + 1) + " of " + std::to_string(now.count));
  if (const std::string words = words_of_stop(state); !words.empty())
    text_block(Face::text, ui.theme.text, words);
  text_block(Face::text, lesson.script ? ui.theme.second_text : ui.theme.text, lesson.caption);
  if (!lesson.formula.empty()) draw_box(ui.theme.well, ui.theme.text, Face::label, lesson.formula);
  draw_answers(ui);
  draw_question(ui);
  ImGui::PopStyleVar();
}

void draw_lesson_code(const Ui& ui) {
  const LessonState& lesson = ui.state.lesson;
  const auto lines = pseudo_code(settings(ui.state).metric);
  const std::uint32_t current = pseudo_line(*lesson.trace, lesson.detail);
  text_line(Face::strong_label, ui.theme.second_text, "The algorithm");
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float width = full_width();
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
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
  }
  ImGui::PopStyleVar();
}

void draw_lesson_history(const Ui& ui) {
  const std::vector<Visited>& visited = ui.state.lesson.visited;
  if (visited.size() < 2) return;
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
