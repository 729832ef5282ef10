// The number of a drawing's shapes, and the loads below the first.
#include <evenlift/import.h>
#include <evenlift/output/words.h>

#include <cstdio>

int main() {
  const auto drawing = evenlift::read_shapes(
      "<svg xmlns='http://www.w3.org/2000/svg'><rect width='30' height='20'/><circle r='5'/></svg>");
  if (!drawing) return 1;
  const auto placement = evenlift::place(drawing->shapes.front().document);
  if (!placement) return 1;
  std::printf("%zu shapes. %s\n", drawing->shapes.size(),
              evenlift::loads_in_words(*placement).c_str());
}
