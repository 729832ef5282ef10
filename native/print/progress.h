// Shows the progress of a long computation on standard error.
#pragma once

#include <atomic>
#include <cstddef>
#include <future>
#include <mutex>
#include <string>

namespace evenlift::native {

// A progress bar, if standard error is a terminal. Several threads may use it at the same time.
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

// On a terminal, after half a second, shows what is being done and the time since the start: "placing
// the robots: 2.5 s", "placing the robots, shape 312 of 2000: 2.5 s". It shows no percentage, since
// a search may end early. Elsewhere, writes one line after ten seconds. A separate thread does this,
// so that the computation does not have to.
class Waiting {
 public:
  // `what` is text that lasts. Of `total` items, each `of_one`, begin() tells the next.
  explicit Waiting(const char* what, std::size_t total = 0, const char* of_one = "");
  ~Waiting();  // erases the line
  Waiting(const Waiting&) = delete;
  Waiting& operator=(const Waiting&) = delete;

  void now(const char* what) { what_ = what; }
  void begin() { ++begun_; }

 private:
  std::string text(double seconds) const;
  void draw(const std::future<void>& over) const;
  void tell_once(const std::future<void>& over) const;

  std::atomic<const char*> what_;
  std::size_t total_;
  const char* of_one_;
  std::atomic<std::size_t> begun_ = 0;
  std::promise<void> over_;
  std::future<void> drawing_;  // destroyed before over_; its destructor waits for the thread
};

}  // namespace evenlift::native
