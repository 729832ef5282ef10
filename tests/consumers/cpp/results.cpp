// The placement of a file's polygon as JSON.
#include <evenlift/formats.h>
#include <evenlift/output/json.h>

#include <cstdio>
#include <fstream>
#include <iterator>

int main(int count, char** values) {
  if (count != 2) return 2;
  std::ifstream file(values[1], std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  const auto document = evenlift::read_polygon(text);
  if (!document) return 2;
  const auto placement = evenlift::place(*document);
  if (!placement) return 2;
  std::fputs(evenlift::placement_json(*placement, false).c_str(), stdout);
}
