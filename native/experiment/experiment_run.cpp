#include "experiment/experiment_run.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <map>
#include <mutex>
#include <numeric>

#include "input/files.h"

namespace evenlift::native {
namespace {

void add_shapes(const PolygonFile& file, std::vector<ImportedShape> shapes,
                std::vector<MeasuredPolygon>& polygons) {
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const std::string number = std::to_string(i + 1);
    const bool several = shapes.size() > 1;
    polygons.push_back({file.set,
                        several ? file.name + " " + number : file.name,
                        several ? file.path + ": shape " + number : file.path,
                        std::move(shapes[i].document),
                        {}});
  }
}

// "gear 2" may be the second shape of a file, or a file of that name.
void check_names(const std::vector<MeasuredPolygon>& polygons) {
  std::map<std::pair<std::string, std::string>, const MeasuredPolygon*> known;  // by set and name
  for (const MeasuredPolygon& polygon : polygons) {
    const auto [other, added] = known.emplace(std::pair(polygon.set, polygon.name), &polygon);
    if (!added)
      throw Failure{bad_input_status, polygon.source,
                    "would have the same name, " + polygon.name + ", as " + other->second->source +
                        "; rename one of the files"};
  }
}

}  // namespace

std::vector<MeasuredPolygon> read_polygons(const std::vector<PolygonFile>& files) {
  std::vector<MeasuredPolygon> polygons;
  for (const PolygonFile& file : files) {
    try {
      add_shapes(file, read_all_shapes(file.path).shapes, polygons);
    } catch (const Failure& failure) {
      if (failure.status != bad_input_status) throw;
      polygons.push_back({file.set, file.name, file.path, {}, failure});
    }
  }
  check_names(polygons);
  return polygons;
}

}  // namespace evenlift::native

#ifndef __EMSCRIPTEN__
#include <system_error>
#endif

#include "print/progress.h"
#include "print/threads.h"

namespace evenlift::native {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

experiment::Part measured(const MeasuredPolygon& polygon, const experiment::Subject& subject,
                          const experiment::ExperimentSettings& settings) {
  experiment::Part part;
  part.settings = settings;
  part.result = experiment::result_of(polygon.set, polygon.name, subject);
  for (const Method method : all_methods) {
    const Clock::time_point start = Clock::now();
    for (const experiment::Measurement& m : experiment::measure(subject, method, settings))
      part.result.measurements.push_back(m);
    part.times.emplace_back(evenlift::name(method), seconds_since(start));
  }
  return part;
}

struct Work {
  experiment::ShardList::Entry entry;
  bool resumed = false;
  std::optional<Failure> refused;
};

Work refuse(const MeasuredPolygon& polygon, const Failure& failure,
            const experiment::ExperimentSettings& settings, const ExperimentFolder& folder) {
  experiment::Part part;
  part.settings = settings;
  part.fingerprint = experiment::refused_fingerprint;
  part.result.set = polygon.set;
  part.result.polygon = polygon.name;
  // The file's path differs between machines, so it is removed.
  const std::size_t source =
      failure.where.rfind(polygon.source, 0) == 0 ? polygon.source.size() : 0;
  const std::string place = failure.where.substr(std::min(source + 2, failure.where.size()));
  part.result.problem = (source == 0 || place.empty() ? "" : place + ": ") + failure.what;
  folder.keep(part);
  return {{polygon.set, polygon.name, part.fingerprint}, false, failure};
}

Work work_on(const MeasuredPolygon& polygon, const experiment::ExperimentSettings& settings,
             const ExperimentFolder& folder) {
  if (polygon.refused) return refuse(polygon, *polygon.refused, settings, folder);
  const std::string id = experiment::fingerprint(polygon.document, settings);
  const experiment::ShardList::Entry entry{polygon.set, polygon.name, id};
  if (folder.find(entry, settings)) return {entry, true, {}};
  const Clock::time_point start = Clock::now();
  const Result<experiment::Subject> subject = experiment::prepare(polygon.document, settings);
  const double seconds = seconds_since(start);
  if (!subject)
    return refuse(polygon, bad_input(polygon.source, subject.error()), settings, folder);
  experiment::Part part = measured(polygon, *subject, settings);
  part.fingerprint = id;
  part.times.insert(part.times.begin(), {"candidates", seconds});
  folder.keep(part);
  return {entry, false, {}};
}

// The largest come first, so that the threads end at about the same time.
std::vector<std::size_t> by_size(const std::vector<MeasuredPolygon>& polygons) {
  std::vector<std::size_t> order(polygons.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const std::size_t size_a = polygons[a].document.vertices.size(),
                      size_b = polygons[b].document.vertices.size();
    return size_a != size_b ? size_a > size_b : a < b;
  });
  return order;
}

}  // namespace

RunOutcome run_experiment(const std::vector<PolygonFile>& all, const Loading& loading,
                          const experiment::Shard& shard,
                          const experiment::ExperimentSettings& settings, unsigned jobs,
                          const ExperimentFolder& folder) {
  std::vector<PolygonFile> files;
  for (std::size_t i = shard.i - 1; i < all.size(); i += shard.n) files.push_back(all[i]);

  std::vector<MeasuredPolygon> polygons = read_polygons(files);
  for (MeasuredPolygon& polygon : polygons) {
    try {
      loading(polygon.document);
    } catch (const Failure& failure) {  // such as more cargo than is possible
      if (!polygon.refused) polygon.refused = Failure{failure.status, polygon.source, failure.what};
    }
  }
  std::vector<Work> works(polygons.size());
  {
    const std::vector<std::size_t> order = by_size(polygons);
    Progress progress(polygons.size());
    in_threads(polygons.size(), jobs, [&](std::size_t turn) {
      const std::size_t i = order[turn];
      works[i] = work_on(polygons[i], settings, folder);
      progress.done(polygons[i].name);
    });
  }
  RunOutcome outcome;
  experiment::ShardList list{shard, settings, {}};
  outcome.polygons = polygons.size();
  for (const Work& work : works) {
    list.entries.push_back(work.entry);
    outcome.resumed += work.resumed;
    if (work.refused) outcome.refused.push_back(*work.refused);
  }
  folder.finish(list);
  return outcome;
}

}  // namespace evenlift::native
