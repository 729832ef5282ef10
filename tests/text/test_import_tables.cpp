// As programs write them, and files of other kinds.
#include <string>
#include <string_view>
#include <vector>

#include "evenlift/import.h"
#include "evenlift/numbers.h"
#include "evenlift/polygon.h"
#include "kit/catch.h"
#include "kit/imported.h"
#include "kit/random_documents.h"

using namespace evenlift;
using evenlift::testing::only;
using evenlift::testing::read;
using evenlift::testing::refusal;
using evenlift::testing::same_vertices;

namespace {

using Notes = std::vector<std::string>;

Notes notes(const std::string& text) { return read(text).notes; }

std::vector<std::string> described(const std::string& text) {
  std::vector<std::string> lines;
  for (const ImportedShape& shape : read(text).shapes) lines.push_back(describe(shape));
  return lines;
}

const Points corner = {{0, 0}, {30, 0}, {30, 20.5}};

}  // namespace

// --- Headings

TEST_CASE("columns: headings as people write them name x and y", "[import][columns]") {
  const char* pairs[][2] = {{"X", "Y"},
                            {"x (mm)", "y (mm)"},
                            {"X-Coordinate", "Y-Coordinate"},
                            {"x_coord", "y_coord"},
                            {"xcoord", "ycoord"},
                            {"POINT_X", "POINT_Y"},
                            {"Position X", "Position Y"},
                            {"Pos X", "Pos Y"},
                            {"PosX", "PosY"},
                            {"XCoord [m]", "YCoord [m]"},
                            {"Easting", "Northing"},
                            {"EASTING (m)", "NORTHING (m)"},
                            {"E", "N"},
                            {"Rechtswert", "Hochwert"},
                            {"lon", "lat"},
                            {"Longitude", "Latitude"},
                            {"long", "lat"},
                            {"lng", "lat"},
                            {"Start X", "Start Y"}};
  for (const auto& [x, y] : pairs) {
    const std::string a = x, b = y;
    INFO(a);
    for (const std::string& text :
         {a + "," + b + "\n0,0\n30,0\n30,20.5\n", b + ";" + a + "\n0;0\n0;30\n20,5;30\n",
          "OBJECTID," + a + "," + b + "\n1,0,0\n2,30,0\n3,30,20.5\n",
          "No.\t" + b + "\t" + a + "\tDescription\n4\t0\t0\ta\n9\t0\t30\tb\n7\t20,5\t30\tc\n"})
      CHECK(same_vertices(only(text), corner));
  }
}

TEST_CASE("columns: lengths go before degrees, and words that only contain x name nothing",
          "[import][columns]") {
  CHECK(same_vertices(
      only("Longitude,Latitude,Easting,Northing\n9,50,0,0\n9.1,50,30,0\n9.1,50.1,30,20.5\n"),
      corner));
  CHECK(same_vertices(only("xml,index,easy,N\n7,0,0,a\n9,30,0,b\n8,30,20.5,c\n"),
                      {{7, 0}, {9, 0}, {8, 20.5}}));
}

TEST_CASE("columns: a heading may be a comment, be parted in its own way, or have units below",
          "[import][columns]") {
  CHECK(same_vertices(only("# y x\n0 0\n0 30\n20.5 30\n"), corner));
  CHECK(same_vertices(only("#,X,Y\n5,0,0\n8,30,0\n9,30,20.5\n"), corner));
  CHECK(same_vertices(only("No   X coord   Y coord\n7    0         0\n9    30        0\n"
                           "8    30        20.5\n"),
                      corner));
  CHECK(same_vertices(only("y [m] x [m]\n0 0\n0 30\n20.5 30\n"), corner));
  CHECK(same_vertices(only("Y coord X coord\n0 0\n0 30\n20.5 30\n"), corner));
  CHECK(same_vertices(only("# north plate, east side\n0 0\n30 0\n30 20.5\n"), corner));
  CHECK(same_vertices(only("The north and the east plate\n0 0\n30 0\n30 20.5\n"), corner));
  CHECK(read("x;y\nmm;mm\n0;0\n30;0\n30;20,5\n").unit == "millimetres");
  CHECK(read("Northing (m),Easting (m)\n0,0\n0,30\n20.5,30\n").unit == "metres");
  CHECK(notes("sep=;\nx;y\n0;0\n30;0\n30;20,5\n").empty());
}

