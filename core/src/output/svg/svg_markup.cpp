#include "output/svg/svg_markup.h"

#include "evenlift/output/markup.h"
#include "output/words/ascii_number.h"

namespace evenlift::svg {

std::string px(double value) {
  std::string text = ascii_fixed(value, 2);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text;
}

std::string attribute(std::string_view name, std::string_view value) {
  return " " + std::string(name) + "=\"" + std::string(value) + "\"";
}

std::string attribute(std::string_view name, double value) { return attribute(name, px(value)); }

std::string element(std::string_view tag, std::string_view attributes) {
  return "<" + std::string(tag) + std::string(attributes) + "/>\n";
}

namespace {

std::string path_data(const Points& points, bool closed) {
  std::string data;
  for (const Vec2& p : points) data += (data.empty() ? "M" : "L") + px(p.x) + " " + px(p.y);
  return data + (closed ? "Z" : "");
}

}  // namespace

std::string path(const Points& points, bool closed) {
  return attribute("d", path_data(points, closed));
}

std::string path(const std::vector<Points>& rings) {
  std::string data;
  for (const Points& ring : rings) data += path_data(ring, true);
  return attribute("d", data);
}

std::string arrow(const Vec2& tail, const Vec2& head, std::string_view colour) {
  const Vec2 along = unit(head - tail), across(-along.y, along.x);
  const Vec2 neck = head - 9 * along;
  const auto line = [&](std::string_view stroke, double width) {
    return element("path", path({tail, neck}, false) + attribute("stroke", stroke) +
                               attribute("stroke-width", width) +
                               attribute("stroke-linecap", "round"));
  };
  return line("#FFFFFF", 6) + line(colour, 3) +
         element("path", path({head, neck + 5.5 * across, neck - 5.5 * across}, true) +
                             attribute("fill", colour) + attribute("stroke", "#FFFFFF") +
                             attribute("paint-order", "stroke") + attribute("stroke-width", 2));
}

std::string text(const Vec2& at, double size, std::string_view words, std::string_view attributes) {
  return "<text" + attribute("x", at.x) + attribute("y", at.y) + attribute("font-size", size) +
         std::string(attributes) + ">" + escaped(words) + "</text>\n";
}

double text_width(std::string_view words, double size, double average) {
  return average * size * static_cast<double>(character_count(words));
}

std::vector<std::string> wrapped(std::string_view words, double size, double width) {
  std::vector<std::string> lines = {""};
  while (!words.empty()) {
    const std::size_t end = words.find(' ');
    const std::string word(words.substr(0, end));
    words = end == std::string_view::npos ? "" : words.substr(end + 1);
    std::string& line = lines.back();
    if (line.empty())
      line = word;
    else if (text_width(line + " " + word, size) <= width)
      line += " " + word;
    else
      lines.push_back(word);
  }
  return lines;
}

}  // namespace evenlift::svg
