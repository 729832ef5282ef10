#include "input/failure.h"

#include <cstdio>

namespace evenlift::native {
namespace {

std::string printable(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  return text;
}

}  // namespace

void print_failure(const Failure& failure) {
  if (failure.silent) return;
  const std::string where = failure.where.empty() ? "\"\"" : printable(failure.where);
  std::fprintf(stderr, "evenlift: %s: %s\n", where.c_str(), printable(failure.what).c_str());
  for (const std::string& line : failure.list)
    std::fprintf(stderr, "  %s\n", printable(line).c_str());
}

std::string system_message(const std::error_code& error) {
  std::string text = error.message();
  if (!text.empty() && text[0] >= 'A' && text[0] <= 'Z')
    text[0] = static_cast<char>(text[0] - 'A' + 'a');
  return text;
}

Failure bad_value(const std::string& option, const std::string& expected,
                  const std::string& typed) {
  constexpr std::size_t most_quoted = 200;
  const bool quotes = typed.size() <= most_quoted;
  return {bad_input_status, option, expected + (quotes ? ", not \"" + typed + '"' : "")};
}

Failure bad_input(const std::string& source, const InputError& error) {
  const std::string place = describe(error.place);
  // A place in a link is complete in itself: "link, character 5".
  const bool alone = error.place.kind == Place::Kind::link;
  const std::string where = place.empty() ? source : alone ? place : source + ": " + place;
  return {bad_input_status, where, error.message};
}

}  // namespace evenlift::native
