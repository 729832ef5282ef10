#include "app/set_settings.h"

#include <string>

#include "evenlift/placement.h"
#include "evenlift/settings.h"
#include "evenlift/similar_setting.h"

namespace evenlift::view {
namespace {

template <class Value, class Read>
std::optional<InputError> take(Setting setting, const Read& read, Value& value) {
  if (!read) return setting_error(setting);
  value = *read;
  return std::nullopt;
}

std::optional<InputError> read(Setting setting, std::string_view text, Changeable& changed) {
  switch (setting) {
    case Setting::loads:
      return take(setting, load_model_from_name(text), changed.load_model);
    case Setting::failed:
      return take(setting, read_failed(text), changed.failed);
    default:
      return read_setting(setting, text, changed.document);
  }
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
    if (!setting || equals == std::string_view::npos)
      return InputError{ErrorCode::bad_setting,
                        unknown_setting(name),
                        {Place::Kind::option, 0, 0, std::string(name)}};
    if (auto error = read(*setting, line.substr(equals + 1), given)) return *error;
  }
  if (const auto error = check_settings(given.document.settings, given.document.shown))
    return *error;
  return given;
}

std::string kept_text(const Kept& kept) { return kept.motion ? "motion=1\n" : "motion=0\n"; }

Kept read_kept(std::string_view lines) {
  Kept kept;
  while (!lines.empty()) {
    const std::size_t end = lines.find('\n');
    const std::string_view line = lines.substr(0, end);
    lines.remove_prefix(end == std::string_view::npos ? lines.size() : end + 1);
    if (line.starts_with("motion=")) kept.motion = line != "motion=0";
  }
  return kept;
}

}  // namespace evenlift::view
