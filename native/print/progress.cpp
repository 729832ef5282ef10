#include "print/progress.h"

#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <system_error>
#include <utility>

namespace evenlift::native {
namespace {

constexpr const char* erase_line = "\r\x1b[K";

// Under Node, Emscripten reports every pipe as a terminal, so nothing is drawn there.
bool on_terminal() {
#ifdef __EMSCRIPTEN__
  return false;
#else
  const char* kind = std::getenv("TERM");
  return isatty(STDERR_FILENO) == 1 && !(kind && std::string_view(kind) == "dumb");
#endif
}

#ifndef __EMSCRIPTEN__
void draw_seconds(const std::string& what, const std::future<void>& over) {
  using namespace std::chrono;
  const steady_clock::time_point start = steady_clock::now();
  bool drawn = false;
  while (over.wait_for(milliseconds(500)) != std::future_status::ready) {
    const duration<double> seconds = steady_clock::now() - start;
    std::fprintf(stderr, "%s%s: %.1f s", erase_line, what.c_str(), seconds.count());
    drawn = true;
  }
  if (drawn) std::fputs(erase_line, stderr);
}
#endif

}  // namespace

Progress::Progress(std::size_t total) : shown_(on_terminal()), total_(total) { draw(""); }

Progress::~Progress() {
  if (shown_) std::fputs(erase_line, stderr);
}

void Progress::done(const std::string& name) {
  const std::lock_guard<std::mutex> lock(mutex_);
  ++done_;
  draw(name);
}

// Fits into 80 columns.
void Progress::draw(const std::string& name) const {
  if (!shown_) return;
  constexpr std::size_t width = 30;
  const std::size_t filled = total_ == 0 ? width : width * done_ / total_;
  std::string shown = name.substr(0, 28);
  for (char& c : shown)
    if (static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) >= 0x7f) c = '?';
  std::fprintf(stderr, "%s[%s%s] %zu/%zu %s", erase_line, std::string(filled, '#').c_str(),
               std::string(width - filled, '.').c_str(), done_, total_, shown.c_str());
  std::fflush(stderr);
}

#ifdef __EMSCRIPTEN__
Waiting::Waiting(std::string) {}  // it has no threads
#else
Waiting::Waiting(std::string what) {
  if (!on_terminal()) return;
  try {
    drawing_ = std::async(std::launch::async, draw_seconds, std::move(what), over_.get_future());
  } catch (const std::system_error&) {
    // Without another thread, the work continues without the line.
  }
}
#endif

Waiting::~Waiting() { over_.set_value(); }

}  // namespace evenlift::native
