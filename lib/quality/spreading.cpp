#include <railbook/quality/spreading.hpp>

#include <algorithm>
#include <cmath>

#include <railbook/units/input_error.hpp>

namespace railbook::quality {
namespace {

// u(h) = c h^(n+1)/(n+1), and its slope.
double potential(const Spreading& law, double h) {
  return law.coefficient / (law.power + 1) * std::pow(std::max(h, 0.0), law.power + 1);
}
double slope(const Spreading& law, double h) {
  return law.coefficient * (law.power == 0 ? 1 : std::pow(std::max(h, 0.0), law.power));
}

// The divergence of the flux: (u_(i+1) - 2 u_i + u_(i-1))/dx^2 with closed ends.
std::vector<double> divergence(const Spreading& law, const Histogram& p) {
  const std::size_t n = p.height.size();
  std::vector<double> result(n, 0.0);
  const double scale = 1 / (p.width * p.width);
  for (std::size_t i = 0; i + 1 < n; ++i) {
    const double flow = scale * (potential(law, p.height[i + 1]) - potential(law, p.height[i]));
    result[i] += flow;
    result[i + 1] -= flow;
  }
  return result;
}

// Solves h - step f(h) = known by Newton's method, from p as it is. The Jacobian's columns sum to
// one, so that elimination needs no pivoting.
bool implicit(const Spreading& law, Histogram& p, const std::vector<double>& known, double step,
              int& iterations) {
  const std::size_t n = p.height.size();
  const double scale = step / (p.width * p.width);
  // The solution stays between the extremes of what is known; so do the iterates.
  const double size = *std::max_element(known.begin(), known.end());
  const double least = std::min(0.0, *std::min_element(known.begin(), known.end()));
  std::vector<double> diagonal(n), right(n);
  for (int iteration = 0; iteration < 200; ++iteration) {
    ++iterations;
    const auto f = divergence(law, p);
    std::vector<double> s(n);
    for (std::size_t i = 0; i < n; ++i) s[i] = scale * slope(law, p.height[i]);
    for (std::size_t i = 0; i < n; ++i) {
      diagonal[i] = 1 + (i == 0 || i + 1 == n ? 1 : 2) * s[i];
      right[i] = known[i] + step * f[i] - p.height[i];
    }
    for (std::size_t i = 1; i < n; ++i) {  // below the diagonal -s[i-1], above -s[i]
      const double factor = -s[i - 1] / diagonal[i - 1];
      diagonal[i] += factor * s[i];
      right[i] -= factor * right[i - 1];
    }
    double change = 0;
    for (std::size_t i = n; i-- > 0;) {
      if (i + 1 < n) right[i] += s[i + 1] * right[i + 1];
      right[i] /= diagonal[i];
    }
    for (std::size_t i = 0; i < n; ++i) {
      const double next = std::clamp(p.height[i] + right[i], least, size);
      change = std::max(change, std::abs(next - p.height[i]));
      p.height[i] = next;
    }
    if (change <= 1e-13 * size) return true;
  }
  return false;
}

// h_0 and x_N at t = 1: h_0^3 = 9/10 x_N^2 from the equation, 2 h_0 x_N B = 1 from the area.
struct Blob {
  double front, height;
};
Blob blob() {
  const double shape =
      std::beta(0.5, 4.0 / 3);  // twice the integral of (1 - s^2)^(1/3) from 0 to 1
  const double front = std::pow(1 / (std::cbrt(0.9) * shape), 3.0 / 5);
  return {front, std::cbrt(0.9 * front * front)};
}

}  // namespace

double area(const Histogram& p) {
  double sum = 0;
  for (const double h : p.height) sum += h;
  return sum * p.width;
}

double mean(const Histogram& p) {
  double sum = 0;
  for (std::size_t i = 0; i < p.height.size(); ++i) sum += p.x(i) * p.height[i];
  return sum * p.width / area(p);
}

double deviation(const Histogram& p) {
  const double centre = mean(p);
  double sum = 0;
  for (std::size_t i = 0; i < p.height.size(); ++i)
    sum += (p.x(i) - centre) * (p.x(i) - centre) * p.height[i];
  return std::sqrt(sum * p.width / area(p));
}

Spread spread(const Spreading& law, Histogram profile, double from, double to, int steps) {
  units::require_positive("coefficient of spreading", law.coefficient);
  units::require_between("power of spreading", law.power, 0, 20);
  units::require_positive("cell width", profile.width);
  units::require_between("cells", static_cast<double>(profile.height.size()), 3, 1e7);
  units::require_positive("initial time", from);
  units::require_positive("later time less initial time", to - from);
  units::require_between("steps", steps, 1, 1e7);
  constexpr double gamma = 0.29289321881345254;  // 1 - 1/sqrt 2
  Spread result{std::move(profile)};
  const double ratio = std::pow(to / from, 1.0 / steps);
  double t = from;
  for (int i = 0; i < steps && result.converged; ++i) {
    const double step = (i + 1 == steps ? to : t * ratio) - t;
    const std::vector<double> old = result.profile.height;
    result.converged &= implicit(law, result.profile, old, gamma * step, result.iterations);
    const auto f = divergence(law, result.profile);
    std::vector<double> known = old;
    for (std::size_t j = 0; j < known.size(); ++j) known[j] += (1 - gamma) * step * f[j];
    result.converged &= implicit(law, result.profile, known, gamma * step, result.iterations);
    const auto [low, high] =
        std::minmax_element(result.profile.height.begin(), result.profile.height.end());
    result.converged &= *low >= -1e-3 * *high;
    t += step;
  }
  return result;
}

double blob_front(double t) {
  units::require_positive("time", t);
  return blob().front * std::pow(t, 0.2);
}

double blob_height(double x, double t) {
  const double share = x / blob_front(t);
  if (std::abs(share) >= 1) return 0;
  return blob().height * std::pow(t, -0.2) * std::cbrt((1 - share) * (1 + share));
}

}  // namespace railbook::quality
