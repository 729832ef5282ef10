// The program as scripts use it, or the one that the environment's EVENLIFT_COMMAND names, such as
// "node build/bin/evenlift.js".
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <set>
#include <sstream>

#include "evenlift/output/json_text.h"
#include "kit/corpus.h"
#include "kit/texts.h"

using namespace evenlift;

namespace {

namespace fs = std::filesystem;

// Of tests/cli/cases.txt.
struct Case {
  std::string name;
  std::vector<std::pair<std::string, std::string>> files;  // name, text
  std::string command;                                     // for sh
  std::string expected;                                    // status and the line on standard error
};

std::vector<Case> read_cases(const std::string& text) {
  std::vector<Case> cases;
  std::istringstream lines(text);
  Case current;
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line[0] == '#') continue;
    if (line.rfind("== ", 0) == 0) {
      current = {line.substr(3), {}, "", ""};
    } else if (line.rfind("> ", 0) == 0) {
      current.files.emplace_back(line.substr(2), "");
    } else if (line.rfind("$ ", 0) == 0) {
      current.command = line.substr(2);
      std::getline(lines, current.expected);
      cases.push_back(current);
    } else {
      INFO("a line of no file: " << line);
      REQUIRE_FALSE(current.files.empty());
      current.files.back().second += line + "\n";
    }
  }
  return cases;
}

struct Outcome {
  int status = -1;
  std::string output, errors;
};

class Folder {
 public:
  explicit Folder(const std::string& name)
      : path_(fs::temp_directory_path() /
              ("evenlift-test-" + name + "-" + std::to_string(::getpid()))) {
    fs::create_directories(path_);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

// Runs a line of sh in the folder, where `evenlift` is the program.
Outcome run(const Folder& folder, const std::string& line) {
  const char* other = std::getenv("EVENLIFT_COMMAND");
  const std::string program = other ? other : "'" EVENLIFT_PROGRAM "'";
  const fs::path script = folder.path() / "script.sh";
  corpus::write_file(script, "evenlift() { " + program + " \"$@\"; }\n" + line + "\n");
  const std::string folder_text = folder.path().string();
  const int status =
      std::system(("cd '" + folder_text + "' && sh script.sh > script.out 2> script.err").c_str());
  Outcome outcome;
  outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  outcome.output = corpus::read_file(folder.path() / "script.out");
  outcome.errors = corpus::read_file(folder.path() / "script.err");
  return outcome;
}

const std::string square = "(0,0)\n(4,0)\n(4,4)\n(0,4)\n";

}  // namespace

TEST_CASE("bad usage and bad input get one clear line, and nothing else", "[cli][thorough]") {
  const std::vector<Case> cases =
      read_cases(corpus::read_file(fs::path(EVENLIFT_TESTS_DIR) / "cli" / "cases.txt"));
  REQUIRE(cases.size() >= 40);
  const Folder folder("cases");
  // Another program (EVENLIFT_COMMAND) only reads files, writes and exits in its own way, and Node
  // starts slowly: a third of the cases shows it.
  const std::size_t every = std::getenv("EVENLIFT_COMMAND") ? 3 : 1;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const Case& c = cases[i];
    for (const auto& [name, text] : c.files) corpus::write_file(folder.path() / name, text);
    if (i % every != 0) continue;
    const Outcome outcome = run(folder, c.command);
    INFO(c.name << "\n$ " << c.command);
    CHECK(std::to_string(outcome.status) + " " + outcome.errors == c.expected + "\n");
    CHECK(outcome.output.empty());
  }
}

