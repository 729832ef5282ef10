#include "experiment/measured_polygons.h"

#include <map>

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
