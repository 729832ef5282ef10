#include "evenlift/output/trace_json.h"

#include <algorithm>

#include "evenlift/output/json_text.h"
#include "evenlift/output/trace_words.h"

namespace evenlift {
namespace {

constexpr std::size_t most_objects = 100, most_ranks = 10;

std::string digits(std::size_t number) { return std::to_string(number); }

std::string numbers_json(const Trace& trace, const StepDetail& detail) {
  std::vector<json::Member> members;
  for (const Number& number : numbers(trace, detail))
    members.emplace_back(number.name, json::number(number.value));
  return json::object(members);
}

std::string figure_json(const Figure& figure) {
  std::vector<std::string> points;
  for (const Vec2& point : figure.points) points.push_back(json::pair(point));
  std::vector<json::Member> members{{"mark", json::text(name(figure.kind))},
                                    {"points", json::array(points)}};
  if (figure.item) members.emplace_back("item", digits(*figure.item));
  if (figure.value != 0) members.emplace_back("value", json::number(figure.value));
  return json::object(members);
}

// Without the outline and holes, which are the same in every step.
std::string objects_json(const Trace& trace, const StepDetail& detail, std::size_t& left_out) {
  std::vector<std::string> items;
  for (const Figure& figure : figures(trace, detail)) {
    if (figure.kind == FigureKind::object || figure.kind == FigureKind::hole) continue;
    if (items.size() < most_objects) {
      items.push_back(figure_json(figure));
    } else {
      ++left_out;
    }
  }
  return json::array(items);
}

std::string ranking_json(const TeamScores& scores) {
  std::vector<std::string> items;
  for (const std::uint32_t candidate : scores.ranking) {
    if (items.size() == most_ranks) break;
    const Score& score = scores.of_candidate[candidate];
    items.push_back(json::object({{"candidate", digits(candidate)},
                                  {"value", json::number(score.value)},
                                  {"exact", json::boolean(score.exact)}}));
  }
  return json::array(items);
}

std::string step_json(const Trace& trace, std::uint32_t k,
                      const std::vector<std::string_view>& code) {
  const StepDetail detail = look_at(trace, k);
  std::string_view line = code[pseudo_line(trace, detail)];
  while (line.front() == ' ') line.remove_prefix(1);
  std::vector<json::Member> members{{"kind", json::text(name(detail.step.kind))},
                                    {"chapter", json::text(name(detail.step.chapter))},
                                    {"item", digits(detail.step.item)},
                                    {"caption", json::text(caption(trace, detail))},
                                    {"formula", json::text(formula(trace, detail))},
                                    {"code", json::text(line)},
                                    {"numbers", numbers_json(trace, detail)}};
  if (detail.step.kind == StepKind::scores)
    members.emplace_back("ranking", ranking_json(*detail.scores));
  if (const auto asked = question(trace, detail)) {
    members.emplace_back("question", json::text(question_text(trace, detail, *asked)));
    members.emplace_back("answer", digits(asked->answer));
  }
  std::size_t left_out = 0;
  members.emplace_back("objects", objects_json(trace, detail, left_out));
  if (left_out > 0) members.emplace_back("objects_left_out", digits(left_out));
  return json::object(members);
}

}  // namespace

std::optional<InputError> check_printed_size(const Trace& trace) {
  if (trace.size() > most_printed_steps)
    return InputError{ErrorCode::unsupported, "the trace has " + digits(trace.size()) +
                                                  " steps, more than the " +
                                                  digits(most_printed_steps) + " that are printed"};
  const std::uint64_t comparisons =
      std::uint64_t{trace.count(StepKind::scores)} * trace.placement.candidates.size();
  if (comparisons > most_printed_comparisons)
    return InputError{ErrorCode::unsupported,
                      "the trace compares " + digits(trace.placement.candidates.size()) +
                          " candidates for " + digits(trace.count(StepKind::scores)) +
                          " teams, more than are printed; ask for fewer teams"};
  return std::nullopt;
}

std::string trace_json(const Trace& trace) {
  const std::vector<std::string_view> code = pseudo_code(trace.placement.settings);
  std::vector<std::string> steps;
  for (std::uint32_t k = 0; k < trace.size(); ++k) steps.push_back(step_json(trace, k, code));
  return json::long_array(steps, 0) + '\n';
}

std::string trace_list(const Trace& trace) {
  std::string text;
  const std::size_t width = digits(trace.size()).size();
  for (std::uint32_t k = 0; k < trace.size(); ++k) {
    const StepDetail detail = look_at(trace, k);
    if (trace.chapter_begin(detail.step.chapter) == k) {
      if (k > 0) text += '\n';
      text += title(detail.step.chapter);
      text += "\n\n";
    }
    const std::string number = digits(k + std::size_t{1});
    text.append(width - number.size() + 2, ' ');
    text += number + "  " + caption(trace, detail) + '\n';
    if (const std::string filled = formula(trace, detail); !filled.empty())
      text.append(width + 4, ' ') += filled + '\n';
  }
  return text;
}

}  // namespace evenlift
