#include <railbook/spectra/classify.hpp>

#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/num/quadrature.hpp>
#include <railbook/spectra/chord.hpp>
#include <railbook/units/input_error.hpp>

using namespace railbook;

TEST_CASE("unit: the coefficient of A is nine times the variance a chord reads on A = 1") {
  // Equation (8) by quadrature: between the zeros of the gain, then its mean square 3/2 over the
  // tail.
  const double L = 62 * units::foot;
  double variance = 0;
  const int periods = 400;
  for (int i = 0; i < periods; ++i)
    variance += num::integrate(
                    [&](double phi) {
                      const double g = phi > 0 ? spectra::chord_gain(L, phi) / phi : 0;
                      return g * g;
                    },
                    i * 2 / L, (i + 1) * 2 / L)
                    .value;
  variance += 1.5 / (periods * 2 / L);
  CHECK(spectra::random_coefficient({}) == Approx(9 * variance).epsilon(1e-6));
  CHECK(spectra::random_coefficient({.chord = 19}) == Approx(843.851).epsilon(1e-6));
  CHECK(spectra::random_coefficient({.alpha = 1}) ==
        Approx(std::pow(spectra::chord_sigma(1.0, L), 2)));
}

TEST_CASE("unit: classes by hand") {
  const auto only_dips = [](double B) { return spectra::classify(0, B).track_class; };
  CHECK(only_dips(0) == 6);
  CHECK(only_dips(0.25 * units::inch) == 6);
  CHECK(only_dips(0.2501 * units::inch) == 5);
  CHECK(only_dips(0.999 * units::inch) == 4);
  CHECK(only_dips(1.499 * units::inch) == 1);
  CHECK(only_dips(1.501 * units::inch) == 0);
  const auto rough = spectra::classify(5e-7, 11e-3);
  CHECK(rough.track_class == 5);
  CHECK(rough.deviation == Approx(std::sqrt(839.303 * 5e-7 + 4 * 11e-3 * 11e-3)).epsilon(1e-5));
  CHECK(rough.margin == Approx(1 - rough.deviation / (1.25 * units::inch)));
  CHECK(rough.to_next == Approx(rough.deviation / (0.5 * units::inch) - 1));
  CHECK(spectra::classify(1e-4, 0).track_class == 0);
  CHECK(spectra::classify(1e-4, 0).to_next > 0);
  for (const double dip : {0.0, 0.1 * units::inch}) {  // nothing is better than class 6
    const auto best = spectra::classify(1e-9, dip);
    CHECK(best.track_class == 6);
    CHECK(best.to_next == 0);
    CHECK(best.margin == Approx(1 - best.deviation / (0.5 * units::inch)));
  }
  CHECK(spectra::classify(1e-4, 0).margin < 0);
}

TEST_CASE("unit: the coefficient range of a class is where the class changes") {
  for (const int m : {1, 2, 3, 4, 5}) {
    const double A = 5e-7, B = 4e-3;
    const auto range = spectra::coefficient_range(A, B, m);
    REQUIRE(range.low < range.high);
    const auto class_with = [&](double k) {
      spectra::ClassRule rule;
      rule.alpha = std::sqrt(k / spectra::random_coefficient({.alpha = 1}));
      return spectra::classify(A, B, rule).track_class;
    };
    CHECK(class_with(range.high * (1 - 1e-9)) == m);
    CHECK(class_with(range.high * (1 + 1e-9)) == m - 1);
    CHECK(class_with(range.low * (1 + 1e-9)) == m);
    CHECK(class_with(range.low * (1 - 1e-9)) == m + 1);
  }
  const auto none = spectra::coefficient_range(5e-7, 0.03, 5);  // the dips alone exceed class 5
  CHECK(none.low > none.high);
}

TEST_CASE("unit: class probabilities are those of a normal squared deviation") {
  spectra::SpectrumFit fit;
  fit.A = {5e-7, 3e-8};
  fit.Q_1 = {3e-6, 2e-7};
  auto p = spectra::class_probabilities(fit);
  double sum = 0;
  for (const double value : p) sum += value;
  CHECK(sum == Approx(1));
  const double k = spectra::random_coefficient({}), q = 18 * units::pi * units::pi;
  const double mean = k * 5e-7 + q * 3e-6, error = std::hypot(k * 3e-8, q * 2e-7);
  const double D = 1.25 * units::inch;
  const auto density = [&](double y) { return std::exp(-0.5 * y * y) / std::sqrt(2 * units::pi); };
  const double D_6 = 0.5 * units::inch;
  CHECK(p[5] ==
        Approx(num::integrate(density, (D_6 * D_6 - mean) / error, (D * D - mean) / error).value));
  fit.A.error = fit.Q_1.error = 0;
  p = spectra::class_probabilities(fit);
  CHECK(p[static_cast<std::size_t>(
            spectra::classify(5e-7,
                              spectra::dip_from_line_power(3e-6, spectra::LineConvention::printed))
                .track_class)] == 1);
}

TEST_CASE("unit: exceedances of three standard deviations") {
  CHECK(1 - spectra::normal_exceedance(3) == Approx(0.99730).epsilon(1e-5));
  CHECK(1 - spectra::chebyshev_exceedance(3) == Approx(8.0 / 9));
  CHECK(spectra::chebyshev_exceedance(0.5) == 1);
}

TEST_CASE("input: the class rule refuses negative parameters and limits out of order") {
  CHECK_THROWS_AS(spectra::classify(-1e-7, 0), InputError);
  CHECK_THROWS_AS(spectra::classify(1e-7, -1e-3), InputError);
  CHECK_THROWS_AS(spectra::classify(1e-7, 0, {.chord = 0}), InputError);
  spectra::ClassRule rule;
  rule.limits[5] = 1;
  CHECK_THROWS_AS(spectra::classify(1e-7, 0, rule), InputError);
  CHECK_THROWS_AS(spectra::coefficient_range(1e-7, 1e-3, 7), InputError);
}
