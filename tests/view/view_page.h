// A page without a window: Dear ImGui draws into nothing, and the pointer is simulated.
#pragma once

#include <imgui.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "actions/actions.h"
#include "app/app.h"
#include "app/update.h"
#include "edits/undo.h"
#include "evenlift/formats.h"
#include "evenlift/settings.h"
#include "kit/catch.h"
#include "state/derived.h"
#include "ui/theme.h"
#include "walkthrough/walkthrough.h"

namespace view_page {

using namespace evenlift;
using namespace evenlift::view;

inline Document document(const std::string& text) {
  Result<Document> read = read_polygon(text);
  REQUIRE(read.ok());
  return *read;
}

// As opening it does.
inline Opened placed(const Document& document) {
  Result<Opened> result = opened(document);
  REQUIRE(result.ok());
  return std::move(result).value();
}

inline const std::string l_shape = "(0,0)\n(400,0)\n(400,150)\n(150,150)\n(150,300)\n(0,300)\n";

inline std::string asset(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

inline std::vector<std::filesystem::path> assets() {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(EVENLIFT_ASSETS_DIR "/polygons")) {
    if (entry.path().extension() == ".txt" && entry.path().stem() != "index")
      paths.push_back(entry.path());
  }
  REQUIRE(paths.size() > 10);
  return paths;
}

// As a control or key would.
inline void give(AppState& state, Command command) {
  Commands commands;
  commands.push_back(std::move(command));
  apply(state, commands);
}

inline void begin(AppState& state, Opened opened) {
  start_with(state, std::move(opened), std::nullopt);
  conclude(state);
}

// It may be refused, as from a script.
inline std::optional<InputError> edit_by_script(AppState& state, const Document& edited) {
  auto problem = try_edit(state, edited);
  conclude(state);
  return problem;
}

// Whether the page accepts the robots that a search found, or the message that it stopped.
inline bool take_robots(AppState& state, std::uint64_t number, std::optional<std::string> robots,
                        bool ended = true) {
  state.session.effects.clear();
  give(state, TakeRobots{number, std::move(robots), ended});
  return std::any_of(
      state.session.effects.begin(), state.session.effects.end(),
      [](const Effect& effect) { return std::holds_alternative<SummaryChanged>(effect); });
}

class Page {
 public:
  explicit Page(const std::string& text = l_shape) {
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    load_fonts(1);
    unsigned char* pixels = nullptr;
    int width = 0, height = 0;
    io.Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
    begin(app.state, placed(document(text)));
  }
  ~Page() { ImGui::DestroyContext(); }
  Page(const Page&) = delete;
  Page& operator=(const Page&) = delete;

  void frame(const Pointer& pointer = {}) {
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = ImVec2(static_cast<float>(app.state.session.screen.width),
                            static_cast<float>(app.state.session.screen.height));
    io.DeltaTime = 1.0f / 60;
    ImGui::NewFrame();
    advance(app, pointer, ImGui::GetTime());
    const Commands asked = draw_frame(app);
    app.commands.insert(app.commands.end(), asked.begin(), asked.end());
    ImGui::Render();
    settle(app);
  }

  Pointer at(const Vec2& world) const {
    Pointer p;
    p.at = app.state.view.camera.to_screen(world);
    p.present = true;
    return p;
  }

  void click(const Vec2& world) {
    Pointer p = at(world);
    p.pressed = p.down = true;
    frame(p);
    p.pressed = p.down = false;
    p.released = true;
    frame(p);
  }

  // `off` leads to a second drawing of the polygon, in CSS pixels.
  void drag(const Vec2& from, const Vec2& to, const Vec2& off = Vec2{}) {
    Pointer p = at(from);
    p.at += off;
    frame(p);
    p.pressed = p.down = true;
    frame(p);
    p.pressed = false;
    const Vec2 start = p.at, end = app.state.view.camera.to_screen(to) + off;
    for (int i = 1; i <= 4; ++i) {
      p.at = start + (end - start) * i / 4;
      p.moved = length(p.at - start);
      frame(p);
    }
    p.down = false;
    p.released = true;
    frame(p);
  }

  void open(const Document& document) {
    app.commands.push_back(OpenDocument{placed(document)});
    settle(app);
  }

  void press(const view::Key& key) {
    const Action* found = action_for(app.state, key);
    REQUIRE(found != nullptr);
    found->run(app.state, app.commands);
    settle(app);
  }

  App app;
};

// As a script would. It must not be refused.
inline void set(Page& page, const std::string& name, const std::string& text) {
  Document changed = page.app.state.work.document();
  const auto setting = setting_from_name(name);
  REQUIRE(setting);
  REQUIRE_FALSE(read_setting(*setting, text, changed));
  REQUIRE_FALSE(edit_by_script(page.app.state, changed));
}

// A page, and what it wrote at the last look.
class RecordedPage {
 public:
  RecordedPage() { record_texts(&drawn_); }
  ~RecordedPage() { record_texts(nullptr); }
  RecordedPage(const RecordedPage&) = delete;
  RecordedPage& operator=(const RecordedPage&) = delete;

  const std::vector<DrawnText>& look(const Pointer& pointer = {}) {
    // Cards get their size from the last frame.
    for (int frame = 0; frame < 3; ++frame) {
      drawn_.clear();
      page.frame(pointer);
    }
    return drawn_;
  }

  AppState& state() { return page.app.state; }

  // Goes through all steps of the method.
  template <class See>
  void walk(Method method, See see) {
    give(state(), SetMethod{method});
    page.press({"b"});
    page.press({"u"});
    const std::uint32_t count = timeline(state()).count;
    for (std::uint32_t step = 0; step < count; ++step) {
      give(state(), GoToStep{step});
      see(step);
    }
    page.press({"b"});
  }

  Page page;

 private:
  std::vector<DrawnText> drawn_;
};

}  // namespace view_page
