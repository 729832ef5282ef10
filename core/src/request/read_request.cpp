#include "request/read_request.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "document/document_json.h"
#include "evenlift/closest_name.h"
#include "evenlift/numbers.h"
#include "evenlift/settings.h"
#include "evenlift/wording.h"
#include "import/readers.h"
#include "numbers/text_cursor.h"

namespace evenlift {
namespace {

using Kind = JsonTree::Kind;
using Index = JsonTree::Index;
using Problem = std::optional<InputError>;

using Names = RequestKind::Names;

// `members` are allowed next to "command", and for a polygon also those of `of_polygon` and the
// fields of a document.
struct CommandEntry {
  std::string_view name;
  Command command;
  bool has_polygon;
  Names members;
};
constexpr CommandEntry commands[] = {
    {"place",
     Command::place,
     true,
     {"candidates", "failures", "even_out", "cases", "require", "weight_per_area", "thickness",
      "density", "keep_misfits"}},
    {"candidates", Command::candidates, true, {}},
    {"svg",
     Command::svg,
     true,
     {"candidates", "keep_misfits", "weight_per_area", "thickness", "density"}},
    {"poses",
     Command::poses,
     true,
     {"format", "frame", "origin", "keep_misfits", "weight_per_area", "thickness", "density"}},
    {"link", Command::link, true, {}},
    {"optimum", Command::optimum, true, {}},
    {"trace", Command::trace, true, {"keep_misfits"}},
    {"shapes", Command::shapes, false, {"text", "bytes", "flatten", "join", "project", "holes"}},
    {"parts",
     Command::parts,
     true,
     {"candidates", "failures", "even_out", "require", "weight_per_area", "thickness", "density",
      "sort", "keep_misfits"}},
    {"experiment", Command::experiment, false, {"polygons", "settings"}},
    {"version", Command::version, false, {}},
};
constexpr Names of_polygon = {"text",    "bytes", "document", "settings",
                              "flatten", "join",  "project",  "shape"};
constexpr Names of_measured = {"name", "set",   "polygon",  "holes",
                               "text", "bytes", "document", "centre_of_mass"};

bool is_among(const Names& names, std::string_view name) {
  return !name.empty() && std::find(names.begin(), names.end(), name) != names.end();
}

// Base64 (RFC 4648), perhaps without the padding.
std::optional<std::string> from_base64(std::string_view text) {
  while (text.ends_with('=')) text.remove_suffix(1);
  constexpr std::string_view digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3 + 3);
  std::uint32_t held = 0;
  int bits = 0;
  for (const char c : text) {
    const std::size_t digit = digits.find(c);
    if (digit == std::string_view::npos) return std::nullopt;
    held = held << 6 | static_cast<std::uint32_t>(digit);
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes += static_cast<char>(held >> bits & 0xff);
  }
  return bytes;
}

class Reader {
 public:
  Reader(std::string_view text, const JsonTree& tree)
      : tree_(tree),
        fields_(text, tree, DocumentReader::From::request),
        written_(text, tree, DocumentReader::From::written_in_request) {}

  Result<Request> read();
  Problem check_members(Index object, const Names& allowed) const;

 private:
  InputError error(Index at, std::string message, ErrorCode code = ErrorCode::bad_syntax) const {
    return fields_.error(at, std::move(message), code);
  }
  InputError unknown(Index at, const char* thing, const Names& others, bool fields) const;
  Problem check_fields(Index object, const Names& others) const;
  Problem take_command(Request& request, const CommandEntry*& entry) const;
  Problem take_polygon(Index object, Request& request);
  Problem take_members(Index object, Request& request);
  Problem take_pose_options(Index object, Request& request) const;
  Problem take_import_options(Index object, ImportOptions& options) const;
  Result<std::string> given_text(Index object) const;
  Result<Document> document(Index object, const ImportOptions& options,
                            std::vector<std::string>& notices);
  Result<Document> shape_of(Index object, const ImportOptions& options,
                            std::vector<std::string>& notices) const;
  Problem take_settings(Index object, Document& document);
  Problem take_weight(Index object, Request& request) const;
  Problem take_parts(Index object, Request& request);
  Problem take_polygons(Request& request);
  Problem take_experiment_settings(Request& request) const;

