#include "derive/settings_text.h"

#include <algorithm>

namespace evenlift::view {

std::string setting_line(Setting setting, const Document& document) {
  const std::string text = text_of(setting, document);
  return text.empty() ? text : std::string(name(setting)) + '=' + text + '\n';
}

std::string settings_text(const Document& document) {
  std::string text;
  for (const SettingRow& row : all_settings())
    if (row.changes == Changes::stands || row.changes == Changes::loads)
      text += setting_line(row.setting, document);
  return text;
}

bool read_lines(std::string_view lines, Document& document) {
  while (!lines.empty()) {
    const std::string_view line = lines.substr(0, lines.find('\n'));
    lines.remove_prefix(std::min(lines.size(), line.size() + 1));
    const std::size_t equals = line.find('=');
    const auto setting = setting_from_name(line.substr(0, equals));
    if (!setting || equals == std::string_view::npos) return false;
    if (read_setting(*setting, line.substr(equals + 1), document)) return false;
  }
  return true;
}

}  // namespace evenlift::view
