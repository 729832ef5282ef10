// JSON as tests read it, without the headers of the library that parses it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace evenlift::testing {

// A value that does not change. What it does not hold (a member, an element, a number) fails the
// test with an exception.
class Json {
 public:
  static Json parse(const std::string& text);

  bool is_null() const { return kind_ == Kind::null; }
  std::size_t size() const { return items_.size(); }  // 0 for what is no array or object
  bool empty() const { return items_.empty(); }
  bool contains(std::string_view name) const { return find(name) != nullptr; }
  const std::vector<std::string>& names() const { return names_; }  // in the order of the text
  const Json& operator[](std::string_view name) const;
  const Json& operator[](const char* name) const { return (*this)[std::string_view(name)]; }
  template <class Integer>
  requires std::is_integral_v<Integer>
  const Json& operator[](Integer index) const { return items_.at(static_cast<std::size_t>(index)); }
  auto begin() const { return items_.begin(); }
  auto end() const { return items_.end(); }

  double number() const;
  std::uint64_t whole_number() const;
  const std::string& text() const;
  std::vector<double> numbers() const;
  std::vector<std::string> texts() const;
  // A member's, or the given one if there is no such member.
  double number_or(std::string_view name, double otherwise) const {
    return contains(name) ? (*this)[name].number() : otherwise;
  }
  std::string text_or(std::string_view name, const char* otherwise) const {
    return contains(name) ? (*this)[name].text() : otherwise;
  }
  explicit operator double() const { return number(); }

  // Members may stand in any order.
  friend bool operator==(const Json& a, const Json& b);
  friend bool operator==(const Json& a, bool b) {
    return a.kind_ == Kind::boolean && a.whole_ == b;
  }
  friend bool operator==(const Json& a, std::string_view b) {
    return a.kind_ == Kind::text && a.text_ == b;
  }
  friend bool operator==(const Json& a, const char* b) { return a == std::string_view(b); }
  friend bool operator==(const Json& a, const std::string& b) { return a == std::string_view(b); }
  friend bool operator==(const Json& a, const std::vector<double>& b) { return a.numbers() == b; }
  template <class Number>
  requires(std::is_arithmetic_v<Number> && !std::is_same_v<Number, bool>) friend bool operator==(
      const Json& a, Number b) {
    return a.kind_ == Kind::number && a.number_ == static_cast<double>(b);
  }
  friend std::ostream& operator<<(std::ostream& stream, const Json& json);

 private:
  enum class Kind : std::uint8_t { null, boolean, number, text, array, object };
  friend struct JsonBuilder;
  const Json* find(std::string_view name) const;

  Kind kind_ = Kind::null;
  double number_ = 0;
  std::uint64_t whole_ = 0;  // of a whole number, which may have more digits than a double
  std::string text_;
  std::vector<std::string> names_;
  std::vector<Json> items_;
};

}  // namespace evenlift::testing