TEST_CASE("each sentence of the program says what it said", "[cli][expected]") {
  const fs::path path = fs::path(EVENLIFT_TESTS_DIR) / "cli" / "sentences.txt";
  const std::string expected = corpus::read_file(path);
  const Folder folder("sentences");
  fs::create_directory_symlink(corpus::polygons_folder(), folder.path() / "polygons");
  std::set<std::string> known;
  std::string said;
  std::istringstream lines(expected);
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line[0] == '#') said += line + "\n";
    if (!line.starts_with("$ ")) continue;
    said += line + "\n";
    const Outcome outcome = run(folder, line.substr(2));
    if (outcome.status != 0) said += "    [status " + std::to_string(outcome.status) + "]\n";
    std::istringstream output(outcome.output + outcome.errors);
    for (std::string text; std::getline(output, text);)
      for (std::size_t at = 0, next = 0; at < text.size(); at = next) {
        const std::size_t end = text.find(". ", at);
        next = end == std::string::npos ? text.size() : end + 2;
        const std::string sentence = text.substr(at, end == std::string::npos ? end : end + 1 - at);
        if (const std::string kind = testing::without_numbers(sentence);
            !kind.empty() && known.insert(kind).second)
          said += "    " + sentence + "\n";
      }
  }
  if (std::getenv("EVENLIFT_UPDATE_EXPECTED") != nullptr) corpus::write_file(path, said);
  CHECK(said == expected);
}

TEST_CASE("the program answers in all its ways", "[cli][slow]") {
  const Folder folder("answers");
  corpus::write_file(folder.path() / "square.txt", square);
  corpus::write_file(folder.path() / "1.dat", square);
  const auto answers = [&](const std::string& line) {
    const Outcome outcome = run(folder, line);
    INFO("$ " << line);
    CHECK(outcome.status == 0);
    CHECK(outcome.errors.empty());
    CHECK_FALSE(outcome.output.empty());
    return outcome.output;
  };

  CHECK(answers("evenlift --version").rfind("evenlift ", 0) == 0);
  for (const char* command :
       {"place", "trace", "link", "link encode", "link lesson", "link decode", "generate"})
    CHECK(answers("evenlift " + std::string(command) + " --help")
              .find("Usage: evenlift " + std::string(command)) != std::string::npos);
  CHECK(answers("evenlift --help") == answers("evenlift help"));

  SECTION("a lesson becomes a link and comes back, and its task is found in it") {
    const std::string task =
        "title: Hold it\npolygon: square\nrequire: steady\nmove: teams\n[task]\nHold it.\n";
    corpus::write_file(folder.path() / "task.txt", task);
    const std::string link = answers("evenlift link lesson task.txt");
    CHECK(link.starts_with("L1."));
    CHECK(answers("evenlift link lesson - < task.txt") == link);
    CHECK(answers("evenlift link decode " + link) == task);
    CHECK(answers("evenlift link decode \"https://example.org/#1.abc&" +
                  link.substr(0, link.size() - 1) + "\"") == task);
    const Outcome marked =
        run(folder, "evenlift check \"$(evenlift link encode square.txt)\" --task " + link);
    CHECK(marked.errors.empty());
    CHECK(marked.output.find("The task is ") != std::string::npos);
    CHECK(run(folder, "evenlift place " + link).errors.find("the link of a lesson") !=
          std::string::npos);
    CHECK(run(folder, "evenlift link lesson square.txt").status == 2);
  }
  SECTION("FILE is a path, standard input or a link") {
    const std::string expected = answers("evenlift place square.txt --json --teams 2");
    CHECK(answers("evenlift place --json --teams=2 square.txt") == expected);
    CHECK(answers("evenlift place - --json --teams 2 < square.txt") == expected);
    CHECK(answers("evenlift place 1.dat --json --teams 2") == expected);
    CHECK(answers("evenlift place --json --teams 2 -- square.txt") == expected);
    CHECK(answers("evenlift place \"$(evenlift link encode square.txt --teams 2)\" --json") ==
          expected);
    CHECK(answers("evenlift place \"https://example.org/evenlift/#$(evenlift link encode "
                  "square.txt)\" --json --teams 2") == expected);
  }
  SECTION("an option overrides what a link carries") {
    CHECK(answers("evenlift place \"$(evenlift link encode square.txt --metric circle --com 1,2 "
                  "--seed 5)\" --json "
                  "--metric area --com 2,2 --seed 1") ==
          answers("evenlift place square.txt --com 2,2 --json"));
  }
  SECTION("a negative centre of mass is a value, not an option") {
    CHECK(answers("printf '(-4,-4)\\n(4,-4)\\n(0,4)\\n' | evenlift place - --com -.5,-1 --json")
              .find("\"centre_of_mass\": [-0.5, -1]") != std::string::npos);
  }
  SECTION("fewer teams than asked for are no failure") {
    CHECK(answers("evenlift place square.txt --teams 9").find("only 4 of 9 teams") !=
          std::string::npos);
  }
  SECTION("a picture is written beside the result") {
    CHECK(answers("evenlift place square.txt --svg square.svg --json") ==
          answers("evenlift place square.txt --json"));
    CHECK(corpus::read_file(folder.path() / "square.svg").find("</svg>") != std::string::npos);
    CHECK_FALSE(fs::exists(folder.path() / "square.svg.part"));
    CHECK(answers("evenlift place square.txt --svg /dev/stdout").find("</svg>") !=
          std::string::npos);
  }
  SECTION("a trace is an array of steps, or a list to read") {
    const std::string json = answers("evenlift trace square.txt --json --teams 2 --metric circle");
    CHECK(json.rfind("[\n  {\"kind\": \"polygon\", ", 0) == 0);
    CHECK(json.substr(json.size() - 3) == "\n]\n");
    CHECK(answers("evenlift trace \"$(evenlift link encode square.txt --teams 2 --metric circle)\" "
                  "--json") == json);
    CHECK(answers("evenlift trace square.txt").find("\nThe first team\n") != std::string::npos);
  }
  SECTION("what is generated can be placed") {
    CHECK(answers("evenlift generate random --n 60 --seed 3 | evenlift place - --json").front() ==
          '{');
    CHECK(answers("evenlift generate comb").substr(0, 1) == "(");
  }
}

