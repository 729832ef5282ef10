#include "evenlift/request.h"

#include <utility>
#include <vector>

#include "evenlift/candidates.h"
#include "evenlift/experiment/outputs.h"
#include "evenlift/link.h"
#include "evenlift/output/json.h"
#include "evenlift/output/json_text.h"
#include "evenlift/output/svg.h"
#include "evenlift/output/words.h"
#include "evenlift/placement.h"
#include "evenlift/settings.h"
#include "request/read_request.h"

namespace evenlift {
namespace {

std::string error_answer(const InputError& error) {
  return json::object({{"error", error_json(error)}}) + "\n";
}

std::string one_member(std::string_view name, std::string_view text) {
  return json::object({{name, json::text(text)}}) + "\n";
}

std::string placement_answer(const Request& request, const Placement& placement) {
  const bool failures = request.failures || need_failures(request.conditions);
  const Reported of({placement, request.document.shown},
                    {.models = true, .failures = failures, .plans = true});
  return placement_json(of, request.candidates, request.failures,
                        check_conditions(of, request.conditions));
}

std::string svg_answer(const Request& request, const Placement& placement) {
  Shown shown = request.document.shown;
  shown.overlays.candidates |= request.candidates;
  const Result<std::string> link = encode_link(request.document);  // a huge polygon has none
  return one_member("svg", placement_svg({placement, shown}, link ? *link : std::string()));
}

std::string placed_answer(Request request) {
  if (request.even_out) {
    auto even = with_even_supports(request.document);
    if (!even) return error_answer(even.error());
    request.document = *std::move(even);
  }
  const Result<Placement> placement = place(request.document);
  if (!placement) return error_answer(placement.error());
  if (request.command == Command::svg) return svg_answer(request, *placement);
  if (request.command == Command::poses)
    return one_member("poses", poses_text({*placement, request.document.shown}, request.pose_format,
                                          request.poses));
  return placement_answer(request, *placement);
}

std::string candidates_answer(const Request& request) {
  const Result<std::vector<Candidate>> candidates = candidates_of(request.document);
  return candidates ? candidates_json(*candidates) : error_answer(candidates.error());
}

std::string link_answer(const Request& request) {
  const Result<std::string> link = encode_link(request.document);
  return link ? one_member("link", *link) : error_answer(link.error());
}

// --- Experiments

experiment::PolygonResult measured(const NamedPolygon& polygon,
                                   const experiment::ExperimentSettings& settings) {
  const auto refused = [&](const InputError& error) {
    experiment::PolygonResult result;
    result.set = polygon.set;
    result.polygon = polygon.name;
    result.problem = sentence(error);
    return result;
  };
  if (!polygon.document) return refused(polygon.document.error());
  const auto subject = experiment::prepare(*polygon.document, settings.min_ratio);
  if (!subject) return refused(subject.error());
  experiment::PolygonResult result = experiment::result_of(polygon.set, polygon.name, *subject);
  for (const Method method : all_methods)
    for (const experiment::Measurement& m : experiment::measure(*subject, method, settings))
      result.measurements.push_back(m);
  return result;
}

std::string experiment_answer(const Request& request) {
  std::vector<experiment::PolygonResult> results;
  for (const NamedPolygon& polygon : request.polygons)
    results.push_back(measured(polygon, request.experiment));
  experiment::sort_results(results);
  const auto sets = experiment::group_by_set(std::move(results));
  return experiment::outputs_json(experiment::make_outputs(sets)) + "\n";
}

}  // namespace

std::string answer(std::string_view request) { return answer(request, {}); }

std::string answer(std::string_view request, std::span<const RequestKind> kinds) {
  const std::size_t most = kinds.empty() ? max_request_bytes : max_bytes_of_own_kinds;
  const Result<RequestReader> reader = RequestReader::read(request, most);
  if (!reader) return error_answer(reader.error());
  if (const RequestKind* const kind = reader->kind_among(kinds)) {
    const auto wrong = reader->check_members(kind->members);
    return wrong ? error_answer(*wrong) : kind->answer(*reader) + "\n";
  }
  const Result<Request> read = reader->request();
  if (!read) return error_answer(read.error());
  switch (read->command) {
    case Command::place:
    case Command::svg:
    case Command::poses:
      return placed_answer(*read);
    case Command::candidates:
      return candidates_answer(*read);
    case Command::link:
      return link_answer(*read);
    case Command::experiment:
      return experiment_answer(*read);
    case Command::version:
      return one_member("version", EVENLIFT_VERSION);
  }
  return {};
}

}  // namespace evenlift
