// Links that learners hand in.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace evenlift::native {

struct HandedIn {
  std::string name;                     // what precedes the link in its line; may be empty
  std::string link;                     // a share link or an address that ends in one
  std::optional<std::uint64_t> number;  // the learner's number, if the address has one
  std::size_t line = 0;                 // from 1
};

// The link, or the links in a file: one in each line, perhaps with a name before it and spaces, a
// tab, a comma or a semicolon between. Empty lines and lines that begin with # do not count. Throws
// Failure if there is no link.
std::vector<HandedIn> read_handed_in(const std::string& link_or_file);

}  // namespace evenlift::native