TEST_CASE("several shapes are listed, and one is taken by its number or name", "[cli][slow]") {
  const Folder folder("shapes");
  corpus::write_file(
      folder.path() / "shapes.svg",
      "<svg><rect id='table' width='40' height='20'/><circle id='lid' r='5'/></svg>\n");
  const std::string list =
      "  1  \"table\", rectangle, 4 vertices, 40 x 20\n  2  \"lid\", circle, 64 vertices, 10 x 10\n";
  for (const char* command : {"place", "trace", "link encode"}) {
    const std::string line = "evenlift " + std::string(command) + " shapes.svg";
    Outcome outcome = run(folder, line);
    CHECK(outcome.status == 2);
    CHECK(outcome.errors ==
          "evenlift: shapes.svg: it has 2 shapes; --shape N selects one\n" + list);
    CHECK(outcome.output.empty());
    outcome = run(folder, line + " --shape lad");
    CHECK(outcome.status == 2);
    CHECK(outcome.errors ==
          "evenlift: --shape: expected a number from 1 to 2 or a shape's name, not \"lad\"\n" +
              list);
    const Outcome first = run(folder, line + " --shape 1");
    CHECK(first.status == 0);
    CHECK(first.errors.empty());
    CHECK(first.output == run(folder, line + " --shape table").output);
    CHECK_FALSE(first.output.empty());
    outcome = run(folder, line + " --shape lid");
    CHECK(outcome.status == 0);
    CHECK(outcome.errors ==
          "evenlift: shapes.svg: curves were flattened to within 0.01; --flatten T changes this\n");
    const Outcome finer = run(folder, line + " --shape lid --flatten 0.001");
    CHECK(finer.errors == "evenlift: shapes.svg: curves were flattened to within 0.001\n");
    CHECK(finer.output != outcome.output);
  }
}

TEST_CASE("a file is written at once, beside files of the user that are called alike", "[cli]") {
  const Folder folder("parts");
  corpus::write_file(folder.path() / "square.txt", square);
  corpus::write_file(folder.path() / "a.svg.part", "mine");
  run(folder, "evenlift place square.txt --svg a.svg --poses b.csv");
  CHECK(corpus::read_file(folder.path() / "a.svg.part") == "mine");
  CHECK(corpus::read_file(folder.path() / "a.svg").starts_with("<"));
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder.path()))
    if (entry.path().stem() != "script") names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  CHECK(names == std::vector<std::string>{"a.svg", "a.svg.part", "b.csv", "square.txt"});
}

