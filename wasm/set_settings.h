// Settings by name, as window.evenlift.set() gives them.
#pragma once

#include <string_view>

#include "evenlift/document.h"
#include "evenlift/result.h"

namespace evenlift::view {

// The document with the changes of `lines` made, each a line `name=value`: teams (a number or
// "max"), metric, min_ratio, weight, seed, com ("x,y" or "centroid"), step (a number or "none").
// Ranges are check_settings()'s and place()'s to judge; the first line that cannot be read is the
// error. Pure.
Result<Document> with_settings(const Document& document, std::string_view lines);

}  // namespace evenlift::view