  std::optional<Index> given(Index object, std::string_view name) const;
  bool given_setting(Index object, std::string_view name) const;
  Problem take_flag(Index object, std::string_view name, bool& flag) const;
  Problem take_length(Index object, std::string_view name, std::optional<double>& length) const;
  Result<std::string> string(Index at, const char* what) const;
  std::string value_text(Index at) const;

  const JsonTree& tree_;
  DocumentReader fields_, written_;
};

std::string Reader::value_text(Index at) const {
  if (tree_.kind(at) == Kind::string) return std::string(tree_.text(at));
  return tree_.kind(at) == Kind::number ? shortest(tree_.number(at)) : std::string();
}

Result<std::string> Reader::string(Index at, const char* what) const {
  if (tree_.kind(at) != Kind::string)
    return error(at, std::string(what) + " must be a text", ErrorCode::bad_setting);
  return std::string(tree_.text(at));
}

// Suggests the name that was probably meant.
InputError Reader::unknown(Index at, const char* thing, const Names& others, bool fields) const {
  std::vector<std::string_view> names(others.begin(), others.end());
  names.insert(names.end(), of_polygon.begin(), of_polygon.end());
  if (fields) {
    names.insert(names.end(), {"holes", "centre_of_mass"});
    for (const SettingRow& row : all_settings())
      if (fields_.is_field(row.name)) names.push_back(row.name);
  }
  std::erase(names, std::string_view());
  const std::string_view name = tree_.name(at), meant = closest_name(name, names);
  std::string message = "there is no " + std::string(thing) + " \"" + std::string(name) + '"';
  if (!meant.empty()) message += "; did you mean \"" + std::string(meant) + "\"?";
  return error(at, std::move(message), fields ? ErrorCode::bad_setting : ErrorCode::unsupported);
}

Problem Reader::check_members(Index object, const Names& allowed) const {
  for (Index i = tree_.first(object); i != tree_.end(object); i = tree_.next(i)) {
    const std::string_view name = tree_.name(i);
    if (!is_among(allowed, name) && !(object == tree_.root() && name == "command"))
      return unknown(i, "member", allowed, false);
    if (tree_.member(object, name) != i)
      return error(i, "\"" + std::string(name) + "\" is given twice");
  }
  return std::nullopt;
}

// Of a polygon's request: fields, and others.
Problem Reader::check_fields(Index object, const Names& others) const {
  const bool root = object == tree_.root();
  for (Index i = tree_.first(object); i != tree_.end(object); i = tree_.next(i)) {
    const std::string_view name = tree_.name(i);
    if (fields_.is_field(name)) continue;
    const bool known =
        is_among(others, name) || (root && (name == "command" || is_among(of_polygon, name)));
    if (!known) return unknown(i, "setting", others, true);
    if (tree_.member(object, name) != i)
      return error(i, "\"" + std::string(name) + "\" is given twice");
  }
  return std::nullopt;
}

Problem Reader::take_flag(Index object, std::string_view name, bool& flag) const {
  const auto at = given(object, name);
  if (!at) return std::nullopt;
  if (tree_.kind(*at) != Kind::boolean)
    return error(*at, "this must be true or false", ErrorCode::bad_setting);
  flag = tree_.is_true(*at);
  return std::nullopt;
}

Problem Reader::take_length(Index object, std::string_view name,
                            std::optional<double>& length) const {
  const auto at = given(object, name);
  if (!at) return std::nullopt;
  if (tree_.kind(*at) != Kind::number || !(tree_.number(*at) > 0))
    return error(*at, "this length must be a number above 0", ErrorCode::bad_setting);
  length = tree_.number(*at);
  return std::nullopt;
}

// --- Polygons

// Holes that are `false` are left out of the text.
Problem Reader::take_import_options(Index object, ImportOptions& options) const {
  if (auto wrong = take_length(object, "flatten", options.tolerance)) return wrong;
  if (auto wrong = take_length(object, "join", options.join)) return wrong;
  if (const auto at = tree_.member(object, "holes"); at && tree_.kind(*at) == Kind::boolean)
    options.holes = tree_.is_true(*at);
  return take_flag(object, "project", options.project);
}

Result<std::string> Reader::given_text(Index object) const {
  if (const auto text = tree_.member(object, "text")) return string(*text, "the text");
  const auto bytes = tree_.member(object, "bytes");
  if (!bytes) return error(object, "there is no text");
  const Result<std::string> coded = string(*bytes, "the bytes, in base64,");
  if (!coded) return coded.error();
  auto text = from_base64(*coded);
  if (!text) return error(*bytes, "this is not base64");
  return *std::move(text);
}

// One shape of a text: what it is called or its number, or the only one.
Result<Document> Reader::shape_of(Index object, const ImportOptions& options,
                                  std::vector<std::string>& notices) const {
  const Result<std::string> text = given_text(object);
  if (!text) return text.error();
  Result<Import> read = read_shapes(*text, options);
  if (!read) return read.error();
  std::optional<std::string> wanted;
  const auto shape = given(object, "shape");
  if (shape) wanted = value_text(*shape);
  const Result<std::size_t> chosen = choose_shape(*read, wanted);
  if (!chosen && wanted) return error(*shape, chosen.error().message, ErrorCode::bad_setting);
  if (!chosen)
    return InputError{ErrorCode::unsupported,
                      say("{reason}; \"shape\" chooses one of them by its number or name",
                          {chosen.error().message})};
  notices.insert(notices.end(), read->notes.begin(), read->notes.end());
  return std::move(read->shapes[*chosen].document);
}

Result<Document> Reader::document(Index object, const ImportOptions& options,
                                  std::vector<std::string>& notices) {
  const auto document = tree_.member(object, "document");
  std::size_t given = 0;
  for (const char* name : {"polygon", "text", "bytes", "document"})
    given += tree_.member(object, name).has_value();
  if (given != 1)
    return error(object,
                 "a polygon must be given either as \"polygon\", an array of points [x, y], as "
                 "\"text\" or as \"document\"");
  if (document) {
    if (tree_.kind(*document) != Kind::object || !tree_.member(*document, "polygon"))
      return error(*document, "a document must be an object with a \"polygon\"");
    return read_written(written_, *document);
  }
  if (tree_.member(object, "polygon")) return Document{};
  return shape_of(object, options, notices);
}

Problem Reader::take_polygon(Index object, Request& request) {
  if (auto wrong = take_import_options(object, request.import)) return wrong;
  Result<Document> read = document(object, request.import, request.notices);
  if (!read) return read.error();
  request.document = std::move(read).value();
  if (auto wrong = take_settings(object, request.document)) return wrong;
  if (const auto doubt = doubtful_unit(request.weight, request.document.shown.units))
    request.notices.push_back(sentence(*doubt));
  return set_weight(request.document, request.weight);
}

// Also those in an object of their own.
Problem Reader::take_settings(Index object, Document& document) {
  if (auto wrong = fields_.read(object, document)) return wrong;
  const auto settings = given(object, "settings");
  if (!settings) return std::nullopt;
  if (tree_.kind(*settings) != Kind::object)
    return error(*settings, "the settings must be an object");
  if (auto wrong = check_fields(*settings, {})) return wrong;
  for (Index i = tree_.first(*settings); i != tree_.end(*settings); i = tree_.next(i))
    if (tree_.member(object, tree_.name(i)))
      return error(i, "\"" + std::string(tree_.name(i)) + "\" is given twice");
  return fields_.read(*settings, document);
}

// A weight by area takes the place of the weight.
Problem Reader::take_weight(Index object, Request& request) const {
  for (const auto& [name, text] : {std::pair("weight_per_area", &request.weight.per_area),
                                   {"thickness", &request.weight.thickness},
                                   {"density", &request.weight.density}}) {
    const auto at = given(object, name);
    if (!at) continue;
    *text = value_text(*at);
    if (given_setting(object, "weight"))
      return error(*at, "the weight by area applies without a weight", ErrorCode::bad_setting);
  }
  return std::nullopt;
}

// All shapes of a text but its sheets, each with the settings of the request.
Problem Reader::take_parts(Index object, Request& request) {
  for (const char* name : {"polygon", "document", "shape"})
    if (const auto at = tree_.member(object, name))
      return error(*at,
                   "this is of a single polygon; parts are those of a \"text\" or of \"bytes\"",
                   ErrorCode::unsupported);
  if (auto wrong = take_import_options(object, request.import)) return wrong;
  const Result<std::string> text = given_text(object);
  if (!text) return text.error();
  Result<Import> read = read_shapes(*text, request.import);
  if (!read) return read.error();
  request.notices = read->notes;
  read->shapes.resize(count_parts(*read));
  request.parts = std::move(read->shapes);
  for (ImportedShape& part : request.parts) {
    Problem wrong = take_settings(object, part.document);
    if (!wrong) wrong = set_weight(part.document, request.weight);
    if (wrong) return wrong;
  }
  if (const auto doubt = doubtful_unit(request.weight, request.parts[0].document.shown.units))
    request.notices.push_back(sentence(*doubt));
  request.number_chosen = given_setting(object, "teams") || given_setting(object, "robots");
  const auto at = given(object, "sort");
  if (!at) return std::nullopt;
  const auto order = part_order_from_name(value_text(*at));
  if (!order) return error(*at, part_order_requirement, ErrorCode::bad_setting);
  request.order = *order;
  return std::nullopt;
}

// A member that is there and not null.
std::optional<Index> Reader::given(Index object, std::string_view name) const {
  const auto at = tree_.member(object, name);
  return at && tree_.kind(*at) != Kind::null ? at : std::nullopt;
}

// In the request or in its object of settings.
bool Reader::given_setting(Index object, std::string_view name) const {
  const auto settings = given(object, "settings");
  return given(object, name) || (settings && given(*settings, name));
}

Problem Reader::take_pose_options(Index object, Request& request) const {
  if (const auto at = given(object, "format")) {
    const auto format = pose_format_of_file("." + value_text(*at));
    if (!format)
      return error(*at, "the format of poses must be csv, json or yaml", ErrorCode::bad_setting);
    request.pose_format = *format;
  }
  if (const auto at = given(object, "origin")) {
    const auto origin = pose_origin_from_name(value_text(*at));
    if (!origin) return error(*at, pose_origin_requirement, ErrorCode::bad_setting);
    request.poses.origin = *origin;
  }
  if (const auto at = given(object, "frame")) {
    request.poses.frame = value_text(*at);
    if (tree_.kind(*at) != Kind::string || !is_frame_name(request.poses.frame))
      return error(*at, frame_requirement, ErrorCode::bad_setting);
  }
  return std::nullopt;
}

// --- Experiments

Problem Reader::take_polygons(Request& request) {
  const auto array = tree_.member(0, "polygons");
  if (!array || tree_.kind(*array) != Kind::array)
    return error(array.value_or(0), "an experiment needs an array of polygons");
  for (Index i = tree_.first(*array); i != tree_.end(*array); i = tree_.next(i)) {
    if (request.polygons.size() == max_request_polygons)
      return error(i, "there are more than 10000 polygons", ErrorCode::unsupported);
    if (tree_.kind(i) != Kind::object) return error(i, "each of the polygons must be an object");
    if (auto wrong = check_members(i, of_measured)) return wrong;
    Result<Document> given = document(i, {}, request.notices);
    const auto is_text = [&](const char* name) {
      const auto at = tree_.member(i, name);
      return at && tree_.kind(*at) == Kind::string;
    };
    // A text that cannot be read is refused by itself; another fault is the request's.
    const bool has_other = tree_.member(i, "polygon") || tree_.member(i, "document");
    if (!given && (has_other || is_text("text") == is_text("bytes"))) return given.error();
    if (given)
      if (auto wrong = fields_.read(i, *given)) return wrong;
    NamedPolygon polygon{"polygons", "polygon " + std::to_string(request.polygons.size() + 1),
                         std::move(given)};
    for (const auto& [member, into] :
         {std::pair("name", &polygon.name), std::pair("set", &polygon.set)})
      if (const auto at = tree_.member(i, member)) {
        const Result<std::string> name = string(*at, "a name");
        if (!name) return name.error();
        *into = *name;
      }
    request.polygons.push_back(std::move(polygon));
  }
  return std::nullopt;
}

Problem Reader::take_experiment_settings(Request& request) const {
  const auto settings = given(0, "settings");
  if (!settings) return std::nullopt;
  if (tree_.kind(*settings) != Kind::object)
    return error(*settings, "the settings must be an object");
  if (auto wrong = check_members(*settings, {"min_ratio", "samples", "max_teams", "max_balanced"}))
    return wrong;
  experiment::ExperimentSettings& given = request.experiment;
  if (const auto at = tree_.member(*settings, "min_ratio"))
    given.min_ratio = read_number(value_text(*at)).value_or(-1);
  for (const auto& [name, into] :
       {std::pair("samples", &given.samples), std::pair("max_teams", &given.most_teams),
        std::pair("max_balanced", &given.most_balanced)})
    if (const auto at = tree_.member(*settings, name)) {
      const auto number = read_whole(value_text(*at));
      *into = static_cast<std::uint32_t>(std::min<std::uint64_t>(number.value_or(0), ~0u));
    }
  return experiment::check_settings(given);
}

// --- The whole request

std::string command_names() {
  std::string names = "the command must be ";
  for (std::size_t i = 0; i < std::size(commands); ++i)
    names += (i == 0                         ? ""
              : i + 1 == std::size(commands) ? " or "
                                             : ", ") +
             std::string(commands[i].name);
  return names;
}

Problem Reader::take_command(Request& request, const CommandEntry*& entry) const {
  const auto at = tree_.member(0, "command");
  const std::string name = at ? value_text(*at) : "place";
  for (const CommandEntry& each : commands) {
    if (each.name != name) continue;
    request.command = each.command;
    entry = &each;
    return std::nullopt;
  }
  return error(at.value_or(0), command_names(), ErrorCode::unsupported);
}

Problem Reader::take_members(Index object, Request& request) {
  if (auto wrong = take_weight(object, request)) return wrong;
  const bool parts = request.command == Command::parts;
  if (auto wrong = parts ? take_parts(object, request) : take_polygon(object, request))
    return wrong;
  for (const auto& [name, flag] : {std::pair("candidates", &request.candidates),
                                   {"failures", &request.failures},
                                   {"even_out", &request.even_out},
                                   {"cases", &request.cases},
                                   {"keep_misfits", &request.keep_misfits}})
    if (auto wrong = take_flag(object, name, *flag)) return wrong;
  if (const auto at = given(object, "require")) {
    const Result<std::string> required = string(*at, "the conditions");
    if (!required) return required.error();
    auto conditions = read_conditions(*required);
    if (!conditions) return conditions.error();
    request.conditions = std::move(conditions).value();
  }
  return take_pose_options(object, request);
}

Result<Request> Reader::read() {
  Request request;
  const CommandEntry* entry = nullptr;
  if (auto wrong = take_command(request, entry)) return *std::move(wrong);
  Problem wrong =
      entry->has_polygon ? check_fields(0, entry->members) : check_members(0, entry->members);
  if (wrong) return *std::move(wrong);
  if (entry->has_polygon) {
    wrong = take_members(0, request);
  } else if (request.command == Command::shapes) {
    Result<std::string> text = given_text(0);
    if (!text) return text.error();
    request.text = std::move(text).value();
    wrong = take_import_options(0, request.import);
  } else if (request.command == Command::experiment) {
    wrong = take_polygons(request);
    if (!wrong) wrong = take_experiment_settings(request);
  }
  if (wrong) return *std::move(wrong);
  for (const DocumentReader* reader : {&fields_, &written_})
    request.notices.insert(request.notices.end(), reader->notices().begin(),
                           reader->notices().end());
  return request;
}

}  // namespace