TEST_CASE("tables name the overloaded robot, and have all columns in every row", "[cli][slow]") {
  const Folder folder("tables");
  corpus::write_file(folder.path() / "square.txt", square);
  const Outcome piano = run(folder, "evenlift place '" EVENLIFT_ASSETS_DIR
                                    "/polygons/grand-piano.txt' --teams 3 --weight 480 "
                                    "--capacity 85");
  CHECK(piano.output.find("86.2      second\n") != std::string::npos);
  CHECK(piano.output.find("73.6       first\n") != std::string::npos);

  const Outcome needed = run(folder,
                             "evenlift place square.txt --supports '0,0 4,0 2,4' --failures "
                             "--com-height 1 --slope 0.1");
  const std::size_t row = needed.output.find("      1        1       no ");
  REQUIRE(row != std::string::npos);
  const std::string cells = needed.output.substr(row, needed.output.find('\n', row) - row);
  CHECK(std::count(cells.begin(), cells.end(), '-') == 9);

  const std::string link = run(folder, "evenlift link encode square.txt").output;
  corpus::write_file(folder.path() / "links.txt", link + link.substr(0, 8) + "\n");
  const std::string csv = run(folder, "evenlift check links.txt --task task-steady --csv").output;
  const auto commas = [&](std::size_t from) {
    return std::count(csv.begin() + static_cast<std::ptrdiff_t>(from),
                      csv.begin() + static_cast<std::ptrdiff_t>(csv.find('\n', from)), ',');
  };
  const std::size_t second = csv.find('\n') + 1, third = csv.find('\n', second) + 1;
  REQUIRE(third < csv.size());
  CHECK(commas(third) == commas(0));  // as many as the headings
  // Lines are those of the file, with remarks and empty lines.
  corpus::write_file(folder.path() / "class.txt", "# 7b\n\n" + link);
  CHECK(run(folder, "evenlift check class.txt --task task-steady --csv").output.find("\n3,") !=
        std::string::npos);
}

TEST_CASE("supports in metres stand on an object in millimetres", "[cli][slow]") {
  const Folder folder("units");
  corpus::write_file(folder.path() / "plate.txt", "(0,0)\n(4000,0)\n(4000,4000)\n(0,4000)\n");
  corpus::write_file(folder.path() / "poses.csv", "x (m),y (m)\n0,0\n4,0\n2,4\n");
  const Outcome outcome =
      run(folder, "evenlift place plate.txt --unit mm --supports poses.csv --json");
  CHECK(outcome.output.find("\"at\": [4000, 0]") != std::string::npos);
}

TEST_CASE("places on an SVG are read with y upward, or with --y-down as in the file", "[cli]") {
  const Folder folder("y-down");
  corpus::write_file(folder.path() / "panel.svg",
                     "<svg xmlns='http://www.w3.org/2000/svg'><path d='M0 0H1722V1134H0Z'/></svg>");
  const std::string place = "evenlift place panel.svg --weight 64 ";
  const Outcome upward =
                    run(folder,
                        place + "--supports '0,0 1722,0 1722,-1134 0,-1134' --cargo 400,-300:38"),
                down = run(
                    folder,
                    place + "--y-down --supports '0,0 1722,0 1722,1134 0,1134' --cargo 400,300:38");
  CHECK(
      upward.errors ==
      "evenlift: panel.svg: places are read and printed with y upward, so (x, y) of the file is (x, -y); "
      "with --y-down they are as in the file\n");
  CHECK(down.errors.empty());
  CHECK(upward.output.find("(1722.0, \u22121134.0)") != std::string::npos);
  CHECK(down.output.find("(1722.0, 1134.0)") != std::string::npos);
  CHECK(down.output.find("Centre of mass                (689.3, 467.5)") != std::string::npos);
  // Links and JSON are evenlift's own.
  for (const std::string format : {"--json", "--failures --json"})
    CHECK(
        run(folder, place + "--supports '0,0 1722,0 1722,-1134 0,-1134' " + format).output ==
        run(folder, place + "--y-down --supports '0,0 1722,0 1722,1134 0,1134' " + format).output);
  const std::string load =
      "evenlift: --cargo: the load at (400, 300) is outside the object; (400, -300) would be "
      "inside: y points up here, and --y-down counts it downward, as the file does\n";
  CHECK(run(folder, place + "--cargo 400,300:38").errors.ends_with(load));
}

