#include "kit/json.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace evenlift::testing {

struct JsonBuilder {
  using Kind = Json::Kind;

  static Json json_of(const nlohmann::ordered_json& value) {
    Json json;
    if (value.is_boolean()) {
      json.kind_ = Kind::boolean;
      json.whole_ = value.get<bool>();
    } else if (value.is_number()) {
      json.kind_ = Kind::number;
      json.number_ = value.get<double>();
      if (value.is_number_unsigned()) json.whole_ = value.get<std::uint64_t>();
    } else if (value.is_string()) {
      json.kind_ = Kind::text;
      json.text_ = value.get<std::string>();
    } else if (value.is_structured()) {
      json.kind_ = value.is_array() ? Kind::array : Kind::object;
      for (const auto& member : value.items()) {
        if (value.is_object()) json.names_.push_back(member.key());
        json.items_.push_back(json_of(member.value()));
      }
    }
    return json;
  }
};

Json Json::parse(const std::string& text) {
  return JsonBuilder::json_of(nlohmann::ordered_json::parse(text));
}

const Json* Json::find(std::string_view name) const {
  const auto at = std::find(names_.begin(), names_.end(), name);
  return at == names_.end() ? nullptr : &items_[static_cast<std::size_t>(at - names_.begin())];
}

const Json& Json::operator[](std::string_view name) const {
  if (const Json* const found = find(name)) return *found;
  throw std::out_of_range("no member " + std::string(name));
}

double Json::number() const {
  if (kind_ != Kind::number) throw std::logic_error("not a number");
  return number_;
}

std::uint64_t Json::whole_number() const {
  if (kind_ != Kind::number || (whole_ == 0 && number_ != 0))
    throw std::logic_error("not a whole number");
  return whole_;
}

const std::string& Json::text() const {
  if (kind_ != Kind::text) throw std::logic_error("not a text");
  return text_;
}

std::vector<double> Json::numbers() const {
  if (kind_ != Kind::array) throw std::logic_error("not an array");
  std::vector<double> numbers;
  for (const Json& item : items_) numbers.push_back(item.number());
  return numbers;
}

std::vector<std::string> Json::texts() const {
  if (kind_ != Kind::array) throw std::logic_error("not an array");
  std::vector<std::string> texts;
  for (const Json& item : items_) texts.push_back(item.text());
  return texts;
}

bool operator==(const Json& a, const Json& b) {
  if (a.kind_ != b.kind_ || a.number_ != b.number_ || a.whole_ != b.whole_ || a.text_ != b.text_ ||
      a.size() != b.size())
    return false;
  if (a.kind_ != Json::Kind::object) return a.items_ == b.items_;
  return std::all_of(a.names_.begin(), a.names_.end(), [&](const std::string& name) {
    const Json* const other = b.find(name);
    return other && a[name] == *other;
  });
}

std::ostream& operator<<(std::ostream& stream, const Json& json) {
  switch (json.kind_) {
    case Json::Kind::null:
      return stream << "null";
    case Json::Kind::boolean:
      return stream << (json.whole_ != 0 ? "true" : "false");
    case Json::Kind::number:
      return stream << json.number_;
    case Json::Kind::text:
      return stream << '"' << json.text_ << '"';
    case Json::Kind::array:
    case Json::Kind::object:
      break;
  }
  stream << '[';
  for (std::size_t i = 0; i < json.size(); ++i) {
    if (i > 0) stream << ", ";
    if (!json.names_.empty()) stream << json.names_[i] << ": ";
    stream << json.items_[i];
  }
  return stream << ']';
}

}  // namespace evenlift::testing
