#include "evenlift/experiment/shard_list.h"

#include "experiment/measure/fields.h"

namespace evenlift::experiment {
namespace {

constexpr const char* list_format = "evenlift experiment shard 3";

bool read_heading(const csv::Row& row, ShardList& list) {
  csv::Fields fields(row, 1);
  list.shard = {fields.whole(), 0};
  list.shard.n = fields.whole();
  list.settings = csv::read_settings(fields);
  return fields.done() && row[0] == list_format && list.shard.i >= 1 &&
         list.shard.i <= list.shard.n && list.shard.n <= max_shards;
}

}  // namespace

std::string write_shard_list(const ShardList& list) {
  csv::Row heading = csv::settings_fields(list.settings);
  heading.insert(heading.begin(),
                 {list_format, std::to_string(list.shard.i), std::to_string(list.shard.n)});
  std::string text = csv::line(heading);
  for (const ShardList::Entry& entry : list.entries)
    text += csv::line({entry.set, entry.polygon, entry.fingerprint});
  return text + "end\n";
}

std::optional<ShardList> read_shard_list(std::string_view text) {
  const auto rows = csv::read(text);
  if (!rows || rows->size() < 2 || rows->back() != csv::Row{"end"}) return std::nullopt;
  ShardList list;
  if (!read_heading(rows->front(), list)) return std::nullopt;
  for (std::size_t i = 1; i + 1 < rows->size(); ++i) {
    const csv::Row& row = (*rows)[i];
    if (row.size() != 3) return std::nullopt;
    list.entries.push_back({row[0], row[1], row[2]});
  }
  return list;
}

}  // namespace evenlift::experiment
