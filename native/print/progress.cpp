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

Waiting::Waiting(const char* what, std::size_t total, const char* of_one)
    : what_(what), total_(total), of_one_(of_one) {
#ifndef __EMSCRIPTEN__  // which has no threads
  const bool draws = on_terminal();
  try {
    drawing_ = std::async(std::launch::async, [this, draws, over = over_.get_future()] {
      draws ? draw(over) : tell_once(over);
    });
  } catch (const std::system_error&) {
    // Without another thread, the work continues without the line.
  }
#endif
}

Waiting::~Waiting() { over_.set_value(); }

std::string Waiting::text(double seconds) const {
  char time[32];
  std::snprintf(time, sizeof time, ": %.1f s", seconds);
  std::string text = what_.load();
  if (total_ > 0)
    text += std::string(", ") + of_one_ + " " + std::to_string(begun_) + " of " +
            std::to_string(total_);
  return text + time;
}

void Waiting::draw(const std::future<void>& over) const {
  using namespace std::chrono;
  const steady_clock::time_point start = steady_clock::now();
  bool drawn = false;
  while (over.wait_for(milliseconds(500)) != std::future_status::ready) {
    const duration<double> seconds = steady_clock::now() - start;
    std::fprintf(stderr, "%s%s", erase_line, text(seconds.count()).c_str());
    drawn = true;
  }
  if (drawn) std::fputs(erase_line, stderr);
}

void Waiting::tell_once(const std::future<void>& over) const {
  constexpr std::chrono::seconds patience(10);
  if (over.wait_for(patience) == std::future_status::ready) return;
  std::fprintf(stderr, "evenlift: %s so far\n", text(10).c_str());
}

}  // namespace evenlift::native
