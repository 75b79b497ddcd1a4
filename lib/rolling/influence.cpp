#include <railbook/rolling/influence.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <vector>

#include <railbook/num/fft.hpp>
#include <railbook/num/frame_fft.hpp>
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

// The inverses of L and U in one matrix, without pivots: those of the strain tend to a limit, as
// its symbol has factors, and those of the displacement are positive.
Eigen::MatrixXd inverse_factors(Eigen::MatrixXd m) {
  const Eigen::Index n = m.rows();
  for (Eigen::Index k = 0; k + 1 < n; ++k) {
    const Eigen::Index rest = n - k - 1;
    m.col(k).tail(rest) /= m(k, k);
    m.bottomRightCorner(rest, rest).noalias() -= m.col(k).tail(rest) * m.row(k).tail(rest);
  }
  Eigen::MatrixXd lower = Eigen::MatrixXd::Identity(n, n), upper = lower;
  m.triangularView<Eigen::UnitLower>().solveInPlace(lower);
  m.triangularView<Eigen::Upper>().solveInPlace(upper);
  upper.triangularView<Eigen::StrictlyLower>() = lower;
  return upper;
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
  Eigen::MatrixXd matrix;  // dense, or empty; see fill_matrix
  std::unique_ptr<SteppedRows> stepped;
  std::unique_ptr<num::FrameFft> fft;
  std::unique_ptr<num::Workspace> workspace;
  Eigen::MatrixXcd mean, difference;  // wave numbers across x along; see fill_spectra

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

// Tractions and strains are complex: along and across as real and imaginary part, T and S. With the
// parts of the influence, S = (xx + yy)/2 T + [(xx - yy)/2 + i xy] conj(T): one product with the
// spectrum of T, and one with that of its opposite wave's conjugate. xx and yy are even across, xy
// odd, so that both spectra at (-u, v) are the conjugates of those at (u, v).
void TangentialInfluence::Parts::fill_spectra() {
  const auto n = static_cast<std::size_t>(mesh.along), rows = static_cast<std::size_t>(mesh.rows());
  fft = std::make_unique<num::FrameFft>(rows, n, num::good_frame_size(2 * rows - 1),
                                        num::good_frame_size(2 * n), 1,
                                        num::FrameFft::Values::complex);
  workspace = std::make_unique<num::Workspace>(fft->workspace());
  const std::size_t big_rows = fft->frame_rows(), columns = fft->frame_columns();
  const double dx = mesh.dx[0], dy = mesh.dy[0];
  const double upstream_part = response == Response::strain ? 1 : 0;
  const double scale = 1 / (units::pi * (response == Response::strain ? dx : 1) *
                            static_cast<double>(big_rows) * static_cast<double>(columns));
  // u at distances -n .. n cells from one cell, the strain at -n .. n - 1.
  std::vector<Influence2> u(2 * n + 1);
  const std::size_t field = rows * columns;
  // Of the rows j >= 0; the others are their images.
  std::vector<double> of_mean(2 * field), of_difference(2 * field);
  for (std::size_t j = 0; j < rows; ++j) {
    row_displacements(static_cast<double>(n) * dx, static_cast<double>(j) * dy, dx, dy, poisson, u);
    for (std::size_t i = 0; i < 2 * n; ++i) {
      // u[k] belongs to a cell (k - n) dx downstream of the point: distance of the point n - k.
      const Influence2 &here = u[2 * n - i], &upstream = u[2 * n - i - 1];
      const auto part = [&](double Influence2::*of) {
        return (j > 0 ? 1 : 0.5) * scale * (here.*of - upstream_part * upstream.*of);
      };
      const std::size_t to = j * columns + (i + columns - n) % columns;
      const double xx = part(&Influence2::xx), yy = part(&Influence2::yy);
      of_mean[to] = (xx + yy) / 2;
      of_difference[to] = (xx - yy) / 2, of_difference[field + to] = part(&Influence2::xy);
    }
  }
  const num::FrameFft of_kernels(rows, columns, big_rows, columns, 1,
                                 num::FrameFft::Values::complex);
  num::Workspace space(of_kernels.workspace());
  const auto transform = [&](const std::vector<double>& kernel, Eigen::MatrixXcd& spectrum) {
    spectrum.resize(static_cast<Eigen::Index>(big_rows),
                    static_cast<Eigen::Index>(fft->wave_numbers()));
    of_kernels.apply(kernel.data(), nullptr, space.data(),
                     [&](std::size_t wave, double* column, double* opposite) {
                       const auto as_vector = [&](double* pairs) {
                         return Eigen::Map<const Eigen::VectorXcd>(
                             reinterpret_cast<std::complex<double>*>(pairs), spectrum.rows());
                       };
                       spectrum.col(static_cast<Eigen::Index>(wave)) =
                           as_vector(column) + as_vector(opposite).conjugate();
                     });
  };
  transform(of_mean, mean);
  transform(of_difference, difference);
}

void TangentialInfluence::Parts::multiply(const Eigen::VectorXd& p, Eigen::VectorXd& strain) {
  strain.resize(2 * mesh.cells());
  fft->apply(p.data(), strain.data(), workspace->data(),
             [&](std::size_t wave, double* column, double* opposite) {
               const auto u = static_cast<Eigen::Index>(wave);
               const Eigen::Index size = mean.rows();
               const auto* s = reinterpret_cast<const double*>(mean.col(u).data());
               const auto* d = reinterpret_cast<const double*>(difference.col(u).data());
               // Of a column that is its own opposite a half does for all.
               const Eigen::Index count = column == opposite ? size / 2 + 1 : size;
               for (Eigen::Index v = 0, w = 0; v < count; ++v, w = size - v) {
                 double *a = column + 2 * v, *b = opposite + 2 * w;
                 const double *k = s + 2 * v, *m = d + 2 * v, *n = d + 2 * w;
                 const double ax = a[0], ay = a[1], bx = b[0], by = b[1];
                 b[0] = k[0] * bx + k[1] * by + n[0] * ax - n[1] * ay;
                 b[1] = k[0] * by - k[1] * bx - n[0] * ay - n[1] * ax;
                 a[0] = k[0] * ax - k[1] * ay + m[0] * bx + m[1] * by;
                 a[1] = k[0] * ay + k[1] * ax - m[0] * by + m[1] * bx;
               }
             });
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
    rows_.push_back({b.xx, b.yy, inverse_factors(b.xx), inverse_factors(b.yy)});
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

void TangentialInfluence::approximate(const Eigen::VectorXd& p, Eigen::VectorXd& strain) const {
  if (parts_->stepped)
    parts_->stepped->approximate(p, strain);
  else
    apply(p, strain);
}

}  // namespace railbook::rolling
