// Texts that tests import.
#pragma once

#include <string>
#include <utility>

#include "evenlift/import.h"
#include "kit/catch.h"
#include "kit/data_table.h"

namespace evenlift::testing {

// The text must be readable.
inline Import read(const std::string& text, const ImportOptions& options = {}) {
  Result<Import> import = read_shapes(text, options);
  INFO(text.substr(0, 300));
  INFO((import ? "" : import.error().message));
  REQUIRE(import.ok());
  REQUIRE_FALSE(import->shapes.empty());
  return *std::move(import);
}

// The vertices of its only shape.
inline Points only(const std::string& text) {
  const Import import = read(text);
  INFO(text.substr(0, 300));
  REQUIRE(import.shapes.size() == 1);
  return import.shapes.front().document.vertices;
}

// The message must be one sentence.
inline InputError import_error(const std::string& text) {
  const Result<Import> import = read_shapes(text);
  INFO(text.substr(0, 300));
  REQUIRE(!import.ok());
  CHECK(is_one_sentence(import.error().message));
  return import.error();
}

// With the place: "line 2: a number is missing".
inline std::string refusal(const std::string& text) {
  const InputError error = import_error(text);
  const std::string place = describe(error.place);
  return (place.empty() ? "" : place + ": ") + error.message;
}

}  // namespace evenlift::testing
