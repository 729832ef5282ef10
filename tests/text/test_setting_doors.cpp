// The places that name settings and that no compiler reads (CONTRIBUTING.md, "Add a setting").
// Messages report names that are missing or do not belong there. The target update_expected adds
// what docs lack, from the setting's row.
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "evenlift/output/quantities.h"
#include "evenlift/settings.h"
#include "kit/corpus.h"
#include "link/records.h"

using namespace evenlift;

namespace {

namespace fs = std::filesystem;
using Names = std::set<std::string>;

fs::path root() { return fs::path(EVENLIFT_TESTS_DIR).parent_path(); }

// What is before, in and after a part of a file.
struct Parts {
  std::string before, part, after;
};

// Between the two texts.
Parts parts_of(const std::string& file, const std::string& begins, const std::string& ends) {
  const std::string text = corpus::read_file(root() / file);
  INFO(file << " has nothing between \"" << begins << "\" and \"" << ends << "\"");
  const std::size_t found = text.find(begins);
  REQUIRE(found != std::string::npos);
  const std::size_t begin = found + begins.size(), end = text.find(ends, begin);
  REQUIRE(end != std::string::npos);
  return {text.substr(0, begin), text.substr(begin, end - begin), text.substr(end)};
}

std::string part_of(const std::string& file, const std::string& begins, const std::string& ends) {
  return parts_of(file, begins, ends).part;
}

// Each without the characters before its first cell.
std::vector<std::string> table_rows(const std::string& text) {
  std::vector<std::string> rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("| ")) rows.push_back(line.substr(2));
  return rows;
}

std::string first_cell(const std::string& row) { return row.substr(0, row.find(" |")); }

// All matches of the first group.
Names found(const std::string& text, const std::string& pattern) {
  const std::regex each(pattern);
  Names names;
  for (std::sregex_iterator at(text.begin(), text.end(), each), end; at != end; ++at)
    names.insert((*at)[1]);
  return names;
}

// --- The doors: the settings at each, and their names there

bool is_option(const SettingRow& row) { return row.option.group != OptionGroup::none; }

std::string as_is(const SettingRow& row) { return std::string(row.name); }
std::string as_option(const SettingRow& row) { return "--" + hyphened(row.name); }

struct Door {
  std::string file, begins, ends;  // the part of the file; of tables, the first cells
  std::string name;                // a pattern, whose first group is a name
  std::string entry;               // what update_expected adds; with \n, on a line of its own
  std::string lacks;               // the message if it is missing
  bool (*goes_through)(const SettingRow&);
  std::string (*called)(const SettingRow&) = as_is;
  Names others = {};  // other names there
};

// Only settings, apart from `others`.
const Door lists[] = {
    {"docs/cli.md",
     "## `evenlift place`\n",
     "\n### ",
     "`(--[a-z-]+)",
     "\n| `{name} {value}` | {default} | {help} |",
     "has no row for {name}",
     is_option,
     as_option,
     {"--loads", "--failures", "--json", "--candidates", "--svg", "--poses", "--frame",
      "--origin"}},
};

// The records of links; their test checks more than names.
bool is_record(const SettingRow& row) { return row.record != 0; }
const Door described_record{"docs/link-format.md",
                            "| tag |",
                            "\n\n",
                            "\n\\| \\d+ \\| (\\w+)",
                            "\n| {record} | {name} | {needed} | it is {default} |",
                            "has no row for record {record}, {name}",
                            is_record};
const Door read_record{"docs/link_reader.py",
                       "RECORDS = {",
                       "}",
                       "\\d+: .\"(\\w+)\", \\w+.",
                       ", {record}: (\"{name}\", {python})",
                       "has no {record}: (\"{name}\", ...) in RECORDS",
                       is_record};

Names names_at(const Door& door) {
  const std::string part = part_of(door.file, door.begins, door.ends);
  std::string cells;
  for (const std::string& row : table_rows(part)) cells += first_cell(row) + '\n';
  return found(cells.empty() ? part : cells, door.name);
}

std::string replaced(std::string text, const std::string& old, const std::string& by) {
  for (std::size_t at = 0; (at = text.find(old, at)) != std::string::npos; at += by.size())
    text.replace(at, old.size(), by);
  return text;
}

