#include <railbook/contact/convolution.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

#include <railbook/contact/detail/split_convolution.hpp>
#include <railbook/contact/influence.hpp>
#include <railbook/num/fft.hpp>
#include <railbook/num/parallel.hpp>
#include <railbook/units/constants.hpp>

namespace railbook::contact {
namespace {

std::size_t size(Eigen::Index n) {
  return static_cast<std::size_t>(n);
}

std::size_t padded(Eigen::Index n) {
  return num::good_frame_size(size(2 * n - 1));
}

long points_of(const num::EvenFilter& filter) {
  return static_cast<long>(filter.frame_rows() * filter.frame_columns());
}

// Far from the cell the second difference loses digits like (r/h)^2, while the first two terms of
// the expansion of 1/r about the centre are good to (h/r)^4: they cross near r = 280 h at about
// 1e-11.
double far_integral(double x, double y, double dx, double dy) {
  const double r2 = x * x + y * y;
  const double quadrupole =
      (dx * dx * (2 * x * x - y * y) + dy * dy * (2 * y * y - x * x)) / (24 * r2 * r2);
  return dx * dy / std::sqrt(r2) * (1 + quadrupole);
}

// The symbol of A times E*/2: waves exp(i k x) of pressure held constant on each cell give
// displacements of 1/|k|, summed over the waves that look the same at the cell centres.
double symbol(double theta_x, double theta_y, const Grid& grid) {
  const double sin_x = std::sin(theta_x / 2), sin_y = std::sin(theta_y / 2);
  double sum = 0;
  for (int n = -2; n <= 2; ++n) {
    const double ky = theta_y + 2 * units::pi * n;
    const double sinc_y = ky == 0 ? 1 : 2 * (n % 2 ? -sin_y : sin_y) / ky;
    for (int m = -2; m <= 2; ++m) {
      const double kx = theta_x + 2 * units::pi * m;
      const double sinc_x = kx == 0 ? 1 : 2 * (m % 2 ? -sin_x : sin_x) / kx;
      const double x = kx / grid.dx, y = ky / grid.dy;
      sum += sinc_x * sinc_y / std::sqrt(x * x + y * y);
    }
  }
  return sum;
}

}  // namespace

Convolution::Convolution(const Grid& grid, double effective_modulus, int threads)
    : grid_(grid),
      threads_(threads),
      filter_(size(grid.ny), size(grid.nx), padded(grid.ny), padded(grid.nx), threads),
      workspace_(filter_.workspace()),
      effective_modulus_(effective_modulus) {
  const double k = 1 / (units::pi * effective_modulus);
  const double dx = grid.dx, dy = grid.dy;
  const double far = 280 * std::max(dx, dy);
  num::in_parallel(threads, size(grid.ny), [&](std::size_t begin, std::size_t end, std::size_t) {
    std::vector<double> below(size(grid.nx) + 1), above(below.size());
    const auto fill_corners = [&](double row, std::vector<double>& g) {
      for (std::size_t i = 0; i < g.size(); ++i)
        g[i] = corner_function((static_cast<double>(i) - 0.5) * dx, (row - 0.5) * dy);
    };
    fill_corners(static_cast<double>(begin), above);
    for (std::size_t j = begin; j < end; ++j) {
      std::swap(below, above);
      fill_corners(static_cast<double>(j + 1), above);
      for (std::size_t i = 0; i < size(grid.nx); ++i) {
        const double x = static_cast<double>(i) * dx, y = static_cast<double>(j) * dy;
        const double b = std::hypot(x, y) > far ? far_integral(x, y, dx, dy)
                                                : above[i + 1] - above[i] - below[i + 1] + below[i];
        filter_.at(j, i) = k * b;
      }
    }
  });
  self_ = filter_.at(0, 0);
  filter_.transform_kernel();
  if (std::min(grid.nx, grid.ny) >= 64 && 5 * SplitConvolution::points(grid) < 3 * points())
    split_ = std::make_unique<SplitConvolution>(grid, effective_modulus, threads);
}

Convolution::~Convolution() = default;

Convolution::Convolution(const Grid& grid, double effective_modulus,
                         const std::function<double(Eigen::Index, Eigen::Index)>& kernel)
    : grid_(grid),
      filter_(size(grid.ny), size(grid.nx), padded(grid.ny), padded(grid.nx), 1),
      workspace_(filter_.workspace()),
      effective_modulus_(effective_modulus) {
  for (Eigen::Index j = 0; j < grid.ny; ++j)
    for (Eigen::Index i = 0; i < grid.nx; ++i)
      filter_.at(size(j), size(i)) = kernel(i, j) / (units::pi * effective_modulus);
  self_ = filter_.at(0, 0);
  filter_.transform_kernel();
}

void Convolution::apply(const Eigen::VectorXd& p, Eigen::VectorXd& u) {
  filter_.apply(p.data(), u.data(), workspace_.data());
}

void Convolution::approximate(const Eigen::VectorXd& p, Eigen::VectorXd& u) {
  if (split_)
    split_->apply(p, u, workspace_.data());
  else
    apply(p, u);
}

long Convolution::approximate_points() const {
  return split_ ? split_->points() : points();
}

long Convolution::points() const {
  return points_of(filter_);
}

InversePreconditioner& Convolution::inverse() {
  if (!inverse_)
    inverse_ = std::make_unique<InversePreconditioner>(grid_, effective_modulus_, threads_);
  return *inverse_;
}

InversePreconditioner::InversePreconditioner(const Grid& grid, double effective_modulus,
                                             int threads)
    : filter_(size(grid.ny), size(grid.nx), num::good_fft_size(size(grid.ny)),
              num::good_fft_size(size(grid.nx)), threads) {
  const std::size_t rows = filter_.frame_rows(), columns = filter_.frame_columns();
  num::in_parallel(threads, columns / 2 + 1, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i)
      for (std::size_t j = 0; j <= rows / 2; ++j) {
        // The lowest wave number that fits stands in for zero: the patch is not periodic, its mean
        // is finite.
        const double u = i + j ? static_cast<double>(i) : 0.5;
        filter_.at(j, i) =
            effective_modulus / 2 /
            symbol(2 * units::pi * u / static_cast<double>(columns),
                   2 * units::pi * static_cast<double>(j) / static_cast<double>(rows), grid);
      }
  });
}

void InversePreconditioner::apply(const Eigen::VectorXd& r, Eigen::VectorXd& z, double* workspace) {
  filter_.apply(r.data(), z.data(), workspace);
}

long InversePreconditioner::points() const {
  return points_of(filter_);
}

double memory_needed(Eigen::Index nx, Eigen::Index ny) {
  const double cells = static_cast<double>(nx) * static_cast<double>(ny);
  const double big = static_cast<double>(padded(nx)) * static_cast<double>(padded(ny));
  // Filters (the approximate one takes 0.4 of the cells and two frames of an eighth), workspace,
  // and the solver's vectors; as much is taken again by the answer when these are gone.
  return 8 * (0.25 * (big + cells) + static_cast<double>(ny) * static_cast<double>(padded(nx)) +
              7 * cells);
}

}  // namespace railbook::contact
