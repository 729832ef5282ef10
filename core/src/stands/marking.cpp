#include <algorithm>
#include <utility>

#include "evenlift/stands.h"
#include "exact/sorted_indices.h"

namespace evenlift {
namespace {

bool comes_first(const EdgePart& a, const EdgePart& b) {
  return a.edge != b.edge ? a.edge < b.edge : a.from < b.from;
}

// Sorted, and joined where they meet.
std::vector<EdgePart> united(std::vector<EdgePart> parts) {
  sort_items(parts, comes_first);
  std::vector<EdgePart> joined;
  for (const EdgePart& part : parts) {
    if (!joined.empty() && joined.back().edge == part.edge && part.from <= joined.back().to)
      joined.back().to = std::max(joined.back().to, part.to);
    else
      joined.push_back(part);
  }
  return joined;
}

}  // namespace

std::vector<EdgePart> with_part(std::vector<EdgePart> no_go, const EdgePart& part) {
  no_go.push_back(part);
  return united(std::move(no_go));
}

std::vector<EdgePart> without_part(std::vector<EdgePart> no_go, const EdgePart& part) {
  std::vector<EdgePart> left;
  for (const EdgePart& marked : united(std::move(no_go))) {
    if (marked.edge != part.edge) {
      left.push_back(marked);
      continue;
    }
    if (marked.from < part.from)
      left.push_back({marked.edge, marked.from, std::min(marked.to, part.from)});
    if (marked.to > part.to)
      left.push_back({marked.edge, std::max(marked.from, part.to), marked.to});
  }
  return left;
}

bool is_marked(const std::vector<EdgePart>& no_go, std::uint32_t edge, double at) {
  return std::any_of(no_go.begin(), no_go.end(), [&](const EdgePart& part) {
    return part.edge == edge && at >= part.from && at <= part.to;
  });
}

std::vector<EdgePart> after_split(const std::vector<EdgePart>& no_go, std::uint32_t edge,
                                  double at) {
  std::vector<EdgePart> parts;
  for (EdgePart part : no_go) {
    if (part.edge != edge) {
      if (part.edge > edge) ++part.edge;
      parts.push_back(part);
      continue;
    }
    if (part.from < at && at > 0)
      parts.push_back({edge, part.from / at, std::min(part.to / at, 1.0)});
    if (part.to > at && at < 1)
      parts.push_back(
          {edge + 1, std::max((part.from - at) / (1 - at), 0.0), (part.to - at) / (1 - at)});
  }
  return united(std::move(parts));
}

std::vector<EdgePart> after_removal(const std::vector<EdgePart>& no_go, const Points& vertices,
                                    std::uint32_t vertex) {
  const auto n = static_cast<std::uint32_t>(vertices.size());
  const std::uint32_t before = (vertex + n - 1) % n, next = (vertex + 1) % n;
  const double first = length(vertices[vertex] - vertices[before]),
               second = length(vertices[next] - vertices[vertex]);
  const double at = first / (first + second);
  const std::uint32_t joined = vertex == 0 ? n - 2 : vertex - 1;
  std::vector<EdgePart> parts;
  for (const EdgePart& part : no_go) {
    if (part.edge == before)
      parts.push_back({joined, part.from * at, part.to * at});
    else if (part.edge == vertex)
      parts.push_back(
          {joined, at + part.from * (1 - at), part.to == 1 ? 1 : at + part.to * (1 - at)});
    else
      parts.push_back({part.edge > vertex ? part.edge - 1 : part.edge, part.from, part.to});
  }
  return united(std::move(parts));
}

}  // namespace evenlift
