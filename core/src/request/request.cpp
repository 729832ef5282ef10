#include "evenlift/request.h"

#include <utility>
#include <vector>

#include "evenlift/candidates.h"
#include "evenlift/experiment/outputs.h"
#include "evenlift/import.h"
#include "evenlift/link.h"
#include "evenlift/optimum.h"
#include "evenlift/output/json.h"
#include "evenlift/output/json_text.h"
#include "evenlift/output/svg.h"
#include "evenlift/output/trace_json.h"
#include "evenlift/output/words.h"
#include "evenlift/placement.h"
#include "evenlift/settings.h"
#include "request/read_request.h"

namespace evenlift {
namespace {

std::string error_answer(const InputError& error) {
  return json::object({{"error", error_json(error)}}) + "\n";
}

// Of the answers that are not a placement's.
std::string with_notices(std::vector<json::Member> members, const Request& request) {
  if (!request.notices.empty()) members.push_back({"notices", json::texts(request.notices)});
  return json::object(members) + "\n";
}

std::string one_text(std::string_view name, std::string_view text, const Request& request) {
  return with_notices({{name, json::text(text)}}, request);
}

std::string placement_answer(const Request& request, const Placement& placement,
                             std::optional<std::vector<SupportMove>> moves) {
  const bool failures = request.failures || need_failures(request.conditions);
  const Reported of({placement, request.document.shown},
                    {.models = true, .failures = failures, .plans = true});
  return placement_json(
      of, request.candidates, request.failures, check_conditions(of, request.conditions),
      {std::move(moves), request.cases ? std::optional(load_cases(of)) : std::nullopt,
       request.notices});
}

std::string svg_answer(const Request& request, const Placement& placement) {
  Shown shown = request.document.shown;
  shown.overlays.candidates |= request.candidates;
  const Result<std::string> link = encode_link(request.document);  // a huge polygon has none
  return one_text("svg", placement_svg({placement, shown}, link ? *link : std::string()), request);
}

Misfitting misfitting_of(const Request& request) {
  return request.keep_misfits ? Misfitting::left_out : Misfitting::refused;
}

std::string placed_answer(Request request) {
  std::optional<std::vector<SupportMove>> moves;
  if (request.even_out) {
    auto even = with_even_supports(request.document, misfitting_of(request));
    if (!even) return error_answer(even.error());
    moves = support_moves(request.document, *even);
    request.document = *std::move(even);
  }
  const Result<Placement> placement =
      place(request.document, Effort::whole, misfitting_of(request));
  if (!placement) return error_answer(placement.error());
  if (request.command == Command::svg) return svg_answer(request, *placement);
  if (request.command == Command::poses)
    return one_text(
        "poses",
        poses_text({*placement, request.document.shown}, request.pose_format, request.poses),
        request);
  return placement_answer(request, *placement, std::move(moves));
}

std::string candidates_answer(const Request& request) {
  const Result<std::vector<Candidate>> candidates = candidates_of(request.document);
  return candidates ? candidates_json(*candidates, request.notices)
                    : error_answer(candidates.error());
}

std::string link_answer(const Request& request) {
  const Result<std::string> link = encode_link(request.document);
  return link ? one_text("link", *link, request) : error_answer(link.error());
}

std::string optimum_answer(const Request& request) {
  const auto compared = compare_choices(request.document);
  if (!compared) return error_answer(compared.error());
  return choices_json(*compared, request.notices);
}

std::string trace_answer(const Request& request) {
  // The trace does the search for balanced robots itself.
  const Result<Placement> placement =
      place(request.document, Effort::start, misfitting_of(request));
  if (!placement) return error_answer(placement.error());
  const Result<Trace> trace =
      make_trace(*placement, HistoryLength::whole, request.document.shown.units);
  if (!trace) return error_answer(trace.error());
  if (const auto error = check_printed_size(*trace)) return error_answer(*error);
  return with_notices({{"steps", trace_json(*trace)}}, request);
}

std::string shapes_answer(const Request& request) {
  const Result<Import> read = read_shapes(request.text, request.import);
  if (!read) return error_answer(read.error());
  std::vector<std::string> shapes;
  for (const ImportedShape& shape : read->shapes)
    shapes.push_back(
        json::object({{"name", json::text(shape.name)},
                      {"kind", json::text(shape.kind)},
                      {"sheet", json::boolean(shape.sheet)},
                      {"tolerance", shape.tolerance ? json::number(*shape.tolerance) : "null"},
                      {"document", json::on_one_line(document_json(shape.document))}}));
  return json::long_object({{"format", json::text(read->format)},
                            {"unit", json::text(read->unit)},
                            {"doubtful", json::boolean(read->doubtful)},
                            {"notices", json::texts(read->notes)},
                            {"shapes", json::long_array(shapes, 1)}},
                           0) +
         "\n";
}

// The same as the lines of `evenlift place --shape all --json`, and its CSV.
std::string parts_answer(const Request& request) {
  const std::vector<Part> parts = parts_of(request.parts);
  const PartsAsked asked{.conditions = request.conditions,
                         .weight_by_area = request.weight.typed(),
                         .number_chosen = request.number_chosen,
                         .even_out = request.even_out,
                         .failures = request.failures,
                         .misfitting = misfitting_of(request),
                         .as_json = true,
                         .candidates = request.candidates};
  std::vector<PartResult> results;
  for (std::size_t i = 0; i < parts.size(); ++i)
    results.push_back(place_part(parts[i], request.parts[i], asked));
  const std::vector<std::size_t> rows = order_of_rows(request.order, request.parts, parts, results);
  std::vector<std::string> lines;
  for (const std::size_t row : rows) {
    std::string& line = results[row].json;
    line.pop_back();  // its newline
    lines.push_back(std::move(line));
  }
  return json::long_object(
             {{"notices", json::texts(request.notices)},
              {"parts", json::long_array(lines, 1)},
              {"csv", json::text(parts_csv(rows, parts, results, !asked.conditions.empty()))}},
             0) +
         "\n";
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
  const auto subject = experiment::prepare(*polygon.document, settings);
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
    case Command::optimum:
      return optimum_answer(*read);
    case Command::trace:
      return trace_answer(*read);
    case Command::shapes:
      return shapes_answer(*read);
    case Command::parts:
      return parts_answer(*read);
    case Command::experiment:
      return experiment_answer(*read);
    case Command::version:
      return one_text("version", version(), *read);
  }
  return {};
}

}  // namespace evenlift
