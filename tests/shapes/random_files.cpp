#include "shapes/random_files.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "evenlift/hull.h"
#include "evenlift/import.h"
#include "evenlift/numbers.h"
#include "evenlift/random.h"
#include "evenlift/vec.h"

namespace random_files {
namespace {

using evenlift::Points;
using evenlift::Rng;
using evenlift::shortest;
using evenlift::Vec2;

// In whole numbers, so that areas are exact and nothing touches.
struct Cell {
  int x, y, width, height;
};

// A rectangle whose corners are cut, so that no reader takes it for a sheet.
Points ring_in(const Cell& cell) {
  const double x = cell.x, y = cell.y, w = cell.width, h = cell.height, c = 1;
  return {{x + c, y},         {x + w - c, y}, {x + w, y + c}, {x + w, y + h - c},
          {x + w - c, y + h}, {x + c, y + h}, {x, y + h - c}, {x, y + c}};
}

double area_in(const Cell& cell) { return cell.width * cell.height - 2.0; }

struct Nested {
  std::vector<Points> rings;
  std::vector<Shape> shapes;
};

// A ring, and rings in it side by side. Every other level is a shape, whose children are its holes.
void nest(Rng& rng, const Cell& cell, bool is_shape, Nested& nested) {
  nested.rings.push_back(ring_in(cell));
  const std::size_t shape = nested.shapes.size();
  if (is_shape) nested.shapes.push_back({area_in(cell), 0});
  const int count = static_cast<int>(rng.below(4)), gap = 3;
  const int width = count == 0 ? 0 : (cell.width - gap) / count - gap;
  for (int i = 0; i < count && width >= 6 && cell.height >= 12; ++i) {
    const Cell child{cell.x + gap + i * (width + gap), cell.y + gap, width, cell.height - 2 * gap};
    if (is_shape) {
      nested.shapes[shape].area -= area_in(child);
      ++nested.shapes[shape].holes;
    }
    nest(rng, child, !is_shape, nested);
  }
}

Nested plates(Rng& rng) {
  Nested nested;
  const std::size_t count = 1 + rng.below(3);
  for (std::size_t i = 0; i < count; ++i) {
    const int width = 40 + static_cast<int>(rng.below(100)),
              height = 30 + static_cast<int>(rng.below(90));
    nest(rng, {20 + static_cast<int>(i) * 160, 20, width, height}, true, nested);
  }
  return nested;
}

template <class Value>
void shuffle(Rng& rng, std::vector<Value>& values) {
  for (std::size_t i = values.size(); i > 1; --i) std::swap(values[i - 1], values[rng.below(i)]);
}

// From beside the plates to somewhere among them. Two segments cannot enclose anything, even if the end
// comes to lie on a line by chance, nor can lines that begin at different places.
Points open_line(Rng& rng, std::size_t number) {
  Points points{{3.3, 5.1 + 7 * static_cast<double>(number)}};
  const std::size_t count = 1 + rng.below(2);
  for (std::size_t i = 0; i < count; ++i) {
    const double x = 15.37 + 440 * rng.uniform(), y = 15.61 + 110 * rng.uniform();
    points.emplace_back(x, y);
  }
  return points;
}

// --- SVG

std::string path_of(const Points& points, bool closed) {
  std::string d = "M";
  for (const Vec2& p : points) d += shortest(p.x) + " " + shortest(p.y) + " ";
  return "<path fill='none' stroke='#000' d='" + d + (closed ? "Z" : "") + "'/>";
}

// Each element in an entity, and entities in entities.
std::string by_entities(Rng& rng, const std::vector<std::string>& elements) {
  std::string declared, used;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const std::string name = "e" + std::to_string(i);
    const bool is_inner = i > 0 && rng.below(3) == 0;
    declared += "<!ENTITY " + name + " \"" +
                (is_inner ? "&f" + std::to_string(i) + ";" : elements[i]) + "\">";
    if (is_inner) declared += "<!ENTITY f" + std::to_string(i) + " \"" + elements[i] + "\">";
    used += "&" + name + ";";
  }
  return "<!DOCTYPE svg [" + declared +
         "]><svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 500 140'>" + used + "</svg>";
}

File svg(Rng& rng, Nested nested) {
  File file{"SVG", {}, std::move(nested.shapes), {}, {}};
  std::vector<std::string> elements;
  for (const Points& ring : nested.rings) elements.push_back(path_of(ring, true));
  const std::size_t open = rng.below(3);
  for (std::size_t i = 0; i < open; ++i) elements.push_back(path_of(open_line(rng, i), false));
  shuffle(rng, elements);
  if (rng.below(2) == 0)
    elements.insert(elements.begin(), "<rect width='500' height='140' fill='white'/>");
  if (rng.below(3) == 0) {
    file.what += " with entities";
    file.text = by_entities(rng, elements);
    return file;
  }
  file.text = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 500 140'>";
  for (const std::string& element : elements)
    file.text += rng.below(3) == 0
                     ? "<g transform='translate(7 -3)'><g transform='translate(-7 3)'>" + element +
                           "</g></g>"
                     : element;
  file.text += "</svg>";
  return file;
}

// --- DXF

struct CodePage {
  std::string_view name, bytes, utf8;
};
constexpr CodePage code_pages[] = {
    {"ANSI_1252",
     "Blech Gr\xf6\xdf"
     "e",
     "Blech Gr\u00f6\u00dfe"},
    {"ANSI_1251", "\xc4\xe5\xf2\xe0\xeb\xfc", "\u0414\u0435\u0442\u0430\u043b\u044c"},
    {"ANSI_1250", "\xe8\xe1st", "\u010d\u00e1st"},
    {"ANSI_932", "\x95\x94\x95i", "\u90e8\u54c1"},
    {"ANSI_936", "\xb2\xbf\xbc\xfe", "\u90e8\u4ef6"},
    {"ANSI_1252", "T\\U+00E9l", "T\u00e9l"}};

std::string entity(std::string_view kind, std::string_view layer) {
  return "0\n" + std::string(kind) + "\n8\n" + std::string(layer) + "\n";
}

std::string point_in_dxf(const Vec2& p, int code) {
  return std::to_string(code) + "\n" + shortest(p.x) + "\n" + std::to_string(code + 10) + "\n" +
         shortest(p.y) + "\n";
}

std::string line_in_dxf(const Vec2& from, const Vec2& to, std::string_view layer) {
  return entity("LINE", layer) + point_in_dxf(from, 10) + point_in_dxf(to, 11);
}

File dxf(Rng& rng, Nested nested) {
  const CodePage& page = code_pages[rng.below(std::size(code_pages))];
  File file{"DXF", {}, std::move(nested.shapes), std::string(page.utf8), {}};
  const bool by_lines = rng.below(2) == 0;
  std::vector<std::string> entities;
  for (const Points& ring : nested.rings) {
    if (!by_lines) {
      std::string text = entity("LWPOLYLINE", page.bytes) + "70\n1\n";
      for (const Vec2& p : ring) text += point_in_dxf(p, 10);
      entities.push_back(text);
      continue;
    }
    for (std::size_t i = 0; i < ring.size(); ++i) {
      Vec2 from = ring[i], to = ring[(i + 1) % ring.size()];
      if (rng.below(2) == 0) std::swap(from, to);
      entities.push_back(line_in_dxf(from, to, page.bytes));
    }
  }
  const std::size_t open = rng.below(3);
  for (std::size_t k = 0; k < open; ++k) {
    const Points line = open_line(rng, k);
    for (std::size_t i = 1; i < line.size(); ++i)
      entities.push_back(line_in_dxf(line[i - 1], line[i], page.bytes));
  }
  shuffle(rng, entities);
  file.text = "0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1015\n9\n$DWGCODEPAGE\n3\n" +
              std::string(page.name) + "\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n";
  for (const std::string& text : entities) file.text += text;
  file.text += "0\nENDSEC\n0\nEOF\n";
  return file;
}

// --- Tables

File table(Rng& rng) {
  File file{"table", {}, {}, {}, {}};
  constexpr std::pair<const char*, const char*> names[] = {{"x", "y"},
                                                           {"X (mm)", "Y (mm)"},
                                                           {"Easting", "Northing"},
                                                           {"Rechtswert", "Hochwert"},
                                                           {"POINT_X", "POINT_Y"},
                                                           {"Position X", "Position Y"},
                                                           {"coord_x", "coord_y"},
                                                           {"Ost", "Nord"}};
  const auto& [x, y] = names[rng.below(std::size(names))];
  const char separator = ",;\t|"[rng.below(4)];
  const bool decimal_comma = separator != ',' && rng.below(2) == 0, swapped = rng.below(4) == 0;
  constexpr const char* groups[] = {"part", "Bauteil", "plate", "room", "Layer", ""};
  constexpr const char* further[] = {"", "Remark", "capacity (kg)", "Thickness"};
  const std::string group = groups[rng.below(std::size(groups))],
                    more = further[rng.below(std::size(further))];
  const bool numbered = rng.below(2) == 0;
  const auto row = [&](const std::vector<std::string>& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i)
      file.text += (i > 0 ? std::string(1, separator) : "") + cells[i];
    file.text += rng.below(2) == 0 ? "\n" : "\r\n";
  };
  const auto cells = [&](const std::string& number, const std::string& a, const std::string& b,
                         const std::string& of, const std::string& last) {
    std::vector<std::string> all;
    if (numbered) all.push_back(number);
    all.push_back(swapped ? b : a);
    all.push_back(swapped ? a : b);
    if (!group.empty()) all.push_back(of);
    if (!more.empty()) all.push_back(last);
    return all;
  };
  row(cells("No", x, y, group, more));
  const std::size_t count = 1 + rng.below(3);
  int number = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const int width = 9 + static_cast<int>(rng.below(40)),
              height = 9 + static_cast<int>(rng.below(40));
    const Cell cell{static_cast<int>(i) * 60, 0, width, height};
    if (i > 0 && group.empty()) file.text += "\n";
    for (const Vec2& p : ring_in(cell)) {
      const auto written = [&](double value) {
        std::string text = shortest(value + 0.25);
        if (decimal_comma) std::replace(text.begin(), text.end(), '.', ',');
        return text;
      };
      ++number;
      row(cells(std::to_string(number), written(p.x), written(p.y), "p" + std::to_string(i),
                std::to_string(7 + number % 3)));
    }
    file.shapes.push_back({area_in(cell), 0});
  }
  if (!more.empty()) file.notes.push_back("the column \"" + more + "\" was left out");
  return file;
}

}  // namespace

