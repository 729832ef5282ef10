// Shows the progress of a long computation on standard error, if that is a terminal.
#pragma once

#include <cstddef>
#include <future>
#include <mutex>
#include <string>

namespace evenlift::native {

// A progress bar. Several threads may use it at the same time.
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

// After half a second, shows the name of the running task and the time since its start. It shows no
// percentage, since a search may end early. A separate thread draws this line, so that the
// computation does not have to.
class Waiting {
 public:
  explicit Waiting(std::string what);
  ~Waiting();  // erases the line
  Waiting(const Waiting&) = delete;
  Waiting& operator=(const Waiting&) = delete;

 private:
  std::promise<void> over_;
  std::future<void> drawing_;  // destroyed before over_; its destructor waits for the thread
};

}  // namespace evenlift::native
