#include <railbook/contact/subsurface.hpp>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <complex>
#include <vector>

#include <railbook/num/eigenvalues.hpp>
#include <railbook/num/fft.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::contact {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// Derivatives of Phi, the integral of z ln(r + z) - r over a rectangle: harmonic, its second
// derivative by z is the integral of 1/r. At a corner (x, y) of the rectangle, seen from the point;
// the signed sum over the corners is the derivative.
struct Derivatives {
  double xxx, yyy, xxy, xyy, xxz, yyz, xyz, xzz, yzz, zzz;
  // Times z, with one z more.
  double xxxz, yyyz, xxyz, xyyz, xxzz, yyzz, xyzz, xzzz, yzzz, zzzz;
};
constexpr std::size_t derivatives = sizeof(Derivatives) / sizeof(double);
using Corner = std::array<double, derivatives>;

Derivatives at_corner(double x, double y, double z) {
  const double r = std::hypot(x, y, z);
  // r + x and r + y without cancellation where these are negative.
  const auto sum = [r, z](double a, double b) {
    return a >= 0 ? r + a : (b * b + z * z) / (r - a);
  };
  const double rx = sum(x, y), ry = sum(y, x), rz = r + z;
  Derivatives d{};
  d.xyz = std::log(rz);
  d.xxy = -x / rz, d.xyy = -y / rz;
  d.xzz = std::log(ry), d.yzz = std::log(rx);
  d.xxx = -d.xyy - d.xzz, d.yyy = -d.xxy - d.yzz;
  d.zzz = -std::atan2(x * y, z * r);
  d.xxz = std::atan(y / x) - std::atan(y * z / (x * r));
  d.yyz = std::atan(x / y) - std::atan(x * z / (y * r));
  d.xyzz = z / r;
  d.xzzz = z * z / (r * ry), d.yzzz = z * z / (r * rx);
  d.xxzz = z * x / (r * ry), d.yyzz = z * y / (r * rx);
  d.xxyz = z * x / (r * rz), d.xyyz = z * y / (r * rz);
  d.xxxz = -d.xyyz - d.xzzz, d.yyyz = -d.xxyz - d.yzzz;
  d.zzzz = -d.xxzz - d.yyzz;
  return d;
}

// Stresses times 2 pi of a unit pressure.
Stress from_pressure(const Derivatives& d, double nu) {
  const double m = 1 - 2 * nu;
  Stress s;
  s << 2 * nu * d.zzz - m * d.xxz - d.xxzz, 2 * nu * d.zzz - m * d.yyz - d.yyzz, d.zzz - d.zzzz,
      -m * d.xyz - d.xyzz, -d.yzzz, -d.xzzz;
  return s;
}
// And of a unit pull along x.
Stress from_x(const Derivatives& d, double nu) {
  Stress s;
  s << 2 * d.xzz + 2 * nu * (d.xxx + d.xzz) - d.xxxz, 2 * nu * (d.xyy + d.xzz) - d.xyyz, -d.xzzz,
      d.yzz + 2 * nu * d.xxy - d.xxyz, -d.xyzz, d.zzz - d.xxzz;
  return s;
}
// Along y: the same with x and y exchanged.
Stress from_y(const Derivatives& d, double nu) {
  Stress s;
  s << 2 * nu * (d.xxy + d.yzz) - d.xxyz, 2 * d.yzz + 2 * nu * (d.yyy + d.yzz) - d.yyyz, -d.yzzz,
      d.xzz + 2 * nu * d.xyy - d.xyyz, d.zzz - d.yyzz, -d.xyzz;
  return s;
}

constexpr std::array of_traction{from_pressure, from_x, from_y};
// Whether a stress is odd in x, and in y, under each traction.
using Odd = std::array<bool, 6>;
constexpr std::array<Odd, 3> odd_x{Odd{0, 0, 0, 1, 0, 1}, Odd{1, 1, 1, 0, 1, 0},
                                   Odd{0, 0, 0, 1, 0, 1}};
