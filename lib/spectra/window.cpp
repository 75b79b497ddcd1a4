#include <railbook/spectra/window.hpp>

#include <array>
#include <cmath>
#include <string>

#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::spectra {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

struct Named {
  Window window;
  std::string_view name;
};
constexpr std::array names{
    Named{Window::boxcar, "boxcar"}, Named{Window::hann, "hann"}, Named{Window::hamming, "hamming"},
    Named{Window::blackman_harris, "blackman-harris"}, Named{Window::dpss, "dpss"}};

// sum_j c_j (-1)^j cos(2 pi j i / n), the generalised cosine windows.
VectorXd cosine_window(std::initializer_list<double> coefficients, Index n) {
  VectorXd w(n);
  for (Index i = 0; i < n; ++i) {
    const double angle = 2.0 * units::pi * static_cast<double>(i) / static_cast<double>(n);
    double sum = 0, order = 0, sign = 1;
    for (const double c : coefficients) {
      sum += sign * c * std::cos(order * angle);
      order += 1;
      sign = -sign;
    }
    w[i] = sum;
  }
  return w;
}

// Slepian's tridiagonal matrix, which commutes with the concentration operator: the wanted sequence
// is the eigenvector of its largest eigenvalue.
struct Tridiagonal {
  VectorXd diagonal, beside;
};

Tridiagonal slepian_matrix(Index n, double half_bandwidth) {
  Tridiagonal t{VectorXd(n), VectorXd(n - 1)};
  const double c = std::cos(2.0 * units::pi * half_bandwidth);
  for (Index i = 0; i < n; ++i) {
    const double x = 0.5 * static_cast<double>(n - 1 - 2 * i);
    t.diagonal[i] = x * x * c;
  }
  for (Index i = 1; i < n; ++i)
    t.beside[i - 1] = 0.5 * static_cast<double>(i) * static_cast<double>(n - i);
  return t;
}

// Is every eigenvalue below x? (All pivots of T - x I are negative; Sturm.)
bool above_all(const Tridiagonal& t, double x) {
  double pivot = t.diagonal[0] - x;
  for (Index i = 1; i < t.diagonal.size() && pivot < 0; ++i)
    pivot = t.diagonal[i] - x - t.beside[i - 1] * t.beside[i - 1] / pivot;
  return pivot < 0;
}

double largest_eigenvalue(const Tridiagonal& t) {
  double low = t.diagonal.maxCoeff();
  double high = low + 2.0 * t.beside.maxCoeff();  // Gershgorin
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (above_all(t, middle) ? high : low) = middle;
  }
  return high;
}

// One step of inverse iteration: solves (shift I - T) v = right. The shift lies above every
// eigenvalue, so the matrix is positive definite and elimination needs no pivoting.
VectorXd solve_shifted(const Tridiagonal& t, double shift, const VectorXd& right) {
  const Index n = right.size();
  VectorXd pivot(n), v = right;
  pivot[0] = shift - t.diagonal[0];
  for (Index i = 1; i < n; ++i) {
    const double factor = -t.beside[i - 1] / pivot[i - 1];
    pivot[i] = shift - t.diagonal[i] + factor * t.beside[i - 1];
    v[i] -= factor * v[i - 1];
  }
  v[n - 1] /= pivot[n - 1];
  for (Index i = n - 1; i-- > 0;) v[i] = (v[i] + t.beside[i] * v[i + 1]) / pivot[i];
  return v;
}

VectorXd dpss_window(Index n) {
  const double time_bandwidth = 4.0;
  const Tridiagonal t = slepian_matrix(n, time_bandwidth / static_cast<double>(n));
  const double top = largest_eigenvalue(t);
  const double shift = top + 1e-10 * std::abs(top);
  VectorXd v = cosine_window({0.5, 0.5}, n);
  for (int i = 0; i < 8; ++i) v = solve_shifted(t, shift, v).normalized();
  return v / v.maxCoeff();
}

}  // namespace

VectorXd window_weights(Window window, Index n) {
  if (n < 8) throw InputError{"window of " + std::to_string(n) + " samples; allowed: 8 or more"};
  switch (window) {
    case Window::boxcar:
      return VectorXd::Ones(n);
    case Window::hann:
      return cosine_window({0.5, 0.5}, n);
    case Window::hamming:
      return cosine_window({0.54, 0.46}, n);
    case Window::blackman_harris:
      return cosine_window({0.35875, 0.48829, 0.14128, 0.01168}, n);
    case Window::dpss:
      return dpss_window(n);
  }
  throw InputError{"unknown window"};
}

Window parse_window(std::string_view name) {
  std::string allowed;
  for (const auto& known : names) {
    if (known.name == name) return known.window;
    allowed += (allowed.empty() ? "" : ", ") + std::string{known.name};
  }
  throw InputError{"window is '" + std::string{name} + "'; allowed: " + allowed};
}

}  // namespace railbook::spectra
