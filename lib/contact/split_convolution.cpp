#include <algorithm>
#include <array>
#include <cmath>

#include <railbook/contact/detail/split_convolution.hpp>
#include <railbook/contact/influence.hpp>
#include <railbook/num/fft.hpp>
#include <railbook/num/parallel.hpp>
#include <railbook/units/constants.hpp>

namespace railbook::contact {
namespace {

using Eigen::Index, Eigen::VectorXd;

constexpr Index nodes = 8;   // that a value is interpolated from, along each axis
constexpr Index before = 3;  // of them before the cell

std::size_t unsigned_of(Index n) {
  return static_cast<std::size_t>(n);
}

// The smooth part of the integral of dA/r over a cell: F(r) times the area, and its quadrupole.
class SmoothInfluence {
 public:
  SmoothInfluence(const Grid& grid, double radius) : grid_(grid), radius_(radius) {
    for (std::size_t k = 1; k < taylor_.size(); ++k)
      taylor_[k] = -taylor_[k - 1] * (static_cast<double>(k) - 0.5) / static_cast<double>(k);
  }

  double operator()(double x, double y) const {
    const double s = (x * x + y * y) / (radius_ * radius_);
    double f = 0, df = 0, ddf = 0;  // F R and its derivatives by s
    if (s >= 1) {
      f = 1 / std::sqrt(s), df = -f / (2 * s), ddf = -1.5 * df / s;
    } else {
      for (std::size_t k = taylor_.size(); k-- > 0;) {
        ddf = ddf * (s - 1) + 2 * df;
        df = df * (s - 1) + f;
        f = f * (s - 1) + taylor_[k];
      }
    }
    const double dx2 = grid_.dx * grid_.dx, dy2 = grid_.dy * grid_.dy, r2 = radius_ * radius_;
    const double quadrupole =
        (2 * df * (dx2 + dy2) + 4 * ddf * (x * x * dx2 + y * y * dy2) / r2) / (24 * r2);
    return grid_.dx * grid_.dy / radius_ * (f + quadrupole);
  }

 private:
  const Grid& grid_;
  double radius_;
  std::array<double, 7> taylor_ = {1};  // of s^-1/2 about s = 1
};

}  // namespace

// The radius R and the two frames, for coarse cells of `step` of the larger side of a cell.
struct SplitConvolution::Sizes {
  double radius;
  Index step_x, step_y, coarse_x, coarse_y, near_x, near_y;
  std::size_t frame_x, frame_y, coarse_frame_x, coarse_frame_y;