TEST_CASE("typed lengths and weights may have units", "[cli][slow]") {
  const Folder folder("units");
  corpus::write_file(folder.path() / "square.txt", square);
  const auto json = [&](const std::string& options) {
    return run(folder, "evenlift place square.txt --json " + options).output;
  };
  const std::pair<const char*, const char*> pairs[] = {
      {"--weight '30 lb'", "--weight 13.6077711"},
      {"--weight-unit lb --weight 30kg", "--weight-unit lb --weight 66.1386787"},
      {"--weight 1e3kg", "--weight 1000"},
      {"--capacity 40lb --extra 2t", "--capacity 18.1436948 --extra 2000"},
      {"--unit mm --com-height 0.6m --slope 8deg", "--unit mm --com-height 600 --slope 8deg"},
      {"--unit cm --com 20mm,1.5 --robot r=1mm,gap=2", "--unit cm --com 2,1.5 --robot r=0.1,gap=2"},
      {"--unit mm --cargo '3,0.2cm:5lb:\"3 kg\"'", "--unit mm --cargo '3,2:2.26796185:\"3 kg\"'"},
      {"--unit m --supports '0,0:5\n400cm,0 2,4'", "--unit m --supports '0,0:5 4,0 2,4'"},
      {"--supports '0,0@40lb:5kg 4,0:a 2,4'", "--supports '0,0@18.1436948:5kg 4,0:a 2,4'"},
      {"--supports '0,0 4,0 2,4' --readings '30kg 20 20lb'",
       "--supports '0,0 4,0 2,4' --readings '30 20 9.0718474'"}};
  for (const auto& [with_units, without] : pairs) {
    INFO(with_units);
    CHECK_FALSE(json(without).empty());
    CHECK(json(with_units) == json(without));
  }
}

