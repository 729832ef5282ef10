// Against geodesics on the ellipsoid.
#include "import/projection/projection.h"

#include <cmath>

#include "evenlift/formats.h"
#include "evenlift/import.h"
#include "kit/catch.h"
#include "kit/imported.h"

using namespace evenlift;
using evenlift::testing::is_one_sentence;
using evenlift::testing::read;

namespace {

using Real = long double;

constexpr Real degree = 3.14159265358979323846264338327950288L / 180;
constexpr Real half_axis = 6378137, flattening = 1 / 298.257223563L;
constexpr Real other_half_axis = half_axis * (1 - flattening);

// Its length on WGS 84 between places in degrees, as T. Vincenty computes it (Survey Review 23,
// 1975).
Real geodesic(const Vec2& from, const Vec2& to) {
  const auto reduced = [](double latitude) {
    return std::atan((1 - flattening) * std::tan(Real(latitude) * degree));
  };
  const Real u = reduced(from.y), v = reduced(to.y);
  const Real between = (Real(to.x) - Real(from.x)) * degree;
  Real lambda = between, sine = 0, cosine = 1, arc = 0, square = 1, middle = 0;
  for (int i = 0; i < 50; ++i) {
    const Real across = std::cos(v) * std::sin(lambda),
               along = std::cos(u) * std::sin(v) - std::sin(u) * std::cos(v) * std::cos(lambda);
    sine = std::sqrt(across * across + along * along);
    if (sine == 0) return 0;
    cosine = std::sin(u) * std::sin(v) + std::cos(u) * std::cos(v) * std::cos(lambda);
    arc = std::atan2(sine, cosine);
    const Real azimuth = std::cos(u) * across / sine;
    square = 1 - azimuth * azimuth;
    middle = square > 0 ? cosine - 2 * std::sin(u) * std::sin(v) / square : 0;
    const Real c = flattening / 16 * square * (4 + flattening * (4 - 3 * square));
    lambda = between + (1 - c) * flattening * azimuth *
                           (arc + c * sine * (middle + c * cosine * (2 * middle * middle - 1)));
  }
  const Real k = square * (half_axis * half_axis - other_half_axis * other_half_axis) /
                 (other_half_axis * other_half_axis);
  const Real a = 1 + k / 16384 * (4096 + k * (-768 + k * (320 - 175 * k)));
  const Real b = k / 1024 * (256 + k * (-128 + k * (74 - 47 * k)));
  const Real shorter =
      b * sine *
      (middle + b / 4 *
                    (cosine * (2 * middle * middle - 1) -
                     b / 6 * middle * (4 * sine * sine - 3) * (4 * middle * middle - 3)));
  return other_half_axis * a * (arc - shorter);
}

// The relative error of the lengths between 49 places in a square.
double greatest_error(const Vec2& middle, double side, double* stated) {
  const double north = side / 111320, east = north / std::cos(middle.y * 0.017453292519943295);
  const Vec2 half(east / 2, north / 2);
  const Result<Projection> projection = Projection::about_middle({middle - half, middle + half});
  REQUIRE(projection.ok());
  *stated = projection->error();
  Points places;
  for (int i = -3; i <= 3; ++i)
    for (int j = -3; j <= 3; ++j) places.push_back(middle + Vec2(i * half.x, j * half.y) / 3);
  double greatest = 0;
  for (const Vec2& a : places)
    for (const Vec2& b : places) {
      if (a == b) continue;
      const double metres = length(projection->metres(a) - projection->metres(b));
      greatest = std::max(greatest, std::abs(metres / static_cast<double>(geodesic(a, b)) - 1));
    }
  return greatest;
}

ImportOptions with_project() {
  ImportOptions options;
  options.project = true;
  return options;
}

std::string refused(const std::string& text) {
  const Result<Import> import = read_shapes(text, with_project());
  INFO(text);
  REQUIRE_FALSE(import.ok());
  CHECK(is_one_sentence(import.error().message));
  return import.error().message;
}

}  // namespace

TEST_CASE("projected lengths are those of the geodesic within the stated error", "[import]") {
  CHECK(std::abs(static_cast<double>(geodesic({0, 0}, {1, 0})) - 111319.4908) < 1e-4);
  CHECK(std::abs(static_cast<double>(geodesic({0, 0}, {0, 1})) - 110574.3886) < 1e-4);
  const struct {
    double latitude, error;  // in a square of 1 km
  } squares[] = {{0, 1e-8}, {30, 4.6e-5}, {-47.5, 8.6e-5}, {60, 1.4e-4}, {80, 4.5e-4}};
  for (const auto& [latitude, error] : squares)
    for (const double times : {1.0, 10.0}) {
      INFO(latitude << " " << times);
      double stated = 0;
      const double greatest = greatest_error({8.5, latitude}, 1000 * times, &stated);
      CHECK(greatest < error * times * (latitude == 0 ? times : 1.01));
      CHECK(greatest < stated * 1.01 + 1e-8);
      CHECK(stated < greatest * 1.01 + 1e-8);
    }
}

