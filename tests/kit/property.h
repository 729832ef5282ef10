// RapidCheck under Catch2, with a fixed seed, so that every run is the same.
#pragma once

#include <rapidcheck.h>

#include <sstream>
#include <string>
#include <utility>

#include "kit/catch.h"

namespace evenlift::property {

// `property` uses RC_ASSERT or returns a bool. It must hold for this number of generated arguments;
// the message is the shrunk counterexample.
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
