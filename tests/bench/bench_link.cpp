// Share links of 1,000 vertices, the most common large size, and of the most that a link can hold.
#include "bench/bench.h"
#include "evenlift/link.h"

namespace evenlift::bench {
namespace {

void encode(benchmark::State& state, Family family) {
  const Document document = document_of(family, state.range(0));
  std::size_t length = 0;
  for (auto _ : state) {
    length = encode_link(document)->size();
    benchmark::DoNotOptimize(length);
  }
  state.counters["characters"] = static_cast<double>(length);
}

void decode(benchmark::State& state, Family family) {
  const std::string link = *encode_link(document_of(family, state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(decode_link(link));
}

void of_1000(benchmark::internal::Benchmark* family) {
  family->Arg(1000)->ArgName("n")->Unit(benchmark::kMillisecond);
}
BENCHMARK_CAPTURE(encode, random, Family::random)->Apply(of_1000);
BENCHMARK_CAPTURE(encode, star, Family::star)->Apply(of_1000);
BENCHMARK_CAPTURE(decode, random, Family::random)->Apply(of_1000);
BENCHMARK_CAPTURE(decode, star, Family::star)->Apply(of_1000);

void of_most(benchmark::internal::Benchmark* family) {
  family->Arg(max_link_vertices)->ArgName("n")->Unit(benchmark::kMillisecond);
}
BENCHMARK_CAPTURE(encode, max_link_vertices, Family::random)->Apply(of_most);
BENCHMARK_CAPTURE(decode, max_link_vertices, Family::random)->Apply(of_most);

}  // namespace
}  // namespace evenlift::bench
