// The progress of a long computation, on standard error if that is a terminal.
#pragma once

#include <cstddef>
#include <future>
#include <mutex>
#include <string>

namespace evenlift::native {

// A bar; safe for several threads.
class Progress {
 public:
  explicit Progress(std::size_t total);
  ~Progress();  // erases the bar
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // Counts a finished polygon, and shows its name.
  void done(const std::string& name);

 private:
  void draw(const std::string& name) const;

  bool shown_;
  std::size_t total_, done_ = 0;
  std::mutex mutex_;
};

// After half a second, shows the running task's name and time so far, but no share, since a search
// may end before its total. A separate thread draws, so the computation is independent of it.
class Waiting {
 public:
  explicit Waiting(std::string what);
  ~Waiting();  // erases the line
  Waiting(const Waiting&) = delete;
  Waiting& operator=(const Waiting&) = delete;

 private:
  std::promise<void> over_;
  std::future<void> drawing_;  // destroyed first, which waits for the thread
};

}  // namespace evenlift::native
