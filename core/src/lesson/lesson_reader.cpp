#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "evenlift/lesson.h"
#include "evenlift/numbers.h"
#include "evenlift/wording.h"
#include "numbers/number_text.h"

namespace evenlift {
namespace {

std::string_view trimmed(std::string_view text) {
  const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!text.empty() && blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && blank(text.back())) text.remove_suffix(1);
  return text;
}

constexpr struct {
  Movable part;
  std::string_view name;
} movables[] = {{Movable::robots, "robots"},
                {Movable::teams, "teams"},
                {Movable::centre, "centre"},
                {Movable::vertices, "vertices"},
                {Movable::cargo, "cargo"}};

std::optional<Movable> movable_from_name(std::string_view text) {
  for (const auto& movable : movables)
    if (movable.name == text) return movable.part;
  return std::nullopt;
}

std::string names_of_movable() {
  std::vector<std::string> names;
  for (const auto& movable : movables) names.emplace_back(movable.name);
  return listed(names);
}

constexpr std::size_t most_robots_to_place = 64;

class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}

  Result<Lesson> read() {
    if (text_.size() > max_lesson_bytes)
      return InputError{ErrorCode::text_too_long, "a lesson has at most 65536 bytes"};
    if (text_.substr(0, 3) == "\xef\xbb\xbf") text_.remove_prefix(3);  // the byte-order mark
    while (!text_.empty() && !error_) {
      const std::size_t end = text_.find('\n');
      const std::string_view whole_line = text_.substr(0, end);
      text_.remove_prefix(end == std::string_view::npos ? text_.size() : end + 1);
      ++line_;
      read_line(whole_line);
    }
    finish();
    if (error_) return *error_;
    return std::move(lesson_);
  }

 private:
  void refuse(std::string message, std::size_t line) {
    if (!error_)
      error_ =
          InputError{ErrorCode::bad_syntax, std::move(message), {Place::Kind::line, line, 0, {}}};
  }
  void refuse(std::string message) { refuse(std::move(message), line_); }

  void read_line(std::string_view whole_line) {
    if (!is_line_of_text(whole_line)) return refuse("not readable text (UTF-8)");
    const std::string_view line = trimmed(whole_line);
    if (!line.empty() && line.front() == '#') return;
    if (!line.empty() && line.front() == '[') return begin_part(line);
    if (!part_.words) return read_heading(line);
    read_words(line);
  }

  // Before the first step: a name and its value.
  void read_heading(std::string_view line) {
    if (line.empty()) return;
    const std::size_t colon = line.find(':');
    if (colon == std::string_view::npos)
      return refuse("expected a setting such as `title: ...`, or a step such as [team 2]");
    const std::string_view key = trimmed(line.substr(0, colon));
    const std::string_view value = trimmed(line.substr(colon + 1));
    if (value.empty()) return refuse("the setting has no value");
    const std::optional<Setting> setting = setting_of(key);
    // An alias is the same setting.
    const std::string_view given = setting ? name(*setting) : key;
    if (std::find(seen_.begin(), seen_.end(), given) != seen_.end())
      return refuse("the setting is given twice");
    seen_.push_back(given);
    for (const std::string_view of_task : keys_of_tasks)
      if (of_task == key && task_key_line_ == 0) task_key_line_ = line_;
    for (const Key& own : keys)
      if (own.name == key) return (this->*own.take)(value);
    if (setting) return take_setting(value, *setting);
    refuse(say("unknown setting; the settings are {names}", {names_of_keys()}));
  }

  void take_title(std::string_view value) {
    if (value.size() > max_lesson_title) return refuse("the title is longer than 100 bytes");
    lesson_.title = value;
  }

  void take_polygon(std::string_view value) {
    for (const char c : value)
      if (!((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-'))
        return refuse("a sample's name contains only lower-case letters, digits and hyphens");
    lesson_.polygon = value;
  }

  void take_link(std::string_view value) { lesson_.link = value; }

  void take_loads(std::string_view value) {
    lesson_.loads = load_model_from_name(value);
    if (!lesson_.loads) refuse(requirement(Setting::loads));
  }

  void take_failed(std::string_view value) {
    const auto robot = read_failed(value);
    if (!robot || *robot > most_supports) return refuse(requirement(Setting::failed));
    if (*robot > 0) lesson_.failed = static_cast<std::size_t>(*robot - 1);
  }

  // "star n=9 seed={number}"; `n` and `seed` may be missing.
  void take_generate(std::string_view value) {
    const std::optional<Family> family = family_from_name(next_word(value));
    bool sound = family.has_value();
    GeneratedPolygon polygon;
    polygon.family = family.value_or(polygon.family);
    polygon.seed = 1;
    while (!value.empty()) {
      const std::string_view word = next_word(value);
      const std::string_view number = word.substr(std::min(word.size(), word.find('=') + 1));
      const auto whole = read_whole(number);
      const bool is_size = word.starts_with("n="), is_seed = word.starts_with("seed=");
      if (is_size && whole && *whole <= max_link_vertices)
        polygon.n = static_cast<std::size_t>(*whole);
      else if (is_seed && number == "{number}")
        polygon.seed.reset();
      else if (is_seed && whole)
        polygon.seed = *whole;
      else
        sound = false;
    }
    if (!sound)
      return refuse(
          "expected a family of polygons, its number of vertices and a seed, such as star n=9 seed={number}");
    lesson_.generated = polygon;
  }

  void take_require(std::string_view value) {
    Result<std::vector<Condition>> conditions = read_conditions(value);
    if (!conditions) return refuse(conditions.error().message);
    task_.conditions = *std::move(conditions);
  }

  void take_move(std::string_view value) {
    std::vector<Movable> may;
    while (true) {
      const std::size_t comma = value.find(',');
      const auto part = movable_from_name(trimmed(value.substr(0, comma)));
      if (!part)
        return refuse(say("what may be moved is one or more of {names}", {names_of_movable()}));
      if (std::find(may.begin(), may.end(), *part) == may.end()) may.push_back(*part);
      if (comma == std::string_view::npos) break;
      value.remove_prefix(comma + 1);
    }
    std::sort(may.begin(), may.end());
    task_.may = std::move(may);
  }

  void take_place(std::string_view value) {
    const auto robots = read_whole(value);
    if (!robots || *robots < 1 || *robots > most_robots_to_place)
      return refuse("the number of robots to place must be a whole number from 1 to 64");
    task_.place = static_cast<std::size_t>(*robots);
  }

  void take_find(std::string_view value) {
    if (value != "centre") return refuse("only the centre can be found: find: centre");
    task_.find_centre = true;
  }

  // Checks the setting and stores its text for lesson_document().
  void take_setting(std::string_view value, Setting setting) {
    Document tried;
    if (read_setting(setting, value, tried)) return refuse(requirement(setting));
    lesson_.settings.push_back({setting, std::string(value), line_});
  }

  void take_predict(std::string_view value) {
    if (value != "yes" && value != "no") return refuse("expected yes or no");
    lesson_.predict = value == "yes";
  }

  // The keys of lessons in addition to the settings.
  struct Key {
    std::string_view name;
    void (Reader::*take)(std::string_view value);
  };
  static constexpr Key keys[] = {
      {"title", &Reader::take_title},     {"polygon", &Reader::take_polygon},
      {"link", &Reader::take_link},       {"generate", &Reader::take_generate},
      {"predict", &Reader::take_predict}, {"loads", &Reader::take_loads},
      {"failed", &Reader::take_failed},   {"require", &Reader::take_require},
      {"move", &Reader::take_move},       {"place", &Reader::take_place},
      {"find", &Reader::take_find}};
  static constexpr std::string_view keys_of_tasks[] = {"require", "move", "place", "find"};
  static bool is_key(const SettingRow& row) {
    return row.option.group != OptionGroup::none || row.setting == Setting::overlays;
  }

  // Keys have hyphens in place of underscores.
  static std::optional<Setting> setting_of(std::string_view key) {
    std::string name(key);
    for (char& c : name) c = c == '-' ? '_' : c == '_' ? '-' : c;
    const std::optional<Setting> setting = setting_from_name(name);
    return setting && is_key(row_of(*setting)) ? setting : std::nullopt;
  }

  static std::string names_of_keys() {
    std::vector<std::string> names;
    for (const Key& own : keys) names.emplace_back(own.name);
    for (const SettingRow& row : all_settings())
      if (is_key(row)) names.push_back(hyphened(row.name));
    return listed(names);
  }

  // Where the next words go.
  struct Part {
    std::string* words = nullptr;  // of lesson_; null before the first part
    std::size_t most = 0;          // bytes
    const char* too_long = nullptr;
    const char* missing = nullptr;
    std::size_t line = 0;
  };

  void begin_part(std::string_view line) {
    finish_part();
    gap_ = false;
    if (line.back() != ']') return refuse("a step's address must end in ]");
    const std::string_view name = trimmed(line.substr(1, line.size() - 2));
    if (name == "task") return begin_task();
    if (name == "question") return begin_question();
    if (name == "answer") return begin_answer();
    begin_step(name);
  }

  void begin_step(std::string_view name) {
    if (asked_) return refuse("a step after the question, which must be the end of the lesson");
    if (lesson_.task) return refuse("a step after the task, which must come after all steps");
    if (lesson_.steps.size() == max_lesson_steps) return refuse("a lesson has at most 200 steps");
    const auto address = read_address(name);
    if (!address)
      return refuse(
          "expected the address of a step, such as [centre], [vertex 3], [pair 2], [edges 4 7], [team 2] or [end]");
    lesson_.steps.push_back({*address, {}, line_});
    part_ = {&lesson_.steps.back().words, max_lesson_words,
             "a step has more than 1000 bytes of text", "the step has no text", line_};
  }

  void begin_task() {
    if (lesson_.task) return refuse("a lesson has at most one task");
    if (asked_) return refuse("the task must come before the question");
    if (task_.conditions.empty() && !task_.find_centre)
      return refuse(
          "the task has no conditions; give them above, such as require: max<=30, robots<=4");
    if (task_.may.empty())
      return refuse("the task does not say what may be moved; say it above, such as move: robots");
    lesson_.task = task_;
    part_ = {&lesson_.task->words, max_lesson_task, "the task is longer than 300 bytes",
             "the task has no text", line_};
  }

  void begin_question() {
    if (asked_) return refuse("a lesson has at most one question, at its end");
    if (lesson_.steps.empty() && !lesson_.task)
      return refuse("the question must come after the steps");
    asked_ = line_;
    part_ = {&lesson_.question, max_lesson_question, "the question is longer than 300 bytes",
             "the question has no text", line_};
  }

  void begin_answer() {
    if (!asked_) return refuse("an answer without a question before it");
    if (!lesson_.answer.empty()) return refuse("a question has only one answer");
    part_ = {&lesson_.answer, max_lesson_answer, "the answer is longer than 600 bytes",
             "the answer has no text", line_};
  }

  static std::optional<StepAddress> read_address(std::string_view text) {
    std::array<std::uint32_t, 2> numbers{};
    std::size_t count = 0;
    const std::string_view word = next_word(text);
    for (; !text.empty(); ++count) {
      const auto number = read_whole(next_word(text));
      if (count == numbers.size() || !number || *number < 1 || *number > ~std::uint32_t{0})
        return std::nullopt;
      numbers[count] = static_cast<std::uint32_t>(*number - 1);
    }
    if (word == "end" && count == 0) return at::End{};
    if (word == "edges" && count == 2) return at::Edges{numbers[0], numbers[1]};
    if (word == "vertex" && count == 1) return at::Vertex{numbers[0]};
    if (word == "step" && count == 1) return at::Number{numbers[0]};
    const auto kind = step_kind_from_name(word == "pair" ? "outcome" : word);
    if (!kind || count == 2) return std::nullopt;
    return at::Kind{*kind, numbers[0]};
  }

  static std::string_view next_word(std::string_view& text) {
    const std::size_t end = text.find_first_of(" \t");
    const std::string_view word = text.substr(0, end);
    text = end == std::string_view::npos ? std::string_view() : trimmed(text.substr(end));
    return word;
  }

  void read_words(std::string_view line) {
    std::string& words = *part_.words;
    if (line.empty()) {
      gap_ = !words.empty();
      return;
    }
    if (!words.empty()) words += gap_ ? '\n' : ' ';
    gap_ = false;
    words += line;
    if (words.size() > part_.most) refuse(part_.too_long, part_.line);
  }

  void finish_part() {
    if (part_.words && part_.words->empty()) refuse(part_.missing, part_.line);
  }

  void finish() {
    finish_part();
    if (asked_ && lesson_.answer.empty())
      refuse("the question has no answer; write one below [answer]", *asked_);
    if (error_) return;
    if (task_key_line_ > 0 && !lesson_.task)
      return refuse("the lesson has no task; write it below [task]", task_key_line_);
    const int objects =
        !lesson_.polygon.empty() + !lesson_.link.empty() + lesson_.generated.has_value();
    const char* missing =
        lesson_.title.empty() ? "the lesson has no title"
        : objects == 0        ? "the lesson has neither a polygon nor a link"
        : objects > 1
            ? "the lesson has two of a polygon, a link and a generated polygon; give only one"
        : lesson_.steps.empty() && !lesson_.task ? "the lesson has no steps"
                                                 : nullptr;
    if (missing) refuse(missing, line_ > 0 ? line_ : 1);
  }

  std::string_view text_;
  std::size_t line_ = 0;
  Lesson lesson_;
  std::vector<std::string_view> seen_;  // names in the text so far
  Part part_;
  bool gap_ = false;                  // an empty line follows the last words
  std::optional<std::size_t> asked_;  // line of the question
  Task task_;                         // so far
  std::size_t task_key_line_ = 0;     // of the first setting of a task
  std::optional<InputError> error_;
};

}  // namespace

std::string_view name(Movable part) { return movables[static_cast<std::size_t>(part)].name; }

Result<Lesson> parse_lesson(std::string_view text) { return Reader(text).read(); }

}  // namespace evenlift
