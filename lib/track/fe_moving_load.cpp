#include <railbook/track/fe_moving_load.hpp>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>

#include <railbook/num/banded.hpp>
#include <railbook/num/double_double.hpp>
#include <railbook/track/moving_load.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::track {

namespace {

using Eigen::Index;
using Eigen::Matrix4d;
using Eigen::MatrixXd;
using Eigen::Vector4d;
using Eigen::VectorXd;
using num::DoubleDouble;

// Integrals over the cubic Hermite element of unit length, unknowns (y, y') at each end, as whole
// numbers.
Matrix4d bending() {  // of v'' w''
  Matrix4d m;
  m << 12, 6, -12, 6,   //
      6, 4, -6, 2,      //
      -12, -6, 12, -6,  //
      6, 2, -6, 4;
  return m;
}
Matrix4d mass() {  // 420 times that of v w
  Matrix4d m;
  m << 156, 22, 54, -13,  //
      22, 4, 13, -3,      //
      54, 13, 156, -22,   //
      -13, -3, -22, 4;
  return m;
}
Matrix4d geometric() {  // 30 times that of v' w'
  Matrix4d m;
  m << 36, 3, -36, 3,   //
      3, 4, -3, -1,     //
      -36, -3, 36, -3,  //
      3, -1, -3, 4;
  return m;
}
Matrix4d convection() {  // 60 times that of v w', v the row
  Matrix4d m;
  m << -30, 6, 30, -6,  //
      -6, 0, 6, -1,     //
      -30, -6, 30, 6,   //
      6, 1, -6, 0;
  return m;
}
// The same integrals over length h, without the power of h that the derivatives bring.
Matrix4d stretched(const Matrix4d& unit, double h) {
  const Vector4d scale{1, h, 1, h};
  return scale.asDiagonal() * unit * scale.asDiagonal();
}
Vector4d hermite(double u, double h) {  // shape functions at the fraction u of the element
  const double v = 1.0 - u;
  return {v * v * (1 + 2 * u), u * v * v * h, u * u * (3 - 2 * u), -u * u * v * h};
}

// The matrix of the steady element of length h for the unknowns (y, h y') at each end, times h^3:
// all entries of bending are exact, and the others as small beside them as they are.
std::array<std::array<DoubleDouble, 4>, 4> steady_element(double theta, double zeta, double h) {
  const DoubleDouble h2 = DoubleDouble{h} * h, tension = DoubleDouble{-4 * theta} * theta * h2 / 30,
                     drag = DoubleDouble{-8 * theta} * zeta * h2 * h / 60,
                     support = h2 * h2 * 4 / 420;
  std::array<std::array<DoubleDouble, 4>, 4> element;
  for (Index i = 0; i < 4; ++i)
    for (Index j = 0; j < 4; ++j)
      element[std::size_t(i)][std::size_t(j)] = tension * geometric()(i, j) +
                                                drag * convection()(i, j) + support * mass()(i, j) +
                                                bending()(i, j);
  return element;
}

// Elimination with partial pivoting, for the matrix is not definite, of identical elements between
// clamped ends under a `load` at the node `loaded`: (y, h y') at all nodes. In double-double, for
// the condition grows with the fourth power of the number of elements.
std::vector<double> solve_band(const std::array<std::array<DoubleDouble, 4>, 4>& element,
                               std::size_t nodes, std::size_t loaded, const DoubleDouble& load) {
  constexpr std::size_t band = 3, width = 2 * band + 1;
  // A row: its entries from the column that is eliminated next, the unknown of its own at first
  // `band` further; the right side.
  using Row = std::array<DoubleDouble, width + 1>;
  const std::size_t n = 2 * (nodes - 2);  // the ends are clamped
  std::vector<Row> rows(n);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t kind = i % 2, first = std::max(i, band) - band;  // 0: y, 1: its slope
    for (std::size_t j = 0; j < 4; ++j)
      for (const std::size_t element_row : {kind, kind + 2}) {
        const std::size_t column = i + j - element_row;  // wraps below 0
        if (column < n) rows[i][column - first] += element[element_row][j];
      }
  }
  rows[2 * (loaded - 1)][width] = load;
  const auto size = [](const Row& row) { return std::abs(row[0].high); };
  for (std::size_t j = 0; j < n; ++j) {
    const auto top = rows.begin() + std::ptrdiff_t(j),
               end = rows.begin() + std::ptrdiff_t(std::min(j + band + 1, n));
    std::iter_swap(top, std::ranges::max_element(top, end, {}, size));
    for (auto row = top + 1; row != end; ++row) {
      const DoubleDouble factor = (*row)[0] / (*top)[0];
      for (std::size_t k = 1; k < width; ++k) (*row)[k - 1] = (*row)[k] - factor * (*top)[k];
      (*row)[width - 1] = 0;
      (*row)[width] += -(factor * (*top)[width]);
    }
  }
  std::vector<double> x(2 * nodes, 0.0);
  for (std::size_t j = n; j-- > 0;) {  // the right sides become the solution
    DoubleDouble& unknown = rows[j][width];
    for (std::size_t k = 1; k < width && j + k < n; ++k)
      unknown += -(rows[j][k] * rows[j + k][width]);
    unknown = unknown / rows[j][0];
    x[j + 2] = double(unknown);
  }
  return x;
}

