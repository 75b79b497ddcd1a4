#include "report/inventory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <sstream>

#include "table/csv.hpp"
#include "units/input_error.hpp"

namespace railbook::report {
namespace {

constexpr std::array kinds{"equation", "table", "figure", "number", "claim"};

bool matches(const std::string& pattern, const std::string& id) {
  if (pattern.ends_with('*')) return id.starts_with(pattern.substr(0, pattern.size() - 1));
  return pattern == id;
}

// Whether a check or an item has the id; checks that have it get the row's place.
bool place_checks(const InventoryRow& row, const std::string& pattern, ChapterRecord& record) {
  bool known = false;
  for (CheckRecord& check : record.checks) {
    if (!matches(pattern, check.id)) continue;
    known = true;
    if ((check.source == "print" || check.source == "claim") && check.place.empty())
      check.place = row.number.empty() ? row.place : row.place + ", " + row.number;
  }
  return known || std::any_of(record.items.begin(), record.items.end(),
                              [&](const ItemRecord& item) { return matches(pattern, item.id); });
}

}  // namespace

std::vector<InventoryRow> read_inventory(const std::filesystem::path& file) {
  const table::CsvTable table = table::read_table(file);
  std::vector<InventoryRow> rows;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    InventoryRow row{
        table.at(i, "place"),  table.at(i, "kind"), table.at(i, "number"), table.at(i, "what"), {},
        table.at(i, "symbol"), table.at(i, "test"), table.at(i, "reason")};
    std::istringstream ids{table.at(i, "treated")};
    for (std::string id; ids >> id;) row.treated.push_back(id);
    if (std::find(kinds.begin(), kinds.end(), row.kind) == kinds.end())
      throw InputError{fmt::format("file \"{}\", row {}: kind is \"{}\"; allowed: {}",
                                   file.string(), i + 1, row.kind, fmt::join(kinds, ", "))};
    rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<std::string> audit(const std::vector<InventoryRow>& inventory, ChapterRecord& record) {
  std::vector<std::string> problems;
  for (const InventoryRow& row : inventory) {
    const std::string name =
        fmt::format("{} {} {} \"{}\"", row.place, row.kind, row.number, row.what);
    if (row.treated.empty() && row.symbol.empty() && row.reason.empty())
      problems.push_back(name + ": neither treated nor left out for a reason");
    for (const std::string& id : row.treated)
      if (!place_checks(row, id, record))
        problems.push_back(fmt::format("{}: no check or item {}", name, id));
  }
  for (const CheckRecord& check : record.checks)
    if ((check.source == "print" || check.source == "claim") && check.place.empty())
      problems.push_back(check.id + ": a check of the paper that no row names");
  return problems;
}

}  // namespace railbook::report
