#include "numbers/json_tree.h"

#include <utility>

#include "numbers/text_cursor.h"

namespace evenlift {

class TreeBuilder final : public JsonSink {
 public:
  bool value(const JsonValue& value) override {
    if (tree_.nodes_.size() == max_json_values) {
      too_many_at_ = value.offset;
      return false;
    }
    const auto at = static_cast<JsonTree::Index>(tree_.nodes_.size());
    std::uint32_t string = 0;
    if (value.kind == JsonValue::Kind::string) string = keep(value.text);
    tree_.nodes_.push_back({value.kind == JsonValue::Kind::number ? value.number : 0, at + 1,
                            static_cast<std::uint32_t>(value.offset), string,
                            std::exchange(name_, 0), value.kind});
    if (value.kind == JsonValue::Kind::object || value.kind == JsonValue::Kind::array)
      open_.push_back(at);
    return true;
  }

  bool key(std::string_view name, std::size_t) override {
    // A name equal to the preceding one is stored once.
    if (tree_.strings_[last_name_] != name) last_name_ = keep(name);
    name_ = last_name_;
    return true;
  }

  bool end() override {
    tree_.nodes_[open_.back()].next = static_cast<JsonTree::Index>(tree_.nodes_.size());
    open_.pop_back();
    return true;
  }

  std::optional<std::size_t> too_many_at() const { return too_many_at_; }
  JsonTree take() { return std::move(tree_); }

 private:
  std::uint32_t keep(std::string_view text) {
    tree_.strings_.emplace_back(text);
    return static_cast<std::uint32_t>(tree_.strings_.size() - 1);
  }

  JsonTree tree_;
  std::vector<JsonTree::Index> open_;
  std::uint32_t name_ = 0, last_name_ = 0;
  std::optional<std::size_t> too_many_at_;
};

Result<JsonTree> JsonTree::read(std::string_view text) {
  TreeBuilder builder;
  if (auto invalid = read_json(text, builder)) return *std::move(invalid);
  if (const auto offset = builder.too_many_at())
    return text_error(ErrorCode::unsupported, "the JSON has more than 4194304 values", text,
                      *offset);
  static_assert(max_json_values == 4194304, "the message names the number");
  return builder.take();
}

std::optional<JsonTree::Index> JsonTree::member(Index object, std::string_view wanted) const {
  std::optional<Index> found;
  if (kind(object) != Kind::object) return found;
  for (Index i = first(object); i != end(object); i = next(i))
    if (name(i) == wanted) found = i;
  return found;
}

bool JsonTree::is_string(std::optional<Index> i, std::string_view wanted) const {
  return i && kind(*i) == Kind::string && text(*i) == wanted;
}

}  // namespace evenlift