TEST_CASE("columns: headings may follow a comment of any length", "[import][columns]") {
  std::string text;
  for (int line = 0; line < 5000; ++line)
    text += "# Measured in the hall, " + std::to_string(line) + "\n";
  text += "no;y;x\n1;0;0\n2;0;30\n3;20.5;30\n";
  CHECK(same_vertices(only(text), corner));
}

TEST_CASE("columns: heights are left out with a note", "[import][columns]") {
  CHECK(notes("Point,Northing,Easting,Elevation\n1,0,0,7\n2,0,30,7\n3,20.5,30,8\n") ==
        Notes{"the column \"Elevation\" was left out"});
  CHECK(notes("POINT_X,POINT_Y,POINT_Z\n0,0,7\n30,0,7\n30,20.5,8\n") ==
        Notes{"the column \"POINT_Z\" was left out"});
}

// --- Columns that no heading names

TEST_CASE("columns: the number of a point is no coordinate while two others are there",
          "[import][columns]") {
  for (const char* text :
       {"1,0.0,0.0,9.1,IP\n2,30.0,0.0,9.2,FNC\n3,30.0,20.5,9.3,BLD\n",  // survey
        "1 0 0\n2 30 0\n3 30 20.5\n",
        "17;0,0;0,0\n19;30,0;0,0\n40;30,0;20,5\n",  // points were deleted
        "A,B,C\n1,0,0\n2,30,0\n3,30,20.5\n",        // headings that say nothing
        "id,a,b\n9,0,0\n4,30,0\n6,30,20.5\n",       // a heading that says so
        "1,8,0,0\n2,8,30,0\n3,8,30,20.5\n"}) {      // what stays the same is none either
    INFO(text);
    CHECK(same_vertices(only(text), corner));
    REQUIRE(notes(text).size() == 1);
    CHECK(notes(text)[0].find("numbers the points") != std::string::npos);
  }
  CHECK(same_vertices(only("1,0\n2,9\n3,4\n"), {{1, 0}, {2, 9}, {3, 4}}));
  CHECK(same_vertices(only("0 0 5\n1 3 5\n2 0 5\n"), {{0, 0}, {1, 3}, {2, 0}}));
}

TEST_CASE("columns: rows that change their columns or their word are refused",
          "[import][columns]") {
  CHECK(refusal("0 0\n30 0\n30 20\n0 1 2\n") ==
        "line 4, column 1: the line has 3 numbers, but the first row has 2: all rows need the same "
        "columns");
  CHECK(refusal("4 2 0 0\n1 0 0\n2 30 0\n3 30 20\n").find("line 2, column 1: the line has 3") == 0);
  CHECK(
      refusal("p 0 0\np 30 0\np 30 20\nedge 1 2\n") ==
      "line 4, column 1: the line begins with \"edge\", but the lines before it with \"p\": blank "
      "lines separate shapes");
  CHECK(refusal("x,y\n1,5,2,5\n3,5,2,5\n").find("decimals with a comma need a semicolon") !=
        std::string::npos);
  CHECK(same_vertices(only("IP 0 0\nFNC 30 0\nFNC 30 20.5\n"), corner));
  CHECK(same_vertices(only("G1 0 0\nG2 30 0\nG3 30 20.5\n"), corner));
}

TEST_CASE("columns: within a column of kinds, the column of names parts the shapes",
          "[import][columns]") {
  const std::string kinds =
      "PtID,East,North,Code,Object\n1,0,0,Edge,A\n2,0,3,Edge,A\n3,4,3,Edge,A\n4,10,3,Edge,B\n"
      "5,10,0,Edge,B\n6,6,0,Edge,B\n";
  const std::string points = "7,20,0,Post,P1\n8,21,0,Post,P2\n9,21,1,Post,P3\n";
  for (const std::string& text : {kinds, kinds + points}) {
    const Result<Import> import = read_shapes(text);
    REQUIRE(import);
    REQUIRE(import->shapes.size() == 2);
    CHECK(import->shapes[0].name == "A");
    CHECK(same_vertices(import->shapes[0].document.vertices, {{0, 0}, {0, 3}, {4, 3}}));
    CHECK(same_vertices(import->shapes[1].document.vertices, {{10, 3}, {10, 0}, {6, 0}}));
  }
  CHECK(notes(kinds + points).back() == "3 groups of fewer than three points were left out");
  // Segments of outlines are not their names.
  const std::string segments =
      "Part,Segment,X,Y\nA,1,0,0\nA,1,5,0\nA,1,9,0\nA,2,9,5\nA,2,9,9\nA,3,5,9\nA,3,0,9\nA,3,0,5\n"
      "B,4,20,0\nB,4,25,0\nB,4,29,0\nB,5,29,5\nB,5,29,9\nB,6,25,9\nB,6,20,9\nB,6,20,5\n";
  const Result<Import> parts = read_shapes(segments);
  REQUIRE(parts);
  CHECK(parts->shapes.size() == 2);
  // A mark at one point of an outline is not the name of a shape.
  const std::string marked =
      "East,North,Mark\n0,0,edge\n9,0,edge\n9,5,edge\n9,9,corner\n0,9,edge\n0,5,edge\n1,4,edge\n";
  const Result<Import> one = read_shapes(marked);
  REQUIRE(one);
  CHECK(one->shapes.size() == 1);
}

