// Quasi-linear cars at random, and their eigenvalues in 80 bits from the car put together body by
// body.
#pragma once

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <complex>

#include <railbook/vehicle/quasi_linear.hpp>
#include <railbook/wheelset/paper_pairs.hpp>

#include "support/body_by_body.hpp"
#include "support/claim.hpp"

namespace railbook::tests {

using namespace railbook::vehicle;

using LongComplex = std::complex<Long>;
using Gains = QuasiLinearCar::Gains;

// Forces by unit motions. Frictions, which have a gain each, are added by their joints' rows.
inline Matrix9 probed(const QuasiLinearCar& car, const Gains& gains, double speed, bool rates) {
  const FreightCar& c = car.car();
  const CarParameters& p = c.data;
  const Dampers none{}, all = equivalent_dampers(p);
  Matrix9 result;
  for (int j = 0; j < 9; ++j) {
    const Vector9 zero = Vector9::Zero(), unit = Vector9::Unit(j), &q = rates ? zero : unit,
                  &v = rates ? unit : zero;
    for (int i = 0; i < 9; ++i) {
      const Vector9 w = Vector9::Unit(i);
      double power = body_by_body::suspension_power(p, c.has_friction ? none : all, false, q, v, w);
      for (std::size_t n = 0; n < wheelsets; ++n) {
        const bool rear = n >= 2, trailing = n % 2 == 1;
        const auto at = body_by_body::axle(p, q, rear, trailing);
        const double r = gains.wheel[n][0].value * at.x, d = gains.wheel[n][1].value * at.x,
                     roll = gains.wheel[n][2].value * at.x;
        power += body_by_body::contact_power(
            p, speed,
            {p.wheel_radius + p.half_gauge * r, p.wheel_radius - p.half_gauge * r, d, -d, roll}, at,
            body_by_body::axle(p, v, rear, trailing), body_by_body::axle(p, w, rear, trailing));
      }
      for (std::size_t n = 0; c.has_friction && n < joints; ++n)
        power -= gains.joint[n].value * c.joint[n].row.dot(v) * c.joint[n].row.dot(w);
      result(i, j) = -power;
    }
  }
  return result;
}

using LongMatrix = Eigen::Matrix<Long, 18, 18>;
inline Eigen::Matrix<LongComplex, 18, 1> eigenvalues_of(const QuasiLinearCar& car,
                                                        const Gains& gains, double speed) {
  Matrix9 mass;
  for (int i = 0; i < 9; ++i)
    for (int j = 0; j < 9; ++j) {
      const Vector9 u = Vector9::Unit(i), v = Vector9::Unit(j);
      mass(i, j) = kinetic_energy(car.car().data, u + v) - kinetic_energy(car.car().data, u) -
                   kinetic_energy(car.car().data, v);
    }
  using Long9 = Eigen::Matrix<Long, 9, 9>;
  const Eigen::PartialPivLU<Long9> lu{mass.cast<Long>()};
  LongMatrix a = LongMatrix::Zero();
  a.topRightCorner<9, 9>() = 10 * Long9::Identity();
  a.bottomLeftCorner<9, 9>() = -lu.solve(probed(car, gains, speed, false).cast<Long>()) / 10;
  a.bottomRightCorner<9, 9>() = -lu.solve(probed(car, gains, speed, true).cast<Long>());
  return Eigen::EigenSolver<LongMatrix>(a, false).eigenvalues();
}

inline double nearest(const Eigen::Matrix<LongComplex, 18, 1>& all, Complex lambda) {
  const LongComplex wanted{lambda.real(), lambda.imag()};
  Long best = 1e30L;
  for (const LongComplex& other : all) best = std::min(best, std::abs(other - wanted));
  return static_cast<double>(best);
}

inline CarParameters random_car(RandomStream& draw) {
  CarParameters car;
  for (const CarDatum& datum : car_data()) car.*datum.member *= draw.decades(0.5, 2);
  car.half_gauge = CarParameters{}.half_gauge;  // the tables', too
  return car;
}
inline QuasiLinearCar random_quasi(RandomStream& draw, bool friction) {
  const auto& table = draw(0, 3) < 1   ? wheelset::new_wheel_table()
                      : draw(0, 2) < 1 ? wheelset::cn_table()
                                       : wheelset::heumann_table();
  return {assemble(random_car(draw), friction ? Suspension::friction : Suspension::dampers), table};
}

// How far a motion is from being undamped with these gains, or those of its amplitude: the nearest
// eigenvalue, relative.
inline double off_axis(const QuasiLinearCar& car, const Gains& gains, const Motion& m) {
  return nearest(eigenvalues_of(car, gains, m.speed), m.lambda) / m.lambda.imag();
}
inline double off_axis(const QuasiLinearCar& car, const Motion& m) {
  return off_axis(car, car.at(m.shape, m.lambda.imag()), m);
}
// Eigenvalues of oscillations that grow.
inline int growing(const QuasiLinearCar& car, double speed) {
  int count = 0;
  for (const LongComplex& lambda : eigenvalues_of(car, car.small(), speed))
    count += lambda.real() > 0 && std::abs(lambda.imag()) > 1e-6L;
  return count;
}

}  // namespace railbook::tests
