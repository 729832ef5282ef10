#include "state/history.h"

#include <iterator>
#include <utility>

#include "evenlift/link.h"

namespace evenlift::view {
namespace {

constexpr const char* words[] = {"opened a polygon",
                                 "drew a polygon",
                                 "changed settings",
                                 "changed the number of teams",
                                 "changed the method",
                                 "changed the minimum load ratio",
                                 "changed the weight",
                                 "changed the seed",
                                 "moved a vertex",
                                 "added a vertex",
                                 "removed a vertex",
                                 "moved the centre of mass",
                                 "put the centre of mass back to the centroid",
                                 "moved, turned or scaled the whole",
                                 "changed what a robot can carry",
                                 "changed the comparison",
                                 "left a lesson",
                                 "changed the number of robots",
                                 "changed what the robots are for",
                                 "changed how well the centre of mass is known",
                                 "changed where teams may stand",
                                 "changed the size of the robots",
                                 "changed what robots may not touch",
                                 "moved robots by hand",
                                 "put the robots back",
                                 "opened a lesson"};
static_assert(std::size(words) == edit_count);

}  // namespace

const char* in_words(Edit edit) { return words[static_cast<std::size_t>(edit)]; }

bool is_other_object(Edit edit) {
  return edit == Edit::opened || edit == Edit::drawn || edit == Edit::lesson_opened ||
         edit == Edit::lesson_left;
}

History::Entry History::remember(const Document& document, const Beside& beside, Edit edit) const {
  std::shared_ptr<const Points> vertices;
  for (const std::vector<Entry>* entries : {&past_, &future_})
    if (!vertices && !entries->empty() && *entries->back().vertices == document.vertices)
      vertices = entries->back().vertices;
  if (!vertices) vertices = std::make_shared<const Points>(document.vertices);
  return {std::move(vertices),
          document.centre_of_mass,
          document.settings,
          document.moved,
          beside,
          edit,
          {}};
}

Document History::recall(const Entry& entry) {
  return {*entry.vertices, entry.centre_of_mass, entry.settings, entry.moved};
}

// The edit leads from one document to the other, so it goes along in both directions.
History::Recalled History::step(std::vector<Entry>& from, std::vector<Entry>& to,
                                const Document& now, const Beside& beside) {
  const Edit edit = from.back().edit;
  to.push_back(remember(now, beside, edit));
  Recalled recalled{recall(from.back()), from.back().beside, edit};
  from.pop_back();
  return recalled;
}

void History::record(const Document& before, const Beside& beside, Edit edit) {
  past_.push_back(remember(before, beside, edit));
  if (edit == Edit::lesson_opened) future_before_lesson_ = std::move(future_);
  future_.clear();
}

History::Recalled History::undo(const Document& now, const Beside& beside) {
  return step(past_, future_, now, beside);
}
History::Recalled History::redo(const Document& now, const Beside& beside) {
  return step(future_, past_, now, beside);
}

std::optional<std::size_t> History::lesson_opened(std::size_t later) const {
  for (std::size_t i = later; i < past_.size(); ++i) {
    const Edit edit = past_[past_.size() - 1 - i].edit;
    if (edit == Edit::lesson_opened) return i;
    if (is_other_object(edit)) return std::nullopt;
  }
  return std::nullopt;
}

std::optional<History::Recalled> History::leave_lesson(const Document& now, const Beside& beside) {
  const std::optional<std::size_t> edits = lesson_opened();
  if (!edits) return std::nullopt;
  const Entry& opening = past_[past_.size() - 1 - *edits];
  Recalled before{recall(opening), opening.beside, Edit::lesson_left};
  if (*edits > 0) {
    record(now, beside, Edit::lesson_left);
  } else {
    past_.pop_back();
    future_ = std::exchange(future_before_lesson_, {});
  }
  return before;
}

std::optional<History::Kept> History::kept(bool redo, std::size_t index) {
  std::vector<Entry>& entries = redo ? future_ : past_;
  if (index >= entries.size()) return std::nullopt;
  Entry& entry = entries[entries.size() - 1 - index];
  if (entry.link.empty()) {
    if (Result<std::string> link = encode_link(recall(entry))) entry.link = std::move(link).value();
  }
  return Kept{entry.edit, entry.beside, entry.link};
}

void History::add(bool redo, const Kept& kept) {
  Result<Document> document = decode_link(kept.link);
  if (!document) return;
  Entry entry = remember(*document, kept.beside, kept.edit);
  entry.link = kept.link;
  (redo ? future_ : past_).push_back(std::move(entry));
}

void History::clear() {
  past_.clear();
  future_.clear();
  future_before_lesson_.clear();
}

}  // namespace evenlift::view
