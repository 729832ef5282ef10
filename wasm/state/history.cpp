#include "state/work.h"

#include <iterator>
#include <utility>
#include <variant>

#include "evenlift/link.h"
#include "evenlift/wording.h"

namespace evenlift::view {
namespace {

// By number: a text, or the changed setting.
using What = std::variant<const char*, Setting>;
constexpr What edits[] = {"opened a polygon",
                          "drew a polygon",
                          "changed settings",
                          Setting::teams,
                          Setting::method,
                          Setting::min_ratio,
                          Setting::weight,
                          Setting::seed,
                          "moved a vertex",
                          "added a vertex",
                          "removed a vertex",
                          "moved the centre of mass",
                          "put the centre of mass back to the centroid",
                          "moved, turned or scaled the shape",
                          Setting::capacity,
                          "changed the comparison",
                          "left a lesson",
                          Setting::robots,
                          Setting::goal,
                          Setting::com_radius,
                          Setting::positions,
                          Setting::robot,
                          Setting::no_go,
                          "moved robots by hand",
                          "put the robots back",
                          "opened a lesson",
                          "drew a hole",
                          "removed a hole",
                          "added a weight",
                          "moved a weight",
                          "changed a weight",
                          "removed a weight"};
static_assert(std::size(edits) == edit_count);

// A number unknown to this version stands for Edit::settings.
What what_of(Edit edit) {
  const auto number = static_cast<std::size_t>(edit);
  if (number < edit_count) return edits[number];
  for (const SettingRow& row : all_settings())
    if (row.record != 0 && number == edit_of_records + row.record) return row.setting;
  return what_of(Edit::settings);
}

}  // namespace

std::string in_words(Edit edit) {
  const What what = what_of(edit);
  const Setting* setting = std::get_if<Setting>(&what);
  return setting ? say("changed {setting}", {row_of(*setting).edit})
                 : say(std::get<const char*>(what));
}

Edit edit_of(const SettingRow& row) {
  for (std::size_t i = 0; i < edit_count; ++i) {
    const Setting* setting = std::get_if<Setting>(&edits[i]);
    if (setting && row_of(*setting).edit == row.edit) return static_cast<Edit>(i);
  }
  return static_cast<Edit>(edit_of_records + row.record);
}

Shown seen_as(Shown shown, const Shown& other) {
  shown.overlays = other.overlays;
  shown.step = other.step;
  return shown;
}

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
  Document rest = document;
  rest.vertices = Points();
  return {std::move(vertices), std::move(rest), beside, edit, {}};
}

Document History::recall(const Entry& entry) {
  Document document = entry.rest;
  document.vertices = *entry.vertices;
  return document;
}

// The edit leads from one document to the other: it is kept in both directions.
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
  const std::optional<std::size_t> since = lesson_opened();
  if (!since) return std::nullopt;
  const Entry& opening = past_[past_.size() - 1 - *since];
  Recalled before{recall(opening), opening.beside, Edit::lesson_left};
  if (*since > 0) {
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
