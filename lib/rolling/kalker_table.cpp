#include <railbook/rolling/kalker_table.hpp>

#include <algorithm>
#include <array>
#include <cmath>

#include <railbook/units/input_error.hpp>

namespace railbook::rolling {
namespace {

// C11, C22, C23, C33, each at Poisson's ratio 0, 1/4, 1/2.
struct TableRow {
  double axis_ratio;
  std::array<std::array<double, 3>, 4> c;
};
constexpr std::array<TableRow, 19> rows{{
    {0.1, {{{2.51, 3.31, 4.85}, {2.51, 2.52, 2.53}, {.334, .473, .731}, {6.42, 8.28, 11.7}}}},
    {0.2, {{{2.59, 3.37, 4.81}, {2.59, 2.63, 2.66}, {.483, .603, .809}, {3.46, 4.27, 5.66}}}},
    {0.3, {{{2.68, 3.44, 4.80}, {2.68, 2.75, 2.81}, {.607, .715, .889}, {2.49, 2.96, 3.72}}}},
    {0.4, {{{2.78, 3.53, 4.82}, {2.78, 2.88, 2.98}, {.720, .823, .977}, {2.02, 2.32, 2.77}}}},
    {0.5, {{{2.88, 3.62, 4.83}, {2.88, 3.01, 3.14}, {.827, .929, 1.07}, {1.74, 1.93, 2.22}}}},
    {0.6, {{{2.98, 3.72, 4.91}, {2.98, 3.14, 3.31}, {.930, 1.03, 1.18}, {1.56, 1.68, 1.86}}}},
    {0.7, {{{3.09, 3.81, 4.97}, {3.09, 3.28, 3.48}, {1.03, 1.14, 1.29}, {1.43, 1.50, 1.60}}}},
    {0.8, {{{3.19, 3.91, 5.05}, {3.19, 3.41, 3.65}, {1.13, 1.25, 1.40}, {1.34, 1.37, 1.42}}}},
    {0.9, {{{3.29, 4.01, 5.12}, {3.29, 3.54, 3.82}, {1.23, 1.36, 1.51}, {1.27, 1.27, 1.27}}}},
    {1.0, {{{3.40, 4.12, 5.20}, {3.40, 3.67, 3.98}, {1.33, 1.47, 1.63}, {1.21, 1.19, 1.16}}}},
    {1 / 0.9, {{{3.51, 4.22, 5.30}, {3.51, 3.81, 4.16}, {1.44, 1.59, 1.77}, {1.16, 1.11, 1.06}}}},
    {1 / 0.8, {{{3.65, 4.36, 5.42}, {3.65, 3.99, 4.39}, {1.58, 1.75, 1.94}, {1.10, 1.04, .954}}}},
    {1 / 0.7, {{{3.82, 4.54, 5.58}, {3.82, 4.21, 4.67}, {1.76, 1.95, 2.18}, {1.05, .965, .852}}}},
    {1 / 0.6, {{{4.06, 4.78, 5.80}, {4.06, 4.50, 5.04}, {2.01, 2.23, 2.50}, {1.01, .892, .751}}}},
    {1 / 0.5, {{{4.37, 5.10, 6.11}, {4.37, 4.90, 5.56}, {2.35, 2.62, 2.96}, {.958, .819, .650}}}},
    {1 / 0.4, {{{4.84, 5.57, 6.57}, {4.84, 5.48, 6.31}, {2.88, 3.24, 3.70}, {.912, .747, .549}}}},
    {1 / 0.3, {{{5.57, 6.34, 7.34}, {5.57, 6.40, 7.51}, {3.79, 4.32, 5.01}, {.868, .674, .446}}}},
    {1 / 0.2, {{{6.96, 7.78, 8.82}, {6.96, 8.14, 9.79}, {5.72, 6.63, 7.89}, {.828, .601, .341}}}},
    {1 / 0.1, {{{10.7, 11.7, 12.9}, {10.7, 12.8, 16.0}, {12.2, 14.6, 18.0}, {.795, .526, .228}}}},
}};

// The parabola through 1/C at 0, 1/4, 1/2, as a factor on each of the three. C33 of contacts long
// along rolling falls with Poisson's ratio almost to nothing, and there is a parabola itself.
double over_poisson(const TableRow& row, std::size_t n, double nu) {
  const bool itself = n == 3 && row.axis_ratio > 1;
  const auto form = [&](double c) { return itself ? c : 1 / c; };
  const auto& c = row.c[n];
  return form(8 * (nu - 0.25) * (nu - 0.5) * form(c[0]) + 16 * nu * (0.5 - nu) * form(c[1]) +
              8 * nu * (nu - 0.25) * form(c[2]));
}

}  // namespace

KalkerCoefficients kalker_table(double axis_ratio, double poisson) {
  units::require_between("axis ratio a/b of Kalker's table", axis_ratio, 0.1, 10);
  units::require_between("Poisson's ratio", poisson, 0, 0.5);
  const auto above =
      std::ranges::find_if(rows, [&](const TableRow& row) { return row.axis_ratio >= axis_ratio; });
  const auto last = static_cast<long>(rows.size()) - 4;
  const auto first = std::clamp(above - rows.begin() - 2, 0L, last);
  std::array<double, 4> log_c{};
  for (long k = first; k < first + 4; ++k) {
    const auto& row = rows[static_cast<std::size_t>(k)];
    double weight = 1;
    for (long m = first; m < first + 4; ++m) {
      const double other = rows[static_cast<std::size_t>(m)].axis_ratio;
      if (m != k) weight *= std::log(axis_ratio / other) / std::log(row.axis_ratio / other);
    }
    for (std::size_t n = 0; n < 4; ++n)
      log_c[n] += weight * std::log(over_poisson(row, n, poisson));
  }
  return {std::exp(log_c[0]), std::exp(log_c[1]), std::exp(log_c[2]), std::exp(log_c[3])};
}

}  // namespace railbook::rolling
