#include "contact/convolution.hpp"

#include <algorithm>
#include <cmath>

#include "contact/influence.hpp"
#include "units/constants.hpp"

namespace railbook::contact {
namespace {

std::size_t padded(Eigen::Index n) {
  return num::good_fft_size(static_cast<std::size_t>(2 * n - 1));
}

// Far from the cell the second difference loses digits like (r/h)^2, while the first two terms of the
// expansion of 1/r about the centre are good to (h/r)^4: they cross near r = 280 h at about 1e-11.
double far_integral(double x, double y, double dx, double dy) {
  const double r2 = x * x + y * y;
  const double quadrupole =
      (dx * dx * (2 * x * x - y * y) + dy * dy * (2 * y * y - x * x)) / (24 * r2 * r2);
  return dx * dy / std::sqrt(r2) * (1 + quadrupole);
}

// The symbol of A times E*/2: waves exp(i k x) of pressure held constant on each cell give displacements of
// 1/|k|, summed over the waves that look the same at the cell centres.
double symbol(double theta_x, double theta_y, const Grid& grid) {
  const double sin_x = std::sin(theta_x / 2), sin_y = std::sin(theta_y / 2);
  double sum = 0;
  for (int n = -2; n <= 2; ++n) {
    const double ky = theta_y + 2 * units::pi * n;
    const double sinc_y = ky == 0 ? 1 : 2 * (n % 2 ? -sin_y : sin_y) / ky;
    for (int m = -2; m <= 2; ++m) {
      const double kx = theta_x + 2 * units::pi * m;
      const double sinc_x = kx == 0 ? 1 : 2 * (m % 2 ? -sin_x : sin_x) / kx;
      sum += sinc_x * sinc_y / std::hypot(kx / grid.dx, ky / grid.dy);
    }
  }
  return sum;
}

}  // namespace

Convolution::Convolution(const Grid& grid, double effective_modulus)
    : nx_(grid.nx),
      ny_(grid.ny),
      fft_(padded(grid.ny), padded(grid.nx)),
      effective_modulus_(effective_modulus) {
  const double k = 1 / (units::pi * effective_modulus);
  const double dx = grid.dx, dy = grid.dy;
  const double far = 280 * std::max(dx, dy);
  const auto rows = fft_.rows(), columns = fft_.columns();
  std::ranges::fill(fft_.real(), 0.0);
  std::vector<double> below(static_cast<std::size_t>(nx_) + 1), above(below.size());
  auto fill_corners = [&](double y, std::vector<double>& g) {
    for (std::size_t i = 0; i < g.size(); ++i)
      g[i] = corner_function((static_cast<double>(i) - 0.5) * dx, y);
  };
  fill_corners(-0.5 * dy, above);
  for (std::size_t j = 0; j < static_cast<std::size_t>(ny_); ++j) {
    std::swap(below, above);
    fill_corners((static_cast<double>(j) + 0.5) * dy, above);
    for (std::size_t i = 0; i < static_cast<std::size_t>(nx_); ++i) {
      const double x = static_cast<double>(i) * dx, y = static_cast<double>(j) * dy;
      const double b = std::hypot(x, y) > far ? far_integral(x, y, dx, dy)
                                              : above[i + 1] - above[i] - below[i + 1] + below[i];
      for (const std::size_t row : {j, (rows - j) % rows})
        for (const std::size_t column : {i, (columns - i) % columns}) fft_.row(row)[column] = k * b;
    }
  }
  self_ = fft_.row(0)[0];
  fft_.forward();
  const std::size_t width = columns / 2 + 1;
  spectrum_.resize((rows / 2 + 1) * width);
  const double norm = 1 / static_cast<double>(rows * columns);
  for (std::size_t n = 0; n < spectrum_.size(); ++n)
    spectrum_[n] = fft_.spectrum()[n].real() * norm;
}

void Convolution::apply(const Eigen::VectorXd& p, Eigen::VectorXd& u) {
  const auto rows = fft_.rows(), width = fft_.columns() / 2 + 1;
  const auto nx = static_cast<std::size_t>(nx_), ny = static_cast<std::size_t>(ny_);
  for (std::size_t j = 0; j < ny; ++j) {
    std::copy_n(p.data() + j * nx, nx, fft_.row(j));
    std::fill_n(fft_.row(j) + nx, fft_.stride() - nx, 0.0);
  }
  std::fill_n(fft_.row(ny), (rows - ny) * fft_.stride(), 0.0);
  fft_.forward();
  for (std::size_t j = 0; j < rows; ++j) {
    std::complex<double>* row = fft_.spectrum().data() + j * width;
    const double* s = spectrum_.data() + std::min(j, rows - j) * width;
    for (std::size_t i = 0; i < width; ++i) row[i] *= s[i];
  }
  fft_.inverse();
  for (std::size_t j = 0; j < ny; ++j) std::copy_n(fft_.row(j), nx, u.data() + j * nx);
}

long Convolution::points() const {
  return static_cast<long>(fft_.rows() * fft_.columns());
}

InversePreconditioner::InversePreconditioner(const Grid& grid, double effective_modulus)
    : nx_(grid.nx),
      ny_(grid.ny),
      fft_(num::good_fft_size(static_cast<std::size_t>(ny_)),
           num::good_fft_size(static_cast<std::size_t>(nx_))) {
  const auto rows = fft_.rows(), columns = fft_.columns(), width = columns / 2 + 1;
  inverse_.resize((rows / 2 + 1) * width);
  const double norm = effective_modulus / (2 * static_cast<double>(rows * columns));
  for (std::size_t j = 0; j <= rows / 2; ++j)
    for (std::size_t i = 0; i < width; ++i) {
      // The lowest wave number that fits stands in for zero: the patch is not periodic, its mean is finite.
      const double u = i + j ? static_cast<double>(i) : 0.5;
      inverse_[j * width + i] =
          norm / symbol(2 * units::pi * u / static_cast<double>(columns),
                        2 * units::pi * static_cast<double>(j) / static_cast<double>(rows), grid);
    }
}

void InversePreconditioner::apply(const Eigen::VectorXd& r, Eigen::VectorXd& z) {
  const auto rows = fft_.rows(), width = fft_.columns() / 2 + 1;
  const auto nx = static_cast<std::size_t>(nx_), ny = static_cast<std::size_t>(ny_);
  for (std::size_t j = 0; j < rows; ++j) {
    const std::size_t filled = j < ny ? nx : 0;
    if (filled) std::copy_n(r.data() + j * nx, nx, fft_.row(j));
    std::fill_n(fft_.row(j) + filled, fft_.stride() - filled, 0.0);
  }
  fft_.forward();
  for (std::size_t j = 0; j < rows; ++j) {
    std::complex<double>* row = fft_.spectrum().data() + j * width;
    const double* s = inverse_.data() + std::min(j, rows - j) * width;
    for (std::size_t i = 0; i < width; ++i) row[i] *= s[i];
  }
  fft_.inverse();
  for (std::size_t j = 0; j < ny; ++j) std::copy_n(fft_.row(j), nx, z.data() + j * nx);
}

long InversePreconditioner::points() const {
  return static_cast<long>(fft_.rows() * fft_.columns());
}

double memory_needed(Eigen::Index nx, Eigen::Index ny) {
  const double cells = static_cast<double>(nx) * static_cast<double>(ny);
  const double big = static_cast<double>(padded(nx)) * static_cast<double>(padded(ny));
  return 8 * (big * 1.25 + cells * (1.25 + 9));
}

}  // namespace railbook::contact