// The slowest rate at which a side of the shape decays: the smaller real part of its two roots.
double decay_rate(const MovingLoadSide& side) {
  const double half = 0.5 * side.damping;
  const double w2 = side.stiffness - half * half;
  return w2 >= 0 ? half : side.stiffness / (half + std::sqrt(-w2));
}

FeShape nodal_values(const double* x, std::size_t nodes, std::size_t loaded, double h) {
  FeShape fe;
  fe.unknowns = static_cast<int>(2 * nodes);
  for (std::size_t i = 0; i < nodes; ++i) {
    fe.s.push_back(h * (static_cast<double>(i) - static_cast<double>(loaded)));
    fe.y.push_back(x[2 * i]);
    fe.slope.push_back(x[2 * i + 1]);
  }
  fe.at_load = fe.y[loaded];
  return fe;
}

// Newmark's average acceleration on a uniform beam with clamped ends; the effective matrix is
// factored once.
class NewmarkBeam {
 public:
  NewmarkBeam(std::size_t nodes, double element, double step, double zeta)
      : h_(element),
        dt_(step),
        mass_(stretched(mass(), h_) * (h_ / 420)),
        damping_(2.0 * zeta * mass_),
        y_(VectorXd::Zero(2 * static_cast<Index>(nodes))),
        v_(y_),
        a_(y_),
        rhs_(y_),
        effective_(band(mass_ * (4.0 / (dt_ * dt_)) + damping_ * (2.0 / dt_) +
                        stretched(bending(), h_) * (0.25 / (h_ * h_ * h_)) + mass_),
                   "Newmark's effective matrix") {}

  // One step with the force f at the abscissa x, between the first node and the last, at its end.
  void step(double f, double x) {
    // M (4/dt^2 y + 4/dt v + a) + C (2/dt y + v), element by element
    const Index n = y_.size();
    rhs_.setZero();
    for (Index i = 0; i + 3 < n; i += 2)
      rhs_.segment<4>(i) += mass_ * (4.0 / (dt_ * dt_) * y_.segment<4>(i) +
                                     4.0 / dt_ * v_.segment<4>(i) + a_.segment<4>(i)) +
                            damping_ * (2.0 / dt_ * y_.segment<4>(i) + v_.segment<4>(i));
    const auto e = static_cast<Index>(x / h_);
    rhs_.segment<4>(2 * e) += f * hermite(x / h_ - static_cast<double>(e), h_);
    rhs_.head<2>().setZero();
    rhs_.tail<2>().setZero();
    effective_.solve_in_place(rhs_);
    for (Index i = 0; i < n; ++i) {
      const double speed = 2.0 / dt_ * (rhs_[i] - y_[i]) - v_[i];
      a_[i] = 2.0 / dt_ * (speed - v_[i]) - a_[i];
      v_[i] = speed;
    }
    y_.swap(rhs_);
  }
  const VectorXd& deflection() const { return y_; }

 private:
  MatrixXd band(const Matrix4d& element) const {
    const Index n = y_.size();
    MatrixXd lower = MatrixXd::Zero(4, n);
    for (Index e = 0; e + 3 < n; e += 2)
      for (Index j = 0; j < 4; ++j)
        for (Index k = 0; j + k < 4; ++k) lower(k, e + j) += element(j + k, j);
    for (Index i : {Index{0}, Index{1}, n - 2, n - 1}) lower(0, i) *= 1e30;
    return lower;
  }

  double h_, dt_;
  Matrix4d mass_, damping_;
  VectorXd y_, v_, a_, rhs_;
  num::BandedCholesky effective_;
};

}  // namespace

