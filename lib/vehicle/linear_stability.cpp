#include <railbook/vehicle/linear_stability.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <railbook/num/dense_lu.hpp>
#include <railbook/num/eigenvalues.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/vehicle/cycle_solver.hpp>

namespace railbook::vehicle {

namespace {

using Eigen::MatrixXd;

// x' = (A + B / V) x for x = (q, q' / 10): the scale keeps both halves of one size.
constexpr double rate_scale = 10;
// The smallest pivot over the largest at which a pencil still has digits.
constexpr double least_pivot = 1e-13;
constexpr double most_rounding = 1e-3;  // 1/s, of growth rates
struct SpeedPencil {
  MatrixXd constant, by_slowness;
  MatrixXd at(double slowness) const { return constant + slowness * by_slowness; }
};

SpeedPencil speed_pencil(const QuasiLinearCar& car, const QuasiLinearCar::Gains& gains) {
  const Matrix9& mass = car.car().mass;
  const auto m = car.matrices(gains, 1);
  const Matrix9 creep = car.car().creep_damping;
  SpeedPencil s{MatrixXd::Zero(18, 18), MatrixXd::Zero(18, 18)};
  s.constant.topRightCorner<9, 9>() = rate_scale * Matrix9::Identity();
  s.constant.bottomLeftCorner<9, 9>() = -num::solved(mass, m.stiffness) / rate_scale;
  s.constant.bottomRightCorner<9, 9>() = -num::solved(mass, m.damping - creep);
  s.by_slowness.bottomRightCorner<9, 9>() = -num::solved(mass, creep);
  return s;
}

// What rounding moves simple eigenvalues by.
double rounding_of(const MatrixXd& a) {
  return double(a.rows()) * std::numeric_limits<double>::epsilon() * a.norm();
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

// Speeds at which two eigenvalues sum up to zero: Hopf points, and pairs of real eigenvalues
// besides. Nothing when the pencil is singular to rounding: two motions that nothing holds back
// have eigenvalues zero at every speed, joints that hardly slip leave no digits to the others.
std::optional<std::vector<double>> paired_speeds(const SpeedPencil& s, double low, double high) {
  const double shift = -1 / high;  // no car runs there, and no eigenvalue is expected there
  num::DenseLu lu;
  lu.factor(pair_sums(s.at(shift)));
  if (!(lu.least_pivot() > least_pivot)) return std::nullopt;
  // Pairs of motions that no creep damps have nothing but zeros in their columns, and no speed.
  const MatrixXd by_slowness = pair_sums(s.by_slowness);
  std::vector<Eigen::Index> damped;
  for (Eigen::Index k = 0; k < by_slowness.cols(); ++k)
    if (!by_slowness.col(k).isZero(0)) damped.push_back(k);
  const MatrixXd pencil = lu.solve(by_slowness(Eigen::all, damped))(damped, Eigen::all);
  std::vector<double> speeds;
  for (const Complex theta : num::eigenvalues(pencil)) {
    if (std::abs(theta) < 1e-12 * pencil.norm()) continue;
    const Complex slowness = shift - 1.0 / theta;
    if (std::abs(slowness.imag()) > 1e-4 * std::abs(slowness) || slowness.real() <= 0) continue;
    const double speed = 1 / slowness.real();
    if (speed > low * (1 - 1e-4) && speed < high * (1 + 1e-4)) speeds.push_back(speed);
  }
  return speeds;
}

// The same by counting the oscillations that grow, at speeds 1 % apart: two that begin and end
// within a step are missed.
class Scan {
 public:
  explicit Scan(const SpeedPencil& s) : state_(s) {}
  std::vector<double> speeds(double low, double high) {
    const int steps = 1 + int(std::log(high / low) / 0.01);
    const double ratio = std::pow(high / low, 1.0 / steps);
    double from = low;
    int before = growing(from);
    for (int k = 1; k <= steps; ++k) {
      const double to = low * std::pow(ratio, k);
      const int now = growing(to);
      halve(from, before, to, now);
      from = to;
      before = now;
    }
    return std::move(found_);
  }

 private:
  int growing(double speed) const {
    const MatrixXd state = state_.at(1 / speed);
    const double least = std::max(1e-4, 10 * rounding_of(state));
    int count = 0;
    for (const Complex lambda : num::eigenvalues(state))
      count += lambda.real() > 0 && lambda.imag() > least;
    return count;
  }
  void halve(double from, int before, double to, int now) {
    if (before == now) return;
    if (to - from < 1e-7 * to) {
      found_.push_back(to);
      return;
    }
    const double middle = 0.5 * (from + to);
    const int between = growing(middle);
    halve(from, before, middle, between);
    halve(middle, between, to, now);
  }

  const SpeedPencil& state_;
  std::vector<double> found_;
};

std::vector<double> candidate_speeds(const SpeedPencil& s, double low, double high) {
  if (auto speeds = paired_speeds(s, low, high)) return *speeds;
  return Scan{s}.speeds(low, high);
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
  const auto [values, vectors] = num::eigenpairs(speed_pencil(car, gains).at(1 / speed));
  std::vector<Motion> result;
  for (Eigen::Index k = 0; k < 18; ++k) {
    const Complex lambda = values[k];
    if (lambda.imag() < 0) continue;
    const Vector9c shape = vectors.col(k).head<9>();
    result.push_back({scaled_to(car.car(), shape, 1), lambda, speed});
  }
  std::sort(result.begin(), result.end(),
            [](const Motion& a, const Motion& b) { return a.lambda.real() > b.lambda.real(); });
  return result;
}

double growth_rounding(const QuasiLinearCar& car, const Motion& mode) {
  const double rounding = rounding_of(speed_pencil(car, car.small()).at(1 / mode.speed));
  // A double zero is split by the square root of what the matrix is changed by.
  const double split = std::sqrt(rounding * rate_scale);
  return std::abs(mode.lambda) < split ? std::max(rounding, split) : rounding;
}

namespace {

// A motion at which Z is singular, completed.
HopfPoint hopf_at(const QuasiLinearCar& car, const Motion& motion, int iterations) {
  const auto gains = car.small();
  HopfPoint point;
  point.motion = motion;
  point.motion.shape = scaled_to(car.car(), motion.shape, 1);
  point.iterations = iterations;
  const Motion& m = point.motion;
  // The left null vector: one step of inverse iteration, Z being singular to rounding.
  const Matrix9c z = car.dynamic_stiffness(gains, m.lambda, m.speed);
  point.adjoint = num::solved(z.adjoint(), Vector9c::Ones());
  point.adjoint = num::solved(z.adjoint(), point.adjoint.normalized()).normalized();
  const auto e = car.evaluate(m, gains);
  point.rate_by_speed = -point.adjoint.dot(e.by_speed) / point.adjoint.dot(e.by_lambda);
  point.residual =
      e.residual.norm() / (car.matrices(gains, m.speed).stiffness.cast<Complex>() * m.shape).norm();
  return point;
}

// The same where Newton's equations are singular, as for two trucks that hunt alike and apart, or
// short of digits: the speed at which the growth rate vanishes, by the secant rule, as well as
// rounding lets it.
HopfSearch find_by_growth(const QuasiLinearCar& car, const Motion& start) {
  const auto gains = car.small();
  const auto mode_at = [&](double speed) {
    const auto all = modes(car, gains, speed);
    return *std::min_element(all.begin(), all.end(), [&](const Motion& a, const Motion& b) {
      return std::abs(a.lambda - start.lambda) < std::abs(b.lambda - start.lambda);
    });
  };
  HopfSearch search;
  Motion before = mode_at(start.speed * (1 + 1e-6)), now = mode_at(start.speed);
  for (int i = 1; i <= 20; ++i) {
    if (std::abs(now.lambda.real()) < growth_rounding(car, now)) {
      now.lambda = {0, now.lambda.imag()};
      search.converged = now.lambda.imag() > 0;
      if (search.converged) search.point = hopf_at(car, now, i);
      return search;
    }
    const double change = now.lambda.real() - before.lambda.real();
    if (change == 0) return search;
    const double speed = now.speed - now.lambda.real() * (now.speed - before.speed) / change;
    if (!(std::abs(speed / start.speed - 1) < 0.01)) return search;
    before = now;
    now = mode_at(speed);
  }
  return search;
}

}  // namespace

HopfSearch find_hopf(const QuasiLinearCar& car, const Motion& start) {
  Motion guess = start;
  guess.lambda = {0, start.lambda.imag()};
  const auto solved = solve_linear(car, car.small(), guess);
  if (!solved.converged || !(solved.motion.lambda.imag() > 0)) return find_by_growth(car, start);
  return {hopf_at(car, solved.motion, solved.iterations), true};
}

std::vector<HopfPoint> hopf_points(const QuasiLinearCar& car, double low, double high) {
  units::require_positive("lowest speed", low, "m/s");
  units::require_between("highest speed", high, low, 1e6, "m/s");
  const auto gains = car.small();
  const SpeedPencil state = speed_pencil(car, gains);
  if (const double rounding = rounding_of(state.constant); rounding > most_rounding)
    throw InputError(
        fmt::format("joints of the linear car are so stiff that rounding moves its growth rates by "
                    "{:.1g} 1/s; allowed: up to "
                    "{:g} 1/s (a larger sticking speed or rate, or smaller dampers and springs)",
                    rounding, most_rounding));
  std::vector<HopfPoint> found;
  for (const double speed : candidate_speeds(state, low, high)) {
    auto all = modes(car, gains, speed);
    const double least = std::max(1e-6, 10 * rounding_of(state.at(1 / speed)));
    std::erase_if(all, [&](const Motion& m) { return m.lambda.imag() < least; });
    std::sort(all.begin(), all.end(), [](const Motion& a, const Motion& b) {
      return std::abs(a.lambda.real()) < std::abs(b.lambda.real());
    });
    // If the nearest is known, the next: of two that cross at one speed either may be the nearer.
    for (std::size_t k = 0; k < std::min<std::size_t>(2, all.size()); ++k) {
      const auto search = find_hopf(car, all[k]);
      const double at = search.point.motion.speed;
      if (!search.converged || at < low || at > high || std::abs(at - speed) > 0.01 * speed) break;
      const bool known = std::any_of(found.begin(), found.end(), [&](const HopfPoint& other) {
        return std::abs(other.motion.speed - at) < 1e-8 * at &&
               std::abs(other.motion.lambda - search.point.motion.lambda) < 1e-8;
      });
      if (known) continue;
      found.push_back(search.point);
      break;
    }
  }
  std::sort(found.begin(), found.end(),
            [](const HopfPoint& a, const HopfPoint& b) { return a.motion.speed < b.motion.speed; });
  return found;
}

}  // namespace railbook::vehicle
