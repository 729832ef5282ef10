// Nothing stays English, and each text has room.

#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <string>

#include "evenlift/wording.h"
#include "kit/catch.h"
#include "kit/json.h"
#include "panels/summary.h"
#include "ui/controls.h"
#include "ui/theme.h"
#include "view/view_page.h"
#include "walkthrough/walkthrough.h"

using namespace evenlift;
using namespace evenlift::view;
using namespace view_page;

namespace {

std::map<std::string, std::string> german() {
  std::ifstream file(EVENLIFT_ASSETS_DIR "/words/de.json");
  const auto read = testing::Json::parse({std::istreambuf_iterator<char>(file), {}});
  std::map<std::string, std::string> words;
  for (const std::string& english : read.names()) words[english] = read[english].text();
  return words;
}

// A page in a language, and what it wrote at each look.
class SpokenPage : public RecordedPage {
 public:
  explicit SpokenPage(const std::map<std::string, std::string>& words) {
    for (const auto& [english, other] : words) add_translation(english, other);
  }
  ~SpokenPage() { forget_translations(); }

  // Draws, and looks at what was written.
  void look() {
    std::set<std::string> without_room;
    for (const DrawnText& text : RecordedPage::look()) {
      seen.insert(text.text);
      // A press shows all of the verdict.
      const Verdict told = verdict(page.app.state, Words::in_panel);
      if (!text.has_room && text.text != told.detail && text.text != told.headline)
        without_room.insert(text.text);
    }
    for (const Control& control : controls()) seen.insert(control.label);
    for (const std::string& text : {summary(page.app.state), news(page.app.state)})
      seen.insert(text);
    cut.push_back(std::move(without_room));
  }

  std::set<std::string> seen;
  std::vector<std::set<std::string>> cut;  // at each look
};

// By words that German sentences lack.
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

// Looks at the same in German and English. The verdict may be cut by "…" for lack of room, but not
// only in German.
void check(void (*walk)(SpokenPage&)) {
  std::vector<std::set<std::string>> cut_in_english;
  {
    SpokenPage page({});
    walk(page);
    cut_in_english = page.cut;
  }
  SpokenPage page(german());
  walk(page);
  std::set<std::string> english, cut;
  for (const std::string& text : page.seen)
    if (is_english(text)) english.insert(text);
  INFO("English:" << list(english));
  CHECK(english.empty());
  REQUIRE(page.cut.size() == cut_in_english.size());
  for (std::size_t look = 0; look < page.cut.size(); ++look)
    if (cut_in_english[look].empty()) cut.insert(page.cut[look].begin(), page.cut[look].end());
  INFO("Without room:" << list(cut));
  CHECK(cut.empty());
}

void walk_through_settings(SpokenPage& page) {
  give(page.state(), SetSectionOpen{&View::formal_open, true});
  for (std::size_t i = 0; i < drawer_count; ++i)
    give(page.state(), SetDrawerOpen{static_cast<Drawer>(i), true});
  struct Size {
    int width, height;
  };
  for (const Size& size : {Size{1280, 800}, Size{390, 844}}) {
    page.state().session.screen.width = size.width;
    page.state().session.screen.height = size.height;
    for (const Method method : all_methods) {
      give(page.state(), SetMethod{method});
      page.look();
      for (const LoadModel model : all_load_models) {
        give(page.state(), SetLoadModel{model});
        page.look();
      }
      give(page.state(), SetLoadModel{LoadModel::plan});
      give(page.state(), Fail{1});
      page.look();
      give(page.state(), Fail{});
    }
    for (const Tool tool :
         {Tool::draw, Tool::transform, Tool::mark, Tool::robot, Tool::hole, Tool::weight}) {
      give(page.state(), SetTool{tool});
      page.look();
      give(page.state(), SetTool{Tool::parts});
    }
    give(page.state(), Compare{Method::circle});
    page.look();
    give(page.state(), Compare{});
  }
}

void walk_through_steps(SpokenPage& page) {
  for (const Method method : all_methods) page.walk(method, [&](std::uint32_t) { page.look(); });
}

void walk_through_samples(SpokenPage& page) {
  for (const auto& path : assets()) {
    page.page.open(document(asset(path)));
    page.look();
  }
}

}  // namespace

TEST_CASE("the German page has no English words, and room for all", "[words][view]") {
  check(walk_through_settings);
}

TEST_CASE("every step of the German walkthrough is German", "[words][lesson]") {
  check(walk_through_steps);
}

TEST_CASE("what the German page says of samples is German", "[words][view][thorough]") {
  check(walk_through_samples);
}
