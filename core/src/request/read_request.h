// Reads a request from JSON.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "evenlift/document.h"
#include "evenlift/experiment/measure.h"
#include "evenlift/import.h"
#include "evenlift/output/poses.h"
#include "evenlift/output/requirements.h"
#include "evenlift/parts.h"
#include "evenlift/request.h"
#include "evenlift/result.h"
#include "numbers/json_tree.h"

namespace evenlift {

enum class Command : std::uint8_t {
  place,
  candidates,
  svg,
  poses,
  link,
  optimum,
  trace,
  shapes,
  parts,
  experiment,
  version
};

// A polygon of an experiment. If `document` is an error, the polygon does not count in the
// averages, and the answer gives the reason.
struct NamedPolygon {
  std::string set, name;
  Result<Document> document;
};

struct Request {
  Command command = Command::place;
  Document document;
  std::string text;                  // for `shapes`
  ImportOptions import;              // of a text
  std::vector<std::string> notices;  // what was left out of polygon or text
  bool candidates = false, failures = false, even_out = false, cases = false, keep_misfits = false;
  std::vector<Condition> conditions;
  WeightByArea weight;
  std::vector<ImportedShape> parts;  // for `parts`
  bool number_chosen = false;        // of teams or robots
  PartOrder order = PartOrder::file;
  PoseFormat pose_format = PoseFormat::json;
  PoseOptions poses;
  std::vector<NamedPolygon> polygons;
  experiment::ExperimentSettings experiment;
};

// A request as JSON. Members that the command does not have are errors, so that no mistyped name
// goes unnoticed.
class RequestReader final : public RequestMembers {
 public:
  // The text, of at most so many bytes, must outlive the reader. O(bytes).
  static Result<RequestReader> read(std::string_view text, std::size_t most = max_request_bytes);

  // The kind that the command names; null if it is none of these. O(kinds).
  const RequestKind* kind_among(std::span<const RequestKind> kinds) const;
  std::optional<InputError> check_members(const RequestKind::Names& allowed) const;
  // The request of any other command. The geometry is not checked. O(bytes).
  Result<Request> request() const;

  std::string text(std::string_view name) const override;
  double number(std::string_view name) const override;
  std::vector<std::string> texts(std::string_view name) const override;
  std::vector<std::pair<std::string, std::string>> named_texts(
      std::string_view name) const override;

 private:
  RequestReader(std::string_view text, JsonTree tree) : text_(text), tree_(std::move(tree)) {}

  std::string_view text_;
  JsonTree tree_;
};

}  // namespace evenlift
