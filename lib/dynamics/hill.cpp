#include "dynamics/hill.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "num/eigenvalues.hpp"

namespace railbook::dynamics {

namespace {

using Matrix18 = Eigen::Matrix<double, 18, 18>;

// What multiplies s: 2 i omega M + C, and the friction that a change of rate's amplitude brings.
Matrix18 rate_matrix(const QuasiLinearCar& car, const Motion& cycle,
                     const QuasiLinearCar::Gains& gains) {
  const Matrix9 damping = car.matrices(gains, cycle.speed).damping;
  const Matrix9 turning = 2 * cycle.lambda.imag() * car.car().mass;
  Matrix18 c;
  c << damping, -turning, turning, damping;
  for (std::size_t j = 0; j < joints; ++j) {
    if (gains.joint[j].slope == 0) continue;
    const Vector9& row = car.car().joint[j].row;
    const Complex rate = cycle.lambda * row.cast<Complex>().dot(cycle.shape);
    Eigen::Matrix<double, 18, 1> along;
    along << rate.real() * row, rate.imag() * row;
    c += gains.joint[j].slope / std::abs(rate) * along * along.transpose();
  }
  return c;
}

}  // namespace

std::vector<Complex> hill_exponents(const QuasiLinearCar& car, const Motion& cycle) {
  const auto gains = car.at(cycle.shape, cycle.lambda.imag());
  Matrix18 mass = Matrix18::Zero();
  mass.topLeftCorner<9, 9>() = mass.bottomRightCorner<9, 9>() = car.car().mass;
  const Eigen::PartialPivLU<Eigen::MatrixXd> lu{mass};
  constexpr double rate_scale = 10;  // the state is (p, p' / 10)
  Eigen::MatrixXd state = Eigen::MatrixXd::Zero(36, 36);
  state.topRightCorner<18, 18>() = rate_scale * Matrix18::Identity();
  state.bottomLeftCorner<18, 18>() =
      -lu.solve(Eigen::MatrixXd(car.evaluate(cycle, gains).by_shape)) / rate_scale;
  state.bottomRightCorner<18, 18>() = -lu.solve(Eigen::MatrixXd(rate_matrix(car, cycle, gains)));
  const Eigen::VectorXcd found = num::eigenvalues(state);
  std::vector<Complex> exponents{found.begin(), found.end()};
  std::sort(exponents.begin(), exponents.end(),
            [](Complex a, Complex b) { return a.real() > b.real(); });
  return exponents;
}

Complex leading_exponent(const QuasiLinearCar& car, const Motion& cycle) {
  auto all = hill_exponents(car, cycle);
  all.erase(std::min_element(all.begin(), all.end(),
                             [](Complex a, Complex b) { return std::norm(a) < std::norm(b); }));
  return all.front();
}

}  // namespace railbook::dynamics