TEST_CASE("the option --shape all places every shape, whatever becomes of the others",
          "[cli][slow]") {
  const Folder folder("all-shapes");
  corpus::write_file(folder.path() / "square.txt", square);
  corpus::write_file(folder.path() / "good.svg",
                     "<svg><rect id='table' width='40' height='20'/>"
                     "<rect x='90' width='4' height='4'/></svg>\n");
  corpus::write_file(folder.path() / "mixed.svg",
                     "<svg><rect id='table' width='40' height='20'/>"
                     "<polygon id='crossed' points='90,0 94,4 94,0 90,3'/></svg>\n");
  SECTION("as a table, with a row for each") {
    const Outcome good = run(folder, "evenlift place good.svg --shape all --capacity 15 --teams 3");
    CHECK(good.status == 0);
    CHECK(good.errors.empty());
    CHECK(
        good.output ==
        "  shape       name         size  weight  robots  greatest load  least load  coverage    use  held  overloaded  verdict\n"
        "      1      table  40.0 x 20.0     100       6           16.7        16.7     100\u00A0%  112\u00A0%    no           6      bad\n"
        "      2  rectangle    4.0 x 4.0     100       6           16.7        16.7     100\u00A0%  112\u00A0%    no           6      bad\n");
    // Without a number, each part gets the one that it needs.
    CHECK(run(folder, "evenlift place good.svg --shape all --capacity 15")
              .output.find("      1      table  40.0 x 20.0     100       8           12.5") !=
          std::string::npos);
    const Outcome mixed = run(folder, "evenlift place mixed.svg --shape all");
    CHECK(mixed.status == 2);
    CHECK(mixed.errors == "evenlift: mixed.svg: 1 of 2 shapes was refused\n");
    CHECK(mixed.output.find(
              "      2  crossed    4.0 x 4.0     100  Edges 1 and 3 cross, touch or overlap\n") !=
          std::string::npos);
    const Outcome falls = run(folder, "evenlift place square.txt --shape all --supports '0,0 1,0'");
    CHECK(falls.status == 0);
    CHECK(
        falls.output.find(
            "      1  polygon  4.00 x 4.00     100       2              -           -         -     -      bad\n") !=
        std::string::npos);
  }
  SECTION("with ranges, whose greatest end it shows") {
    const Outcome ranges = run(folder, "evenlift place '" EVENLIFT_ASSETS_DIR
                                       "/polygons/grand-piano.txt' --shape all --weight 480 "
                                       "--com-radius 20");
    CHECK(ranges.output.find(" 93.5        65.4 ") != std::string::npos);
  }
  SECTION("the coarsest of their tolerances is told") {
    corpus::write_file(
        folder.path() / "curves.svg",
        "<svg><circle r='5'/><circle cx='90' r='50'/><circle cx='300' r='5'/></svg>\n");
    CHECK(run(folder, "evenlift place curves.svg --shape all").errors.find("within 0.1;") !=
          std::string::npos);
  }
  SECTION("as JSON, with a line for each that is the result of this shape alone") {
    const std::string options = " --json --candidates --require 'coverage>=0.5'";
    const Outcome lines = run(folder, "evenlift place mixed.svg --shape all" + options);
    CHECK(lines.status == 2);
    const std::size_t end = lines.output.find('\n');
    Outcome alone = run(folder, "evenlift place mixed.svg --shape 1" + options);
    std::string expected = json::on_one_line(alone.output);
    expected.insert(
        1, R"("shape": 1, "name": "table", "at": [20, -10], "size": [40, 20], "area": 800, )");
    CHECK(lines.output.substr(0, end) == expected);
    CHECK(lines.output.substr(end + 1) ==
          R"({"shape": 2, "name": "crossed", "at": [92, -2], "size": [4, 4], "area": 0, )"
          R"("error": {"code": "edges_cross", )"
          R"("message": "Edges 1 and 3 cross, touch or overlap", "place": {"edges": [0, 2]}, )"
          R"("path": "polygon[0]"}})"
          "\n");
    CHECK(run(folder,
              "evenlift place mixed.svg --shape all --json | head -n 1 > line.json; "
              "evenlift place line.json --json")
              .output == run(folder, "evenlift place mixed.svg --shape 1 --json").output);
  }
  SECTION("a condition that a shape does not keep is a status of its own") {
    const Outcome outcome = run(folder, "evenlift place good.svg --shape all --require held");
    CHECK(outcome.status == 3);
    CHECK(outcome.errors.empty());
    CHECK(outcome.output.find("held  kept  verdict\n") != std::string::npos);
    CHECK(run(folder, "evenlift place good.svg --shape all --require stands").status == 0);
    CHECK(run(folder, "evenlift place mixed.svg --shape all --require held").status == 2);
  }
  SECTION("a drawing of which much stays open is not asked about") {
    corpus::write_file(folder.path() / "open.svg",
                       "<svg stroke='black'><circle cx='60' cy='40' r='5'/>"
                       "<path d='M0 0H120V80H0'/><path d='M0 80L-9 90'/></svg>\n");
    CHECK(run(folder, "evenlift place open.svg").status == 2);
    CHECK(run(folder, "evenlift place open.svg --shape all").status == 0);
  }
}

TEST_CASE("the option --project converts degrees to metres and says so", "[cli]") {
  const Folder folder("degrees");
  corpus::write_file(folder.path() / "field.csv",
                     "lon,lat\n8.5412,47.3765\n8.5422,47.3765\n8.5422,47.3773\n8.5412,47.3773\n");
  const Outcome plain = run(folder, "evenlift place field.csv --json");
  CHECK(plain.errors.find("degrees of longitude and latitude, not lengths") != std::string::npos);
  CHECK(plain.errors.find("evenlift: field.csv: --project converts degrees to metres\n") !=
        std::string::npos);
  const Outcome projected = run(folder, "evenlift place field.csv --project --json");
  CHECK(projected.errors ==
        "evenlift: field.csv: the coordinates were converted from degrees to metres east and north "
        "of 8.5417\u00B0 E, 47.3769\u00B0 N\n");
  CHECK(projected.output.find("\"unit\": \"m\"") != std::string::npos);
  CHECK(run(folder, "evenlift place field.csv --project --shape all --unit m").status == 0);
  const Outcome relabelled = run(folder, "evenlift place field.csv --project --unit mm");
  CHECK(relabelled.status == 2);
  CHECK(relabelled.errors.find("evenlift: --unit: coordinates are in m with --project\n") !=
        std::string::npos);
}

