// The page in German: nothing on it stays English, and each text has room.
#include <nlohmann/json.hpp>

#include <fstream>
#include <map>
#include <set>
#include <string>

#include "evenlift/wording.h"
#include "kit/catch.h"
#include "panels/summary.h"
#include "ui/controls.h"
#include "ui/drawn_texts.h"
#include "view/view_page.h"
#include "walkthrough/timeline.h"

using namespace evenlift;
using namespace evenlift::view;
using namespace view_page;

namespace {

std::map<std::string, std::string> german() {
  std::ifstream file(EVENLIFT_ASSETS_DIR "/words/de.json");
  return nlohmann::json::parse(file).get<std::map<std::string, std::string>>();
}

// A page whose words are German, and what it wrote.
class GermanPage {
 public:
  GermanPage() {
    for (const auto& [english, other] : german()) add_translation(english, other);
    record_texts(&drawn);
  }
  ~GermanPage() {
    record_texts(nullptr);
    forget_translations();
  }
  GermanPage(const GermanPage&) = delete;
  GermanPage& operator=(const GermanPage&) = delete;

  // Draws, and looks at all that was written.
  void look() {
    // Cards take their size from the frame before.
    for (int frame = 0; frame < 3; ++frame) {
      drawn.clear();
      page.frame();
    }
    for (const DrawnText& text : drawn) (text.has_room ? seen : cut).insert(text.text);
    for (const Control& control : controls()) seen.insert(control.label);
    for (const std::string& text : {summary(page.app.state), news(page.app.state)})
      seen.insert(text);
  }

  std::vector<DrawnText> drawn;
  std::set<std::string> seen, cut;
  Page page;
};

// Words that German sentences do not have.
bool is_english(const std::string& text) {
  const std::string padded = ' ' + text + ' ';
  for (const char* word :
       {" the ", " The ", " of ", " and ", " is ", " are ", " to ", " with ", " without ", " at ",
        " robots", " from ", " by ", " edge ", " or ", " no ", " No "})
    if (padded.find(word) != std::string::npos) return true;
  return false;
}

std::string list(const std::set<std::string>& texts) {
  std::string all;
  for (const std::string& text : texts) all += "\n  " + text;
  return all;
}

void check(const GermanPage& german) {
  std::set<std::string> english;
  for (const std::string& text : german.seen)
    if (is_english(text)) english.insert(text);
  INFO("English:" << list(english));
  CHECK(english.empty());
  INFO("Without room:" << list(german.cut));
  CHECK(german.cut.empty());
}

}  // namespace

TEST_CASE("the German page has no English words, and room for all", "[words][view]") {
  GermanPage german;
  AppState& state = german.page.app.state;
  for (bool View::*section :
       {&View::more_open, &View::robot_open, &View::carrying_open, &View::formal_open})
    give(state, SetSectionOpen{section, true});
  struct Size {
    int width, height;
  };
  for (const Size& size : {Size{1280, 800}, Size{390, 844}}) {
    state.session.screen.width = size.width;
    state.session.screen.height = size.height;
    for (const Method method : {Method::area, Method::circle, Method::distance, Method::random,
                                Method::distributed, Method::balanced, Method::given}) {
      give(state, SetMethod{method});
      german.look();
      for (const LoadModel model : all_load_models) {
        give(state, SetLoadModel{model});
        german.look();
      }
      give(state, SetLoadModel{LoadModel::plan});
      give(state, Fail{1});
      german.look();
      give(state, Fail{});
    }
    for (const Tool tool :
         {Tool::draw, Tool::transform, Tool::mark, Tool::robot, Tool::hole, Tool::weight}) {
      give(state, SetTool{tool});
      german.look();
      give(state, SetTool{Tool::parts});
    }
    give(state, Compare{Method::circle});
    german.look();
    give(state, Compare{});
  }
  check(german);
}

TEST_CASE("every step of the German walkthrough is German", "[words][lesson]") {
  GermanPage german;
  AppState& state = german.page.app.state;
  for (const Method method : {Method::area, Method::circle, Method::distance, Method::random,
                              Method::distributed, Method::balanced, Method::given}) {
    give(state, SetMethod{method});
    german.page.press({"b"});
    german.page.press({"u"});
    const std::uint32_t count = timeline(state).count;
    for (std::uint32_t step = 0; step < count; ++step) {
      give(state, GoToStep{step});
      german.look();
    }
    german.page.press({"b"});
  }
  check(german);
}

TEST_CASE("what the German page says of samples is German", "[words][view][thorough]") {
  GermanPage german;
  for (const auto& path : assets()) {
    INFO(path.string());
    german.page.open(document(asset(path)));
    german.look();
  }
  check(german);
}