constexpr std::array<Odd, 3> odd_y{Odd{0, 0, 0, 1, 1, 0}, Odd{0, 0, 0, 1, 1, 0},
                                   Odd{1, 1, 1, 0, 0, 1}};

std::size_t whole(Index n) {
  return static_cast<std::size_t>(n);
}

}  // namespace

double von_mises(const Stress& s) {
  const double xy = s[0] - s[1], yz = s[1] - s[2], zx = s[2] - s[0];
  return std::sqrt(0.5 * (xy * xy + yz * yz + zx * zx) + 3 * s.tail<3>().squaredNorm());
}

double largest_shear(const Stress& s) {
  // Less the mean stress, by differences: close to hydrostatic it would take the digits with it.
  const double xy = s[0] - s[1], yz = s[1] - s[2], zx = s[2] - s[0];
  Eigen::Matrix3d m;
  m << (xy - zx) / 3, s[3], s[5], s[3], (yz - xy) / 3, s[4], s[5], s[4], (zx - yz) / 3;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(m, Eigen::EigenvaluesOnly);
  return 0.5 * (solver.eigenvalues()[2] - solver.eigenvalues()[0]);
}

struct Subsurface::Parts {
  using Spectrum = std::vector<std::complex<double>>;
  Grid grid;
  double poisson = 0;
  mutable num::RealFft2d fft;
  std::array<Spectrum, 3> tractions;  // p, qx, qy; empty: none

  Parts(const Grid& g, double nu)
      : grid(g),
        poisson(nu),
        fft(num::good_fft_size(whole(2 * g.ny - 1)), num::good_fft_size(whole(2 * g.nx - 1))) {}

  void transform(std::size_t traction, const VectorXd& values) {
    if ((values.array() == 0).all()) return;
    std::ranges::fill(fft.real(), 0.0);
    for (Index j = 0; j < grid.ny; ++j)
      std::copy_n(values.data() + j * grid.nx, grid.nx, fft.row(whole(j)));
    fft.forward();
    tractions[traction].assign(fft.spectrum().begin(), fft.spectrum().end());
  }

  // Derivatives of Phi for a cell, at i cells along x and j along y from its middle: row j nx + i.
  std::vector<Derivatives> of_a_cell(double z) const {
    const auto columns = whole(grid.nx), rows = whole(grid.ny);
    std::vector<Derivatives> all;
    all.reserve(columns * rows);
    std::vector<Corner> below(columns + 1), above(columns + 1);
    const auto fill = [&](std::size_t row) {
      std::swap(below, above);
      const double y = (static_cast<double>(row) - 0.5) * grid.dy;
      for (std::size_t i = 0; i <= columns; ++i)
        above[i] = std::bit_cast<Corner>(at_corner((static_cast<double>(i) - 0.5) * grid.dx, y, z));
    };
    fill(0);
    for (std::size_t j = 0; j < rows; ++j) {
      fill(j + 1);
      for (std::size_t i = 0; i < columns; ++i) {
        Corner d;
        for (std::size_t k = 0; k < derivatives; ++k)
          d[k] = above[i + 1][k] - above[i][k] - below[i + 1][k] + below[i][k];
        all.push_back(std::bit_cast<Derivatives>(d));
      }
    }
    return all;
  }

  // The transform of one stress under a unit of one traction is left in `fft`.
  void transform_kernel(const std::vector<Stress>& kernel, int component,
                        std::size_t traction) const {
    const auto c = whole(component);
    const double scale = 1 / (2 * units::pi * static_cast<double>(fft.rows() * fft.columns()));
    const double x_sign = odd_x[traction][c] ? -1 : 1, y_sign = odd_y[traction][c] ? -1 : 1;
    std::ranges::fill(fft.real(), 0.0);
    for (Index j = 0; j < grid.ny; ++j)
      for (Index i = 0; i < grid.nx; ++i) {
        const double value = scale * kernel[whole(j * grid.nx + i)][component];
        const std::size_t right = whole(i), left = fft.columns() - right, up = whole(j),
                          down = fft.rows() - up;
        fft.row(up)[right] = value;
        if (i > 0) fft.row(up)[left] = x_sign * value;
        if (j > 0) fft.row(down)[right] = y_sign * value;
        if (i > 0 && j > 0) fft.row(down)[left] = x_sign * y_sign * value;
      }
    fft.forward();
  }

