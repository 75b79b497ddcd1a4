#include <railbook/cycles/oscillator.hpp>

#include <string>

#include <railbook/num/dense_lu.hpp>
#include <railbook/num/eigenvalues.hpp>
#include <railbook/num/product.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::cycles {

namespace {

Eigen::MatrixXd padded_matrix(const Eigen::MatrixXd& m, bool unit_beyond) {
  const Eigen::Index n = m.rows();
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(most_coordinates, most_coordinates);
  if (unit_beyond) result.setIdentity();
  result.topLeftCorner(n, n) = m;
  return result;
}

// A law's forces at s and, row by row, their slopes.
struct Force {
  Eigen::VectorXd value;
  Eigen::MatrixXd slope;
};
Force force_and_slope(const std::function<void(const double*, double*, double*)>& law,
                      const Eigen::VectorXd& s, Eigen::Index outputs) {
  Force f{Eigen::VectorXd(outputs), Eigen::MatrixXd(s.size(), outputs)};
  law(s.data(), f.value.data(), f.slope.data());
  f.slope.transposeInPlace();
  return f;
}

void require_shape(const Oscillator& o) {
  const Eigen::Index n = o.mass.rows();
  const auto fits = [n](const Eigen::MatrixXd& m) { return m.rows() == n && m.cols() == n; };
  bool good = n >= 1 && n <= most_coordinates && fits(o.mass) && fits(o.damping) &&
              fits(o.damping_by_speed) && fits(o.stiffness);
  for (const Channel& c : o.channels)
    good = good && c.row.size() == n && c.force.rows() == n && c.law.pieces() > 0 &&
           c.force.cols() == c.law.outputs();
  for (const Coupling& c : o.couplings) {
    const auto wide = [&c, n](const Eigen::MatrixXd& m) {
      return m.rows() == c.inputs() && m.cols() == n;
    };
    good = good && wide(c.of_motion) && wide(c.of_rate) && wide(c.of_rate_by_speed) &&
           c.force.rows() == n && c.law;
  }
  if (!good)
    throw InputError("oscillator of " + std::to_string(n) +
                     " coordinates: its matrices, rows and forces do not fit; allowed: 1 to 9");
}

}  // namespace

Oscillator at_speed(Oscillator oscillator, double speed) {
  oscillator.inverse_speed = 1 / units::require_positive("speed", speed, "m/s");
  return oscillator;
}

Eigen::VectorXd rest(const Oscillator& o) {
  const Eigen::Index n = o.coordinates();
  Eigen::VectorXd q = Eigen::VectorXd::Zero(n);
  Eigen::MatrixXd jacobian(n, n);
  // Forces left over at q, and how they change.
  const auto forces = [&](const Eigen::VectorXd& at) {
    Eigen::VectorXd left = -o.stiffness * at;
    jacobian = o.stiffness;
    for (const Channel& c : o.channels) {
      const double s = c.of_rate ? 0.0 : c.row.dot(at);
      left += c.force * c.law(s);
      if (!c.of_rate) jacobian -= c.force * c.law.slopes().col(c.law.piece(s)) * c.row.transpose();
    }
    for (const Coupling& c : o.couplings) {
      const Force f = force_and_slope(c.law, c.of_motion * at, c.outputs());
      left += c.force * f.value;
      jacobian -= num::product(num::product(c.force, f.slope), c.of_motion);
    }
    return left;
  };
  Eigen::VectorXd left = forces(q);
  if (left.norm() == 0) return q;
  num::DenseLu lu;
  const auto newton = [&lu](Eigen::VectorXd b) {
    lu.solve_in_place(b);
    return b;
  };
  for (int i = 0; i < 100; ++i) {
    lu.factor(jacobian);
    const Eigen::VectorXd step = newton(left);
    if (lu.least_pivot() < 1e-15 * double(n) || !step.allFinite()) break;
    if (step.norm() < 1e-13 * (1e-3 + q.norm())) return q + step;
    // Shorter until the same matrix has a shorter step to go: kinks are passed so.
    double part = 1;
    for (int k = 0; k < 12; ++k, part *= 0.5)
      if (newton(forces(q + part * step)).norm() < (1 - 0.25 * part) * step.norm()) break;
    q += part * step;
    left = forces(q);
  }
  throw InputError(
      "wheels or rails of left and right differ so that the car finds no position of rest on them; "
      "allowed: a difference of rolling radii that the wheels' cones can make up");
}

