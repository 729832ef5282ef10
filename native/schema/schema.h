// Describes requests and results as a JSON Schema.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace evenlift::native {

// A member of an object, whose name ends in a question mark if it may be missing. A type is a name
// ("Robot", "number", "null"), a text or `true` in itself ("\"edge\""), one of several ("A | B"), a list
// ("Robot[]"), a list of fixed length ("number[2]"), or a list of these ("(integer, number)").
struct TypeMember {
  std::string_view name, type, about;
};

// An object with these members and those that it extends, or another name for `is`.
struct Type {
  std::string_view name, about;
  std::span<const TypeMember> members;
  std::string_view is = {};
  std::span<const std::string_view> extends = {};  // of other objects, whose members it has, too
  bool is_open = false;                            // whether others extend it
};

// All types but those of settings. A member named settings_as_used stands for the settings that
// results list.
inline constexpr std::string_view settings_as_used = "…";
std::span<const Type> described_types();

// The schema of all types, each in "$defs", with their order kept.
std::string schema_json();

}  // namespace evenlift::native