TEST_CASE("tables have each number under its heading, in columns as wide as their characters",
          "[cli]") {
  const Folder folder("tables");
  corpus::write_file(folder.path() / "square.txt", square);
  const auto shows = [&](const std::string& options, const std::string& rows) {
    const Outcome outcome = run(folder, "evenlift place square.txt" + options);
    INFO(outcome.output);
    CHECK(outcome.output.find("\n" + rows + "\n") != std::string::npos);
  };
  // A range of loads has 9 characters in 11 bytes.
  shows(" --com-radius 0.1",
        "  team  ratio        robot at       load        robot at       load\n"
        "     1  1.000  (0.000, 4.000)  15.1–18.2  (4.000, 0.000)  15.1–18.2");
  // The others' loads by plan, by springs and at best.
  shows(
      " --com 1.9,2 --min-ratio 0.5 --failures",
      "  fails  of team  carried  steady  tipping distance  coverage  form closure  by plan  springs  best\n"
      "      1        1      yes     yes             0.884    73.8\u00A0%            no     26.3     30.6  25.7");
}

TEST_CASE("a result is a document: it opens again with all its settings", "[cli]") {
  const Folder folder("results");
  corpus::write_file(folder.path() / "square.txt", square);
  const std::string options =
      " --metric random --seed 18446744073709551615 --weight 7 --teams 2 --capacity 3 --json";
  const Outcome first = run(folder, "evenlift place square.txt" + options + " > result.json");
  CHECK(first.status == 0);
  const Outcome again = run(folder, "evenlift place result.json --json");
  CHECK(again.errors.empty());
  CHECK(again.output == corpus::read_file(folder.path() / "result.json"));
  const Outcome link =
      run(folder,
          "evenlift link decode \"$(evenlift link encode result.json)\" > link.json; "
          "evenlift place link.json --capacity 3 --json");
  CHECK(link.output == again.output);
}

TEST_CASE(
    "a picture that cannot be written is a failure of its own, and leaves things as they were",
    "[cli]") {
  const Folder folder("picture");
  corpus::write_file(folder.path() / "square.txt", square);
  corpus::write_file(folder.path() / "before.svg", "before");
  fs::create_directory(folder.path() / "folder");
  for (const char* line :
       {"evenlift place square.txt --svg missing/a.svg", "evenlift place square.txt --svg folder",
        "evenlift place square.txt --json --svg /dev/full"}) {
    const Outcome outcome = run(folder, line);
    INFO("$ " << line << "\n" << outcome.errors);
    CHECK(outcome.status == 1);
    CHECK(outcome.output.empty());
    CHECK(outcome.errors.rfind("evenlift: ", 0) == 0);
    CHECK(std::count(outcome.errors.begin(), outcome.errors.end(), '\n') == 1);
  }
  run(folder, "evenlift place square.txt --teams 0 --svg before.svg");
  CHECK(corpus::read_file(folder.path() / "before.svg") == "before");
}

TEST_CASE("output that nothing reads is no crash", "[cli][slow]") {
  const Folder folder("pipe");
  const Outcome broken =
      run(folder, "evenlift generate star --n 100000 | head -c 100 > /dev/null; echo done");
  CHECK(broken.status == 0);
  CHECK(broken.output == "done\n");
  CHECK(broken.errors.empty());
  const Outcome full = run(folder, "evenlift generate star --n 1000 > /dev/full");
  CHECK(full.status == 1);
  CHECK(full.errors == "evenlift: standard output: no space left on device\n");
}

