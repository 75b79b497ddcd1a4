#include <railbook/track/track_geometry.hpp>

#include <algorithm>
#include <cmath>
#include <string>

#include <railbook/num/fft.hpp>
#include <railbook/num/quadrature.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::track {

using units::pi;

long RectifiedSine::piece(double x) const {
  return static_cast<long>(std::floor(x / length));
}

SurfacePoint RectifiedSine::at(double x, long piece) const {
  const double arc = pi / length;
  const double local = arc * (x - static_cast<double>(piece) * length);
  return {depth * (1.0 - std::sin(local)), -depth * arc * std::cos(local)};
}

double RectifiedSine::total_angle() const {
  return 2.0 * pi * depth / length;
}

double rectified_sine_harmonic(int n) {
  units::require_between("harmonic", n, 0, 1e6);
  if (n == 0) return 1.0 - 2.0 / pi;
  return 4.0 / pi / (4.0 * static_cast<double>(n) * static_cast<double>(n) - 1.0);
}

SampledProfile::SampledProfile(std::vector<double> x, std::vector<double> z, Between between)
    : between_(between), x_(std::move(x)), z_(std::move(z)), bend_(x_.size(), 0.0) {
  const std::size_t n = x_.size();
  if (z_.size() != n) throw InputError("profile: distances and heights differ in number");
  units::require_between("profile samples", static_cast<double>(n), 4, 1e8);
  for (std::size_t i = 0; i < n; ++i) {
    units::require_between("profile distance", x_[i], -1e6, 1e6, "m");
    units::require_between("profile height", z_[i], -1e3, 1e3, "m");
    if (i > 0 && !(x_[i] - x_[i - 1] > 1e-9))
      throw InputError("profile distance: sample " + std::to_string(i + 1) +
                       " does not lie beyond the one before it (by 1e-9 m at least)");
  }
  if (between == Between::spline) bend_as_spline();
}

// A tridiagonal system for the second derivatives, zero at the ends.
void SampledProfile::bend_as_spline() {
  const std::size_t n = x_.size();
  std::vector<double> upper(n, 0.0);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double left = x_[i] - x_[i - 1], right = x_[i + 1] - x_[i];
    const double pivot = 2.0 * (left + right) - left * upper[i - 1];
    upper[i] = right / pivot;
    const double jump = (z_[i + 1] - z_[i]) / right - (z_[i] - z_[i - 1]) / left;
    bend_[i] = (6.0 * jump - left * bend_[i - 1]) / pivot;
  }
  bend_[n - 1] = 0.0;
  for (std::size_t i = n - 1; i-- > 1;) bend_[i] -= upper[i] * bend_[i + 1];
}

long SampledProfile::piece(double x) const {
  const auto above = std::upper_bound(x_.begin(), x_.end(), x);
  const auto i = above - x_.begin() - 1;
  return std::clamp<long>(i, 0, static_cast<long>(x_.size()) - 2);
}

SurfacePoint SampledProfile::at(double x, long piece) const {
  const auto i = static_cast<std::size_t>(piece);
  const double h = x_[i + 1] - x_[i];
  const double v = (x - x_[i]) / h, u = 1.0 - v;
  const double p = bend_[i] * h * h / 6.0, q = bend_[i + 1] * h * h / 6.0;
  return {u * z_[i] + v * z_[i + 1] + (u * u * u - u) * p + (v * v * v - v) * q,
          (z_[i + 1] - z_[i] - (3 * u * u - 1) * p + (3 * v * v - 1) * q) / h};
}

SurfacePoint surface_at(const Surface& surface, double x) {
  return std::visit([x](const auto& s) { return s.at(x, s.piece(x)); }, surface);
}

std::vector<double> breakpoints(const Surface& surface, double low, double high) {
  std::vector<double> points;
  if (const auto* rail = std::get_if<RectifiedSine>(&surface)) {
    for (double k = std::floor(low / rail->length) + 1; k * rail->length < high; ++k)
      points.push_back(k * rail->length);
  } else {
    for (double x : std::get<SampledProfile>(surface).knots())
      if (x > low && x < high) points.push_back(x);
  }
  return points;
}

bool has_cusps(const Surface& surface) {
  const auto* profile = std::get_if<SampledProfile>(&surface);
  return profile == nullptr || profile->between() == Between::lines;
}

void require_valid(const Surface& surface) {
  if (const auto* rail = std::get_if<RectifiedSine>(&surface)) {
    units::require_finite("dip depth", rail->depth, "m");
    units::require_positive("rail length", rail->length, "m");
  }
}

BounceRoll half_staggered(const RectifiedSine& rail, double x) {
  const double left = surface_at(rail, x).z, right = surface_at(rail, x - 0.5 * rail.length).z;
  return {0.5 * (left + right), 0.5 * (left - right)};
}

std::vector<double> cosine_amplitudes(std::span<const double> samples, int count) {
  units::require_between("number of amplitudes", count, 1,
                         static_cast<double>(samples.size()) / 2.0);
  num::RealFft fft{samples.size()};
  std::copy(samples.begin(), samples.end(), fft.real().begin());
  fft.forward();
  std::vector<double> amplitudes;
  for (std::size_t n = 0; n < static_cast<std::size_t>(count); ++n)
    amplitudes.push_back((n == 0 ? 1.0 : 2.0) * fft.spectrum()[n].real() /
                         static_cast<double>(samples.size()));
  return amplitudes;
}

double CrossLevelSpectrum::density(double wavenumber) const {
  units::require_non_negative("wavenumber", wavenumber, "1/m");
  units::require_positive("lower break", low_break, "1/m");
  units::require_positive("upper break", high_break, "1/m");
  const double f = wavenumber * wavenumber, h = high_break * high_break;
  return roughness * h / ((f + low_break * low_break) * (f + h));
}

double CrossLevelSpectrum::variance(double low, double high) const {
  units::require_non_negative("lower wavenumber", low, "1/m");
  units::require_between("upper wavenumber", high, low, units::infinity, "1/m");
  // The closed form is a difference of arctangents that cancels in narrow bands, in the tail and at
  // equal breaks; Gauss's rule on panels that grow with the distance from the poles, +-i times a
  // break, is exact to rounding.
  static const num::GaussRule rule = num::gauss_legendre(16, 0.0, 1.0);
  const double least = 0.5 * std::min(low_break, high_break);
  double sum = 0;
  for (double from = low, to; from < high; from = to) {
    to = std::min(high, from + std::max(0.5 * from, least));
    for (Eigen::Index i = 0; i < rule.x.size(); ++i)
      sum += rule.w[i] * (to - from) * density(from + rule.x[i] * (to - from));
  }
  return sum;
}

}  // namespace railbook::track
