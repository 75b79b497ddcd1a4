// Values of one unit and one format, in a call.
//
//   report::values(item, "mm", "{:.1f}", "shallowest", low, "deepest", high);
#pragma once

#include <string_view>

#include <railbook/report/item.hpp>

namespace railbook::report {

inline void values(Item&, std::string_view, std::string_view) {}

// Registers each number under the name before it, as Item::value does.
template <class... Rest>
void values(Item& item, std::string_view unit, std::string_view format, std::string_view id,
            double number, const Rest&... rest) {
  item.value(id, number, unit, format);
  values(item, unit, format, rest...);
}

}  // namespace railbook::report
