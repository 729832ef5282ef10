#include "app/set_settings.h"

#include <string>

#include "evenlift/numbers.h"
#include "evenlift/placement.h"
#include "evenlift/settings_text.h"

namespace evenlift::view {
namespace {

// Whether scripts can set it.
bool is_of_the_page(Setting setting) {
  return setting != Setting::com_radius && setting != Setting::loads;
}

// Reads one setting into `changed`.
std::optional<InputError> read(Setting setting, std::string_view text, Changeable& changed) {
  if (setting != Setting::capacity) return read_setting(setting, text, changed.document);
  const std::optional<double> capacity = read_capacity(text);
  if (!capacity && text != "none") return setting_error(setting);
  changed.capacity = capacity;
  return std::nullopt;
}

}  // namespace

Result<Changeable> with_settings(Changeable given, std::string_view lines) {
  while (!lines.empty()) {
    const std::size_t end = lines.find('\n');
    const std::string_view line = lines.substr(0, end);
    lines.remove_prefix(end == std::string_view::npos ? lines.size() : end + 1);
    const std::size_t equals = line.find('=');
    const std::string_view name = line.substr(0, equals);
    const std::optional<Setting> setting = setting_from_name(name);
    if (!setting || !is_of_the_page(*setting) || equals == std::string_view::npos)
      return InputError{ErrorCode::bad_setting,
                        "there is no such setting",
                        {Place::Kind::option, 0, 0, std::string(name)}};
    if (auto error = read(*setting, line.substr(equals + 1), given)) return *error;
  }
  if (const auto error = check_settings(given.document.settings)) return *error;
  return given;
}

std::string kept_text(const Kept& kept) {
  return std::string(kept.motion ? "motion=1\n" : "motion=0\n") +
         (kept.capacity ? "capacity=" + shortest(*kept.capacity) + "\n" : "");
}

Kept read_kept(std::string_view lines) {
  Kept kept;
  while (!lines.empty()) {
    const std::size_t end = lines.find('\n');
    const std::string_view line = lines.substr(0, end);
    lines.remove_prefix(end == std::string_view::npos ? lines.size() : end + 1);
    if (line.starts_with("motion=")) kept.motion = line != "motion=0";
    if (line.starts_with("capacity=")) kept.capacity = read_capacity(line.substr(9));
  }
  return kept;
}

}  // namespace evenlift::view
