#include "experiment/experiment_run.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <filesystem>
#include <mutex>
#include <numeric>

#ifndef __EMSCRIPTEN__
#include <thread>
#endif

#include "input/files.h"
#include "print/progress.h"

namespace evenlift::native {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

experiment::Part measured(const PolygonFile& file, const experiment::Subject& subject,
                          const experiment::ExperimentSettings& settings) {
  experiment::Part part;
  part.settings = settings;
  part.result = experiment::result_of(file.set, file.name, subject);
  for (const Method method : all_methods) {
    const Clock::time_point start = Clock::now();
    for (const experiment::Measurement& m : experiment::measure(subject, method, settings))
      part.result.measurements.push_back(m);
    part.times.emplace_back(evenlift::name(method), seconds_since(start));
  }
  return part;
}

// The result for one file.
struct Work {
  experiment::ShardList::Entry entry;
  bool resumed = false;
  std::optional<Failure> refused;
};

Work refuse(const PolygonFile& file, const Failure& failure,
            const experiment::ExperimentSettings& settings, const ExperimentFolder& folder) {
  experiment::Part part;
  part.settings = settings;
  part.fingerprint = experiment::refused_fingerprint;
  part.result.set = file.set;
  part.result.polygon = file.name;
  // The file's path is removed, since it differs between machines.
  const std::size_t path = failure.where.rfind(file.path, 0) == 0 ? file.path.size() : 0;
  const std::string place = failure.where.substr(std::min(path + 2, failure.where.size()));
  part.result.problem = (path == 0 || place.empty() ? "" : place + ": ") + failure.what;
  folder.keep(part);
  return {{file.set, file.name, part.fingerprint}, false, failure};
}

Work work_on(const PolygonFile& file, const experiment::ExperimentSettings& settings,
             const ExperimentFolder& folder) {
  try {
    const Input input = read_input(file.path);
    const std::string id = experiment::fingerprint(input.document, settings);
    const experiment::ShardList::Entry entry{file.set, file.name, id};
    if (folder.find(entry, settings)) return {entry, true, {}};
    const Clock::time_point start = Clock::now();
    const Result<experiment::Subject> subject =
        experiment::prepare(input.document, settings.min_ratio);
    const double seconds = seconds_since(start);
    if (!subject) return refuse(file, bad_input(file.path, subject.error()), settings, folder);
    experiment::Part part = measured(file, *subject, settings);
    part.fingerprint = id;
    part.times.insert(part.times.begin(), {"candidates", seconds});
    folder.keep(part);
    return {entry, false, {}};
  } catch (const Failure& failure) {
    if (failure.status != bad_input_status) throw;
    return refuse(file, failure, settings, folder);
  }
}

// The largest polygons come first, so that the threads end at about the same time.
std::vector<std::size_t> by_size(const std::vector<PolygonFile>& files) {
  std::vector<std::uintmax_t> sizes;
  for (const PolygonFile& file : files) {
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(file.path, error);
    sizes.push_back(error ? 0 : size);
  }
  std::vector<std::size_t> order(files.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return sizes[a] != sizes[b] ? sizes[a] > sizes[b] : a < b;
  });
  return order;
}

// Calls task(0) .. task(count - 1), each once, in `jobs` threads; rethrows the first exception.
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
  for (unsigned i = 1; i < jobs && i < count; ++i) threads.emplace_back(loop);
  loop();
  for (std::thread& thread : threads) thread.join();
#endif
  if (failed) std::rethrow_exception(failed);
}

}  // namespace

RunOutcome run_experiment(const std::vector<PolygonFile>& all, const experiment::Shard& shard,
                          const experiment::ExperimentSettings& settings, unsigned jobs,
                          const ExperimentFolder& folder) {
  std::vector<PolygonFile> files;
  for (std::size_t i = shard.i - 1; i < all.size(); i += shard.n) files.push_back(all[i]);

  std::vector<Work> works(files.size());
  {
    const std::vector<std::size_t> order = by_size(files);
    Progress progress(files.size());
    in_threads(files.size(), jobs, [&](std::size_t turn) {
      const std::size_t i = order[turn];
      works[i] = work_on(files[i], settings, folder);
      progress.done(files[i].name);
    });
  }
  RunOutcome outcome;
  experiment::ShardList list{shard, settings, {}};
  outcome.polygons = files.size();
  for (const Work& work : works) {
    list.entries.push_back(work.entry);
    outcome.resumed += work.resumed;
    if (work.refused) outcome.refused.push_back(*work.refused);
  }
  folder.finish(list);
  return outcome;
}

}  // namespace evenlift::native