FeShape fe_steady(double theta, double zeta, const FeSteadyOptions& options) {
  const double h = units::require_between("element length", options.element, 1e-9, 1e3, "1/beta");
  units::require_between("neglected amplitude", options.neglect, 1e-15, 0.1);
  const MovingLoadShape shape = moving_load(theta, zeta);  // for the length of the frame only
  const double reach = -std::log(options.neglect);
  const double back = std::ceil(reach / decay_rate(shape.behind) / h);
  const double front = std::ceil(reach / decay_rate(shape.ahead) / h);
  units::require_between("number of elements of the moving frame", back + front, 1.0, 2e6);
  const auto loaded = static_cast<std::size_t>(back);
  const std::size_t nodes = loaded + static_cast<std::size_t>(front) + 1;
  std::vector<double> x =
      solve_band(steady_element(theta, zeta, h), nodes, loaded, DoubleDouble{h} * h * h * 8);
  for (std::size_t i = 1; i < x.size(); i += 2) x[i] /= h;
  FeShape fe = nodal_values(x.data(), nodes, loaded, h);
  fe.steps = 1;
  return fe;
}

FeShape fe_newmark(double theta, double zeta, const FeNewmarkOptions& options) {
  units::require_non_negative("speed ratio V/V_c", theta);
  units::require_positive("damping ratio (the transient must die out)", zeta);
  const double h = units::require_positive("element length", options.element, "1/beta");
  const double dt = units::require_positive("time step", options.step, "sqrt(rho/K)");
  units::require_between("neglected amplitude", options.neglect, 1e-15, 0.1);
  units::require_positive("margin", options.margin, "1/beta");
  // The load ends its path on a node, so that the kink of y''' lies between elements when it is
  // measured.
  const double ramp = 8.0;
  const double steps = std::ceil((ramp - std::log(options.neglect) / std::min(zeta, 1.0)) / dt);
  const double path = theta * steps * dt;
  const auto end_node = static_cast<std::size_t>(std::ceil((path + options.margin) / h));
  const std::size_t nodes = end_node + static_cast<std::size_t>(std::ceil(options.margin / h)) + 1;
  const double refine = options.richardson ? 3.0 : 1.0;
  units::require_between("element steps of the run", refine * steps * static_cast<double>(nodes),
                         1.0, 2e10);
  const double end = h * static_cast<double>(end_node);
  const auto run = [&](int parts) {
    NewmarkBeam beam{nodes, h, dt / parts, zeta};
    const auto count = static_cast<long>(steps) * parts;
    for (long i = 1; i <= count; ++i) {
      const double left = static_cast<double>(count - i) * dt / parts;
      const double t = steps * dt - left;
      const double grown =
          t < ramp ? t / ramp - std::sin(2.0 * units::pi * t / ramp) / (2.0 * units::pi) : 1.0;
      beam.step(2.0 * grown, end - theta * left);
    }
    return beam.deflection();
  };
  VectorXd x = run(1);
  if (options.richardson) {
    const VectorXd fine = run(2);
    x = fine + (fine - x) / 3.0;
  }
  FeShape fe = nodal_values(x.data(), nodes, end_node, h);
  fe.steps = static_cast<int>(steps * refine);
  return fe;
}

FeShape fe_newmark_extrapolated(double theta, double zeta, const FeNewmarkOptions& options) {
  if (!options.richardson) throw InputError("extrapolation: richardson must be on");
  FeNewmarkOptions half = options;
  half.element *= 0.5;
  half.step *= 0.5;
  const FeShape coarse = fe_newmark(theta, zeta, options), fine = fe_newmark(theta, zeta, half);
  FeShape both;
  for (std::size_t i = 0; i < coarse.s.size(); ++i) {
    // The node of the fine run at the same s; its beam may be a little shorter.
    const double place = std::round((coarse.s[i] - fine.s.front()) / half.element);
    if (place < 0 || place >= static_cast<double>(fine.s.size())) continue;
    const auto twin = static_cast<std::size_t>(place);
    both.s.push_back(coarse.s[i]);
    both.y.push_back(fine.y[twin] + (fine.y[twin] - coarse.y[i]) / 15.0);
    both.slope.push_back(fine.slope[twin] + (fine.slope[twin] - coarse.slope[i]) / 15.0);
  }
  both.at_load = fine.at_load + (fine.at_load - coarse.at_load) / 15.0;
  both.unknowns = fine.unknowns;
  both.steps = coarse.steps + fine.steps;
  return both;
}

double largest_difference(const FeShape& fe, double theta, double zeta, double low, double high) {
  const MovingLoadShape exact = moving_load(theta, zeta);
  double worst = 0;
  for (std::size_t i = 0; i < fe.s.size(); ++i)
    if (fe.s[i] >= low && fe.s[i] <= high)
      worst = std::max(worst, std::abs(fe.y[i] - exact.deflection(fe.s[i])));
  return worst;
}

}  // namespace railbook::track