  // Of the tractions together, or of pressures and pulls apart.
  template <std::size_t count>
  std::array<Stresses, count> stresses(double depth) const;
};

Subsurface::Subsurface(const Grid& grid, double poisson, const VectorXd& p, const VectorXd& qx,
                       const VectorXd& qy)
    : parts_(std::make_unique<Parts>(grid, poisson)) {
  units::require_between("Poisson's ratio", poisson, 0, 0.5);
  for (std::size_t k = 0; const VectorXd* values : {&p, &qx, &qy}) {
    if (values->size() != grid.cells())
      throw InputError{"tractions do not have one value for every cell of their grid"};
    if (!values->allFinite()) throw InputError{"tractions must be finite"};
    parts_->transform(k++, *values);
  }
}
Subsurface::~Subsurface() = default;
Subsurface::Subsurface(Subsurface&&) noexcept = default;

template <std::size_t count>
std::array<Stresses, count> Subsurface::Parts::stresses(double depth) const {
  units::require_between("depth", depth, 0, 1e6, "m");
  const std::vector<Derivatives> cell = of_a_cell(depth);
  std::array<std::array<Spectrum, 6>, count> sums;
  for (auto& of_part : sums)
    for (auto& sum : of_part) sum.assign(fft.spectrum().size(), 0.0);
  std::vector<Stress> kernel(cell.size());
  for (std::size_t t = 0; t < 3; ++t) {
    if (tractions[t].empty()) continue;
    std::ranges::transform(cell, kernel.begin(),
                           [&](const Derivatives& d) { return of_traction[t](d, poisson); });
    for (int c = 0; c < 6; ++c) {
      transform_kernel(kernel, c, t);
      Spectrum& sum = sums[t == 0 ? 0 : count - 1][whole(c)];
      const auto spectrum = fft.spectrum();
      for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += spectrum[k] * tractions[t][k];
    }
  }
  std::array<Stresses, count> out;
  for (std::size_t part = 0; part < count; ++part) {
    out[part].resize(grid.cells(), 6);
    for (int c = 0; c < 6; ++c) {
      std::ranges::copy(sums[part][whole(c)], fft.spectrum().begin());
      fft.inverse();
      for (Index j = 0; j < grid.ny; ++j)
        std::copy_n(fft.row(whole(j)), grid.nx, out[part].col(c).data() + j * grid.nx);
    }
  }
  return out;
}

Stresses Subsurface::at(double depth) const {
  return parts_->stresses<1>(depth)[0];
}
std::array<Stresses, 2> Subsurface::parts_at(double depth) const {
  return parts_->stresses<2>(depth);
}

