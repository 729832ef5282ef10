#include "import/other_kinds.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "evenlift/numbers.h"
#include "evenlift/predicates.h"
#include "evenlift/vec.h"
#include "import/tables/table_headings.h"
#include "numbers/text_cursor.h"

namespace evenlift {
namespace {

constexpr std::size_t first_rows_of_table = 100;

using Table = std::vector<Fields>;

Table rows_of(std::string_view text) {
  Table rows;
  Lines lines(text);
  for (auto line = lines.next(); line && rows.size() < first_rows_of_table; line = lines.next())
    rows.push_back(split_cells(line->text, separator_of(line->text)));
  return rows;
}

// Letters and digits only, in lower case: "x_min" and "X Min" are "xmin". Includes letters beyond
// ASCII.
std::string plain_word(std::string_view heading) {
  std::string word;
  for (const char c : heading)
    if (is_letter(c) || is_digit(c) || static_cast<unsigned char>(c) >= 0x80) word += lower_case(c);
  return word;
}

bool has_heading(const Fields& headings, WordList words) {
  return std::any_of(headings.begin(), headings.end(),
                     [&](std::string_view heading) { return words.has(plain_word(heading)); });
}

// Of parts: a length and a width or thickness, but no coordinates.
bool lists_sizes(const Table& rows) {
  return has_heading(rows[0], "length länge laenge longueur largo lunghezza lengte"_words) &&
         has_heading(
             rows[0],
             "width breadth breite largeur ancho larghezza breedte thickness dicke"_words) &&
         !named_columns(rows[0]);
}

bool lists_boxes(const Table& rows) {
  return has_heading(rows[0], "xmin minx"_words) && has_heading(rows[0], "xmax maxx"_words);
}

bool lists_segments(const Table& rows) {
  return has_heading(rows[0], "x1 startx"_words) && has_heading(rows[0], "x2 endx"_words) &&
         has_heading(rows[0], "y1 starty"_words);
}

std::size_t numbers_after_first(const Fields& cells) {
  const auto numbers = std::count_if(cells.begin() + 1, cells.end(), [](std::string_view cell) {
    return cell_number(cell, false).has_value();
  });
  return static_cast<std::size_t>(numbers);
}

// A row "x" with all x, and one "y" with as many.
bool is_transposed(const Table& rows) {
  std::size_t x = 0, y = 0;
  for (const Fields& cells : rows) {
    if (cells.size() < 4 || numbers_after_first(cells) + 1 != cells.size()) continue;
    if (same_word(cells[0], "x")) x = cells.size();
    if (same_word(cells[0], "y")) y = cells.size();
  }
  return x > 0 && x == y;
}

// Eight numbers in each row, or nine after a class: the corners of a convex quadrilateral.
bool lists_four_corners(const Table& rows) {
  if (rows.size() < 2) return false;  // one row may list the points of a shape
  for (const Fields& cells : rows) {
    if (cells.size() != 8 && cells.size() != 9) return false;
    std::array<Vec2, 4> corners;
    for (std::size_t i = 0; i < 8; ++i) {
      const auto number = cell_number(cells[cells.size() - 8 + i], false);
      if (!number) return false;
      (i % 2 == 0 ? corners[i / 2].x : corners[i / 2].y) = *number;
    }
    std::size_t left = 0, right = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const double turn = orient(corners[i], corners[(i + 1) % 4], corners[(i + 2) % 4]);
      left += turn > 0 ? 1 : 0;
      right += turn < 0 ? 1 : 0;
    }
    if (left != 4 && right != 4) return false;
  }
  return true;
}

struct KindOfTable {
  bool (*is_kind)(const Table& rows);
  const char* refusal;
};

constexpr KindOfTable table_kinds[] = {
    {lists_sizes, "this table lists sizes of parts (length, width), not coordinates of vertices"},
    {lists_boxes,
     "this table lists boxes (xmin, ymin, xmax, ymax), not vertices: write the corners of one, a line "
     "for each"},
    {lists_segments,
     "this table lists lines from (x1, y1) to (x2, y2), not vertices: save the drawing as DXF or SVG"},
    {is_transposed,
     "this table has all x in one row and all y in another: swap its rows and columns"},
    {lists_four_corners,
     "each row has four corners: write the corners of a shape in a line each, with a blank line "
     "between shapes"},
};

// Of a table that lists other things than vertices; null for other texts. `beginning` may end within
// a line.
const char* refusal_of_other_table(std::string_view beginning) {
  const Table rows = rows_of(beginning);
  if (rows.empty()) return nullptr;
  for (const KindOfTable& kind : table_kinds)
    if (kind.is_kind(rows)) return kind.refusal;
  return nullptr;
}

using std::string_view_literals::operator""sv;

struct FirstBytes {
  std::string_view begins;
  const char* refusal;
};

constexpr FirstBytes binary_kinds[] = {
    {"AutoCAD Binary DXF",
     "this is a binary DXF drawing, and evenlift reads only DXF as text: save it again as ASCII DXF"},
    {"AC10", "this is a DWG drawing, which evenlift does not read: save it as ASCII DXF"},
    {"\x89PNG",
     "this is a picture made of dots, which has no outline: trace it to SVG first (in Inkscape: Path, "
     "Trace Bitmap)"},
    {"\xff\xd8\xff",
     "this is a photo, which has no outline: trace it to SVG first (in Inkscape: Path, Trace Bitmap)"},
    {"GIF8",
     "this is a picture made of dots, which has no outline: trace it to SVG first (in Inkscape: Path, "
     "Trace Bitmap)"},
    {"%PDF", "this is a PDF, which evenlift does not read: open it in Inkscape and save it as SVG"},
    {"%!PS",
     "this is PostScript, which evenlift does not read: open it in Inkscape and save it as SVG"},
    {"PK\x03\x04",
     "this is a compressed file, such as a spreadsheet: unpack it, or save the sheet as CSV"},
    {"\xd0\xcf\x11\xe0", "this is a file of an office program: save the sheet as CSV"},
    {"\x1f\x8b", "this is a compressed file: unpack it first (an .svgz contains an .svg)"},
    {"\xff\xfe", "this text is in UTF-16: save it again as UTF-8"},
    {"\xfe\xff", "this text is in UTF-16: save it again as UTF-8"},
    {"\0\0\x27\x0a"sv, "this is a shapefile, which evenlift does not read: save it as GeoJSON"},
    {"SQLite format 3",
     "this is a database (GeoPackage or SpatiaLite), which evenlift does not read: save the layer as "
     "GeoJSON"},
    {"3D Geometry File Format",
     "this is a Rhino model, which evenlift does not read: save the outline as ASCII DXF"},
    {"ISO-10303-21",
     "this is a STEP model, which evenlift does not read: save the outline of its face as DXF or SVG"},
};

// --- Kinds of text

constexpr char mesh_obj[] =
    "this is a mesh (OBJ), not an outline: save the outline of its face as DXF or SVG";
constexpr char mesh_ply[] =
    "this is a mesh (PLY), not an outline: save the outline of its face as DXF or SVG";
constexpr char mesh_stl[] =
    "this is a mesh (STL), not an outline: save the outline of its face as DXF or SVG";
constexpr char mesh_off[] =
    "this is a mesh (OFF), not an outline: save the outline of its face as DXF or SVG";
constexpr char iges[] =
    "this is an IGES model, which evenlift does not read: save the outline of its face as DXF or SVG";
constexpr char autocad_list[] =
    "this is the output of AutoCAD's LIST, which evenlift does not read: save the drawing as ASCII "
    "DXF";
constexpr char g_code[] =
    "this is G-code, the path of a tool and not an outline: save the drawing that it was made from "
    "as DXF or SVG";
constexpr char plotter[] =
    "this is a plotter's file (HPGL), which evenlift does not read: save the drawing as DXF or SVG";
constexpr char gerber[] =
    "this is a Gerber file, which evenlift does not read: save the outline of the board as DXF or "
    "SVG";

constexpr char map_answer[] =
    "this is a map server's answer (OpenStreetMap, Overpass), whose nodes are in no order: ask for "
    "GeoJSON, or convert it";

constexpr char map_area[] =
    "this is an area of OpenStreetMap (.poly), which evenlift does not read: convert it to GeoJSON or "
    "WKT";

// A file shows its kind within these.
constexpr std::size_t first_lines_of_text = 500, first_bytes = 65536;

bool contains(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

std::string_view first_word(std::string_view line) {
  line = trimmed(line);
  return line.substr(0, line.find_first_of(" \t"));
}

// Without the comments and blank lines before it.
std::string_view first_line(std::string_view text) {
  const std::optional<Line> line = Lines(text).next();
  return line ? trimmed(line->text) : std::string_view();
}

bool is_ply(std::string_view text) {
  return text.starts_with("ply\n") || text.starts_with("ply\r");
}

bool is_text_stl(std::string_view text) {
  if (!same_word(first_word(first_line(text)), "solid")) return false;
  return contains(text, "facet") || contains(text, "FACET");
}

// A header of 80 bytes, the number of triangles, and 50 bytes for each.
bool is_binary_stl(std::string_view text) {
  if (text.size() < 84) return false;
  std::uint64_t triangles = 0;
  for (std::size_t i = 84; i-- > 80;)
    triangles = triangles << 8 | static_cast<unsigned char>(text[i]);
  return text.size() == 84 + 50 * triangles;
}

bool is_off(std::string_view text) {
  return "OFF COFF NOFF CNOFF STOFF"_words.has(first_word(first_line(text)));
}

// Lines up to the first vertex begin with words of the format. A table may also name a point "v",
// but without three coordinates.
bool is_obj(std::string_view text) {
  Lines lines(text);
  for (std::size_t i = 0; i < first_lines_of_text; ++i) {
    const std::optional<Line> line = lines.next();
    if (!line) return false;
    const Fields cells = split_cells(line->text, ' ');
    if (cells.empty()) return false;
    if (cells[0] == "v")
      return cells.size() >= 4 && std::all_of(cells.begin() + 1, cells.end(),
                                              [](auto cell) { return read_number(cell); });
    if (!"mtllib usemtl o g s vn vt vp l f"_words.has(cells[0])) return false;
  }
  return false;
}

// Lines have 80 characters; the 73rd names the section.
bool is_iges(std::string_view text) {
  const std::string_view line = text.substr(0, text.find_first_of("\r\n"));
  return line.size() == 80 && line[72] == 'S' && is_digit(line[79]) &&
         line.substr(73).find_first_not_of(" 0123456789") == std::string_view::npos;
}

bool is_autocad_list(std::string_view text) {
  return contains(text, "Layer:") && (contains(text, "at point  X=") || contains(text, "Handle ="));
}

// A word such as "G1" or "X-0.5".
bool sees_address(std::string_view line, std::size_t at, std::string_view letters) {
  if (letters.find(line[at]) == std::string_view::npos || at + 1 >= line.size()) return false;
  const char next = line[at + 1];
  return is_digit(next) || ((next == '-' || next == '.' || next == '+') && line[at] != 'G');
}

bool has_address(std::string_view line, std::string_view letters) {
  for (std::size_t at = 0; at < line.size(); ++at)
    if (sees_address(line, at, letters) && (at == 0 || !is_letter(line[at - 1]))) return true;
  return false;
}

// A table may name its points G1 and G2, but its coordinates have no letters.
bool is_move(std::string_view line) {
  return sees_address(line, 0, "GN") && has_address(line, "G") && has_address(line, "XYIJ");
}

// The thesis's format also begins with a parenthesis, but has no words.
bool is_g_code_comment(std::string_view line) {
  if (line[0] == ';' || line[0] == '%') return true;
  if (line[0] != '(') return false;
  for (std::size_t i = 1; i < line.size(); ++i)
    if (is_letter(line[i - 1]) && is_letter(line[i])) return true;
  return false;
}

// Before the first move come commands, comments in parentheses or after semicolons, or the
// program's percent sign and number.
bool is_g_code(std::string_view text) {
  Lines lines(text);
  for (std::size_t i = 0; i < first_lines_of_text; ++i) {
    const std::optional<Line> next = lines.next();
    if (!next) return false;
    const std::string_view line = trimmed(next->text);
    if (is_move(line)) return true;
    if (!is_g_code_comment(line) && !sees_address(line, 0, "GMNTSFO")) return false;
  }
  return false;
}

bool is_plotter_file(std::string_view text) {
  const std::string_view line = first_line(text);
  return line.starts_with("IN;") || line.starts_with("\x1b%") || line.starts_with("PU;") ||
         (line.starts_with("SP") && contains(line, ";PU"));
}

// The answer of a map server: nodes, each with its place, and perhaps ways that name them.
bool is_map_answer(std::string_view text) {
  return first_line(text).starts_with('{') && contains(text, "\"elements\"") &&
         contains(text, "\"node\"") && contains(text, "\"lat\"");
}

// A name, and rings: each has a name, indented lines of longitude and latitude, and END.
bool is_map_area(std::string_view text) {
  Lines lines(text);
  lines.next();
  const std::optional<Line> name = lines.next(), first = lines.next();
  if (!first || split_cells(name->text, ' ').size() != 1 || !is_space_in_line(first->text[0]))
    return false;
  const Fields cells = split_cells(first->text, ' ');
  const bool ends = text.size() == first_bytes || contains(text, "\nEND\n") ||
                    contains(text, "\nEND\r") || text.ends_with("\nEND");
  return ends && cells.size() == 2 && cell_number(cells[0], false) &&
         numbers_after_first(cells) == 1;
}

bool is_gerber(std::string_view text) { return contains(text, "%FSLA") || contains(text, "%FSTA"); }

struct KindOfText {
  bool (*is_kind)(std::string_view text);
  const char* refusal;
};

constexpr KindOfText text_kinds[] = {
    {is_ply, mesh_ply},          {is_text_stl, mesh_stl}, {is_off, mesh_off},
    {is_obj, mesh_obj},          {is_iges, iges},         {is_autocad_list, autocad_list},
    {is_gerber, gerber},         {is_g_code, g_code},     {is_plotter_file, plotter},
    {is_map_answer, map_answer}, {is_map_area, map_area},
};

}  // namespace

const char* refusal_of_other_kind(std::string_view text) {
  for (const FirstBytes& kind : binary_kinds)
    if (text.starts_with(kind.begins)) return kind.refusal;
  if (is_binary_stl(text)) return mesh_stl;
  const std::string_view beginning = text.substr(0, first_bytes);
  for (const KindOfText& kind : text_kinds)
    if (kind.is_kind(beginning)) return kind.refusal;
  return refusal_of_other_table(beginning);
}

}  // namespace evenlift
