#include "dynamics/linear_stability.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "dynamics/cycle_solver.hpp"
#include "units/input_error.hpp"

namespace railbook::dynamics {

namespace {

using Eigen::MatrixXd;

// x' = (A + B / V) x for x = (q, q' / 10): the scale keeps both halves of one size.
constexpr double rate_scale = 10;
struct StateMatrix {
  MatrixXd constant, by_slowness;
  MatrixXd at(double slowness) const { return constant + slowness * by_slowness; }
};

StateMatrix state_matrix(const QuasiLinearCar& car, const QuasiLinearCar::Gains& gains) {
  const Eigen::PartialPivLU<Matrix9> mass{car.car().mass};
  const auto m = car.matrices(gains, 1);
  const Matrix9 creep = car.car().creep_damping;
  StateMatrix s{MatrixXd::Zero(18, 18), MatrixXd::Zero(18, 18)};
  s.constant.topRightCorner<9, 9>() = rate_scale * Matrix9::Identity();
  s.constant.bottomLeftCorner<9, 9>() = -mass.solve(m.stiffness) / rate_scale;
  s.constant.bottomRightCorner<9, 9>() = -mass.solve(m.damping - creep);
  s.by_slowness.bottomRightCorner<9, 9>() = -mass.solve(creep);
  return s;
}

// The bialternate sum: its eigenvalues are the sums of two eigenvalues of a.
MatrixXd pair_sums(const MatrixXd& a) {
  const Eigen::Index n = a.rows();
  MatrixXd b = MatrixXd::Zero(n * (n - 1) / 2, n * (n - 1) / 2);
  const auto place = [](Eigen::Index p, Eigen::Index q) { return p * (p - 1) / 2 + q; };
  // The column of e_r ^ e_s, r > s, is (A e_r) ^ e_s + e_r ^ (A e_s).
  const auto add = [&](Eigen::Index p, Eigen::Index q, Eigen::Index column, double value) {
    if (p > q) b(place(p, q), column) += value;
    if (p < q) b(place(q, p), column) -= value;
  };
  for (Eigen::Index r = 1; r < n; ++r)
    for (Eigen::Index s = 0; s < r; ++s)
      for (Eigen::Index k = 0; k < n; ++k) {
        add(k, s, place(r, s), a(k, r));
        add(r, k, place(r, s), a(k, s));
      }
  return b;
}

// Speeds at which two eigenvalues sum up to zero: Hopf points, and pairs of real eigenvalues besides.
std::vector<double> candidate_speeds(const StateMatrix& s, double low, double high) {
  const double shift = -1 / high;  // no car runs there, and no eigenvalue is expected there
  const MatrixXd pencil = pair_sums(s.at(shift)).partialPivLu().solve(pair_sums(s.by_slowness));
  const Eigen::EigenSolver<MatrixXd> solver{pencil, false};
  std::vector<double> speeds;
  for (const Complex theta : solver.eigenvalues()) {
    if (std::abs(theta) < 1e-12 * pencil.norm()) continue;
    const Complex slowness = shift - 1.0 / theta;
    if (std::abs(slowness.imag()) > 1e-4 * std::abs(slowness) || slowness.real() <= 0) continue;
    const double speed = 1 / slowness.real();
    if (speed > low * (1 - 1e-4) && speed < high * (1 + 1e-4)) speeds.push_back(speed);
  }
  return speeds;
}

}  // namespace

Vector9c scaled_to(const FreightCar& car, const Vector9c& shape, double amplitude) {
  const auto& lateral = car.wheels[static_cast<std::size_t>(largest_wheelset(car, shape))].lateral;
  Complex largest = lateral.cast<Complex>().dot(shape);
  if (std::abs(largest) < 1e-12 * shape.norm()) {
    Eigen::Index k = 0;
    shape.cwiseAbs().maxCoeff(&k);
    largest = shape[k];
  }
  return amplitude / largest * shape;
}

std::vector<Motion> modes(const QuasiLinearCar& car, const QuasiLinearCar::Gains& gains,
                          double speed) {
  units::require_positive("speed", speed, "m/s");
  const Eigen::EigenSolver<MatrixXd> solver{state_matrix(car, gains).at(1 / speed)};
  std::vector<Motion> result;
  for (Eigen::Index k = 0; k < 18; ++k) {
    const Complex lambda = solver.eigenvalues()[k];
    if (lambda.imag() < 0) continue;
    const Vector9c shape = solver.eigenvectors().col(k).head<9>();
    result.push_back({scaled_to(car.car(), shape, 1), lambda, speed});
  }
  std::sort(result.begin(), result.end(),
            [](const Motion& a, const Motion& b) { return a.lambda.real() > b.lambda.real(); });
  return result;
}

HopfSearch find_hopf(const QuasiLinearCar& car, const Motion& start) {
  const auto gains = car.small();
  Motion guess = start;
  guess.lambda = {0, start.lambda.imag()};
  const auto solved = solve_linear(car, gains, guess);
  HopfSearch search;
  search.converged = solved.converged && solved.motion.lambda.imag() > 0;
  if (!search.converged) return search;
  HopfPoint& point = search.point;
  point.motion = solved.motion;
  point.motion.shape = scaled_to(car.car(), solved.motion.shape, 1);
  point.iterations = solved.iterations;
  const Motion& m = point.motion;
  // The left null vector: one step of inverse iteration, Z being singular to rounding.
  const Matrix9c z = car.dynamic_stiffness(gains, m.lambda, m.speed);
  point.adjoint = z.adjoint().partialPivLu().solve(Vector9c::Ones());
  point.adjoint = z.adjoint().partialPivLu().solve(point.adjoint.normalized()).normalized();
  const auto e = car.evaluate(m, gains);
  point.rate_by_speed = -point.adjoint.dot(e.by_speed) / point.adjoint.dot(e.by_lambda);
  point.residual =
      e.residual.norm() / (car.matrices(gains, m.speed).stiffness.cast<Complex>() * m.shape).norm();
  return search;
}

std::vector<HopfPoint> hopf_points(const QuasiLinearCar& car, double low, double high) {
  units::require_positive("lowest speed", low, "m/s");
  units::require_between("highest speed", high, low, 1e6, "m/s");
  const auto gains = car.small();
  std::vector<HopfPoint> found;
  for (const double speed : candidate_speeds(state_matrix(car, gains), low, high)) {
    auto all = modes(car, gains, speed);
    std::erase_if(all, [](const Motion& m) { return m.lambda.imag() < 1e-6; });
    std::sort(all.begin(), all.end(), [](const Motion& a, const Motion& b) {
      return std::abs(a.lambda.real()) < std::abs(b.lambda.real());
    });
    if (all.empty()) continue;
    const auto search = find_hopf(car, all.front());
    const double at = search.point.motion.speed;
    if (!search.converged || at < low || at > high || std::abs(at - speed) > 0.01 * speed) continue;
    const bool known = std::any_of(found.begin(), found.end(), [&](const HopfPoint& other) {
      return std::abs(other.motion.speed - at) < 1e-8 * at &&
             std::abs(other.motion.lambda - search.point.motion.lambda) < 1e-8;
    });
    if (!known) found.push_back(search.point);
  }
  std::sort(found.begin(), found.end(),
            [](const HopfPoint& a, const HopfPoint& b) { return a.motion.speed < b.motion.speed; });
  return found;
}

namespace {

// p dZ/dp q by a central difference: exact to rounding, the matrices being of degree two or less in each datum
// but wheel radius and half gauge.
Vector9c change(const CarParameters& data, Suspension suspension,
                const wheelrail::ConstraintFunctions& geometry, double CarParameters::*member,
                const Motion& motion) {
  constexpr double step = 1e-4;
  const auto side = [&](double factor) -> Vector9c {
    CarParameters moved = data;
    moved.*member *= factor;
    auto table = geometry;
    table.half_spacing = 0;  // the table is kept as it is when the half gauge moves
    const QuasiLinearCar car{assemble(moved, suspension), table};
    return car.evaluate(motion, car.small()).residual;
  };
  return (side(1 + step) - side(1 - step)) / (2 * step);
}

}  // namespace

std::vector<Sensitivity> sensitivities(const QuasiLinearCar& car, Suspension suspension,
                                       const wheelrail::ConstraintFunctions& geometry,
                                       const HopfPoint& hopf) {
  const auto gains = car.small();
  const Motion& m = hopf.motion;
  const Complex by_lambda = hopf.adjoint.dot(car.evaluate(m, gains).by_lambda);
  const auto relative = [&](const Vector9c& by_datum) {
    const double growth = (-hopf.adjoint.dot(by_datum) / by_lambda).real();
    return -growth / (hopf.rate_by_speed.real() * m.speed);
  };
  std::vector<Sensitivity> result;
  for (const CarDatum& datum : car_data())
    result.push_back(
        {datum.key, relative(change(car.car().data, suspension, geometry, datum.member, m))});
  const char* const names[] = {"R-slope", "D-slope", "Phi-slope"};
  for (std::size_t f = 0; f < 3; ++f) {
    Vector9c by_slope = Vector9c::Zero();
    for (std::size_t i = 0; i < wheelsets; ++i) {
      const Wheelset& w = car.car().wheels[i];
      const Vector9& g = f == 0 ? w.g_r : f == 1 ? w.g_d : w.g_phi;
      by_slope -=
          gains.wheel[i][f].value * w.lateral.cast<Complex>().dot(m.shape) * g.cast<Complex>();
    }
    result.push_back({names[f], relative(by_slope)});
  }
  return result;
}

}  // namespace railbook::dynamics
