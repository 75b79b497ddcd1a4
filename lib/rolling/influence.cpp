#include <railbook/rolling/influence.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <railbook/num/fft.hpp>
#include <railbook/num/quadrature.hpp>
#include <railbook/rolling/detail/cell_displacements.hpp>
#include <railbook/rolling/detail/stepped_rows.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::rolling {
namespace {

// Response at the cells of row `at` from unit tractions on the cells of row `from`, as three along
// x along blocks.
struct Blocks {
  explicit Blocks(Eigen::Index n) : xx(n, n), xy(n, n), yy(n, n) {}
  void clear() { xx.setZero(), xy.setZero(), yy.setZero(); }
  Eigen::MatrixXd xx, xy, yy;
};

// What a cell and its mirror image add: t holds the even and odd parts of the tractions along, then
// across, `columns` those of their six columns. What takes the time is reading them: each is read
// once.
void add_cell(const double* columns, Eigen::Index n, const std::array<double, 4>& t,
              double* __restrict sums) {
  const double *xx = columns, *xy = columns + 2 * n, *yy = columns + 4 * n;
  const double x_even = t[0], x_odd = t[1], y_even = t[2], y_odd = t[3];
  for (Eigen::Index i = 0; i < n; ++i) {
    sums[i] += xx[i] * x_even + xy[n + i] * y_odd;
    sums[n + i] += xx[n + i] * x_odd + xy[i] * y_even;
    sums[2 * n + i] += yy[i] * y_even + xy[n + i] * x_odd;
    sums[3 * n + i] += yy[n + i] * y_odd + xy[i] * x_even;
  }
}

void fill(const RollingMesh& mesh, double poisson, Response response, Eigen::Index at,
          Eigen::Index from, Blocks& b) {
  const bool strain = response == Response::strain;
  const Eigen::Index n = mesh.along;
  std::vector<Influence2> here(static_cast<std::size_t>(n)), upstream(here.size());
  const double scale = 1 / (units::pi * (strain ? mesh.dx[at] : 1));
  const double upstream_part = strain ? 1 : 0;
  for (Eigen::Index i = n; i >= 0; --i) {
    std::swap(here, upstream);
    row_displacements(mesh.x(at, i) - mesh.x0[from], mesh.y[at] - mesh.y[from], mesh.dx[from],
                      mesh.dy[from], poisson, here);
    if (i == n) continue;
    for (Eigen::Index k = 0; k < n; ++k) {
      const Influence2& u = here[static_cast<std::size_t>(k)];
      const Influence2& v = upstream[static_cast<std::size_t>(k)];
      b.xx(i, k) = scale * (u.xx - upstream_part * v.xx);
      b.xy(i, k) = scale * (u.xy - upstream_part * v.xy);
      b.yy(i, k) = scale * (u.yy - upstream_part * v.yy);
    }
  }
}

double log_symbol_ratio(double t) {
  double sum = 1 / (t * t);
  for (int m = 1; m < 2000; ++m) {
    const double low = 2 * units::pi * m - t, high = 2 * units::pi * m + t;
    sum += (m % 2 ? 1 : -1) * (1 / (low * low) - 1 / (high * high));
  }
  const double s = std::sin(t / 2);
  return std::log(4 * s * s * sum) / (s * s);
}

}  // namespace

double edge_offset() {
  static const double value = [] {
    const num::GaussRule rule = num::gauss_legendre(24, 0, units::pi);
    double sum = 0;
    for (Eigen::Index i = 0; i < rule.x.size(); ++i) sum += rule.w[i] * log_symbol_ratio(rule.x[i]);
    return -sum / (4 * units::pi);
  }();
  return value;
}

namespace {

// All rows of one height and spacing, and of one length of cell.
bool regular(const RollingMesh& mesh) {
  for (Eigen::Index j = 0; j < mesh.rows(); ++j)
    if (std::abs(mesh.dx[j] / mesh.dx[0] - 1) > 1e-9 ||
        std::abs(mesh.dy[j] / mesh.dy[0] - 1) > 1e-9 ||
        std::abs(mesh.y[j] - mesh.y[0] - static_cast<double>(j) * mesh.dy[0]) > 1e-6 * mesh.dy[0])
      return false;
  return true;
}

}  // namespace

bool RollingMesh::uniform() const {
  return regular(*this) && ((x0.array() - x0[0]).abs() <= 1e-9 * dx[0]).all();
}

bool RollingMesh::stepped() const {
  return regular(*this) && mirrored();
}

