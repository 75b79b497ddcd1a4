// Cells that hold a date or a time of day.
#pragma once

#include <string_view>

namespace railbook::table {

// 2022-10-24, 24.10.2022, 10/24/22: three numbers of a day in any order.
bool is_date(std::string_view text);

// 12:00, 12:00:01.25, 12:00:01,25Z, 12:00:00+02:00.
bool is_clock(std::string_view text);

// One of them or both, "2022-10-24T12:00:00" and "10/24/2022 1:05 PM".
bool is_date_or_time(std::string_view text);

}  // namespace railbook::table
