// Reads documents from JSON, field by field: from requests, and from the results and documents that
// evenlift wrote. The fields are those of a document's outline and all settings (settings.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "evenlift/document.h"
#include "evenlift/result.h"
#include "evenlift/settings.h"
#include "numbers/json_tree.h"

namespace evenlift {

class DocumentReader {
 public:
  using Index = JsonTree::Index;
  using Problem = std::optional<InputError>;
  // In what evenlift wrote, a file or an object within a request, a result's own members are not its
  // settings: `robots` are places there, and the number is called `requested_robots`. Errors have the
  // line in a file, and the path in a request.
  enum class From : std::uint8_t { request, file, written_in_request };

  // Text and tree must outlive the reader.
  DocumentReader(std::string_view text, const JsonTree& tree, From from)
      : text_(text), tree_(tree), from_(from) {}

  bool is_field(std::string_view name) const;

  // Reads the members of an object that are fields. Those that are missing, or null, stay as they
  // are, except that a centre of mass that is null is that of the area. Ranges of single settings
  // are checked; whether they fit together, and the geometry, are not. O(bytes).
  Problem read(Index object, Document& document);

  // Sentences about what was left out: repeated last vertices, and third coordinates.
  const std::vector<std::string>& notices() const { return notices_; }

  InputError error(Index at, std::string message, ErrorCode code = ErrorCode::bad_syntax) const;
  // An array of points [x, y]. A last point that repeats the first and third coordinates are left out.
  Result<Points> ring(Index array);

 private:
  std::optional<std::size_t> field(std::string_view name) const;
  Problem take(std::size_t field, Index at, Document& document);
  Problem take_setting(Setting setting, Index at, std::string_view text, Document& document) const;
  Problem take_value(const SettingRow& row, Index at, Document& document);
  Problem take_teams(Index object, Document& document) const;
  Problem take_holes(Index array, Document& document);
  Problem take_centre(Index at, Document& document);
  Problem take_moved(Index at, Document& document) const;
  Problem take_cargo(Index array, Document& document);
  Problem take_names(Index array, Document& document) const;
  Problem take_supports(Index array, Document& document);
  Problem take_robot(Index object, Document& document) const;
  Problem take_overlays(Index object, Document& document) const;

  Result<Vec2> point(Index at);
  Result<Cargo> cargo_item(Index at);
  Result<std::string> name_item(Index item, const char* wrong) const;
  Result<std::string> support(Index at);
  Problem only(Index object, std::initializer_list<std::string_view> members, const char* of) const;
  std::optional<std::string> value_text(Index at) const;
  std::optional<std::string> list_text(Index array, bool of_numbers) const;
  std::string digits(Index number) const;
  void tell(std::string_view what);

  std::string_view text_;
  const JsonTree& tree_;
  From from_;
  std::vector<std::string> notices_;
};

}  // namespace evenlift
