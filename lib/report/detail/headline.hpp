// A paper in one line: what became of its numbers, its claims and its figures.
#pragma once

#include <string>
#include <vector>

#include <railbook/report/record.hpp>

namespace railbook::report {

// In the order of the front page's table: printed numbers found | confirmed | consistent | fitted |
// corrected | restored | not confirmed | unreadable | claims confirmed / consistent / not confirmed
// / not testable | figures from the paper's data / rebuilt / lost | checks verified by other
// routes. Unreadable and not testable are counted by the reasons of the inventory.
std::vector<std::string> headline(const ChapterRecord& record);

}  // namespace railbook::report
