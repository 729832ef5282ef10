#include "input/handed_in.h"

#include "evenlift/link.h"
#include "evenlift/numbers.h"
#include "evenlift/task.h"
#include "input/failure.h"
#include "input/files.h"

namespace evenlift::native {
namespace {

constexpr std::string_view blanks = " \t\r";

std::string_view without(std::string_view text, std::string_view ends) {
  const std::size_t from = text.find_first_not_of(ends);
  if (from == std::string_view::npos) return {};
  return text.substr(from, text.find_last_not_of(ends) - from + 1);
}

// `number=4711` in the query of an address.
std::optional<std::uint64_t> number_in(std::string_view address) {
  std::string_view query = address.substr(0, address.find('#'));
  const std::size_t begin = query.find('?');
  if (begin == std::string_view::npos) return std::nullopt;
  query.remove_prefix(begin + 1);
  while (!query.empty()) {
    const std::size_t end = query.find('&');
    const std::string_view part = query.substr(0, end);
    constexpr std::string_view key = "number=";
    if (part.starts_with(key)) {
      const auto number = read_whole(part.substr(key.size()));
      if (number && *number <= max_learner) return number;
    }
    query.remove_prefix(end == std::string_view::npos ? query.size() : end + 1);
  }
  return std::nullopt;
}

HandedIn read_line(std::string_view line, std::size_t number) {
  const std::size_t before = line.find_last_of(" \t,;");
  const std::size_t begin = before == std::string_view::npos ? 0 : before + 1;
  const std::string_view link = line.substr(begin);
  return {std::string(without(line.substr(0, begin), " \t,;\"")), std::string(without(link, "\"")),
          number_in(link), number};
}

}  // namespace

std::vector<HandedIn> read_handed_in(const std::string& link_or_file) {
  std::optional<std::string> file;
  if (link_or_file == "-") {
    file = read_standard_input();
  } else if (file = read_file(link_or_file); !file) {
    if (!looks_like_link(link_or_file) && link_or_file.find('#') == std::string::npos)
      throw Failure{bad_input_status, link_or_file, "there is no such file, and it is no link"};
    return {read_line(link_or_file, 1)};
  }
  std::vector<HandedIn> links;
  std::string_view text = *file;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t end = text.find('\n');
    const std::string_view line = without(text.substr(0, end), blanks);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (!line.empty() && line.front() != '#') links.push_back(read_line(line, number));
  }
  if (links.empty()) throw Failure{bad_input_status, link_or_file, "it has no link"};
  return links;
}

}  // namespace evenlift::native
