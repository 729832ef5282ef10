// Drawings and tables as people have them, of random form, with what a reader should find in them: outlines
// nested to random depth, perhaps on a page, as separate lines or from entities; open lines across them;
// names in a code page; tables with random separators, headings and further columns.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace random_files {

struct Shape {
  double area = 0;  // of the material
  std::size_t holes = 0;
};

struct File {
  std::string what;  // its family
  std::string text;
  std::vector<Shape> shapes;       // without the page, in any order
  std::string name;                // that each shape has, perhaps with a number behind it; or empty
  std::vector<std::string> notes;  // that the reader must tell
};

File make_file(std::uint64_t number);

// Reads the file, and says what is read otherwise than it should be; empty if nothing is.
std::string compare(const File& file);

}  // namespace random_files
