#include "master_curve.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "full.hpp"
#include "num/roots.hpp"
#include "rig.hpp"
#include "rolling/theory.hpp"
#include "units/input_error.hpp"

using namespace railbook;
using namespace railbook::rolling;
using namespace railbook::creep_chapter;

namespace {

constexpr int intervals = 72;
constexpr double end = 2;

// Places are dense near 0: X = end (i/n)^2.
std::vector<double> solved() {
  rolling::RollingCase c = unit_case();
  const Solver full = solver(master_theory, axis_ratio, poisson, 32);
  std::vector<double> shares{0};
  for (int i = 1; i <= intervals; ++i) {
    c.creepage.longitudinal = end * (double(i) / intervals) * (double(i) / intervals);
    shares.push_back(full(c).fx);
  }
  return shares;
}

}  // namespace

double creep_chapter::master_curve(double x) {
  static const std::vector<double> shares = solved();
  if (x < 0) return -master_curve(-x);
  // The cubic through four neighbours, in the root of X, where the places lie evenly.
  const double place = std::min(std::sqrt(x / end), 1.0) * intervals;
  const int first = std::clamp(static_cast<int>(place) - 1, 0, intervals - 3);
  double sum = 0;
  for (int i = first; i < first + 4; ++i) {
    double weight = 1;
    for (int j = first; j < first + 4; ++j)
      if (j != i) weight *= (place - j) / (i - j);
    sum += weight * shares[static_cast<std::size_t>(i)];
  }
  return sum;
}

double creep_chapter::master_curve_inverse(double share) {
  units::require_between("share of the friction", share, 1e-12, 0.999);
  return num::find_root([&](double x) { return master_curve(x) - share; }, 0, end, 1e-13).x;
}