TEST_CASE("the origin is the middle of the box with four decimals", "[import]") {
  const Result<Projection> projection =
      Projection::about_middle({{-0.00012, 47.376849}, {0.00022, 47.376953}});
  REQUIRE(projection.ok());
  CHECK(projection->origin() == Vec2(0.0001, 47.3769));
  CHECK(projection->metres(projection->origin()) == Vec2(0, 0));
}

TEST_CASE("degrees of any text become metres east and north, with the unit", "[import]") {
  const std::string ring = "[[[10,60],[10.002,60],[10.002,60.001],[10,60]]]";
  const std::string note =
      "the coordinates were converted from degrees to metres east and north of 10.001\u00B0 E, "
      "60.0005\u00B0 N";
  for (const std::string& text :
       {R"({"type":"Polygon","coordinates":)" + ring + "}",
        R"({"rings":)" + ring + R"(,"spatialReference":{"wkid":4326}})",
        std::string("lon,lat\n10,60\n10.002,60\n10.002,60.001\n"),
        std::string("Latitude;Longitude\n60;10\n60;10,002\n60,001;10,002\n"),
        std::string("SRID=4326;POLYGON((10 60,10.002 60,10.002 60.001,10 60))"),
        std::string("(10,60)\n(10.002,60)\n(10.002,60.001)\n"),  // the user says so
        std::string("x [mm],y [mm]\n10,60\n10.002,60\n10.002,60.001\n")}) {
    INFO(text);
    const Import import = read(text, with_project());
    const Points& vertices = import.shapes.front().document.vertices;
    REQUIRE(vertices.size() == 3);
    CHECK(length(vertices[0] - Vec2(-55.80, -55.71)) < 0.01);
    CHECK(length(vertices[2] - Vec2(55.80, 55.71)) < 0.01);
    CHECK(import.notes.back() == note);
    CHECK(import.unit == "metres");
    CHECK(import.shapes.front().document.shown.units.length == LengthUnit::m);
    CHECK_FALSE(import.in_degrees);
  }
  CHECK(read(R"({"type":"Polygon","coordinates":)" + ring + "}").in_degrees);
  CHECK_FALSE(read("POLYGON((10 60,10.002 60,10.002 60.001,10 60))").in_degrees);
}

TEST_CASE("all shapes of a text have one origin, and so has a centre of mass", "[import]") {
  const Import import = read(
      R"({"type":"FeatureCollection","features":[
        {"type":"Feature","properties":{"centre_of_mass":[-0.5,-1]},
         "geometry":{"type":"Polygon","coordinates":[[[-1,-1],[0,-1],[0,-0.5]]]}},
        {"type":"Feature","properties":{},
         "geometry":{"type":"Polygon","coordinates":[[[0,0],[1,0],[1,1]]]}}]})",
      with_project());
  CHECK(import.notes.back().find("north of 0\u00B0 E, 0\u00B0 N") != std::string::npos);
  const Points &first = import.shapes[0].document.vertices,
               &second = import.shapes[1].document.vertices;
  CHECK(first[0] == -second[2]);
  CHECK(first[1].x == 0);
  CHECK(import.shapes[0].document.centre_of_mass == Vec2(first[0].x / 2, first[0].y));
}

TEST_CASE("widths that are off by a thousandth or more are told", "[import]") {
  const auto told = [](const char* text) { return read(text, with_project()).notes.back(); };
  CHECK(told("lon,lat\n10,60\n10.1,60\n10.1,60.1\n").find("off by up to 0.2\u00A0%") !=
        std::string::npos);
  CHECK(told("lon,lat\n10,60\n10.1,60\n10.1,60.01\n").find("off by") == std::string::npos);
}

TEST_CASE("what no plane in metres can show is refused", "[import]") {
  CHECK(refused("lon,lat\n0,0\n200,0\n10,10\n").find("a longitude is beyond 180") !=
        std::string::npos);
  CHECK(refused("x,y\n0,0\n10,0\n10,91\n").find("a latitude beyond 90") != std::string::npos);
  CHECK(refused("lon,lat\n179.9,0\n-179.9,0\n-179.9,1\n").find("180th meridian") !=
        std::string::npos);
  CHECK(refused("lon,lat\n0,84\n1,84\n1,85.1\n").find("too near a pole") != std::string::npos);
  CHECK(refused(R"({"polygon":[[0,0],[4,0],[4,4]]})").find("a result of evenlift") !=
        std::string::npos);
}

TEST_CASE("GeoJSON that evenlift saved with a centre of mass is not in degrees", "[import]") {
  Document document;
  document.vertices = {{0, 0}, {4, 0}, {4, 4}};
  document.centre_of_mass = Vec2(3, 1);
  const Import import = read(write_geojson(document));
  CHECK(import.notes.empty());
  CHECK_FALSE(import.in_degrees);
}