namespace {

// The narrower semi-axis of the ellipse whose Hertzian pressure has these second moments.
double narrower_semi_axis(const Grid& grid, const VectorXd& p) {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  Eigen::Matrix2d square = Eigen::Matrix2d::Zero();
  for (Index k = 0; k < p.size(); ++k) {
    const Eigen::Vector2d at(grid.x(k % grid.nx), grid.y(k / grid.nx));
    mean += p[k] * at, square += p[k] * at * at.transpose();
  }
  mean /= p.sum(), square /= p.sum();
  square.diagonal() += Eigen::Vector2d(grid.dx * grid.dx, grid.dy * grid.dy) / 12;
  square -= mean * mean.transpose();
  return std::sqrt(5 * num::symmetric_eigenvalues(square)[0]);
}

// The vertex of a parabola through the highest value and its neighbours over the logarithm of the
// depth.
void refine(const VectorXd& depths, const VectorXd& at, LargestStress::Place& place) {
  Index k = 0;
  place.value = at.maxCoeff(&k), place.depth = depths[k];
  if (k < 2 || k + 1 == at.size()) return;
  const double rise = at[k + 1] - at[k - 1], bend = at[k + 1] - 2 * at[k] + at[k - 1];
  if (!(bend < 0)) return;
  const double step = -0.5 * rise / bend;
  place.value += 0.25 * rise * step;
  place.depth *= std::pow(depths[k + 1] / depths[k], step);
}

// Of one body or more: `at` gives the stresses of each at a depth.
template <std::size_t bodies, class At>
std::array<LargestStress, bodies> searched(const Grid& grid, const VectorXd& p, const At& at) {
  if (!(p.array() >= 0).all()) throw InputError{"pressures must not be negative"};
  std::array<LargestStress, bodies> all;
  for (LargestStress& out : all) out.below = VectorXd::Zero(grid.cells());
  if (!(p.maxCoeff() > 0)) return all;
  constexpr int below = 17;
  VectorXd depths = VectorXd::Zero(below + 1);
  const double deepest = 2 * narrower_semi_axis(grid, p);
  for (int k = 1; k <= below; ++k) depths[k] = deepest * std::pow(1.2, k - below);
  struct Most {
    double mises = 0, shear = 0;
    Index mises_cell = 0, shear_cell = 0;
  };
  std::array<Most, bodies> most;
  for (LargestStress& out : all)
    out.depths = depths, out.von_mises_at = out.shear_at = VectorXd::Zero(below + 1);
  for (Index k = 0; k <= below; ++k) {
    const std::array<Stresses, bodies> of_bodies = at(depths[k]);
    for (std::size_t body = 0; body < bodies; ++body)
      for (Index c = 0; c < grid.cells(); ++c) {
        LargestStress& out = all[body];
        Most& m = most[body];
        const Stress s = of_bodies[body].row(c);
        const double mises = von_mises(s), shear = largest_shear(s);
        out.below[c] = std::max(out.below[c], mises);
        out.von_mises_at[k] = std::max(out.von_mises_at[k], mises);
        out.shear_at[k] = std::max(out.shear_at[k], shear);
        if (mises > m.mises) m.mises = mises, m.mises_cell = c;
        if (shear > m.shear) m.shear = shear, m.shear_cell = c;
      }
  }
  const auto place = [&](LargestStress::Place& to, Index cell) {
    to.x = grid.x(cell % grid.nx), to.y = grid.y(cell / grid.nx);
  };
  for (std::size_t body = 0; body < bodies; ++body) {
    LargestStress& out = all[body];
    refine(depths, out.von_mises_at, out.von_mises);
    refine(depths, out.shear_at, out.shear);
    place(out.von_mises, most[body].mises_cell), place(out.shear, most[body].shear_cell);
  }
  return all;
}

}  // namespace

LargestStress largest_stress(const Grid& grid, double poisson, const VectorXd& p,
                             const VectorXd& qx, const VectorXd& qy) {
  const Subsurface body(grid, poisson, p, qx, qy);
  return searched<1>(grid, p, [&](double depth) { return std::array{body.at(depth)}; })[0];
}

std::array<LargestStress, 2> largest_stresses(const Grid& grid, double poisson, const VectorXd& p,
                                              const VectorXd& qx, const VectorXd& qy) {
  const Subsurface body(grid, poisson, p, qx, qy);
  return searched<2>(grid, p, [&](double depth) {
    const std::array<Stresses, 2> parts = body.parts_at(depth);
    return std::array<Stresses, 2>{parts[0] + parts[1], parts[0] - parts[1]};
  });
}

}  // namespace railbook::contact