bool RollingMesh::mirrored() const {
  const Eigen::ArrayXd middles = y + y.reverse();
  return ((x0 - x0.reverse()).array().abs() <= 1e-9 * dx[0]).all() &&
         ((dx - dx.reverse()).array().abs() <= 1e-9 * dx[0]).all() &&
         ((dy - dy.reverse()).array().abs() <= 1e-9 * dy[0]).all() &&
         ((middles - middles[0]).abs() <= 1e-6 * dy[0]).all();
}

struct TangentialInfluence::Parts {
  RollingMesh mesh;
  double poisson = 0;
  Response response = Response::strain;
  Eigen::MatrixXd matrix;               // dense, or empty; see fill_matrix
  std::vector<Eigen::MatrixXd> blocks;  // of the rows, or the one they share
  std::unique_ptr<SteppedRows> stepped;
  std::unique_ptr<num::RealFft2d> x, y;
  std::vector<std::complex<double>> xx, xy, yy;

  void fill_matrix();
  void multiply_matrix(const Eigen::VectorXd& p, Eigen::VectorXd& strain) const;
  void fill_spectra();
  void multiply(const Eigen::VectorXd& p, Eigen::VectorXd& strain);
};

// Of the lower half of the rows (the middle one with it): what a cell does with its mirror image,
// together and against one another, even and odd parts for short. Six columns a cell: xx even, xx
// odd, xy even, xy odd, yy even, yy odd.
void TangentialInfluence::Parts::fill_matrix() {
  const Eigen::Index n = mesh.along, rows = mesh.rows(), half = (rows + 1) / 2;
  matrix.resize(half * n, 6 * half * n);
  Blocks one(n), other(n);
  for (Eigen::Index at = 0; at < half; ++at)
    for (Eigen::Index from = 0; from < half; ++from) {
      const Eigen::Index mirror = rows - 1 - from;
      fill(mesh, poisson, response, at, from, one);
      if (mirror == from)
        other.clear();
      else
        fill(mesh, poisson, response, at, mirror, other);
      for (Eigen::Index k = 0; k < n; ++k) {
        auto to = matrix.block(at * n, 6 * (from * n + k), n, 6);
        to << one.xx.col(k) + other.xx.col(k), one.xx.col(k) - other.xx.col(k),
            one.xy.col(k) + other.xy.col(k), one.xy.col(k) - other.xy.col(k),
            one.yy.col(k) + other.yy.col(k), one.yy.col(k) - other.yy.col(k);
      }
    }
}

// Strain along and across from tractions along, across: mirror images have the same xx and yy, and
// the opposite xy.
void TangentialInfluence::Parts::multiply_matrix(const Eigen::VectorXd& p,
                                                 Eigen::VectorXd& strain) const {
  const Eigen::Index n = mesh.along, rows = mesh.rows(), cells = mesh.cells(), half = matrix.rows();
  const auto mirror_of = [&](Eigen::Index k) { return (rows - 1 - k / n) * n + k % n; };
  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(half, 4);  // along, even and odd; across
  for (Eigen::Index k = 0; k < half; ++k) {
    const Eigen::Index mirror = mirror_of(k);
    const double here[] = {p[k], p[cells + k]}, there[] = {p[mirror], p[cells + mirror]};
    add_cell(matrix.col(6 * k).data(), half,
             {(here[0] + there[0]) / 2, (here[0] - there[0]) / 2, (here[1] + there[1]) / 2,
              (here[1] - there[1]) / 2},
             sums.data());
  }
  strain.resize(2 * cells);
  for (Eigen::Index part = 0; part < 2; ++part)
    for (Eigen::Index k = 0; k < half; ++k) {
      const double even = sums(k, 2 * part), odd = sums(k, 2 * part + 1);
      const Eigen::Index mirror = mirror_of(k);
      strain[part * cells + mirror] = even - odd;
      strain[part * cells + k] = even + odd;
    }
}

