#include <railbook/spectra/rail_line.hpp>

#include <algorithm>
#include <cmath>
#include <string>

#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::spectra {
namespace {

struct Cosine {
  double phi = 0;
  double amplitude = 0;  // signed: all cosines share the origin x = 0
};

// The amplitude of cos(2 pi n phi_0 x) in |sin(pi phi_0 x)| - 1.
double coefficient(int n) {
  if (n == 0) return 2.0 / units::pi - 1.0;
  const double odd = 4.0 * n * n - 1.0;
  return -4.0 / (units::pi * odd);
}

}  // namespace

double rectified_sine(double x, double rail_length, double dip) {
  const double rails = x / rail_length;
  return dip * std::abs(std::sin(units::pi * (rails - std::round(rails))));
}

double rectified_sine_variance(double dip) {
  return dip * dip * (0.5 - 4.0 / (units::pi * units::pi));
}

double line_strength(int n, double dip, LineConvention convention) {
  if (n < 1) throw InputError{"line number is " + std::to_string(n) + "; allowed: at least 1"};
  units::require_finite("dip", dip, "m");
  const double amplitude = -coefficient(n) * dip;
  return convention == LineConvention::exact_one_sided ? amplitude : 0.5 * amplitude;
}

double line_power(int n, double dip, LineConvention convention) {
  const double strength = line_strength(n, dip, convention);
  return 0.5 * strength * strength;
}

std::vector<Line> modulated_lines(double phi_0, double dip, double m, double eps, double phi_max) {
  units::require_positive("phi_0", phi_0, "cycle/m");
  units::require_positive("phi_max", phi_max, "cycle/m");
  units::require_between("lines below phi_max", (phi_max + eps) / phi_0, 0.0, 1e7);
  units::require_finite("dip", dip, "m");
  units::require_finite("modulation m", m);
  if (m != 0.0) units::require_positive("modulation wavenumber", eps, "cycle/m");

  std::vector<Cosine> cosines;
  const auto add = [&](double phi, double amplitude) {
    if (amplitude != 0.0) cosines.push_back({std::abs(phi), amplitude});
  };
  for (int n = 0; n * phi_0 <= phi_max + eps; ++n) {
    const double amplitude = dip * coefficient(n);
    if (n > 0) add(n * phi_0, amplitude);
    add(n * phi_0 + eps, 0.5 * m * amplitude);
    add(n * phi_0 - eps, 0.5 * m * amplitude);
  }
  std::sort(cosines.begin(), cosines.end(),
            [](const Cosine& a, const Cosine& b) { return a.phi < b.phi; });

  std::vector<Line> lines;
  const double same = 1e-9 * phi_0;
  for (std::size_t i = 0; i < cosines.size();) {
    const double phi = cosines[i].phi;
    double amplitude = 0.0;
    for (; i < cosines.size() && cosines[i].phi - phi <= same; ++i)
      amplitude += cosines[i].amplitude;
    if (phi > same && phi <= phi_max) lines.push_back({phi, 0.5 * amplitude * amplitude});
  }
  return lines;
}

}  // namespace railbook::spectra
