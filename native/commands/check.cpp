// Judges whether links solve the task of a lesson.
#include <algorithm>

#include "commands/commands.h"
#include "evenlift/link.h"
#include "evenlift/numbers.h"
#include "evenlift/output/json_text.h"
#include "evenlift/placement.h"
#include "evenlift/task.h"
#include "input/handed_in.h"
#include "input/options.h"
#include "print/progress.h"
#include "print/table.h"

namespace evenlift::native {
namespace {

struct Marked {
  const HandedIn* of;
  std::uint64_t number;  // the learner's
  Attempt attempt;
  std::string problem;  // why it could not be judged; else empty
};

// Makes the exercise for this learner, since another number may make another object. Throws Failure
// if the lesson itself is at fault.
Marked mark(const HandedIn& handed_in, const LessonText& lesson, std::uint64_t number) {
  Marked marked{&handed_in, number, {}, {}};
  const Result<Exercise> begun = exercise(lesson.lesson, lesson.sample, number);
  if (!begun) throw bad_input(lesson.source, at_line(begun.error(), lesson.lesson));
  const Result<Document> document = decode_link(handed_in.link);
  if (!document) {
    marked.problem = document.error().message;
    return marked;
  }
  const Result<Placement> placement = place(*document, Effort::whole, Misfitting::left_out);
  if (!placement) {
    marked.problem = placement.error().message;
    return marked;
  }
  marked.attempt =
      check_task(*lesson.lesson.task, *begun, *document, {*placement, document->shown});
  return marked;
}

std::string changes_of(const Marked& marked) {
  std::string text;
  for (const std::string& changed : marked.attempt.changed)
    text += (text.empty() ? "changed " : ", ") + changed;
  return text;
}

std::string yes_or_no(bool value) { return value ? "yes" : "no"; }

std::string in_words(const Marked& marked) {
  std::string text;
  for (const Goalpost& goal : marked.attempt.goals)
    text += goal.words + ": " + (goal.value.empty() ? "no value" : goal.value) +
            (goal.kept ? ", kept\n" : ", not kept\n");
  for (const std::string& changed : marked.attempt.changed)
    text += "The task does not allow to change " + changed + ".\n";
  return text + (marked.attempt.kept ? "The task is done.\n" : "The task is not done.\n");
}

// The goals, which all links have in common.
std::vector<std::string> goals_of(const std::vector<Marked>& all) {
  std::vector<std::string> names;
  for (const Marked& marked : all)
    if (names.empty())
      for (const Goalpost& goal : marked.attempt.goals) names.push_back(goal.name);
  return names;
}

bool has_numbers(const LessonText& lesson, const std::vector<Marked>& all) {
  return is_numbered(lesson.lesson) ||
         std::any_of(all.begin(), all.end(), [](const Marked& m) { return m.of->number; });
}

std::string as_table(const std::vector<Marked>& all, bool numbers) {
  const std::vector<std::string> goals = goals_of(all);
  std::vector<Row> rows = {{"line", "name"}};
  if (numbers) rows[0].push_back("number");
  rows[0].push_back("done");
  rows[0].insert(rows[0].end(), goals.begin(), goals.end());
  std::vector<std::string> remarks(1);
  for (const Marked& marked : all) {
    Row row = {std::to_string(marked.of->line), marked.of->name};
    if (numbers) row.push_back(std::to_string(marked.number));
    row.push_back(yes_or_no(marked.attempt.kept));
    for (const Goalpost& goal : marked.attempt.goals)
      row.push_back((goal.value.empty() ? "-" : goal.value) + (goal.kept ? " \u2713" : " \u2717"));
    remarks.push_back(marked.problem.empty() ? changes_of(marked) : marked.problem);
    rows.push_back(std::move(row));
  }
  return table(rows, remarks);
}

std::string as_csv(const std::vector<Marked>& all) {
  std::string text = "line,name,number,done";
  for (const std::string& goal : goals_of(all))
    text += "," + csv_cell(goal) + "," + csv_cell(goal + " kept");
  text += ",remark\n";
  const std::size_t goals = goals_of(all).size();
  for (const Marked& marked : all) {
    text += std::to_string(marked.of->line) + "," + csv_cell(marked.of->name) + "," +
            std::to_string(marked.number) + "," + yes_or_no(marked.attempt.kept);
    for (const Goalpost& goal : marked.attempt.goals)
      text += "," + csv_cell(goal.value) + "," + yes_or_no(goal.kept);
    for (std::size_t i = marked.attempt.goals.size(); i < goals; ++i) text += ",,";
    text += "," + csv_cell(marked.problem.empty() ? changes_of(marked) : marked.problem) + "\n";
  }
  return text;
}

std::string as_json(const LessonText& lesson, const std::vector<Marked>& all) {
  std::vector<std::string> results;
  for (const Marked& marked : all) {
    std::vector<std::string> goals, changed;
    for (const Goalpost& goal : marked.attempt.goals)
      goals.push_back(json::object({{"condition", json::text(goal.name)},
                                    {"words", json::text(goal.words)},
                                    {"value", json::text(goal.value)},
                                    {"kept", json::boolean(goal.kept)}}));
    for (const std::string& each : marked.attempt.changed) changed.push_back(json::text(each));
    results.push_back(
        json::object({{"line", std::to_string(marked.of->line)},
                      {"name", json::text(marked.of->name)},
                      {"number", std::to_string(marked.number)},
                      {"done", json::boolean(marked.attempt.kept)},
                      {"goals", json::array(goals)},
                      {"changed", json::array(changed)},
                      {"problem", marked.problem.empty() ? "null" : json::text(marked.problem)}}));
  }
  return json::long_object(
             {{"task", json::text(lesson.lesson.title)}, {"results", json::long_array(results, 1)}},
             0) +
         "\n";
}

}  // namespace

void cmd_check(const Arguments& arguments) {
  CommandLine line(
      "evenlift check", "Says whether links solve the task of a lesson: marks homework.",
      "LINK is a share link, an address that ends in one, or a file of them (- for standard input): one\n"
      "in each line, perhaps with a name before it. Exit status: 0 if all are done, 3 if one is not.\n\n"
      "Examples:\n"
      "  evenlift check \"$LINK\" --task task-thirty\n"
      "  evenlift check handed-in.txt --task my-lesson.txt --csv >marks.csv\n");
  std::string link_or_file;
  std::optional<std::string> task, number_text;
  bool csv = false, json = false;
  line.positional(link_or_file, "LINK", "a link, or a file of links");
  line.value(task, "--task", "NAME", "a lesson with a task: a ready-made one, a file, or a link");
  line.value(number_text, "--number", "N",
             "the learner's number, for addresses without one (default 1)");
  line.flag(csv, "--csv", "print a table for a spreadsheet");
  line.flag(json, "--json", "print JSON");
  if (!line.parse(arguments)) return;
  if (!task)
    throw Failure{bad_input_status, "--task",
                  "missing: a lesson with a task, by its name, its file or its link"};
  if (*task == "-" && link_or_file == "-")
    throw Failure{bad_input_status, "--task",
                  "standard input cannot hold both the lesson and the links"};
  if (csv && json) throw Failure{bad_input_status, "--csv", "cannot be combined with --json"};
  const std::uint64_t number =
      number_text ? whole_option("--number", *number_text, max_learner) : 1;
  const LessonText lesson = read_lesson("--task", *task);
  if (!lesson.lesson.task)
    throw Failure{bad_input_status, lesson.source, "this lesson has no task"};
  const std::vector<HandedIn> links = read_handed_in(link_or_file);

  std::vector<Marked> all;
  {
    Waiting waiting("marking the links", links.size(), "link");
    for (const HandedIn& link : links) {
      waiting.begin();
      all.push_back(mark(link, lesson, link.number.value_or(number)));
    }
  }
  const bool alone = all.size() == 1 && links[0].name.empty();
  if (alone && !all[0].problem.empty() && !csv && !json)
    throw Failure{bad_input_status, "link", all[0].problem};
  write_output(json    ? as_json(lesson, all)
               : csv   ? as_csv(all)
               : alone ? in_words(all[0])
                       : as_table(all, has_numbers(lesson, all)));
  if (!std::all_of(all.begin(), all.end(), [](const Marked& each) { return each.attempt.kept; }))
    throw Failure{not_kept_status, {}, {}, {}, true};
}

}  // namespace evenlift::native