Result<RequestReader> RequestReader::read(std::string_view text, std::size_t most) {
  if (text.size() > most)
    return InputError{ErrorCode::text_too_long,
                      "the request is longer than " + std::to_string(most >> 20) + " MiB"};
  Result<JsonTree> tree = JsonTree::read(text);
  if (!tree) {
    InputError error = tree.error();
    // A value that is no JSON number or text has a path; other faults are where a line says.
    const bool is_value =
        error.code == ErrorCode::bad_coordinate || error.message == half_a_character;
    if (is_value && !error.place.option.empty()) {
      error.place = place_of_path(error.place.option);
      if (error.place.kind == Place::Kind::option) error.code = ErrorCode::bad_setting;
    }
    return error;
  }
  if (tree->kind(tree->root()) != Kind::object)
    return text_error(ErrorCode::bad_syntax, "a request must be a JSON object", text,
                      tree->offset(tree->root()));
  return RequestReader(text, std::move(tree).value());
}

const RequestKind* RequestReader::kind_among(std::span<const RequestKind> kinds) const {
  const auto command = tree_.member(0, "command");
  for (const RequestKind& kind : kinds)
    if (tree_.is_string(command, kind.command)) return &kind;
  return nullptr;
}

std::optional<InputError> RequestReader::check_members(const RequestKind::Names& allowed) const {
  return Reader(text_, tree_).check_members(0, allowed);
}