TEST_CASE("columns: a column that numbers or names the shapes parts them", "[import][columns]") {
  const Notes two = {"\"A\", points, 3 vertices, 4 x 4", "\"B\", points, 3 vertices, 3 x 2"};
  const std::string named =
      "no,Name,y,x\n1,A,0,0\n2,A,0,4\n3,A,4,4\n4,B,9,9\n5,B,9,12\n6,B,11,12\n";
  CHECK(described(named) == two);
  CHECK(notes(named) == Notes{"the column \"Name\" separates the shapes"});
  CHECK(read("1,0,0\n1,4,0\n1,4,4\n2,9,9\n2,12,9\n2,12,11\n").shapes.size() == 2);
  CHECK(refusal("Code,x,y\nA,0,0\nA,4,0\nA,4,4\nB,2,4\n").find("line 5, column 1") == 0);
}

TEST_CASE("columns: decimal commas between commas are read in quotes if they cannot be thousands",
          "[import][columns]") {
  CHECK(same_vertices(only("\"0,0\",\"0,0\"\n\"30,0\",\"0,0\"\n\"30,0\",\"20,5\"\n"), corner));
  CHECK(refusal("\"1,500\",\"2,250\"\n\"3,500\",\"2,250\"\n\"3,500\",\"9,125\"\n")
            .find("no separator between its thousands") != std::string::npos);
}

TEST_CASE("columns: a sign in quotes separates nothing", "[import][columns]") {
  CHECK(same_vertices(only("\"left; low\",0,0\n\"left; low\",30,0\n\"left; low\",30,20.5\n"),
                      corner));
}

// --- What stands before the rows

TEST_CASE("columns: headings with numbers, or of several lines, are skipped with a note",
          "[import][columns]") {
  const std::string rows = "1.0 0.0\n0.5 0.1\n0.0 0.0\n0.5 -0.1\n";
  for (const char* heading : {"Naca 0012 By Somebody", "NACA 64 210 airfoil", "Plate 2, 3 mm"}) {
    const Import import = read(std::string(heading) + "\n" + rows);
    REQUIRE(import.shapes.size() == 1);
    CHECK(import.shapes[0].name == heading);
    CHECK(import.shapes[0].document.vertices.size() == 4);
    CHECK(import.notes ==
          Notes{"the line \"" + std::string(heading) + "\" was taken as a heading"});
  }
  const Import survey = read(
      "Project: Plate 7\nDate: 03.05.2024 10:30\n\nPt  East  North\n1   0.0   0.0\n2   30.0  0.0\n"
      "3   30.0  20.5\n");
  CHECK(same_vertices(survey.shapes.at(0).document.vertices, corner));
  CHECK(survey.notes == Notes{"the first 2 lines were taken as headings"});
  std::string prose;
  for (int i = 0; i < 120; ++i) prose += "words\n";
  CHECK(refusal(prose + rows).find("unknown format") != std::string::npos);
  CHECK(notes("x,y\n0,0\n30,0\n30,20\n\nThe end\n") ==
        Notes{"1 line without numbers was left out"});
}

TEST_CASE("columns: a number alone before the rows must be their number", "[import][columns]") {
  CHECK(same_vertices(only("3\n0 0\n30 0\n30 20.5\n"), corner));
  CHECK(refusal("4\n0 0\n30 0\n30 20.5\n").find("line 1, column 1: a line has two numbers") == 0);
}

