// Links that learners hand in.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace evenlift::native {

struct HandedIn {
  std::string name;                     // precedes the link in its line; may be empty
  std::string link;                     // or an address that ends in one
  std::optional<std::uint64_t> number;  // the learner's, if the address has one
  std::size_t line = 0;                 // from 1
};

// The link, or those in a file, one in each line, perhaps after a name and spaces, a tab, a comma
// or a semicolon. Skips empty lines and lines that begin with #. Throws Failure without links.
std::vector<HandedIn> read_handed_in(const std::string& link_or_file);

}  // namespace evenlift::native
