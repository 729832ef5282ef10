#include "evenlift/load_models.h"

namespace evenlift {

std::string_view name(LoadModel model) {
  switch (model) {
    case LoadModel::plan:
      return "plan";
    case LoadModel::springs:
      return "springs";
    case LoadModel::best:
      return "best";
    case LoadModel::worst:
      return "worst";
  }
  return {};
}

std::optional<LoadModel> load_model_from_name(std::string_view text) {
  for (const LoadModel model : all_load_models)
    if (text == name(model)) return model;
  return std::nullopt;
}

}  // namespace evenlift
