// A symmetric contact has one answer, however arithmetic rounds: neither the sizes of the coarse
// grids nor cells that mirror each other are left to the last digit.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cfenv>
#include <vector>

#include <railbook/contact/cg_fft.hpp>

#include "support/cg_fft_cells.hpp"

using namespace railbook;
using namespace railbook::contact;

namespace {

NormalContact solve(int mode, double ratio, Eigen::Index n) {
  const Gap gap = [ratio](double x, double y) { return 1.6 * x * x + 1.6 * ratio * y * y; };
  std::fesetround(mode);
  NormalContact found = solve_cg_fft(gap, 50e-6, 1.1e11, cells(n, n)).contact;
  std::fesetround(FE_TONEAREST);
  return found;
}

// The largest difference between the modes, as a fraction.
double spread(double ratio, Eigen::Index n, double NormalContact::*number) {
  std::vector<double> values;
  for (const int mode : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO})
    values.push_back(solve(mode, ratio, n).*number);
  const auto [low, high] = std::ranges::minmax(values);
  return (high - low) / high;
}

}  // namespace

TEST_CASE("contact: a symmetric case has one answer in all four modes of rounding") {
  // An odd number of cells is halved in the grids before; 12, 14 and 62 have rows of four cells
  // that mirror each other.
  for (const Eigen::Index n : {12, 14, 31, 33, 47, 62, 63, 65})
    for (const double ratio : {1.0, 1.5}) {
      CAPTURE(n, ratio);
      CHECK(spread(ratio, n, &NormalContact::force) < 1e-9);
      CHECK(spread(ratio, n, &NormalContact::p_max) < 1e-9);
      CHECK(spread(ratio, n, &NormalContact::area) < 1e-7);
      CHECK(spread(ratio, n, &NormalContact::x_max) < 1e-7);
    }
}
