#include <algorithm>
#include <numeric>

#include "evenlift/numbers.h"
#include "evenlift/parts.h"
#include "evenlift/settings.h"

namespace evenlift {
namespace {

double greatest_load(const PartResult& result) {
  return result.columns.empty() ? -1 : result.columns.front().value_or(-1);
}

// Of which the CSV has a column before those of the quantities.
constexpr char first_headings[] = "shape,name,x,y,width,height,area,weight,robots";

std::string yes_or_no(bool value) { return value ? "yes" : "no"; }

std::string csv_row(const Part& part, const PartResult& result, bool conditions) {
  const bool refused = !result.refusal.empty();
  std::string text = std::to_string(part.number) + "," + csv_cell(part.name);
  for (const double value : {part.at.x, part.at.y, part.size.x, part.size.y, part.area})
    text += "," + shortest(value);
  text += "," + (result.weight ? shortest(*result.weight) : std::string());
  text += "," + (refused ? std::string() : std::to_string(result.robots));
  const std::vector<const Quantity*>& columns = part_columns();
  for (std::size_t i = 0; i < columns.size(); ++i) {
    text += ",";
    if (i >= result.columns.size() || !result.columns[i]) continue;
    const double value = *result.columns[i];
    text += columns[i]->unit == Unit::yes_or_no ? yes_or_no(value == 1) : shortest(value);
  }
  text += "," + (result.overloaded ? std::to_string(*result.overloaded) : std::string());
  if (conditions) text += "," + (refused ? std::string() : yes_or_no(result.kept));
  return text + "," + (refused ? "refused" : result.verdict) + "," +
         csv_cell(refused ? result.refusal : result.problem) + "\n";
}

}  // namespace

const std::vector<const Quantity*>& part_columns() {
  static const std::vector<const Quantity*> columns = [] {
    std::vector<const Quantity*> found;
    for (const Quantity& quantity : quantities())
      if (!quantity.column.empty()) found.push_back(&quantity);
    return found;
  }();
  return columns;
}

std::optional<PartOrder> part_order_from_name(std::string_view name) {
  constexpr std::string_view names[] = {"file", "number", "name", "area", "weight", "load"};
  const auto found = std::find(std::begin(names), std::end(names), name);
  if (found == std::end(names)) return std::nullopt;
  return static_cast<PartOrder>(found - std::begin(names));
}

std::vector<std::size_t> order_of_rows(PartOrder order, const std::vector<ImportedShape>& shapes,
                                       const std::vector<Part>& parts,
                                       const std::vector<PartResult>& results) {
  std::vector<std::size_t> rows(parts.size());
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  const auto sort_by = [&](auto key) {
    std::stable_sort(rows.begin(), rows.end(),
                     [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  };
  switch (order) {
    case PartOrder::file:
      sort_by([&](std::size_t i) { return shapes[i].order; });
      break;
    case PartOrder::number:
      break;
    case PartOrder::name:
      sort_by([&](std::size_t i) { return std::string_view(parts[i].name); });
      break;
    case PartOrder::area:
      sort_by([&](std::size_t i) { return -parts[i].area; });
      break;
    case PartOrder::weight:
      // Without an area there may be no weight, and the part is refused.
      sort_by([&](std::size_t i) {
        return parts[i].area > 0 ? -total_weight(shapes[i].document.settings) : 0;
      });
      break;
    case PartOrder::load:
      if (!results.empty()) sort_by([&](std::size_t i) { return -greatest_load(results[i]); });
      break;
  }
  return rows;
}

std::string parts_csv(const std::vector<std::size_t>& rows, const std::vector<Part>& parts,
                      const std::vector<PartResult>& results, bool conditions) {
  std::string text = first_headings;
  for (const Quantity* column : part_columns()) {
    std::string heading(column->column);
    std::replace(heading.begin(), heading.end(), ' ', '_');
    text += "," + heading;
  }
  text += std::string(",overloaded") + (conditions ? ",kept" : "") + ",verdict,problem\n";
  for (const std::size_t row : rows) text += csv_row(parts[row], results[row], conditions);
  return text;
}

}  // namespace evenlift
