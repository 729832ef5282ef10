// How far a long computation is, on a terminal.
#pragma once

#include <cstddef>
#include <future>
#include <mutex>
#include <string>

namespace evenlift::native {

// Draws on standard error if that is a terminal, else does nothing. Safe for several threads.
class Progress {
 public:
  explicit Progress(std::size_t total);
  ~Progress();  // takes the bar away
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // Counts one more polygon as done, and shows its name.
  void done(const std::string& name);

 private:
  void draw(const std::string& name) const;

  bool shown_;
  std::size_t total_, done_ = 0;
  std::mutex mutex_;
};

// From half a second on says on standard error what takes so long, and for how long, if that is a
// terminal. A search has no total that it is sure to reach, so there is no share. A thread of its
// own draws: what is computed need not know of it, and is the same without.
class Waiting {
 public:
  explicit Waiting(std::string what);
  ~Waiting();  // takes the line away
  Waiting(const Waiting&) = delete;
  Waiting& operator=(const Waiting&) = delete;

 private:
  std::promise<void> over_;
  std::future<void> drawing_;  // goes first, and waits for the thread
};

}  // namespace evenlift::native
