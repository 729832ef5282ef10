#include "evenlift/experiment/shard_list.h"

#include "fields.h"

namespace evenlift {
namespace {

constexpr const char* list_format = "evenlift experiment shard 1";

bool read_heading(const csv::Row& row, ShardList& list) {
  csv::Fields fields(row, 1);
  list.shard = {fields.whole(), 0};
  list.shard.n = fields.whole();
  list.settings.min_ratio = fields.number();
  list.settings.samples = fields.whole();
  list.settings.most_teams = fields.whole();
  return fields.done() && row[0] == list_format && list.shard.i >= 1 &&
         list.shard.i <= list.shard.n && list.shard.n <= max_shards;
}

}  // namespace

std::string write_shard_list(const ShardList& list) {
  std::string text =
      csv::line({list_format, std::to_string(list.shard.i), std::to_string(list.shard.n),
                 shortest(list.settings.min_ratio), std::to_string(list.settings.samples),
                 std::to_string(list.settings.most_teams)});
  for (const ShardList::Entry& entry : list.entries)
    text += csv::line({entry.polygon, entry.fingerprint});
  return text + "end\n";
}

std::optional<ShardList> read_shard_list(std::string_view text) {
  const auto rows = csv::read(text);
  if (!rows || rows->size() < 2 || rows->back() != csv::Row{"end"}) return std::nullopt;
  ShardList list;
  if (!read_heading(rows->front(), list)) return std::nullopt;
  for (std::size_t i = 1; i + 1 < rows->size(); ++i) {
    const csv::Row& row = (*rows)[i];
    if (row.size() != 2) return std::nullopt;
    list.entries.push_back({row[0], row[1]});
  }
  return list;
}

}  // namespace evenlift