TEST_CASE("columns: the two surfaces of an airfoil are one outline", "[import][columns]") {
  const Points outline = {{1, 0}, {0.5, 0.1}, {0, 0}, {0.25, -0.05}};
  CHECK(
      same_vertices(only("Wing\n 3. 3.\n\n0 0\n0.5 0.1\n1 0\n\n0 0\n0.25 -0.05\n1 0\n"), outline));
  const char* upper[] = {"0 0\n.2 .1\n.5 .1\n.8 .05\n1 0\n", "1 0\n.8 .05\n.5 .1\n.2 .1\n0 0\n"};
  for (const char* first : upper)
    CHECK(only("Wing\n" + std::string(first) + "\n0 0\n.2 -.1\n.5 -.1\n.8 -.05\n1 0\n").size() ==
          8);
  CHECK(read("0 0\n1 0\n1 1\n\n0 0\n1 0\n1 2\n").shapes.size() == 2);
}

// --- Repeated vertices, and degrees

TEST_CASE("neighbours at one place are one vertex in every file, with a note", "[import]") {
  const Notes one = {"1 vertex at the place of the one before it was left out"};
  for (const char* text :
       {"0,0\n30,0\n30,0\n30,20.5\n", "POLYGON ((0 0, 30 0, 30 0, 30 20.5, 0 0))",
        "[[0,0],[30,0],[30,0],[30,20.5],[0,0]]", "[(0, 0), (30, 0), (30, 0), (30, 20.5)]",
        R"({"rings":[[[0,0],[30,0],[30,0],[30,20.5],[0,0]]]})",
        R"({"type":"Polygon","crs":{},"coordinates":[[[0,0],[30,0],[30,0],[30,20.5],[0,0]]]})"}) {
    INFO(text);
    CHECK(same_vertices(only(text), corner));
    CHECK(notes(text) == one);
  }
  CHECK(only("(0,0)\n(30,0)\n(30,0)\n(30,20)\n").size() == 4);  // refused as a polygon
}

TEST_CASE("coordinates in degrees are said to be no lengths", "[import]") {
  const std::string at_60 = "widths come out 1.997 times too large";
  const auto degrees = [](const std::string& text) {
    std::string found;
    for (const std::string& note : notes(text))
      if (note.find("degrees of longitude and latitude, not lengths") != std::string::npos)
        found = note;
    return found;
  };
  const std::string ring = "[[[10,60],[10.002,60],[10.002,60.001],[10,60]]]";
  for (const std::string& text :
       {R"({"type":"Polygon","coordinates":)" + ring + "}",
        R"({"type":"Polygon","crs":{"type":"name","properties":{"name":)"
        R"("urn:ogc:def:crs:OGC:1.3:CRS84"}},"coordinates":)" +
            ring + "}",
        R"({"rings":)" + ring + R"(,"spatialReference":{"wkid":4326}})",
        std::string(R"([{"lat":60,"lng":10},{"lat":60,"lng":10.002},{"lat":60.001,"lng":10.002}])"),
        std::string("lon,lat\n10,60\n10.002,60\n10.002,60.001\n"),
        std::string("Latitude;Longitude\n60;10\n60;10,002\n60,001;10,002\n"),
        std::string("SRID=4326;POLYGON((10 60,10.002 60,10.002 60.001,10 60))")}) {
    INFO(text);
    CHECK(degrees(text).find(at_60) != std::string::npos);
    CHECK(same_vertices(only(text), {{10, 60}, {10.002, 60}, {10.002, 60.001}}));
  }
  CHECK(degrees("lon,lat\n10,1\n10.1,1\n10.1,1.1\n").find("too large") == std::string::npos);
  CHECK_FALSE(degrees("lon,lat\n10,1\n10.1,1\n10.1,1.1\n").empty());
  for (const std::string& text :
       {R"({"type":"Polygon","crs":{"type":"name","properties":{"name":"EPSG:25832"}},)"
        R"("coordinates":)" +
            ring + "}",
        std::string(R"({"type":"Polygon","coordinates":[[[0,0],[500,0],[500,900]]]})"),
        R"({"type":"Feature","properties":{"centre_of_mass":null},"geometry":{"type":"Polygon",)"
        R"("coordinates":)" +
            ring + "}}",
        std::string("POLYGON((10 60,10.002 60,10.002 60.001,10 60))"),
        std::string("x,y\n10,60\n10.002,60\n10.002,60.001\n")})
    CHECK(degrees(text).empty());
  CHECK(notes("lat,lon\n1,10\n1,10.1\n1.1,10.1\n").at(0) ==
        "the latitude comes first here: x is the longitude, and y the latitude");
}