  Sizes(const Grid& grid, Index step)
      : radius(static_cast<double>(nodes * step) * std::max(grid.dx, grid.dy)) {
    const auto axis = [&](Index cells, double d, Index& cell_step, Index& coarse, Index& near,
                          std::size_t& frame, std::size_t& coarse_frame) {
      cell_step = static_cast<Index>(radius / (static_cast<double>(nodes) * d) * (1 + 1e-12));
      coarse = (cells - 1) / cell_step + nodes;
      near = std::min(static_cast<Index>(radius / d), cells - 1);
      frame = num::good_fft_size(unsigned_of(cells + near));
      coarse_frame = num::good_fft_size(unsigned_of(2 * coarse - 1));
    };
    axis(grid.nx, grid.dx, step_x, coarse_x, near_x, frame_x, coarse_frame_x);
    axis(grid.ny, grid.dy, step_y, coarse_y, near_y, frame_y, coarse_frame_y);
  }
  long points() const {
    return static_cast<long>(frame_x * frame_y + coarse_frame_x * coarse_frame_y);
  }
  static Sizes cheapest(const Grid& grid) {
    Sizes best(grid, 2);
    for (Index step = 4; step <= 32; step *= 2)
      if (const Sizes sizes(grid, step); sizes.points() < best.points()) best = sizes;
    return best;
  }
};

SplitConvolution::Axis::Axis(Index count, Index cells_a_node)
    : cells(count), step(cells_a_node), coarse((count - 1) / cells_a_node + nodes) {
  weights.resize(nodes, step);
  for (Index m = 0; m < step; ++m) {
    const double t = static_cast<double>(m) / static_cast<double>(step);
    for (Index k = 0; k < nodes; ++k) {
      weights(k, m) = 1;  // Lagrange's
      for (Index other = 0; other < nodes; ++other)
        if (other != k)
          weights(k, m) *=
              (t - static_cast<double>(other - before)) / static_cast<double>(k - other);
    }
  }
}

SplitConvolution::SplitConvolution(const Grid& grid, double effective_modulus, int threads)
    : SplitConvolution(grid, Sizes::cheapest(grid), effective_modulus, threads) {}

SplitConvolution::SplitConvolution(const Grid& grid, const Sizes& sizes, double effective_modulus,
                                   int threads)
    : x_(grid.nx, sizes.step_x),
      y_(grid.ny, sizes.step_y),
      threads_(threads),
      near_(unsigned_of(grid.ny), unsigned_of(grid.nx), sizes.frame_y, sizes.frame_x, threads),
      far_(unsigned_of(sizes.coarse_y), unsigned_of(sizes.coarse_x), sizes.coarse_frame_y,
           sizes.coarse_frame_x),
      rows_(sizes.coarse_x, grid.ny),
      coarse_(sizes.coarse_x, sizes.coarse_y) {
  const double k = 1 / (units::pi * effective_modulus);
  const SmoothInfluence smooth(grid, sizes.radius);
  for (Index j = 0; j <= sizes.near_y; ++j)
    for (Index i = 0; i <= sizes.near_x; ++i) {
      const double x = static_cast<double>(i) * grid.dx, y = static_cast<double>(j) * grid.dy;
      if (std::hypot(x, y) < sizes.radius)
        near_.at(unsigned_of(j), unsigned_of(i)) =
            k * (rectangle_influence(x - grid.dx / 2, x + grid.dx / 2, y - grid.dy / 2,
                                     y + grid.dy / 2) -
                 smooth(x, y));
    }
  near_.transform_kernel();
  for (Index j = 0; j < sizes.coarse_y; ++j)
    for (Index i = 0; i < sizes.coarse_x; ++i)
      far_.at(unsigned_of(j), unsigned_of(i)) =
          k * smooth(static_cast<double>(i * x_.step) * grid.dx,
                     static_cast<double>(j * y_.step) * grid.dy);
  far_.transform_kernel();
}

// The pressures of the cells as weights of the coarse nodes: the transpose of spread().
void SplitConvolution::gather(const VectorXd& p) {
  num::in_parallel(threads_, unsigned_of(y_.cells),
                   [&](std::size_t begin, std::size_t end, std::size_t) {
                     for (std::size_t j = begin; j < end; ++j) {
                       auto row = rows_.col(static_cast<Index>(j));
                       row.setZero();
                       const double* values = p.data() + static_cast<Index>(j) * x_.cells;
                       for (Index i = 0, b = 0; i < x_.cells; i += x_.step, ++b) {
                         Eigen::Matrix<double, nodes, 1> about = row.segment<nodes>(b);
                         for (Index m = 0; m < std::min(x_.step, x_.cells - i); ++m)
                           about += values[i + m] * x_.weights.col(m);
                         row.segment<nodes>(b) = about;
                       }
                     }
                   });
  coarse_.setZero();
  for (Index j = 0; j < y_.cells; ++j)
    for (Index n = 0; n < nodes; ++n)
      coarse_.col(j / y_.step + n) += y_.weights(n, j % y_.step) * rows_.col(j);
}

// Adds the values of the coarse nodes, interpolated.
void SplitConvolution::spread(VectorXd& u) const {
  num::in_parallel(threads_, unsigned_of(y_.cells),
                   [&](std::size_t begin, std::size_t end, std::size_t) {
                     VectorXd row(x_.coarse);
                     for (Index j = static_cast<Index>(begin); j < static_cast<Index>(end); ++j) {
                       row.setZero();
                       for (Index n = 0; n < nodes; ++n)
                         row += y_.weights(n, j % y_.step) * coarse_.col(j / y_.step + n);
                       for (Index i = 0, b = 0; i < x_.cells; i += x_.step, ++b) {
                         const auto about = row.segment<nodes>(b);
                         double* values = u.data() + j * x_.cells + i;
                         for (Index m = 0; m < std::min(x_.step, x_.cells - i); ++m)
                           values[m] += about.dot(x_.weights.col(m));
                       }
                     }
                   });
}

void SplitConvolution::apply(const VectorXd& p, VectorXd& u, double* workspace) {
  gather(p);
  far_.apply(coarse_.data(), coarse_.data(), workspace);
  near_.apply(p.data(), u.data(), workspace);
  spread(u);
}

long SplitConvolution::points() const {
  return static_cast<long>(near_.frame_rows() * near_.frame_columns() +
                           far_.frame_rows() * far_.frame_columns());
}

long SplitConvolution::points(const Grid& grid) {
  return Sizes::cheapest(grid).points();
}

}  // namespace railbook::contact
