// Divides work among threads.
#pragma once

#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace evenlift::native {

// Calls task(0) .. task(count - 1), each once, in up to `jobs` threads; rethrows the first exception.
template <class Task>
void in_threads(std::size_t count, unsigned jobs, Task task) {
  std::atomic<std::size_t> next = 0;
  std::mutex mutex;
  std::exception_ptr failed;
  const auto loop = [&] {
    for (std::size_t i; (i = next++) < count;) {
      try {
        task(i);
      } catch (...) {
        const std::lock_guard<std::mutex> lock(mutex);
        if (!failed) failed = std::current_exception();
        next = count;
      }
    }
  };
#ifdef __EMSCRIPTEN__
  (void)jobs;  // it has no threads
  loop();
#else
  std::vector<std::thread> threads;
  try {
    for (unsigned i = 1; i < jobs && i < count; ++i) threads.emplace_back(loop);
  } catch (const std::system_error&) {
    // The threads that could start do all of it.
  }
  loop();
  for (std::thread& thread : threads) thread.join();
#endif
  if (failed) std::rethrow_exception(failed);
}

}  // namespace evenlift::native
