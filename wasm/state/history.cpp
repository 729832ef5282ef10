#include "state/history.h"

#include <utility>

namespace evenlift::view {

History::Entry History::remember(const Document& document) const {
  for (const std::vector<Entry>* entries : {&past_, &future_}) {
    if (!entries->empty() && *entries->back().vertices == document.vertices) {
      return {entries->back().vertices, document.centre_of_mass, document.settings};
    }
  }
  return {std::make_shared<const Points>(document.vertices), document.centre_of_mass,
          document.settings};
}

Document History::recall(const Entry& entry) {
  return {*entry.vertices, entry.centre_of_mass, entry.settings};
}

Document History::step(std::vector<Entry>& from, std::vector<Entry>& to, Entry now) {
  to.push_back(std::move(now));
  Document document = recall(from.back());
  from.pop_back();
  return document;
}

void History::record(const Document& before) {
  past_.push_back(remember(before));
  future_.clear();
}

Document History::undo(const Document& now) { return step(past_, future_, remember(now)); }
Document History::redo(const Document& now) { return step(future_, past_, remember(now)); }

}  // namespace evenlift::view