// --- WKT

TEST_CASE("WKT: collections, EWKT, heights and holes are read as in GeoJSON", "[import][wkt]") {
  for (const char* text :
       {"MULTIPOLYGON (((0 0, 30 0, 30 20.5, 0 0)))", "SRID=25832; POLYGON((0 0,30 0,30 20.5,0 0))",
        "POLYGON Z ((0 0 1,30 0 1,30 20.5 1,0 0 1))", "POLYGONM((0 0 1,30 0 2,30 20.5 3))",
        "polygon zm ((0 0 1 2,30 0 1 2,30 20.5 1 2))", "POLYGON ((0 0 nan,30 0 NaN,30 20.5 1))",
        "POLYGON ((0 0,30 0,30 20.5,0 0),(20 2,22 2,22 4,20 2))",
        "GEOMETRYCOLLECTION(POINT(1 2),POLYGON((0 0,30 0,30 20.5)))",
        "POLYGON ((0 0,30 0,30 20.5,0 0));\n"}) {
    INFO(text);
    CHECK(same_vertices(only(text), corner));
  }
  CHECK(notes("SRID=25832;POLYGON Z ((0 0 1,3 0 1,3 2 1),(2 1 1,2.5 1 1,2.5 1.5 1))") ==
        Notes{"coordinates beyond x and y were left out",
              "the reference system (SRID 25832) was left out"});
  CHECK(described("MULTIPOLYGON(((0 0,3 0,3 2,0 0)),((9 9,12 9,12 13,9 9)))").size() == 2);
  CHECK(described("POLYGON((0 0,3 0,3 2,0 0))\nPOLYGON((0 0,3 0,3 2,0 0))\n").size() == 2);
  CHECK(refusal("POINT (1 2)") == "this WKT has no polygon, only 1 Point");
  CHECK(refusal("POLYGON EMPTY") == "line 1, column 9: the polygon has no vertices");
  CHECK(refusal("MULTIPOLYGON (((0 0,3 0,3 2,0 0))").find("',' or ')'") != std::string::npos);
  std::string deep = "POLYGON((0 0,3 0,3 2))";
  for (int i = 0; i < 1000; ++i) deep = "GEOMETRYCOLLECTION(" + deep + ")";
  CHECK(refusal(deep).find("too deep") != std::string::npos);
}

TEST_CASE("WKT in a column of a table: each row is a shape with a name", "[import][wkt]") {
  for (const char* text :
       {"WKT,id,name\n\"POLYGON ((0 0,30 0,30 20.5,0 0))\",7,plate\n",
        "wkt_geom\tid\tname\nPolygon ((0 0, 30 0, 30 20.5, 0 0))\t7\tplate\n",
        "name;geom\nplate;SRID=25832;POLYGON((0 0,30 0,30 20.5,0 0))\n",
        "Name,fid,geometry\nplate,7,\"MULTIPOLYGON Z (((0 0 1,30 0 1,30 20.5 1,0 0 1)))\"\n",
        "fid,the_geom\nplate,\"POLYGON ((0 0,30 0,30 20.5),(9 1,10 1,10 2))\"\n"}) {
    INFO(text);
    const bool hole = std::string_view(text).find("(9 1") != std::string_view::npos;
    CHECK(described(text) == Notes{std::string("\"plate\", polygon, 3 vertices, ") +
                                   (hole ? "1 hole, " : "") + "30 x 20.5"});
    CHECK(same_vertices(only(text), corner));
  }
  const std::string two =
      "WKT,id\n\"POLYGON ((0 0,3 0,3 2,0 0))\",1\n\"POLYGON ((0 0,5 0,5,0 0))\",2\n"
      "\"POINT (0 0)\",3\n";
  CHECK(described(two) == Notes{"\"1\", polygon, 3 vertices, 3 x 2"});
  CHECK(notes(two).back().find("line 3, column 21") != std::string::npos);
  CHECK(refusal("WKT,id\n\"POINT (0 0)\",1\n\"POINT (1 0)\",2\n") ==
        "this table has no polygon, only 2 Points");
  CHECK(same_vertices(
      only("X,Y,WKT\n0,0,POINT (0 0)\n30,0,POINT (30 0)\n30,20.5,POINT (30 20.5)\n"), corner));
}

// --- JSON and Python