File make_file(std::uint64_t number) {
  Rng rng(number);
  const std::uint64_t kind = rng.below(3);
  if (kind == 2) return table(rng);
  Nested nested = plates(rng);
  return kind == 0 ? svg(rng, std::move(nested)) : dxf(rng, std::move(nested));
}

std::string compare(const File& file) {
  const auto told = [&](const std::string& what) {
    return file.what + ": " + what + "\n" + file.text;
  };
  const auto read = evenlift::read_shapes(file.text);
  if (!read) return told("it is refused: " + read.error().message);
  std::vector<Shape> found;
  for (const evenlift::ImportedShape& shape : read->shapes) {
    if (shape.sheet) continue;
    double area = std::abs(signed_area(shape.document.vertices));
    for (const Points& hole : shape.document.holes) area -= std::abs(signed_area(hole));
    found.push_back({area, shape.document.holes.size()});
    if (!file.name.empty() && shape.name.find(file.name) != 0)
      return told("a shape is called " + shape.name + ", not " + file.name);
  }
  std::vector<Shape> wanted = file.shapes;
  const auto comes_first = [](const Shape& a, const Shape& b) {
    return std::abs(a.area - b.area) > 1e-6 ? a.area < b.area : a.holes < b.holes;
  };
  std::sort(found.begin(), found.end(), comes_first);
  std::sort(wanted.begin(), wanted.end(), comes_first);
  const auto list = [](const std::vector<Shape>& shapes) {
    std::string text;
    for (const Shape& each : shapes)
      text += " " + shortest(each.area) + "/" + std::to_string(each.holes);
    return text;
  };
  const bool equal =
      found.size() == wanted.size() &&
      std::equal(found.begin(), found.end(), wanted.begin(), [](const Shape& a, const Shape& b) {
        return std::abs(a.area - b.area) < 1e-6 && a.holes == b.holes;
      });
  if (!equal) return told("its shapes (area/holes) are" + list(found) + ", not" + list(wanted));
  for (const std::string& note : file.notes)
    if (std::none_of(read->notes.begin(), read->notes.end(),
                     [&](const std::string& each) { return each.find(note) == 0; }))
      return told("it does not tell: " + note);
  return {};
}

}  // namespace random_files
