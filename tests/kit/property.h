// RapidCheck under Catch2: properties with a fixed seed, so that every run is the same.
#pragma once

#include <rapidcheck.h>

#include <sstream>
#include <string>
#include <utility>

#include "kit/catch.h"

namespace evenlift::property {

// Checks that `property` (which uses RC_ASSERT or returns a bool) holds for this number of
// generated arguments; the shrunk counterexample is the message.
template <class Property>
void holds(Property&& property, int cases = 1000) {
  rc::detail::TestParams parameters;
  parameters.seed = 20101;
  parameters.maxSuccess = cases;
  rc::detail::TestMetadata metadata;
  const auto result =
      rc::detail::checkTestable(std::forward<Property>(property), metadata, parameters);
  std::ostringstream text;
  rc::detail::printResultMessage(result, text);
  INFO(text.str());
  CHECK(result.template is<rc::detail::SuccessResult>());
}

}  // namespace evenlift::property
