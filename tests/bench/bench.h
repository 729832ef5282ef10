// Shared by the benchmarks: shapes, and counters that show the complexity.
#pragma once

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "evenlift/chords.h"
#include "evenlift/document.h"
#include "evenlift/formats.h"
#include "evenlift/generate.h"
#include "evenlift/polygon.h"

namespace evenlift::bench {

inline constexpr std::uint64_t seed = 1;

inline Document document_of(Family family, std::int64_t n) {
  Document document;
  document.vertices = *generate(family, static_cast<std::size_t>(n), seed);
  return document;
}

inline Polygon polygon_of(Family family, std::int64_t n) {
  return *Polygon::create(document_of(family, n).vertices);
}

// The samples, with their settings.
inline std::vector<Document> samples() {
  std::vector<Document> documents;
  for (const auto& entry : std::filesystem::directory_iterator(EVENLIFT_ASSETS_DIR "/polygons")) {
    std::ifstream file(entry.path(), std::ios::binary);
    auto document = read_polygon(std::string(std::istreambuf_iterator<char>(file), {}));
    if (document) documents.push_back(std::move(*document));
  }
  return documents;
}

// Applies `work` to each document per iteration, and reports the mean and worst time.
template <class Work>
void time_each(benchmark::State& state, const std::vector<Document>& documents, Work work) {
  double sum = 0, worst = 0, runs = 0;
  for (auto _ : state) {
    for (const Document& document : documents) {
      const std::clock_t begin = std::clock();
      work(document);
      const double time = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
      sum += time;
      worst = std::max(worst, time);
      ++runs;
    }
  }
  state.counters["mean_s"] = sum / runs;
  state.counters["worst_s"] = worst;
}

// The time of an iteration for each of `units`: constant over n if the time is proportional to
// them.
inline void count_time_per(benchmark::State& state, const char* name, double units) {
  using benchmark::Counter;
  state.counters[name] = Counter(units, Counter::kIsIterationInvariantRate | Counter::kInvert);
}

inline double n_log_n(const Polygon& polygon) {
  const auto n = static_cast<double>(polygon.size());
  return n * std::log2(n);
}

// K, the number of edge pairs, and the time per n log2 n + K.
inline void count_pairs(benchmark::State& state, const Polygon& polygon) {
  const auto pairs = static_cast<double>(count_edge_pairs(polygon, polygon.centroid()));
  state.counters["K"] = pairs;
  count_time_per(state, "per_(n_log_n+K)", n_log_n(polygon) + pairs);
}

}  // namespace evenlift::bench