void TangentialInfluence::Parts::fill_spectra() {
  const auto n = static_cast<std::size_t>(mesh.along), rows = static_cast<std::size_t>(mesh.rows());
  x = std::make_unique<num::RealFft2d>(num::good_fft_size(2 * rows - 1), num::good_fft_size(2 * n));
  y = std::make_unique<num::RealFft2d>(x->rows(), x->columns());
  const auto big_rows = x->rows(), columns = x->columns();
  const double dx = mesh.dx[0], dy = mesh.dy[0];
  const double upstream_part = response == Response::strain ? 1 : 0;
  const double scale = 1 / (units::pi * (response == Response::strain ? dx : 1) *
                            static_cast<double>(big_rows) * static_cast<double>(columns));
  // u at distances -n .. n cells from one cell, the strain at -n .. n - 1.
  std::vector<Influence2> u(2 * n + 1);
  const auto put = [&](auto part, std::vector<std::complex<double>>& spectrum, bool odd) {
    std::ranges::fill(x->real(), 0.0);
    for (std::size_t j = 0; j < rows; ++j) {
      row_displacements(static_cast<double>(n) * dx, static_cast<double>(j) * dy, dx, dy, poisson,
                        u);
      for (std::size_t i = 0; i < 2 * n; ++i) {
        // u[k] belongs to a cell (k - n) dx downstream of the point: distance of the point n - k.
        const double value = scale * (u[2 * n - i].*part - upstream_part * u[2 * n - i - 1].*part);
        const std::size_t column = (i + columns - n) % columns;
        x->row(j)[column] = value;
        if (j > 0) x->row(big_rows - j)[column] = odd ? -value : value;
      }
    }
    x->forward();
    spectrum.assign(x->spectrum().begin(), x->spectrum().end());
  };
  put(&Influence2::xx, xx, false);
  put(&Influence2::xy, xy, true);
  put(&Influence2::yy, yy, false);
}

void TangentialInfluence::Parts::multiply(const Eigen::VectorXd& p, Eigen::VectorXd& strain) {
  const auto n = static_cast<std::size_t>(mesh.along), rows = static_cast<std::size_t>(mesh.rows());
  const auto load = [&](num::RealFft2d& fft, const double* from) {
    std::ranges::fill(fft.real(), 0.0);
    for (std::size_t j = 0; j < rows; ++j) std::copy_n(from + j * n, n, fft.row(j));
    fft.forward();
  };
  load(*x, p.data());
  load(*y, p.data() + mesh.cells());
  for (std::size_t k = 0; k < xx.size(); ++k) {
    const std::complex<double> px = x->spectrum()[k], py = y->spectrum()[k];
    x->spectrum()[k] = xx[k] * px + xy[k] * py;
    y->spectrum()[k] = xy[k] * px + yy[k] * py;
  }
  strain.resize(2 * mesh.cells());
  const auto unload = [&](num::RealFft2d& fft, double* to) {
    fft.inverse();
    for (std::size_t j = 0; j < rows; ++j) std::copy_n(fft.row(j), n, to + j * n);
  };
  unload(*x, strain.data());
  unload(*y, strain.data() + mesh.cells());
}

TangentialInfluence::TangentialInfluence(const RollingMesh& mesh, double poisson, bool dense,
                                         Response response)
    : parts_(std::make_unique<Parts>()) {
  parts_->mesh = mesh;
  parts_->poisson = poisson;
  parts_->response = response;
  const bool uniform = mesh.uniform(), stepped = !dense && mesh.stepped();
  if (!dense && uniform)
    parts_->fill_spectra();
  else if (stepped)
    parts_->stepped = std::make_unique<SteppedRows>(mesh, poisson);
  else if (mesh.mirrored())
    parts_->fill_matrix();
  else
    throw InputError("the rows of the mesh are not their own mirror image across");
  Blocks b(mesh.along);
  const Eigen::Index kinds =
      std::min<Eigen::Index>(uniform || stepped ? 1 : mesh.rows(), mesh.rows());
  for (Eigen::Index row = 0; row < kinds; ++row) {
    fill(mesh, poisson, response, row, row, b);
    parts_->blocks.emplace_back(2 * mesh.along, 2 * mesh.along);
    parts_->blocks.back() << b.xx, b.xy, b.xy, b.yy;
  }
}
TangentialInfluence::~TangentialInfluence() = default;
TangentialInfluence::TangentialInfluence(TangentialInfluence&&) noexcept = default;
TangentialInfluence& TangentialInfluence::operator=(TangentialInfluence&&) noexcept = default;

void TangentialInfluence::apply(const Eigen::VectorXd& p, Eigen::VectorXd& strain) const {
  if (parts_->matrix.size())
    parts_->multiply_matrix(p, strain);
  else if (parts_->stepped)
    parts_->stepped->apply(p, strain);
  else
    parts_->multiply(p, strain);
}

const Eigen::MatrixXd& TangentialInfluence::row_block(Eigen::Index row) const {
  return parts_->blocks[parts_->blocks.size() == 1 ? 0 : static_cast<std::size_t>(row)];
}

}  // namespace railbook::rolling
