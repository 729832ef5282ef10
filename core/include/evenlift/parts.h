// All shapes of a file, each with robots of its own, as the rows of a table: `evenlift place --shape
// all`, the request `parts`, and the page's table.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "evenlift/import.h"
#include "evenlift/output/quantities.h"
#include "evenlift/output/requirements.h"
#include "evenlift/result.h"
#include "evenlift/vec.h"

namespace evenlift {

// --- Weight

// How the weight of a part follows from its area without holes, as typed: from a weight for each
// square unit of the coordinates, or from a thickness and the weight of each cubic unit. A number may
// have a unit, such as "15.6/m2", "15.6 kg/m²" or "7850/m3".
struct WeightByArea {
  std::optional<std::string> per_area, thickness, density;

  bool typed() const { return per_area || thickness || density; }
};

// Sets the document's weight, unless its outline is invalid, which place() then says. An error has
// the place weight_per_area, thickness or density. O(n log n).
std::optional<InputError> set_weight(Document& document, const WeightByArea& weight);

// How a number without a unit was read, as a remark in the form of an error, if the coordinates have
// a unit other than metres. O(1).
std::optional<InputError> doubtful_unit(const WeightByArea& weight, const Units& units);

// --- Parts

// A part before robots are placed.
struct Part {
  std::size_t number = 0;  // in the list of shapes, from 1
  std::string name;        // unique; the kind of shape if it has no name
  Vec2 at, size;           // the middle and the size of its bounding box
  double area = 0;         // without holes; 0 if the outline is invalid
};

// O(n log n) for n vertices.
std::vector<Part> parts_of(const std::vector<ImportedShape>& shapes);

// What is asked of each part.
struct PartsAsked {
  std::vector<Condition> conditions;
  bool weight_by_area = false;  // the documents' weights are by area, so none is known without one
  bool number_chosen = false;   // a capacity does not change the number of robots
  bool even_out = false, failures = false;
  Misfitting misfitting = Misfitting::refused;
  LoadModel model = LoadModel::plan;
  bool as_json = false, candidates = false;
};

struct PartResult {
  std::string refusal;           // empty if it was placed
  std::optional<double> weight;  // with cargo
  std::size_t robots = 0;
  // Of all quantities with a column; empty unless robots carry it.
  std::vector<std::optional<double>> columns;
  std::optional<std::size_t> overloaded;  // robots, if any has a capacity
  std::string verdict, problem;           // its kind, and the first reason
  bool kept = true;                       // all conditions
  std::string json;                       // one line, with as_json only
  Settings settings;                      // with the number of robots that was placed
};

// Places robots on a part. With a capacity, each part has the number of robots that it needs, unless
// one was chosen: at least two teams or three balanced robots, since fewer stand on one line. Costs a
// placement or two and their reports. Several threads may call it.
PartResult place_part(const Part& part, const ImportedShape& shape, const PartsAsked& asked);

// --- Rows

// The quantities with a column, in the order of PartResult::columns.
const std::vector<const Quantity*>& part_columns();

enum class PartOrder : std::uint8_t { file, number, name, area, weight, load };
std::optional<PartOrder> part_order_from_name(std::string_view name);
inline constexpr char part_order_requirement[] =
    "expected file, number, name, area, weight or load";

// The rows, as indices of parts; weights, areas and loads with the greatest first. Only the order by
// load needs results, which are otherwise empty. O(k log k) for k parts.
std::vector<std::size_t> order_of_rows(PartOrder order, const std::vector<ImportedShape>& shapes,
                                       const std::vector<Part>& parts,
                                       const std::vector<PartResult>& results);

// The rows as CSV, with a heading. Numbers are those of JSON; what is unknown is an empty cell. With
// conditions, a column says whether they are kept. O(output).
std::string parts_csv(const std::vector<std::size_t>& rows, const std::vector<Part>& parts,
                      const std::vector<PartResult>& results, bool conditions);

}  // namespace evenlift
