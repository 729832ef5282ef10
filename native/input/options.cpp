#include "input/options.h"

#include <algorithm>
#include <thread>
#include "evenlift/import.h"
#include "evenlift/numbers.h"
#include "evenlift/plane.h"
#include "evenlift/polygon_with_holes.h"
#include "evenlift/supports.h"
#include "evenlift/wording.h"
#include "input/command_line.h"
#include "input/typed_units.h"

namespace evenlift::native {

std::string as_typed(std::string_view setting) { return "--" + hyphened(setting); }

namespace {

// Why a setting has no effect with the others, or empty.
std::string why_unused(const SettingRow& row, const Settings& settings) {
  if (row.setting == Setting::teams && settings.method == Method::balanced)
    return "balanced robots do not form teams; give --robots";
  if (settings.method == Method::given && row.counts_for != CountsFor::given &&
      !counts(row.counts_for, settings))
    return "does not apply to given supports";
  if (counts(row.counts_for, settings)) return {};
  const std::string method(name(settings.method));
  switch (row.counts_for) {
    case CountsFor::all:
      break;
    case CountsFor::candidates:
      return "applies only to --metric area, circle and distance, not to " + method;
    case CountsFor::hold_requirements:
      return "applies only to --goal hold";
    case CountsFor::placing:
      break;
    case CountsFor::balanced:
      return "applies only to --metric balanced, not to " + method;
    case CountsFor::given:
      return "applies only to --metric given, not to " + method;
  }
  return {};
}

template <class Value>
Value value_or_refusal(Setting setting, const std::optional<Value>& value,
                       const std::string& text) {
  if (!value) throw bad_value(as_typed(name(setting)), requirement(setting), text);
  return *value;
}

// A weight whose unit is that many kilograms in the document's unit; without a unit it is in that.
double in_own_unit(double weight, const std::optional<double>& unit, const Document& document) {
  return unit ? weight * *unit / in_kilograms(1, document.shown.units.weight) : weight;
}

// The readings of a file of supports.
void take_readings(const SupportFile& read, const std::string& file, Document& document) {
  if (read.wrong_reading) throw bad_input(file, *read.wrong_reading);
  if (read.readings.size() != read.places.size())
    throw Failure{bad_input_status, "--weigh",
                  read.readings.empty()
                      ? file + " has no column of readings, such as \"reading (kg)\""
                      : "a support in " + file + " has no reading"};
  std::string text;
  for (const double reading : read.readings)
    text += (text.empty() ? "" : " ") + shortest(in_own_unit(reading, read.reading_unit, document));
  setting_option(Setting::readings, text, document);
}

// Returns the file if the text named one. If `weigh` is set, takes its readings.
std::optional<SupportFile> supports_option(const std::string& text, Document& document,
                                           bool weigh) {
  const std::optional<std::string> file = read_file(text);
  const std::string typed =
      file ? text : in_own_units(Setting::supports, text, document.shown.units);
  if (!read_setting(Setting::supports, typed, document)) return std::nullopt;
  if (!file && text.find(',') == std::string::npos)
    throw Failure{bad_input_status, "--supports",
                  "there is no file " + text.substr(0, 200) +
                      "; points are written like "
                      "\"0,0 160,0 80,90\""};
  if (!file) {
    setting_option(Setting::supports, text, document);  // says what is wrong
    return std::nullopt;
  }
  Result<SupportFile> read = read_support_file(*file);
  if (!read) throw bad_input(text, read.error());
  // A hand lifts beneath the object, away from the contact.
  const bool by_contact = document.settings.robot.depth > 0 && !read->contacts.empty();
  // Numbers are kept unless both the file and the object have a unit.
  const LengthUnit own = document.shown.units.length;
  const bool converts = read->unit != LengthUnit::none && own != LengthUnit::none;
  const double scale = converts ? in_metres(1, read->unit) / in_metres(1, own) : 1;
  for (const std::string& note : read->notes) print_failure({0, text, note, {}});
  document.settings.supports.clear();
  for (const Vec2& place : by_contact ? read->contacts : read->places)
    document.settings.supports.push_back(place * scale);
  document.settings.support_names = read->names;
  document.shown.support_capacities = read->capacities;
  for (std::optional<double>& capacity : document.shown.support_capacities)
    if (capacity) capacity = in_own_unit(*capacity, read->capacity_unit, document);
  document.settings.method = Method::given;
  document.moved = {};
  if (weigh) take_readings(*read, text, document);
  return *read;
}

// Counts y of typed places downward if that was asked for; 0 stays without a sign. Files that evenlift wrote are as
// they are.
void turn(Document& document, const SettingOptions& options, bool supports_are_own) {
  if (!options.y_down) return;
  if (options.typed(Setting::com) && document.centre_of_mass)
    document.centre_of_mass->y = 0 - document.centre_of_mass->y;
  if (options.typed(Setting::supports) && !supports_are_own)
    for (Vec2& support : document.settings.supports) support.y = 0 - support.y;
  if (auto& heading = document.settings.weighed.heading; heading && options.typed(Setting::heading))
    heading->y = 0 - heading->y;
}

}  // namespace

std::uint64_t whole_option(const std::string& option, const std::string& text, std::uint64_t most) {
  const std::optional<std::uint64_t> value = read_whole(text);
  if (!value || *value > most) throw bad_value(option, "expected a whole number", text);
  return *value;
}

unsigned jobs_option(const std::optional<std::string>& text) {
#ifdef __EMSCRIPTEN__
  const unsigned processors = 1;
#else
  const unsigned processors = std::max(1u, std::thread::hardware_concurrency());
#endif
  if (!text) return processors;
  constexpr std::uint64_t most = 1024;
  const std::optional<std::uint64_t> jobs = read_whole(*text);
  if (!jobs || *jobs < 1 || *jobs > most)
    throw Failure{bad_input_status, "--jobs", "the number of threads must be from 1 to 1024"};
  return static_cast<unsigned>(*jobs);
}

void setting_option(Setting setting, const std::string& typed, Document& document) {
  const std::string text = in_own_units(setting, typed, document.shown.units);
  if (const auto error = read_setting(setting, text, document)) {
    const std::string option = as_typed(name(setting));
    // For a list, the error quotes the invalid part.
    if (error->message != requirement(setting))
      throw Failure{bad_input_status, option, error->message};
    throw bad_value(option, error->message, typed);
  }
}

void add_cargo(const std::string& text, Document& document, bool y_down) {
  Document more;
  more.shown.units = document.shown.units;
  setting_option(Setting::cargo, text, more);
  if (y_down)
    for (Cargo& item : more.settings.cargo) item.at.y = 0 - item.at.y;
  std::vector<Cargo>& cargo = document.settings.cargo;
  if (text == "none") cargo.clear();
  cargo.insert(cargo.end(), more.settings.cargo.begin(), more.settings.cargo.end());
  if (cargo.size() > max_cargo)
    throw Failure{bad_input_status, "--cargo",
                  "with the cargo of the file these are " + std::to_string(cargo.size()) +
                      " loads; at most " + std::to_string(max_cargo) + " are possible"};
  document.moved = {};
}

LoadModel loads_option(const std::string& text) {
  return value_or_refusal(Setting::loads, load_model_from_name(text), text);
}

void SettingOptions::declare(CommandLine& line, OptionGroup group) {
  for (const SettingRow& row : all_settings())
    if (row.option.group == group) {
      line.value(typed_[static_cast<std::size_t>(row.setting)], as_typed(row.name),
                 std::string(row.option.value), std::string(row.option.help));
      if (!row.alias.empty()) line.alias(as_typed(row.alias), as_typed(row.name));
    }
}

std::vector<std::size_t> SettingOptions::apply(Document& document) const {
  // Typed numbers may have units, which become the document's.
  constexpr Setting early[] = {Setting::unit, Setting::weight_unit},
                    late[] = {Setting::supports, Setting::cargo};
  const auto is_among = [](const auto& list, Setting setting) {
    return std::find(std::begin(list), std::end(list), setting) != std::end(list);
  };
  for (const bool first : {true, false})
    for (const SettingRow& row : all_settings())
      if (typed(row.setting) && !is_among(late, row.setting) &&
          is_among(early, row.setting) == first)
        setting_option(row.setting, *typed(row.setting), document);
  if (const Typed& cargo = typed(Setting::cargo)) add_cargo(*cargo, document, y_down);
  // The file of supports may need the unit. Supports set the method; another is refused below.
  const Method method = document.settings.method;
  const Typed& supports = typed(Setting::supports);
  std::optional<SupportFile> file;
  if (supports) file = supports_option(*supports, document, weigh);
  turn(document, *this, file && file->is_own);
  if (weigh && !file)
    throw Failure{bad_input_status, "--weigh", "applies to --supports with a file of supports"};
  if (typed(Setting::method)) document.settings.method = method;
  for (const Setting needs :
       {Setting::reading_error, Setting::level_error, Setting::readings_tilted})
    if (typed(needs) && document.settings.weighed.readings.empty())
      throw Failure{bad_input_status, as_typed(name(needs)), "applies to --readings"};
  if (weigh && typed(Setting::readings))
    throw Failure{bad_input_status, "--readings",
                  "applies without --weigh, which takes the readings from the file of supports"};
  for (const Setting needs : {Setting::tilted, Setting::heading})
    if (typed(needs) && document.settings.weighed.tilted_readings.empty())
      throw Failure{bad_input_status, as_typed(name(needs)), "applies to --readings-tilted"};
  if (is_weighed(document.settings) && typed(Setting::weight))
    throw Failure{bad_input_status, "--weight", weight_is_weighed};
  for (const SettingRow& row : all_settings())
    if (typed(row.setting))
      if (const std::string why = why_unused(row, document.settings); !why.empty())
        throw Failure{bad_input_status, as_typed(row.name), why};
  return file ? std::move(file->lines) : std::vector<std::size_t>();
}

std::optional<std::string> SettingOptions::supports_file() const {
  const Typed& given = typed(Setting::supports);
  Document scratch;
  if (!given || !read_setting(Setting::supports, *given, scratch)) return std::nullopt;
  return given;
}

void InputOptions::declare(CommandLine& line, const std::string& help) {
  line.positional(file, "FILE", help);
  settings.declare(line, OptionGroup::placement);
  line.flag(settings.weigh, "--weigh",
            "the file of --supports has a column of readings: they give the weight and C");
  shapes.declare(line);
}

namespace {

std::string place_text(const Vec2& at) {
  return "(" + shortest(at.x) + ", " + shortest(written_y(at.y) + 0.0) + ")";
}

enum class Fits { support, load, centre };

// "; (3, -4) would be inside: …" if the mirror image of a place outside would fit there.
std::string mirrored(const Input& input, const SettingOptions& options, const Vec2& at, Fits as) {
  const Result<PolygonWithHoles> object = object_of(input.document);
  if (!object || at.y == 0) return {};
  const Vec2 image(at.x, -at.y);
  const Polygon& outline = object->outline();
  const bool fits = as == Fits::support
                        ? SupportPlacer(*object, input.document.settings).place(image).has_value()
                    : as == Fits::centre ? inside(outline.hull(), image)
                                         : is_inside(outline, image);
  if (!fits) return {};
  return "; " + place_text(image) + " would be inside: " +
         (options.y_down ? "--y-down counts y downward"
          : input.y_down ? "y points up here, and --y-down counts it downward, as the file does"
                         : "y points up here");
}

// The number in "supports[3]"; the greatest number for other paths.
std::size_t support_of(std::string_view path) {
  const std::string begin = std::string(name(Setting::supports)) + "[";
  if (!path.starts_with(begin)) return SIZE_MAX;
  path.remove_prefix(begin.size());
  return static_cast<std::size_t>(read_whole(path.substr(0, path.find(']'))).value_or(SIZE_MAX));
}

}  // namespace

void tell_loads_outside(const Input& input, const SettingOptions& options) {
  if (!options.typed(Setting::cargo)) return;
  const Result<PolygonWithHoles> object = object_of(input.document);
  if (!object) return;
  for (const Cargo& item : input.document.settings.cargo) {
    if (SupportPlacer(*object, input.document.settings).distance(item.at) == 0 ||
        is_inside(object->outline(), item.at))
      continue;
    print_failure({0,
                   "--cargo",
                   "the load at " + place_text(item.at) + " is outside the object" +
                       mirrored(input, options, item.at, Fits::load),
                   {}});
    return;
  }
}

Input InputOptions::read() const {
  if (settings.y_down) write_y_down();
  Input input = read_input(file, shapes);
  tell_y(input.source, input.y_down);
  input.lines_of_supports = apply(input.document);
  return input;
}

InputShapes InputOptions::read_all() const {
  InputShapes input = read_all_shapes(file, shapes);
  tell_y(input.source, input.y_down);
  for (ImportedShape& shape : input.shapes) apply(shape.document);
  return input;
}

std::vector<std::size_t> InputOptions::apply(Document& document) const {
  std::vector<std::size_t> lines = settings.apply(document);
  if (shapes.project && document.shown.units.length != LengthUnit::m)
    throw Failure{bad_input_status, "--unit", "coordinates are in m with --project"};
  return lines;
}

void InputOptions::tell_y(const std::string& source, bool y_down) const {
  if (settings.y_down && !y_down)
    throw Failure{bad_input_status, "--y-down", "applies to an SVG, in which y points down"};
  const bool has_places = settings.typed(Setting::com) || settings.typed(Setting::supports) ||
                          settings.typed(Setting::cargo);
  if (y_down && has_places && !settings.y_down)
    print_failure({0,
                   source,
                   "places are read and printed with y upward, so (x, y) of the file is (x, -y); "
                   "with --y-down they are as in the file",
                   {}});
}

Failure SettingOptions::failure(const Input& input, const InputError& error) const {
  if (error.place.kind == Place::Kind::option) {
    const std::string& path = error.place.option;
    const std::size_t support = support_of(path);
    std::string what = error.message;
    const Points& supports = input.document.settings.supports;
    if (support < supports.size()) what += mirrored(input, *this, supports[support], Fits::support);
    if (support < input.lines_of_supports.size())
      return {
          bad_input_status,
          *typed(Setting::supports) + ": line " + std::to_string(input.lines_of_supports[support]),
          what};
    const std::string words = describe(error.place);
    return {bad_input_status, as_typed(path.substr(0, path.find_first_of("[."))),
            (words == path ? "" : words + ": ") + what};
  }
  if (error.place.kind == Place::Kind::centre_of_mass && typed(Setting::com))
    return {
        bad_input_status, "--com",
        error.message + (input.document.centre_of_mass
                             ? mirrored(input, *this, *input.document.centre_of_mass, Fits::centre)
                             : std::string())};
  return bad_input(input.source, error);
}

void PoseFileOptions::declare(CommandLine& line) {
  line.value(file, "--poses", "OUT",
             "also write the robots' poses: OUT ends in .csv, .json or .yaml");
  line.value(frame, "--frame", "NAME", "the poses' coordinate frame (default object)");
  line.value(origin, "--origin", "WHERE", "origin of the poses: file (default) or com");
}

std::optional<PosesAsked> PoseFileOptions::asked() const {
  for (const auto& [option, typed] : {std::pair("--frame", &frame), {"--origin", &origin}})
    if (*typed && !file) throw Failure{bad_input_status, option, "applies only to --poses"};
  if (!file) return std::nullopt;
  const auto format = pose_format_of_file(*file);
  if (!format)
    throw bad_value("--poses", "the name of a file of poses must end in .csv, .json or .yaml",
                    *file);
  PosesAsked asked{*file, *format, {}};
  if (frame) {
    if (*format == PoseFormat::csv)
      throw Failure{bad_input_status, "--frame", "a table (CSV) contains no frame"};
    if (!is_frame_name(*frame)) throw bad_value("--frame", frame_requirement, *frame);
    asked.options.frame = *frame;
  }
  if (origin) {
    const auto known = pose_origin_from_name(*origin);
    if (!known) throw bad_value("--origin", pose_origin_requirement, *origin);
    asked.options.origin = *known;
  }
  return asked;
}

}  // namespace evenlift::native
