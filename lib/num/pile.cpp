#include <railbook/num/pile.hpp>

#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace railbook::num {

std::optional<double> pile(std::span<const double> values, double sign) {
  double lowest = std::numeric_limits<double>::infinity(),
         next = std::numeric_limits<double>::infinity();
  std::size_t at_lowest = 0, at_next = 0;
  for (const double value : values) {
    const double v = sign * value;
    if (std::isnan(v) || v > next) continue;
    if (v < lowest) {
      next = std::exchange(lowest, v);
      at_next = std::exchange(at_lowest, 0);
    } else if (v > lowest && v < next) {
      next = v;
      at_next = 0;
    }
    ++(v == lowest ? at_lowest : at_next);
  }
  const bool piled = at_next > 0 && at_lowest >= 10 && at_lowest >= 10 * at_next;
  return piled ? std::optional{sign * lowest} : std::nullopt;
}

}  // namespace railbook::num
