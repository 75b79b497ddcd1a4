#include "track/fe_moving_load.hpp"

#include <gsl/gsl_linalg.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <memory>

#include "num/banded.hpp"
#include "num/gsl.hpp"
#include "track/moving_load.hpp"
#include "units/constants.hpp"
#include "units/input_error.hpp"

namespace railbook::track {

namespace {

using Eigen::Index;
using Eigen::Matrix4d;
using Eigen::MatrixXd;
using Eigen::Vector4d;
using Eigen::VectorXd;

// Cubic Hermite element of length h, unknowns (y, y') at each end.
Matrix4d bending(double h) {  // integral of v'' w''
  Matrix4d m;
  m << 12, 6 * h, -12, 6 * h,               //
      6 * h, 4 * h * h, -6 * h, 2 * h * h,  //
      -12, -6 * h, 12, -6 * h,              //
      6 * h, 2 * h * h, -6 * h, 4 * h * h;
  return m / (h * h * h);
}
Matrix4d mass(double h) {  // integral of v w
  Matrix4d m;
  m << 156, 22 * h, 54, -13 * h,              //
      22 * h, 4 * h * h, 13 * h, -3 * h * h,  //
      54, 13 * h, 156, -22 * h,               //
      -13 * h, -3 * h * h, -22 * h, 4 * h * h;
  return m * (h / 420.0);
}
Matrix4d geometric(double h) {  // integral of v' w'
  Matrix4d m;
  m << 36, 3 * h, -36, 3 * h,            //
      3 * h, 4 * h * h, -3 * h, -h * h,  //
      -36, -3 * h, 36, -3 * h,           //
      3 * h, -h * h, -3 * h, 4 * h * h;
  return m / (30.0 * h);
}
Matrix4d convection(double h) {  // integral of v w', v the row
  Matrix4d m;
  m << -30, 6 * h, 30, -6 * h,   //
      -6 * h, 0, 6 * h, -h * h,  //
      -30, -6 * h, 30, 6 * h,    //
      6 * h, h * h, -6 * h, 0;
  return m / 60.0;
}
Vector4d hermite(double u, double h) {  // shape functions at the fraction u of the element
  const double v = 1.0 - u;
  return {v * v * (1 + 2 * u), u * v * v * h, u * u * (3 - 2 * u), -u * u * v * h};
}

struct FreeMatrix {
  void operator()(gsl_matrix* m) const { gsl_matrix_free(m); }
};

// Solves the banded system (three diagonals each side) of identical elements with clamped ends and a
// unit right-hand side on the unknown `loaded`; partial pivoting, for the matrix is not definite.
std::vector<double> solve_band(const Matrix4d& element, std::size_t nodes, std::size_t loaded) {
  const std::size_t n = 2 * nodes;
  constexpr std::size_t p = 3;
  num::use_gsl_status_codes();
  const std::unique_ptr<gsl_matrix, FreeMatrix> band{gsl_matrix_calloc(n, 3 * p + 1)};
  const auto at = [&](std::size_t i, std::size_t j) -> double& {
    return *gsl_matrix_ptr(band.get(), j, 2 * p + i - j);
  };
  for (std::size_t e = 0; e + 1 < nodes; ++e)
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < 4; ++j)
        at(2 * e + i, 2 * e + j) += element(static_cast<int>(i), static_cast<int>(j));
  for (std::size_t clamped : {std::size_t{0}, std::size_t{1}, n - 2, n - 1})
    at(clamped, clamped) = 1e30;
  std::vector<double> x(n, 0.0);
  x[loaded] = 1.0;
  const std::unique_ptr<gsl_vector_uint, decltype(&gsl_vector_uint_free)> pivots{
      gsl_vector_uint_alloc(n), gsl_vector_uint_free};
  num::check_gsl(gsl_linalg_LU_band_decomp(n, p, p, band.get(), pivots.get()),
                 "banded elimination");
  gsl_vector_view view = gsl_vector_view_array(x.data(), n);
  num::check_gsl(gsl_linalg_LU_band_svx(p, p, band.get(), pivots.get(), &view.vector),
                 "banded solution");
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

// Newmark's average acceleration on a uniform beam with clamped ends; the effective matrix is factored once.
class NewmarkBeam {
 public:
  NewmarkBeam(std::size_t nodes, double element, double step, double zeta)
      : h_(element),
        dt_(step),
        mass_(mass(element)),
        damping_(2.0 * zeta * mass_),
        y_(VectorXd::Zero(2 * static_cast<Index>(nodes))),
        v_(y_),
        a_(y_),
        rhs_(y_),
        effective_(
            band(mass_ * (4.0 / (dt_ * dt_)) + damping_ * (2.0 / dt_) + 0.25 * bending(h_) + mass_),
            "Newmark's effective matrix") {}

  // One step with the force f at the abscissa x at its end.
  void step(double f, double x) {
    // M (4/dt^2 y + 4/dt v + a) + C (2/dt y + v), element by element
    const Index n = y_.size();
    rhs_.setZero();
    for (Index i = 0; i + 3 < n; i += 2)
      rhs_.segment<4>(i) += mass_ * (4.0 / (dt_ * dt_) * y_.segment<4>(i) +
                                     4.0 / dt_ * v_.segment<4>(i) + a_.segment<4>(i)) +
                            damping_ * (2.0 / dt_ * y_.segment<4>(i) + v_.segment<4>(i));
    const Index e = std::min(static_cast<Index>(x / h_), n / 2 - 2);
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
  const double h = units::require_positive("element length", options.element, "1/beta");
  units::require_between("neglected amplitude", options.neglect, 1e-15, 0.1);
  const MovingLoadShape shape = moving_load(theta, zeta);  // for the length of the frame only
  const double reach = -std::log(options.neglect);
  const double back = std::ceil(reach / decay_rate(shape.behind) / h);
  const double front = std::ceil(reach / decay_rate(shape.ahead) / h);
  units::require_between("number of elements of the moving frame", back + front, 1.0, 2e6);
  const auto loaded = static_cast<std::size_t>(back);
  const std::size_t nodes = loaded + static_cast<std::size_t>(front) + 1;
  const Matrix4d element = bending(h) - 4.0 * theta * theta * geometric(h) -
                           8.0 * zeta * theta * convection(h) + 4.0 * mass(h);
  const std::vector<double> x = solve_band(element / 8.0, nodes, 2 * loaded);
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
  // The load ends its path on a node, so that the kink of y''' lies between elements when it is measured.
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
  std::size_t twin = 0;  // the node of the fine run at the same s; its beam may be a little shorter
  for (std::size_t i = 0; i < coarse.s.size(); ++i) {
    while (twin + 1 < fine.s.size() && fine.s[twin] < coarse.s[i] - 0.25 * half.element) ++twin;
    if (std::abs(fine.s[twin] - coarse.s[i]) > 0.25 * half.element) continue;
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
