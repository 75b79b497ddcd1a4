// The closed forms of the spectra over their whole range, against extended precision.
#include <catch2/catch.hpp>
#include <cmath>

#include "num/log_spaced.hpp"
#include "num/random_source.hpp"
#include "spectra/chord.hpp"
#include "spectra/joint_dips.hpp"

using namespace railbook;

namespace {

using Long = long double;
const Long pi = std::acos(Long(-1));

template <class Function, class Exact>
double worst(double low, double high, const Function& function, const Exact& exact) {
  double most = 0;
  for (const double x : num::log_spaced(low, high, 2000)) {
    const double off = static_cast<double>(std::abs(function(x) / exact(x) - 1));
    if (!(off <= most)) most = off;  // NaN stays
    if (std::isnan(off)) break;
  }
  return most;
}

// A dip's transform by its two cosines; nu is nowhere near 1/2.
Long dip(Long nu) {
  const Long t = pi * nu;
  return std::sin(t) / t - (1 + std::sin(t)) / (pi + 2 * t) - (1 - std::sin(t)) / (pi - 2 * t);
}

// Newton's iteration from the value in double.
Long quantile(Long p) {
  Long x = num::normal_quantile(static_cast<double>(p));
  for (int i = 0; i < 3; ++i)
    x -= (std::erfc(-x / std::sqrt(Long(2))) / 2 - p) * std::sqrt(2 * pi) * std::exp(x * x / 2);
  return x;
}

}  // namespace

TEST_CASE("unit: closed forms of chord, dip and normal quantile keep their digits") {
  CHECK(worst(
            1e-8, 1, [](double phi) { return spectra::chord_gain(1, phi); },
            [](Long phi) { return 2 * std::pow(std::sin(pi * phi / 2), 2); }) < 2e-15);
  CHECK(worst(1e-6, 20, spectra::dip_transform, dip) < 1e-12);
  CHECK(worst(1e-15, 0.4, num::normal_quantile, quantile) < 4e-15);
}
