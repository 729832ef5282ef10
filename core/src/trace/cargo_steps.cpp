// How each item of cargo moves the centre of mass.
#include "trace/step_figures.h"
#include "trace/step_numbers.h"

namespace evenlift {

void StepNumbers::cargo() {
  const Cargo& item = placement_.settings.cargo[item_];
  const Loaded before = with_cargo(item_), after = with_cargo(item_ + std::size_t{1});
  count("cargo", item_ + std::size_t{1});
  add("weight", item.weight);
  point("x", "y", item.at);
  add("total_weight", after.weight);
  point("centre_x", "centre_y", after.centre);
  add("moved_by", length(after.centre - before.centre));
}

// The lever from the former centre of mass to the item turns about the new one.
void StepFigures::cargo() {
  const Cargo& item = placement_.settings.cargo[item_];
  const Vec2 before = with_cargo(item_).centre;
  add(FigureKind::lever, Points{before, item.at});
  add(FigureKind::old_centre, Points{before});
  add(FigureKind::cargo, Points{item.at}, item_, item.weight);
  centre_ = with_cargo(item_ + std::size_t{1}).centre;
}

}  // namespace evenlift