Result<Request> RequestReader::request() const { return Reader(text_, tree_).read(); }

std::string RequestReader::text(std::string_view name) const {
  const auto at = tree_.member(0, name);
  return at && tree_.kind(*at) == Kind::string ? std::string(tree_.text(*at)) : std::string();
}

double RequestReader::number(std::string_view name) const {
  const auto at = tree_.member(0, name);
  return at && tree_.kind(*at) == Kind::number ? tree_.number(*at)
                                               : std::numeric_limits<double>::quiet_NaN();
}

std::vector<std::string> RequestReader::texts(std::string_view name) const {
  std::vector<std::string> texts;
  const auto at = tree_.member(0, name);
  if (!at || tree_.kind(*at) != Kind::array) return texts;
  for (Index i = tree_.first(*at); i != tree_.end(*at); i = tree_.next(i))
    if (tree_.kind(i) == Kind::string) texts.emplace_back(tree_.text(i));
  return texts;
}

std::vector<std::pair<std::string, std::string>> RequestReader::named_texts(
    std::string_view name) const {
  std::vector<std::pair<std::string, std::string>> texts;
  const auto at = tree_.member(0, name);
  if (!at || tree_.kind(*at) != Kind::object) return texts;
  for (Index i = tree_.first(*at); i != tree_.end(*at); i = tree_.next(i))
    if (tree_.kind(i) == Kind::string) texts.emplace_back(tree_.name(i), tree_.text(i));
  return texts;
}

}  // namespace evenlift
