#include <railbook/report/detail/headline.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace railbook::report {

std::vector<std::string> headline(const ChapterRecord& record) {
  const auto checks = [&](std::string_view source, std::string_view outcome) {
    return std::count_if(record.checks.begin(), record.checks.end(), [&](const CheckRecord& c) {
      return c.source == source && c.outcome == outcome;
    });
  };
  const auto left_out = [&](std::string_view why) {
    return std::count_if(record.inventory.begin(), record.inventory.end(),
                         [&](const InventoryRow& row) { return row.reason.starts_with(why); });
  };
  const auto figures = [&](std::initializer_list<std::string_view> inputs) {
    return std::count_if(record.items.begin(), record.items.end(), [&](const ItemRecord& item) {
      return item.kind == "figure" && item.page == "paper" &&
             std::find(inputs.begin(), inputs.end(), item.input) != inputs.end();
    });
  };
  const auto unreadable = left_out("unreadable");
  auto found = unreadable;
  std::vector<std::string> cells{""};
  for (const char* outcome :
       {"confirmed", "consistent", "fitted", "corrected", "restored", "not confirmed"}) {
    const auto n = checks("print", outcome);
    found += n;
    cells.push_back(fmt::format("{}", n));
  }
  cells.front() = fmt::format("{}", found);
  cells.push_back(fmt::format("{}", unreadable));
  cells.push_back(fmt::format("{} / {} / {} / {}", checks("claim", "confirmed"),
                              checks("claim", "consistent"), checks("claim", "not confirmed"),
                              left_out("not testable")));
  cells.push_back(fmt::format("{} / {} / {}", figures({"paper"}), figures({"rebuilt", "sketch"}),
                              figures({"lost"})));
  cells.push_back(
      fmt::format("{}", checks("route", "verified") + checks("publication", "verified")));
  return cells;
}

}  // namespace railbook::report
