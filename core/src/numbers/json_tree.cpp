#include "numbers/json_tree.h"

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <utility>

#include "evenlift/wording.h"
#include "numbers/number_text.h"
#include "numbers/text_cursor.h"

namespace evenlift {
namespace {

// An input iterator for the library that records how far it has read.
struct Tap {
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  const char* at;
  const char** reached;

  reference operator*() const { return *at; }
  Tap& operator++() {
    *reached = ++at;
    return *this;
  }
  friend bool operator==(const Tap& a, const Tap& b) { return a.at == b.at; }
};

// The reason in the library's message, always in English: "[...] parse error at line 1, column 3:
// syntax error while parsing array - REASON; last read: '['; expected ...".
std::string reason(std::string_view message) {
  const std::size_t start = message.find(" - ");
  if (start == std::string_view::npos) return "this is not valid JSON";
  message.remove_prefix(start + 3);
  // The text quoted after "last read" may contain "; expected", so only the library's own words
  // count.
  const std::size_t read = message.find("; last read: ");
  if (read == std::string_view::npos) return say("this is not valid JSON: {reason}", {message});
  constexpr std::string_view words[] = {"; expected ':'",
                                        "; expected ']'",
                                        "; expected '}'",
                                        "; expected end of input",
                                        "; expected string literal",
                                        "; expected '[', '{', or a literal"};
  const auto expected = std::find_if(std::begin(words), std::end(words),
                                     [&](std::string_view end) { return message.ends_with(end); });
  const std::string_view rest = expected == std::end(words) ? std::string_view() : *expected;
  return say("this is not valid JSON: {reason}",
             {std::string(message.substr(0, read)) + std::string(rest)});
}

class Handler {
 public:
  Handler(std::string_view text, JsonSink& sink)
      : text_(text), sink_(sink), reached_(text.data()) {}

  bool read() {
    const char* end = text_.data() + text_.size();
    return nlohmann::json::sax_parse(Tap{text_.data(), &reached_}, Tap{end, &reached_}, this);
  }
  std::optional<InputError> error() { return std::move(error_); }

  bool null() { return sink_.value({JsonValue::Kind::null, offset(), 0, {}}); }
  bool boolean(bool value) {
    return sink_.value({JsonValue::Kind::boolean, offset(), value ? 1.0 : 0.0, {}});
  }
  // The library reports "-0" as the signed integer 0, other non-negative integers as unsigned, and
  // integers beyond 64 bits as number_float.
  bool number_integer(std::int64_t integer) {
    return number(integer == 0 ? -0.0 : static_cast<double>(integer));
  }
  bool number_unsigned(std::uint64_t integer) { return number(static_cast<double>(integer)); }
  bool number_float(double, const std::string& digits) { return number(scan_number(digits).value); }
  bool string(const std::string& text) {
    return sink_.value({JsonValue::Kind::string, offset(), 0, text});
  }
  bool binary(const nlohmann::json::binary_t&) { return false; }  // never in a JSON text
  bool key(const std::string& name) { return sink_.key(name, offset()); }
  bool start_object(std::size_t) { return start(JsonValue::Kind::object); }
  bool start_array(std::size_t) { return start(JsonValue::Kind::array); }
  bool end_object() { return end(); }
  bool end_array() { return end(); }
  bool parse_error(std::size_t position, const std::string&,
                   const nlohmann::json::exception& exception) {
    const std::size_t where = position == 0 ? 0 : position - 1;
    constexpr int number_overflow = 406;
    const std::string_view rest = text_.substr(std::min(where, text_.size()));
    const std::string_view why = exception.what();
    if (exception.id == number_overflow)
      error_ = text_error(ErrorCode::bad_coordinate, "this number is too large", text_, where);
    else if (rest.starts_with("NaN") || rest.starts_with("Infinity"))
      error_ = text_error(ErrorCode::bad_coordinate, "this is not a finite number", text_, where);
    else if (why.find("surrogate") != std::string_view::npos)
      error_ = text_error(ErrorCode::bad_syntax, half_a_character, text_, where);
    else
      error_ = text_error(ErrorCode::bad_syntax, reason(why), text_, where);
    return false;
  }

 private:
  static constexpr int max_depth = 64;

  std::size_t offset() const {
    const auto read = static_cast<std::size_t>(reached_ - text_.data());
    return read == 0 ? 0 : read - 1;
  }
  // Unless a number ends the text, the library finds its end one byte late.
  bool number(double value) {
    std::size_t where = offset();
    if (where > 0 && (text_[where] < '0' || text_[where] > '9')) --where;
    return sink_.value({JsonValue::Kind::number, where, value, {}});
  }
  bool start(JsonValue::Kind kind) {
    if (++depth_ > max_depth) {
      error_ = text_error(ErrorCode::bad_syntax, "arrays and objects are nested more than 64 deep",
                          text_, offset());
      return false;
    }
    return sink_.value({kind, offset(), 0, {}});
  }
  bool end() {
    --depth_;
    return sink_.end();
  }

  std::string_view text_;
  JsonSink& sink_;
  const char* reached_;
  int depth_ = 0;
  std::optional<InputError> error_;
};

}  // namespace

std::optional<InputError> read_json(std::string_view text, JsonSink& sink) {
  Handler handler(text, sink);
  handler.read();
  return handler.error();
}

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
    tree_.nodes_.push_back({value.number, at + 1, static_cast<std::uint32_t>(value.offset), string,
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

  // Of the value that would come next.
  std::string path() const {
    std::string path;
    for (std::size_t i = 0; i < open_.size(); ++i) {
      const bool innermost = i + 1 == open_.size();
      const auto next =
          innermost ? static_cast<JsonTree::Index>(tree_.nodes_.size()) : open_[i + 1];
      const std::uint32_t name = innermost ? name_ : tree_.nodes_[next].name;
      tree_.add_to_path(path, open_[i], next, tree_.strings_[name]);
    }
    return path;
  }
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
  if (auto invalid = read_json(text, builder)) {
    invalid->place.option = builder.path();
    return *std::move(invalid);
  }
  if (const auto offset = builder.too_many_at())
    return text_error(ErrorCode::unsupported, "the JSON has more than 4194304 values", text,
                      *offset);
  static_assert(max_json_values == 4194304, "the message names the number");
  return builder.take();
}

void JsonTree::add_to_path(std::string& path, Index parent, std::size_t before,
                           std::string_view name) const {
  if (kind(parent) == Kind::object) {
    (path += path.empty() ? "" : ".") += name;
    return;
  }
  std::size_t count = 0;
  for (Index i = first(parent); i < before; i = next(i)) ++count;
  path += '[' + std::to_string(count) + ']';
}

std::string JsonTree::path(Index i) const {
  std::string path;
  for (Index at = root(); at != i;) {
    Index child = first(at);
    while (next(child) <= i) child = next(child);
    add_to_path(path, at, child, this->name(child));
    at = child;
  }
  return path;
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
