#include "import/dxf/groups.h"

#include <algorithm>

#include "evenlift/numbers.h"
#include "numbers/text_cursor.h"

namespace evenlift {
namespace {

std::optional<int> code_of(std::string_view line) {
  const bool negative = !line.empty() && line[0] == '-';
  const auto size = read_whole(negative ? line.substr(1) : line);
  if (!size || *size > 9999) return std::nullopt;
  return negative ? -static_cast<int>(*size) : static_cast<int>(*size);
}

}  // namespace

std::optional<DxfGroup> DxfGroups::next() {
  if (at_ >= text_.size()) return std::nullopt;
  code_at_ = at_;
  const std::optional<int> code = code_of(line());
  if (!code) {
    broken_ = true;
    return std::nullopt;
  }
  const std::size_t offset = at_;
  return DxfGroup{*code, line(), offset};
}

std::string_view DxfGroups::line() {
  const std::size_t end = std::min(text_.find_first_of("\r\n", at_), text_.size());
  const std::string_view found = text_.substr(at_, end - at_);
  at_ = end;
  if (at_ < text_.size() && text_[at_] == '\r') ++at_;
  if (at_ < text_.size() && text_[at_] == '\n' && (at_ == end || text_[at_ - 1] == '\r')) ++at_;
  return trimmed(found);
}

}  // namespace evenlift
