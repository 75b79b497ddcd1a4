#include <railbook/contact/influence.hpp>

#include <cmath>

#include <railbook/contact/hertz.hpp>

namespace railbook::contact {
namespace {

// asinh(v/u) for u, v > 0 and r^2 = u^2 + v^2: half the time of the library's, with the root
// shared.
double inverse_sinh(double v, double u, double r) {
  if (v > 0.25 * u) return std::log((v + r) / u);
  return std::log1p((v + v * v / (r + u)) / u);
}

// E(k) and E(k) - m1 K(k) for m1 = 1 - k^2 up to 0.01, by their series in m1 (Abramowitz &
// Stegun 17.3.10, 17.3.33).
struct NearEdge {
  double inside = 1, outside = 1;
};
NearEdge near_edge(double m1) {
  const double log = std::log(4) - 0.5 * std::log(m1);
  NearEdge e;
  double of_k = 1, of_e = 0.5, late = 0,
         power = m1;  // coefficients of m1^n in K and of m1^(n+1) in E
  for (int n = 0; n < 10; ++n) {
    const double k = of_k * (log - late);
    const double step = of_e * (log - late - 1.0 / ((2 * n + 1) * (2 * n + 2)));
    e.inside += power * step;
    e.outside += power * (step - k);
    power *= m1;
    const double ratio = (n + 0.5) / (n + 1);
    of_k *= ratio * ratio;
    of_e *= ratio * (n + 1.5) / (n + 2);
    late += 1.0 / ((n + 1) * (2 * n + 1));
  }
  return e;
}

}  // namespace

double corner_function(double x, double y) {
  const double u = std::abs(x), v = std::abs(y);
  if (u == 0 || v == 0) return 0;  // u asinh(v/u) -> 0, and v asinh(u/v) -> 0
  const double r = std::sqrt(u * u + v * v);
  const double g = u * inverse_sinh(v, u, r) + v * inverse_sinh(u, v, r);
  return std::signbit(x) == std::signbit(y) ? g : -g;
}

double rectangle_influence(double x1, double x2, double y1, double y2) {
  return (corner_function(x2, y2) - corner_function(x1, y2)) -
         (corner_function(x2, y1) - corner_function(x1, y1));
}

double disc_influence(double c, double r) {
  if (c == 0) return 0;
  if (r == c) return 4 * c;
  // With m1 = 1 - k^2: E = B + m1 D, and outside E - m1 K = k^2 B; neither cancels.
  const double k = r < c ? r / c : c / r;
  const double m1 = (r < c ? (c - r) / c : (r - c) / r) * (1 + k);
  if (m1 < 0.01) return r < c ? 4 * c * near_edge(m1).inside : 4 * r * near_edge(m1).outside;
  const EllipticIntegrals i = elliptic_integrals(k < 0.5 ? std::log1p(-k * k) : std::log(m1));
  return r < c ? 4 * c * (i.b + m1 * i.d) : 4 * c * k * i.b;
}

}  // namespace railbook::contact