TEST_CASE("Esri JSON: rings that run the other way are holes", "[import][json]") {
  CHECK(described(R"({"features":[
      {"attributes":{"NAME":"plate"},"geometry":{"rings":[
        [[0,0],[0,80],[120,80],[120,0],[0,0]],[[10,10],[20,10],[20,20],[10,10]],
        [[200,0],[200,10],[210,10],[200,0]]]}},
      {"attributes":{"OBJECTID":5},"geometry":{"rings":[[[0,0],[5,5],[5,0],[0,0]]]}},
      {"attributes":{}}]})") == Notes{"\"plate\", polygon, 4 vertices, 1 hole, 120 x 80",
                                      "\"plate\", polygon, 3 vertices, 10 x 10",
                                      "\"5\", polygon, 3 vertices, 5 x 5"});
  CHECK(same_vertices(only(R"({"rings":[[[0,0,1],[30,0,1],[30,20.5,1],[0,0,1]]]})"), corner));
  CHECK(same_vertices(only(R"({"geometry":{"rings":[[[0,0],[30,0],[30,20.5]]]}})"), corner));
  CHECK(refusal(R"({"geometryType":"esriGeometryPolyline","features":[
      {"geometry":{"paths":[[[0,0],[1,1]]]}}]})") == "this Esri JSON has no polygon, only 1 line");
}

TEST_CASE("JSON: points have members as tables have columns", "[import][json]") {
  for (
      const char* text :
      {R"([{"X":0,"Y":0},{"X":30,"Y":0},{"X":30,"Y":20.5}])",
       R"([{"northing":0,"easting":0},{"northing":0,"easting":30},{"northing":20.5,"easting":30}])",
       R"([{"lon":0,"lat":0},{"lon":30,"lat":0},{"lon":30,"lat":20.5}])",
       R"({"vertices":[[0,0],[30,0],[30,20.5]],"thickness":3})"}) {
    INFO(text);
    CHECK(same_vertices(only(text), corner));
  }
  CHECK(refusal(R"({"type":"Topology","objects":{},"arcs":[]})").find("TopoJSON") !=
        std::string::npos);
}

TEST_CASE("Python's tuples and arrays are points", "[import][json]") {
  for (const char* text :
       {"[(0, 0), (30, 0), (30, 20.5)]\n", "((0,0),(30,0),(30,20.5))", "(0,0), (30,0), (30,20.5)\n",
        "[[0., 0.], [30., 0.], [30., 20.5],]", "[[ 0.   0. ]\n [30.   0. ]\n [30.  20.5]]",
        "[[(0,0),(30,0),(30,20.5)]]"}) {
    INFO(text);
    CHECK(same_vertices(only(text), corner));
  }
  CHECK(read("(0,0)\n(30,0)\n(30,20.5)\n").format == "text");
  CHECK(refusal("(1,2)(3,4)\n").find("the end of the line after ')'") != std::string::npos);
  CHECK(refusal("[(0, 0), (30, 0), 5]").find("expected points (x, y)") != std::string::npos);
  CHECK(refusal("((0,0),(30,0)").find("expected ')'") != std::string::npos);
  CHECK_FALSE(read_shapes(std::string(100000, '(')).ok());
}

// --- Other kinds

TEST_CASE("files of other kinds are refused by name", "[import]") {
  const std::pair<std::string, const char*> files[] = {
      {"# a program\no Cube\nv 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n", "a mesh (OBJ)"},
      {"mtllib a.mtl\nvn 0 0 1\nv 0 0 0\nv 1 0 0\n", "a mesh (OBJ)"},
      {"ply\nformat ascii 1.0\nelement vertex 3\nend_header\n0 0 0\n1 0 0\n1 1 0\n",
       "a mesh (PLY)"},
      {"solid a\n facet normal 0 0 1\n  outer loop\n", "a mesh (STL)"},
      {std::string(80, ' ') + std::string("\1\0\0\0", 4) + std::string(50, '\0'), "a mesh (STL)"},
      {"OFF\n3 1 0\n0 0 0\n1 0 0\n1 1 0\n3 0 1 2\n", "a mesh (OFF)"},
      {"A part" + std::string(66, ' ') + "S      1\n", "an IGES model"},
      {"ISO-10303-21;\nHEADER;\n", "a STEP model"},
      {"   LWPOLYLINE  Layer: \"0\"\n   Handle = 2b1\n   at point  X= 0.0  Y= 0.0\n", "LIST"},
      {"%\nO1000 (PLATE)\nN10 G21\nN20 G1 X0 Y0\n", "G-code"},
      {"(a plate)\nG90\nG01X1.5Y2\n", "G-code"},
      {";LAYER\nM104 S200\nG28\nG1 X10 Y20 E1\n", "G-code"},
      {"IN;SP1;PU0,0;PD30,0;", "HPGL"},
      {R"({"version":0.6,"elements":[{"type":"node","id":1,"lat":47.3,"lon":8.5}]})",
       "a map server's answer"}};
  for (const auto& [text, kind] : files) CHECK(refusal(text).find(kind) != std::string::npos);
  CHECK(read("solid line\n0 0\n1 0\n1 1\n").shapes.size() == 1);
}