// With what the row says.
std::string filled(std::string pattern, const Door& door, const SettingRow& row) {
  const std::string help(row.option.help.empty() ? row.subject : row.option.help);
  std::string needed = requirement(row.setting);
  needed.erase(0, needed.find("must be ") + 8);
  const bool is_number = row.access.is_number;
  const std::pair<const char*, std::string> values[] = {
      {"{name}", door.called(row)},
      {"{default}", row.access.text({}, row.range)},
      {"{value}", std::string(row.option.value)},
      {"{help}", help},
      {"{needed}", needed},
      {"{record}", std::to_string(row.record)},
      {"{python}", is_number ? "float" : "str"}};
  for (const auto& [name, value] : values) pattern = replaced(pattern, name, value);
  return pattern;
}

// The last setting before it with an entry and a value of the same kind.
const SettingRow& one_before(const SettingRow& row, const Door& door) {
  const SettingRow* before = nullptr;
  for (const SettingRow& other : all_settings()) {
    if (&other == &row) break;
    if (door.goes_through(other) && other.access.is_number == row.access.is_number) before = &other;
  }
  INFO(door.file << " has no entry after which " << row.name << " could stand");
  REQUIRE(before != nullptr);
  return *before;
}

// At the door; in tables, only in first cells.
std::regex entries_of(const SettingRow& row, const Door& door) {
  const std::size_t begin = door.name.find('('), end = door.name.find(')') + 1;
  const std::string name = door.name.substr(0, begin) + door.called(row) + door.name.substr(end);
  return std::regex(name.starts_with('`') ? "\n\\| [^|]*" + name + "(?![a-z_-])" : name);
}

// After each entry of the setting before; as a line, only once.
void add_entry(const Door& door, const SettingRow& row) {
  auto [text_before, part, text_after] = parts_of(door.file, door.begins, door.ends);
  const std::regex entries = entries_of(one_before(row, door), door);
  const std::string entry = filled(door.entry, door, row);
  const bool is_line = entry.starts_with('\n');
  std::string with_it;
  std::smatch match;
  while (std::regex_search(part, match, entries)) {
    std::size_t at = static_cast<std::size_t>(match.position() + match.length());
    if (is_line) at = std::min(part.find('\n', at), part.size());
    with_it += part.substr(0, at) + entry;
    part.erase(0, at);
    if (is_line) break;
  }
  INFO(door.file << " has no place for " << row.name);
  REQUIRE_FALSE(with_it.empty());
  corpus::write_file(root() / door.file, text_before + with_it + part + text_after);
  WARN(door.file << " has a new entry for " << row.name << ": read it, and say more if needed");
}

// Adds it instead, if the expected files are renewed.
void report_lack(const Door& door, const SettingRow& row) {
  static const bool renew = std::getenv("EVENLIFT_UPDATE_EXPECTED") != nullptr;
  if (renew)
    add_entry(door, row);
  else
    FAIL_CHECK(door.file << " " << filled(door.lacks, door, row));
}

// The names that should be there; reports the missing ones.
Names check_names_of_settings(const Door& door, const Names& there) {
  Names due;
  for (const SettingRow& row : all_settings()) {
    if (!door.goes_through(row)) continue;
    const std::string name = door.called(row);
    due.insert(name);
    if (!there.contains(name)) report_lack(door, row);
  }
  return due;
}

// --- The records of links

// By docs/link-format.md: each record's setting, and the reserved numbers.
struct Description {
  std::map<int, std::string> held, reserved;
};

// "12 … 14, 16".
std::vector<int> numbers_in(const std::string& cell) {
  const std::regex range("(\\d+)(?: … (\\d+))?");
  std::vector<int> numbers;
  for (std::sregex_iterator at(cell.begin(), cell.end(), range), end; at != end; ++at) {
    const int first = std::stoi((*at)[1]);
    const int last = (*at)[2].matched ? std::stoi((*at)[2]) : first;
    for (int number = first; number <= last; ++number) numbers.push_back(number);
  }
  return numbers;
}

Description described_records() {
  Description said;
  for (const std::string& row : table_rows(part_of("docs/link-format.md", "| tag |", "\n\n"))) {
    const std::string what = first_cell(row.substr(row.find(" | ") + 3));
    const std::vector<int> numbers = numbers_in(first_cell(row));
    if (!what.starts_with("reserved")) {
      for (const int number : numbers) said.held[number] = what;
      continue;
    }
    std::istringstream names(what.substr(what.find("for ") + 4));
    for (const int number : numbers) std::getline(names >> std::ws, said.reserved[number], ',');
  }
  return said;
}

bool is_of_no_setting(int record) {
  for (const int other : {tag::units, tag::holes, tag::halo, tag::moved, tag::tilt, tag::load})
    if (record == other) return true;
  return false;
}

