#include <railbook/report/detail/inventory.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <sstream>

#include <railbook/table/csv.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::report {
namespace {

constexpr std::array kinds{"equation", "table", "figure", "number", "claim"};

bool matches(const std::string& pattern, const std::string& id) {
  if (pattern.ends_with('*')) return id.starts_with(pattern.substr(0, pattern.size() - 1));
  return pattern == id;
}

bool known(const std::string& pattern, const ChapterRecord& record) {
  const auto named = [&](const auto& entry) { return matches(pattern, entry.id); };
  return std::any_of(record.checks.begin(), record.checks.end(), named) ||
         std::any_of(record.items.begin(), record.items.end(), named);
}

// How closely a row is about a check, the smaller the closer: a row of its kind before others, one
// that writes the id out before one that stands for it, one that names few checks before many.
std::array<std::size_t, 3> distance(const InventoryRow& row, const CheckRecord& check) {
  const bool of_kind = (row.kind == "claim") == (check.source == "claim");
  const bool written_out =
      std::find(row.treated.begin(), row.treated.end(), check.id) != row.treated.end();
  return {of_kind ? 0u : 1u, written_out ? 0u : 1u, row.treated.size()};
}

// The place of the row that is most closely about the check; empty if none is about it.
std::string place_of(const CheckRecord& check, const std::vector<InventoryRow>& inventory) {
  const InventoryRow* closest = nullptr;
  for (const InventoryRow& row : inventory) {
    const bool about = std::any_of(row.treated.begin(), row.treated.end(),
                                   [&](const std::string& id) { return matches(id, check.id); });
    if (about && (closest == nullptr || distance(row, check) < distance(*closest, check)))
      closest = &row;
  }
  if (closest == nullptr) return "";
  return closest->number.empty() ? closest->place : closest->place + ", " + closest->number;
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
      if (!known(id, record)) problems.push_back(fmt::format("{}: no check or item {}", name, id));
  }
  for (CheckRecord& check : record.checks) {
    if (check.source != "print" && check.source != "claim") continue;
    check.place = place_of(check, inventory);
    if (check.place.empty())
      problems.push_back(check.id + ": a check of the paper that no row names");
  }
  return problems;
}

}  // namespace railbook::report
