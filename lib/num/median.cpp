#include <railbook/num/median.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace railbook::num {

// As std::nth_element, but without branches that nobody can foretell: each round parts what is left
// into what is below the pivot, to the front of the other array, and what is above it, to its end.
double nth_smallest(std::vector<double>& values, std::size_t wanted) {
  std::vector<double> other(values.size());
  double *from = values.data(), *to = other.data();
  std::size_t n = values.size();
  while (true) {
    const double a = from[n / 4], b = from[n / 2], c = from[3 * n / 4];
    const double pivot = std::max(std::min(a, b), std::min(std::max(a, b), c));
    std::size_t below = 0, above = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const double value = from[i];
      to[below] = value;
      to[n - 1 - above] = value;
      below += value < pivot ? 1 : 0;
      above += value > pivot ? 1 : 0;
    }
    if (wanted >= below && wanted < n - above) return pivot;
    std::swap(from, to);
    if (wanted >= below) {
      from += n - above;
      to += n - above;
      wanted -= n - above;
      n = above;
    } else {
      n = below;
    }
  }
}

}  // namespace railbook::num