TEST_CASE("tables that list other things than vertices are refused by what they list", "[import]") {
  const std::pair<const char*, const char*> tables[] = {
      {"Name,Length,Width,Thickness\nTop,1200,600,18\nSide,600,400,18\nShelf,1100,380,18\n",
       "sizes"},
      {"Teil;L\u00e4nge;Breite\nA;1200;600\nB;600;400\nC;500;30\n", "sizes"},
      {"xmin,ymin,xmax,ymax\n0,0,120,80\n200,0,250,50\n300,0,320,10\n", "boxes"},
      {"x_min\ty_min\tx_max\ty_max\n0\t0\t120\t80\n200\t0\t250\t50\n0\t0\t1\t1\n", "boxes"},
      {"x1,y1,x2,y2\n0,0,120,0\n120,0,120,80\n120,80,0,0\n", "lines from"},
      {"Corner,1,2,3,4\nx,0,120,120,0\ny,0,0,80,80\nz,5,5,5,5\n", "swap its rows"},
      {"0 0.1 0.1 0.3 0.1 0.3 0.2 0.1 0.2\n0 0.5 0.5 0.7 0.5 0.7 0.6 0.5 0.6\n", "four corners"},
      {"0,0,120,0,120,80,0,80\n200,0,250,0,250,50,200,50\n", "four corners"}};
  for (const auto& [text, kind] : tables) {
    INFO(text);
    CHECK(refusal(text).find(kind) != std::string::npos);
  }
  // Coordinates beside sizes are coordinates.
  CHECK(read("x,y,Length,Width\n0,0,1,1\n3,0,1,1\n3,2,1,1\n").shapes.size() == 1);
}

TEST_CASE("a column of words or small numbers tells the shapes, whatever its name", "[import]") {
  const Import found = read(
      "x,y,plate\n0,0,left\n120,0,left\n120,80,left\n-50,80,right\n-100,80,right\n-100,0,right\n");
  REQUIRE(found.shapes.size() == 2);
  CHECK(found.shapes[1].name == "right");
  CHECK(read("x;y;Bauteil\n0;0;1\n12;0;1\n12;8;1\n-5;8;2\n-9;8;2\n-9;0;2\n").shapes.size() == 2);
  // Amounts do not, and are named.
  const Import holes = read("x,y,Dia\n0,0,5\n120,0,5\n120,80,5\n0,80,6\n0,70,6\n0,60,6\n");
  CHECK(holes.shapes.size() == 1);
  CHECK(holes.notes ==
        std::vector<std::string>{"the column \"Dia\" was left out: if the rows are holes, they are "
                                 "not an outline; if robots stand there, they are supports"});
  const Import supports = read("x,y,capacity\n10,10,25\n110,10,25\n110,70,24\n10,70,26\n");
  CHECK(supports.notes ==
        std::vector<std::string>{"the column \"capacity\" was left out: if the rows are places of "
                                 "robots, they are supports, not an outline"});
}

TEST_CASE("WKT is read as Python prints it", "[import][wkt]") {
  const Import one = read("<POLYGON ((0 0, 120 0, 120 80, 0 80, 0 0))>\n");
  REQUIRE(one.shapes.size() == 1);
  CHECK(one.shapes[0].document.vertices.size() == 4);
  const Import list = read(
      "[<POLYGON ((0 0, 120 0, 120 80, 0 80, 0 0))>, <POLYGON ((200 0, 220 0, 220 80, 200 0))>]");
  CHECK(list.shapes.size() == 2);
}