TEST_CASE("bytes that are no text are refused, not misread", "[cli]") {
  const Folder folder("bytes");
  std::string bytes;
  for (int i = 0; i < 4096; ++i) bytes += static_cast<char>((i * 73 + i / 256) & 255);
  corpus::write_file(folder.path() / "noise", bytes);
  for (const char* line :
       {"evenlift place noise", "evenlift place - < noise", "evenlift link encode noise"}) {
    const Outcome outcome = run(folder, line);
    INFO("$ " << line << "\n" << outcome.errors);
    CHECK(outcome.status == 2);
    CHECK(outcome.output.empty());
    CHECK(std::count(outcome.errors.begin(), outcome.errors.end(), '\n') == 1);
  }
}

TEST_CASE("parts of a sheet have their own weights, numbers of robots and names", "[cli][slow]") {
  const Folder folder("sheet");
  const std::string sheet = " '" +
                            std::filesystem::path(EVENLIFT_TESTS_DIR).parent_path().string() +
                            "/examples/sheet/sheet.dxf' --shape all ";
  const std::string steel = sheet + "--thickness 8 --density 7850/m3 --capacity 0.25";
  const Outcome table = run(folder, "evenlift place" + steel + " --csv parts.csv");
  CHECK(table.status == 0);
  const std::string csv = corpus::read_file(folder.path() / "parts.csv");
  std::istringstream lines(csv);
  std::string line;
  std::set<std::string> names;
  std::getline(lines, line);
  CHECK(line.starts_with("shape,name,x,y,width,height,area,weight,robots,greatest_load,"));
  std::size_t number = 0;
  while (std::getline(lines, line)) {
    std::vector<std::string> cells;
    std::istringstream row(line);
    for (std::string cell; std::getline(row, cell, ',');) cells.push_back(cell);
    // In the order of the file, named by their texts.
    std::string name = "P" + std::to_string(++number);
    while (name.size() < 4) name.insert(1, "0");
    CHECK(cells[1] == name);
    names.insert(cells[1]);
    CHECK(std::stod(cells[7]) == Approx(std::stod(cells[6]) * 8 * 7850e-9));
    CHECK(std::stod(cells[9]) <= 0.25 * (1 + 1e-9));
  }
  CHECK(names.size() == 200);
  SECTION("also with the density's unit of weight, but a bare one is of the drawing's unit") {
    const auto output = [&](const std::string& density) {
      return run(folder,
                 "evenlift place" + sheet + "--thickness 8 --capacity 0.25 --density " + density);
    };
    CHECK(output("'7850 kg/m³'").output == table.output);
    CHECK(output("'7850kg/m3'").errors == table.errors);
    const std::string bare = output("7.85e-6").errors;
    CHECK(bare.find(
              "evenlift: --density: this was read as 7.85e-6/mm3, in the unit of the coordinates; "
              "7.85e-6/m3 is another weight\n") != std::string::npos);
  }
  SECTION("and the row says if no number of robots is enough") {
    run(folder, "evenlift place" + sheet +
                    "--thickness 8 --density 7850/m3 --capacity "
                    "0.02 --csv few.csv");
    CHECK(corpus::read_file(folder.path() / "few.csv").find("can be placed are too few.") !=
          std::string::npos);
  }
  SECTION("and the same bytes for any number of threads") {
    const std::string one = run(folder, "evenlift place" + steel + " --json --jobs 1").output;
    CHECK(std::count(one.begin(), one.end(), '\n') == 200);
    CHECK(one.starts_with(R"({"shape": )"));
    CHECK(run(folder, "evenlift place" + steel + " --json --jobs 3").output == one);
  }
  SECTION("which rows may be sorted by") {
    for (const auto& [column, at] : {std::pair("area", 6), {"weight", 7}, {"load", 9}}) {
      run(folder, "evenlift place" + steel + " --csv sorted.csv --sort " + column);
      std::istringstream rows(corpus::read_file(folder.path() / "sorted.csv"));
      std::getline(rows, line);
      double before = std::numeric_limits<double>::infinity();
      while (std::getline(rows, line)) {
        std::istringstream row(line);
        std::string cell;
        for (int i = 0; i <= at; ++i) std::getline(row, cell, ',');
        CHECK(std::stod(cell) <= before);
        before = std::stod(cell);
      }
    }
  }
}
