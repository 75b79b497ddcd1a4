// What pressures do along the surfaces of elastically unlike bodies.
#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

#include <railbook/num/fft.hpp>
#include <railbook/rolling/parts.hpp>
#include <railbook/units/constants.hpp>

namespace railbook::rolling {
namespace {

using Eigen::Index;

// The integral of X/r^2 over a cell dx by dy at (x, y) from the point: x parts, and by exchange y
// parts.
double away(double x, double y, double dx, double dy) {
  const auto corner = [](double a, double b) {
    return 0.5 * b * std::log(a * a + b * b) + (a == 0 ? 0 : a * std::atan(b / a));
  };
  const double l = x - dx / 2, r = x + dx / 2, d = y - dy / 2, u = y + dy / 2;
  return corner(r, u) - corner(l, u) - corner(r, d) + corner(l, d);
}

}  // namespace

Eigen::VectorXd driven_slip(const RollingMesh& mesh, const Eigen::VectorXd& pressure,
                            double dissimilarity, Response response) {
  const auto whole = [](Index n) { return static_cast<std::size_t>(n); };
  const Index n = mesh.along, rows = mesh.rows();
  const double dx = mesh.dx[0], dy = mesh.dy[0];
  num::RealFft2d fft(num::good_fft_size(whole(2 * rows - 1)), num::good_fft_size(whole(2 * n - 1)));
  for (Index j = 0; j < rows; ++j)
    for (Index i = 0; i < n; ++i) fft.row(whole(j))[i] = pressure[j * n + i];
  fft.forward();
  const std::vector<std::complex<double>> p(fft.spectrum().begin(), fft.spectrum().end());
  const bool strain = response == Response::strain;
  const double scale = -dissimilarity / (units::pi * (strain ? dx : 1)) /
                       (static_cast<double>(fft.rows()) * static_cast<double>(fft.columns()));
  Eigen::VectorXd slip(2 * n * rows);
  for (int part = 0; part < 2; ++part) {
    const auto u = [&](Index i, Index j) {
      const double x = static_cast<double>(i) * dx, y = static_cast<double>(j) * dy;
      return part == 0 ? away(x, y, dx, dy) : away(y, x, dy, dx);
    };
    std::ranges::fill(fft.real(), 0.0);
    for (Index j = 1 - rows; j < rows; ++j)
      for (Index i = 1 - n; i < n; ++i)
        fft.row(j < 0 ? fft.rows() - whole(-j)
                      : whole(j))[i < 0 ? static_cast<Index>(fft.columns()) + i : i] =
            scale * (u(i, j) - (strain ? u(i + 1, j) : 0));
    fft.forward();
    for (std::size_t k = 0; k < p.size(); ++k) fft.spectrum()[k] *= p[k];
    fft.inverse();
    for (Index j = 0; j < rows; ++j)
      for (Index i = 0; i < n; ++i) slip[(part * rows + j) * n + i] = fft.row(whole(j))[i];
  }
  return slip;
}

}  // namespace railbook::rolling