void check_reserved(const SettingRow& row, int number, const std::string& name) {
  const bool is_its_own = row.name == name;
  if (!is_its_own && row.record != number) return;
  const std::string start =
      "docs/link-format.md reserves record " + std::to_string(number) + " for " + name;
  if (is_its_own && row.record == number)
    FAIL_CHECK(start << ", which has it now and needs a row");
  else
    FAIL_CHECK(start << ", and core/src/document/settings.cpp has record " << int{row.record}
                     << " for " << row.name);
}

}  // namespace

TEST_CASE("every setting stands wherever settings are listed, and nothing else does",
          "[settings][doors]") {
  for (const Door& door : lists) {
    const Names there = names_at(door), due = check_names_of_settings(door, there);
    for (const std::string& name : there)
      if (!due.contains(name) && !door.others.contains(name))
        FAIL_CHECK(door.file << " has " << name << " where no setting of that name belongs");
    for (const std::string& name : door.others)
      if (!there.contains(name))
        FAIL_CHECK(door.file << " has no " << name << " any more, which this test expects");
  }
}

TEST_CASE("every number can be changed in the panels", "[settings][doors]") {
  std::string panels;
  for (const auto& entry : fs::directory_iterator(root() / "wasm/panels"))
    panels += corpus::read_file(entry.path());
  const auto has = [](const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
  };
  for (const SettingRow& row : all_settings()) {
    const std::string name(row.name);
    if (row.access.is_number && !has(panels, "Setting::" + name + ",") &&
        !has(panels, '"' + name + '"'))
      FAIL_CHECK("wasm/panels has no row for Setting::" << name);
  }
}

TEST_CASE("every record of a setting is described under its number, and none that is reserved",
          "[settings][doors][link]") {
  const Description said = described_records();
  const std::string reader = part_of("docs/link_reader.py", "RECORDS = {", "}");
  Names numbers;
  for (const SettingRow& row : all_settings()) {
    for (const auto& [number, name] : said.reserved) check_reserved(row, number, name);
    if (row.record == 0) continue;
    CHECK_FALSE(is_of_no_setting(row.record));
    const std::string number = std::to_string(row.record), name(row.name);
    numbers.insert(number);
    const auto held = said.held.find(row.record);
    if (held == said.held.end() || !std::regex_search(held->second, std::regex("^" + name + "\\b")))
      report_lack(described_record, row);
    if (reader.find(number + ": (\"" + name + "\"") == std::string::npos)
      report_lack(read_record, row);
  }
  for (const auto& [number, what] : said.held)
    if (!numbers.contains(std::to_string(number)) && !is_of_no_setting(number))
      FAIL_CHECK("docs/link-format.md has a record " << number << " that no setting has");
  for (const std::string& number : found(reader, "(\\d+): \\("))
    if (!numbers.contains(number) && !is_of_no_setting(std::stoi(number)))
      FAIL_CHECK("docs/link_reader.py has a record " << number << " that no setting has");
}

TEST_CASE("docs and schema name each quantity that results tell", "[doors][quantities]") {
  const std::string cli = corpus::read_file(root() / "docs/cli.md"),
                    header =
                        corpus::read_file(root() / "core/include/evenlift/output/requirements.h"),
                    schema = corpus::read_file(root() / "native/schema/types.cpp");
  const auto lacks = [](const std::string& text, const std::string& words) {
    return text.find(words) == std::string::npos;
  };
  const std::set<std::string> objects{"loads", "closure", "robustness", "accuracy", "capacity"};
  for (const Quantity& quantity : quantities()) {
    const std::string condition(quantity.condition), json(quantity.json);
    INFO(condition << " " << json << " " << (quantity.label ? quantity.label : ""));
    CHECK((quantity.value || (condition.empty() && json.empty() && quantity.column.empty())));
    CHECK(condition.empty() == quantity.subject.empty());
    CHECK((quantity.label != nullptr) == (quantity.about != nullptr));
    if (quantity.label || quantity.compared) CHECK((quantity.in_words || quantity.value));
    if (const std::size_t dot = json.find('.'); dot != std::string::npos)
      CHECK(objects.contains(json.substr(0, dot)));
    if (!condition.empty() && lacks(cli, "`" + condition + "`"))
      FAIL_CHECK("docs/cli.md has no row for the condition " << condition);
    if (!condition.empty() && lacks(header, "//   " + condition + " "))
      FAIL_CHECK("requirements.h does not explain the condition " << condition);
    if (json.empty()) continue;
    const std::string member = json.substr(json.find('.') + 1);
    if (lacks(schema, "{\"" + member + "\"") && lacks(schema, "{\"" + member + "?\""))
      FAIL_CHECK("native/schema/types.cpp has no member " << json);
  }
}