TEST_CASE("blank rows separate shapes only if each could be one", "[import][columns]") {
  const auto sizes = [](const std::string& text) {
    std::vector<std::size_t> all;
    for (const ImportedShape& shape : evenlift::testing::read(text).shapes)
      all.push_back(shape.document.vertices.size());
    return all;
  };
  using Sizes = std::vector<std::size_t>;
  CHECK(sizes("x;y\n0;0\n120;0\n;\n120;80\n0;80\n") == Sizes{4});
  CHECK(sizes("0 0\n120 0\n\n120 80\n0 80\n") == Sizes{4});
  CHECK(sizes("x;y\n0;0\n9;0\n9;9\n;\n0;0\n5;0\n5;5\n") == Sizes{3, 3});
}

TEST_CASE("GeoJSON features may follow each other", "[import][geojson]") {
  const auto feature = [](const std::string& name, double side) {
    const std::string s = shortest(side);
    return "{\"type\":\"Feature\",\"properties\":{\"name\":\"" + name +
           "\"},\"geometry\":{\"type\":\"Polygon\",\"coordinates\":[[[0,0],[" + s + ",0],[" + s +
           "," + s + "],[0,0]]]}}";
  };
  for (const std::string& text : {"\x1e" + feature("a", 9) + "\n\x1e" + feature("b", 5) + "\n",
                                  feature("a", 9) + "\n" + feature("b", 5) + "\n"}) {
    const Import import = evenlift::testing::read(text);
    REQUIRE(import.shapes.size() == 2);
    CHECK(import.shapes[0].name == "a");
    CHECK(import.shapes[1].name == "b");
  }
  CHECK(evenlift::testing::read(feature("a", 9)).shapes.size() == 1);
}

TEST_CASE("of columns that name x and y equally well, the first pair counts", "[import]") {
  const Import import = evenlift::testing::read(
      "Position X,Position Y,Center X,Center Y\n0,0,5,5\n40,0,6,5\n40,30,6,6\n0,30,5,6\n");
  CHECK(import.shapes.at(0).document.vertices == Points{{0, 0}, {40, 0}, {40, 30}, {0, 30}});
  CHECK(import.notes == std::vector<std::string>{"the column \"Center X\" was left out",
                                                 "the column \"Center Y\" was left out"});
}

TEST_CASE("Esri JSON: the reference system of a set of features says that they are degrees",
          "[import][json]") {
  const std::string rings = "[[[10,60],[10,60.001],[10.002,60.001],[10,60]]]",
                    system = R"("spatialReference":{"wkid":4326})";
  for (const std::string& text :
       {"{\"features\":[{\"geometry\":{\"rings\":" + rings + "}}]," + system + "}",
        "{\"features\":[{\"geometry\":{\"rings\":" + rings + "," + system + "}}]}"}) {
    INFO(text);
    const auto notes = evenlift::testing::read(text).notes;
    CHECK(std::any_of(notes.begin(), notes.end(), [](const std::string& each) {
      return each.find("degrees") != std::string::npos;
    }));
  }
}

TEST_CASE("what is told about rings counts all of them", "[import][wkt]") {
  const auto notes = [](const std::string& text) { return evenlift::testing::read(text).notes; };
  using Notes = std::vector<std::string>;
  CHECK(
      notes(
          "MULTIPOLYGON(((0 0,9 0,9 0,9 9,0 0),(7 1,8 1,8 1,8 2,7 1)),((20 0,29 0,29 9,20 0)))") ==
      Notes{"2 vertices at the place of the one before them were left out"});
  // Degrees in one of several reference systems.
  const std::string in_degrees = "SRID=4326;POLYGON((10 60,10.002 60,10.002 60.001,10 60))",
                    in_metres = "SRID=25832;POLYGON((0 0,30 0,30 20.5,0 0))";
  for (const std::string& text : {in_degrees + "\n" + in_metres, in_metres + "\n" + in_degrees}) {
    const Notes all = notes(text);
    CHECK(std::any_of(all.begin(), all.end(), [](const std::string& each) {
      return each.find("degrees") != std::string::npos;
    }));
  }
}

TEST_CASE("tables of supports name their columns as outlines do", "[import][supports]") {
  for (const char* heading :
       {"Easting,Northing", "Position X,Position Y", "X-Coordinate,Y-Coordinate"}) {
    INFO(heading);
    const auto read = read_support_file(std::string(heading) + ",capacity\n0,0,3\n120,40,4\n");
    REQUIRE(read.ok());
    REQUIRE(read->places.size() == 2);
    CHECK(read->places[1] == Vec2(120, 40));
    CHECK(read->capacities.at(1) == 4.0);
  }
}
