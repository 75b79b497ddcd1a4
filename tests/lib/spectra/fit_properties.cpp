#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include <railbook/num/parallel.hpp>
#include <railbook/spectra/line_mask.hpp>
#include <railbook/spectra/spectrum_fit.hpp>
#include <railbook/spectra/synthetic_track.hpp>

using namespace railbook;

namespace {

spectra::SyntheticTrack zone(double A, double phi_c, double B_printed, std::uint64_t seed) {
  spectra::SyntheticTrack track;
  track.seed = seed;
  track.A = A;
  track.phi_c = phi_c;
  track.dip = spectra::convert_dip(B_printed, spectra::LineConvention::printed,
                                   spectra::LineConvention::exact_one_sided);
  return track;
}

struct Scatter {
  double sum = 0, squares = 0, claimed = 0;
  int n = 0;
  void add(double value, double error) {
    sum += value;
    squares += value * value;
    claimed += error * error;
    ++n;
  }
  double mean() const { return sum / n; }
  double deviation() const { return std::sqrt((squares - sum * sum / n) / (n - 1)); }
  double claim() const { return std::sqrt(claimed / n); }
};

}  // namespace

// 80 records of 10 km: the mean must sit within 3.5 of its own standard errors of the truth, and the scatter
// within 25 % (3 standard errors of it) of what each fit claims.
TEST_CASE("property: estimates are unbiased and their claimed errors are their scatter") {
  struct Zone {
    double A, phi_c, B;
  };
  for (const auto [A, phi_c, B] : {Zone{5e-7, 0.13, 11e-3}, Zone{8e-7, 0.18, 25e-3}}) {
    for (const auto averaging : {spectra::Averaging::bins, spectra::Averaging::bands}) {
      Scatter a, c, q;
      const double Q = B * B * 2 / (9 * units::pi * units::pi);  // equation (2)
      for (std::uint64_t seed = 1; seed <= 80; ++seed) {
        const auto record = spectra::synthesize(zone(A, phi_c, B, seed), 32808);
        const auto fit = spectra::fit_track_spectrum(spectra::welch(record, units::foot),
                                                     {.averaging = averaging});
        a.add(fit.A.value / A, fit.A.error / A);
        c.add(fit.phi_c.value / phi_c, fit.phi_c.error / phi_c);
        q.add(fit.Q_1.value / Q, fit.Q_1.error / Q);
      }
      for (const Scatter& s : {a, c, q}) {
        CHECK(std::abs(s.mean() - 1) < 3.5 * s.deviation() / std::sqrt(80.0) + 0.005);
        CHECK(s.deviation() / s.claim() == Approx(1).epsilon(0.25));
      }
    }
  }
}

TEST_CASE("property: without joints the line is found significant in 5 % of records") {
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 250; ++seed) {
    const auto record = spectra::synthesize(zone(2e-7, 0.13, 0, seed), 16404);
    if (spectra::fit_track_spectrum(spectra::welch(record, units::foot)).line_significant) ++found;
  }
  CHECK(found > 2);  // 12.5 expected, standard deviation 3.4
  CHECK(found < 26);
}

TEST_CASE("property: a profile scaled by c has A scaled by c^2, B by c, and the same corner") {
  auto record = spectra::synthesize(zone(2e-7, 0.13, 8e-3, 4), 60000);
  const auto fit = spectra::fit_track_spectrum(spectra::welch(record, units::foot));
  for (double& z : record) z *= -3;
  const auto scaled = spectra::fit_track_spectrum(spectra::welch(record, units::foot));
  CHECK(scaled.A.value == Approx(9 * fit.A.value));
  CHECK(scaled.phi_c.value == Approx(fit.phi_c.value));
  CHECK(scaled.B_printed.value == Approx(3 * fit.B_printed.value));
  CHECK(scaled.B_threshold == Approx(3 * fit.B_threshold));
}

TEST_CASE("property: a line nobody named is found where it is, and none where there is none") {
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    auto track = zone(2e-7, 0.13, 8e-3, seed);
    const auto look = [&] {
      const auto spectrum = spectra::welch(spectra::synthesize(track, 40000), units::foot);
      return spectra::stray_line(spectrum, {}, spectra::fit_track_spectrum(spectrum));
    };
    if (look()) ++found;
    if (seed > 5) continue;
    track.memory_dip = 4e-3;
    const auto stray = look();
    REQUIRE(stray);
    CHECK(stray->phi == Approx(1 / (33 * units::foot)).margin(1e-3));
  }
  CHECK(found <= 1);  // one in 1000 expected
}

TEST_CASE("property: joints of random depth are not taken for a foreign line") {
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    auto track = zone(2e-7, 0.13, 8e-3, seed);
    track.dip_scatter = 1;
    track.dip_correlation = seed % 2 == 0 ? 0.0 : 0.5;
    const auto spectrum = spectra::welch(spectra::synthesize(track, 40000), units::foot);
    if (spectra::stray_line(spectrum, {}, spectra::fit_track_spectrum(spectrum))) ++found;
  }
  CHECK(found <= 2);
}

TEST_CASE("property: many records give the same digits on any number of threads") {
  const auto read = [](std::size_t i) {
    const auto record = spectra::synthesize(zone(5e-7, 0.13, 11e-3, 1 + i), 16384);
    const auto fit = spectra::fit_track_spectrum(spectra::welch(record, units::foot));
    return std::vector{fit.A.value, fit.A.error, fit.phi_c.value, fit.Q_1.value, fit.Q_1.error};
  };
  const auto alone = num::map_in_parallel(12, read, 1);
  CHECK(alone.front() != alone.back());
  for (const int threads : {2, 3}) CHECK(num::map_in_parallel(12, read, threads) == alone);
}
