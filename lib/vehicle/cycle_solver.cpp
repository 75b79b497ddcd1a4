#include <railbook/vehicle/cycle_solver.hpp>

#include <cmath>

#include <railbook/num/dense_lu.hpp>
#include <railbook/units/constants.hpp>

namespace railbook::vehicle {

namespace {

using Matrix20 = Eigen::Matrix<double, 20, 20>;
using Row20 = Eigen::Matrix<double, 1, 20>;

constexpr double length_scale = 0.5 * units::inch, frequency_scale = 10, speed_scale = 50;

// Im <p, q> with p, q scaled.
Row20 phase_row(const Unknowns& p) {
  Row20 row = Row20::Zero();
  row.head<9>() = -p.segment<9>(9).transpose();
  row.segment<9>(9) = p.head<9>().transpose();
  return row;
}

Row20 real_row(const Unknowns& p) {
  Row20 row = Row20::Zero();
  row.head<18>() = p.head<18>().transpose();
  return row;
}

Row20 amplitude_row(const FreightCar& car, int wheelset, const Vector9c& q) {
  const Vector9& b = car.wheels[static_cast<std::size_t>(wheelset)].lateral;
  const Complex x = b.cast<Complex>().dot(q);
  Row20 row = Row20::Zero();
  row.head<9>() = length_scale * x.real() / std::abs(x) * b.transpose();
  row.segment<9>(9) = length_scale * x.imag() / std::abs(x) * b.transpose();
  return row;
}

// The first 18 rows.
Matrix20 jacobian(const QuasiLinearCar::Equations& e) {
  Matrix20 j = Matrix20::Zero();
  j.topLeftCorner<18, 18>() = length_scale * e.by_shape;
  const auto column = [&](Eigen::Index at, const Vector9c& values) {
    j.block<9, 1>(0, at) = values.real();
    j.block<9, 1>(9, at) = values.imag();
  };
  column(18, frequency_scale * e.by_frequency);
  column(19, speed_scale * e.by_speed);
  return j;
}

Unknowns solve(const Matrix20& matrix, const Unknowns& right) {
  num::DenseLu lu;
  lu.factor(matrix);
  Eigen::VectorXd x = right;
  lu.solve_in_place(x);
  return x;
}

Unknowns residual(const QuasiLinearCar::Equations& e) {
  Unknowns r = Unknowns::Zero();
  r.head<9>() = e.residual.real();
  r.segment<9>(9) = e.residual.imag();
  return r;
}

bool sound(const Unknowns& u) {
  return u.allFinite() && u[18] > 1e-6 && u[19] > 1e-6 && u.norm() < 1e6;
}

// Row 19: where on the branch the cycle is wanted.
void set_condition(const BranchCondition& pick, const QuasiLinearCar& car, const Motion& m,
                   const Unknowns& u, Matrix20& j, Unknowns& r) {
  if (pick.kind == BranchCondition::hyperplane) {
    j.row(19) = pick.normal.transpose();
    r[19] = pick.normal.dot(u) - pick.value;
  } else if (pick.kind == BranchCondition::speed) {
    j(19, 19) = 1;
    r[19] = u[19] - pick.value / speed_scale;
  } else {
    const auto size = wheelset_amplitudes(car.car(), m.shape);
    j.row(19) = amplitude_row(car.car(), pick.wheelset, m.shape) / length_scale;
    r[19] = (size[static_cast<std::size_t>(pick.wheelset)] - pick.value) / length_scale;
  }
}

}  // namespace

Unknowns scaled(const Motion& m) {
  Unknowns u;
  u << m.shape.real() / length_scale, m.shape.imag() / length_scale,
      m.lambda.imag() / frequency_scale, m.speed / speed_scale;
  return u;
}

Motion motion_of(const Unknowns& u) {
  Motion m;
  m.shape.real() = length_scale * u.head<9>();
  m.shape.imag() = length_scale * u.segment<9>(9);
  m.lambda = {0, frequency_scale * u[18]};
  m.speed = speed_scale * u[19];
  return m;
}

Solved solve_cycle(const QuasiLinearCar& car, const Unknowns& start, const Unknowns& phase,
                   const BranchCondition& pick, int most) {
  Solved result;
  Unknowns u = start;
  const Row20 turn = phase_row(phase);
  for (result.iterations = 1; result.iterations <= most; ++result.iterations) {
    const Motion m = motion_of(u);
    const auto e = car.evaluate(m, car.at(m.shape, m.lambda.imag()));
    Matrix20 j = jacobian(e);
    Unknowns r = residual(e);
    j.row(18) = turn;
    r[18] = turn * u;
    set_condition(pick, car, m, u, j, r);
    const Unknowns step = solve(j, r);
    result.update = step.norm();
    if (!step.allFinite() || !(result.update < 1e3)) return result;
    u -= step;
    if (!sound(u)) return result;
    if (result.update < 1e-10) {
      // Rest solves the equations as well.
      result.converged = u.head<18>().norm() > 1e-6 * start.head<18>().norm();
      break;
    }
  }
  result.motion = motion_of(u);
  return result;
}

Solved solve_linear(const QuasiLinearCar& car, const QuasiLinearCar::Gains& gains,
                    const Motion& start, int most) {
  Solved result;
  Motion guess = start;
  guess.shape *= length_scale / start.shape.norm();
  Unknowns u = scaled(guess);
  const Row20 turn = phase_row(u), size = real_row(u);
  const double square = u.head<18>().squaredNorm();
  double before = 1e300;
  for (result.iterations = 1; result.iterations <= most; ++result.iterations) {
    const auto e = car.evaluate(motion_of(u), gains);
    Matrix20 j = jacobian(e);
    Unknowns r = residual(e);
    j.row(18) = turn;
    r[18] = turn * u;
    j.row(19) = size;
    r[19] = size * u - square;
    const Unknowns step = solve(j, r);
    result.update = step.norm();
    if (!step.allFinite() || !(result.update < 1e3)) return result;
    u -= step;
    if (!sound(u)) return result;
    // Newton to rounding: until it stops getting better.
    result.converged =
        result.update < 1e-11 || (result.update < 1e-9 && result.update > before / 4);
    if (result.converged) break;
    before = result.update;
  }
  result.motion = motion_of(u);
  return result;
}

Unknowns tangent(const QuasiLinearCar& car, const Unknowns& at, const Unknowns& towards) {
  const Motion m = motion_of(at);
  Matrix20 j = jacobian(car.evaluate(m, car.at(m.shape, m.lambda.imag())));
  j.row(18) = phase_row(at);
  j.row(19) = towards.transpose();
  Unknowns right = Unknowns::Zero();
  right[19] = 1;
  return solve(j, right).normalized();
}

double speed_by_amplitude(const QuasiLinearCar& car, const Motion& cycle) {
  Matrix20 j = jacobian(car.evaluate(cycle, car.at(cycle.shape, cycle.lambda.imag())));
  j.row(18) = phase_row(scaled(cycle));
  j.row(19) = amplitude_row(car.car(), largest_wheelset(car.car(), cycle.shape), cycle.shape);
  Unknowns right = Unknowns::Zero();
  right[19] = 1;  // one metre of amplitude
  return speed_scale * solve(j, right)[19];
}

}  // namespace railbook::vehicle