Compiled compile(const Oscillator& o) {
  require_shape(o);
  const Eigen::MatrixXd mass = padded_matrix(o.mass, true);
  if (!mass.allFinite() || !(num::symmetric_eigenvalues(mass)[0] > 0))
    throw InputError("mass matrix: not positive definite");
  const Eigen::Index n = o.coordinates();
  Compiled result;
  result.linear.leftCols<9>() = -num::solved(mass, padded_matrix(o.stiffness, false));
  result.linear.rightCols<9>() =
      -num::solved(mass, padded_matrix(o.damping + o.inverse_speed * o.damping_by_speed, false));
  for (const Channel& c : o.channels) {
    CompiledChannel out;
    out.row.setZero();
    out.row.head(n) = c.row;
    out.of_rate = c.of_rate;
    out.law = c.law;
    out.limit = c.limit;
    Eigen::MatrixXd force = Eigen::MatrixXd::Zero(most_coordinates, c.force.cols());
    force.topRows(n) = c.force;
    const Eigen::MatrixXd response = num::solved(mass, force);
    out.slope = num::product(response, c.law.slopes());
    out.constant = num::product(response, c.law.values().leftCols(c.law.pieces()));
    for (Eigen::Index i = 0; i < c.law.pieces(); ++i)
      out.constant.col(i) -= c.law.knots()[i] * out.slope.col(i);
    result.channels.push_back(std::move(out));
  }
  for (const Coupling& c : o.couplings) {
    CompiledCoupling out;
    out.rows = Eigen::MatrixXd::Zero(c.inputs(), Eigen::Index{2} * most_coordinates);
    out.rows.leftCols(n) = c.of_motion;
    out.rows.middleCols(most_coordinates, n) = c.of_rate + o.inverse_speed * c.of_rate_by_speed;
    Eigen::MatrixXd force = Eigen::MatrixXd::Zero(most_coordinates, c.outputs());
    force.topRows(n) = c.force;
    out.response = num::solved(mass, force);
    out.law = c.law;
    result.couplings.push_back(std::move(out));
  }
  return result;
}

void Compiled::rate(const State& y, State& dy) const {
  dy.head<9>() = y.tail<9>();
  dy.tail<9>().noalias() = linear * y;
  for (const CompiledChannel& c : channels) {
    const double s = scalar(c, y);
    const Eigen::Index i = c.law.piece(s);
    dy.tail<9>() += c.constant.col(i) + s * c.slope.col(i);
  }
  for (const CompiledCoupling& c : couplings) {
    const Eigen::VectorXd s = c.rows * y;
    Eigen::VectorXd f(c.response.cols());
    c.law(s.data(), f.data(), nullptr);
    dy.tail<9>() += c.response * f;
  }
}

void Compiled::jacobian(const State& y, StateMatrix& J) const {
  J.setZero();
  J.topRightCorner<9, 9>().setIdentity();
  J.bottomRows<9>() = linear;
  for (const CompiledChannel& c : channels)
    J.block<9, 9>(9, c.of_rate ? 9 : 0) +=
        c.slope.col(c.law.piece(scalar(c, y))) * c.row.transpose();
  for (const CompiledCoupling& c : couplings) {
    const Force f = force_and_slope(c.law, c.rows * y, c.response.cols());
    J.bottomRows<9>() += num::product(num::product(c.response, f.slope), c.rows);
  }
}

State padded(const Eigen::VectorXd& y) {
  const Eigen::Index n = y.size() / 2;
  if (y.size() % 2 != 0 || n < 1 || n > most_coordinates)
    throw InputError("state of " + std::to_string(y.size()) +
                     " numbers; allowed: an even count from 2 to 18");
  State result = State::Zero();
  result.head(n) = y.head(n);
  result.segment(9, n) = y.tail(n);
  return result;
}

Eigen::VectorXd unpadded(const State& y, Eigen::Index n) {
  Eigen::VectorXd result(2 * n);
  result << y.head(n), y.segment(9, n);
  return result;
}

}  // namespace railbook::cycles
