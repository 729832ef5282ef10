// A progress bar on a terminal.
#pragma once

#include <cstddef>
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

}  // namespace evenlift::native
