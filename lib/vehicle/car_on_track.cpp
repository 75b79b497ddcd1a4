#include <railbook/vehicle/car_on_track.hpp>

#include <string>

#include <railbook/units/input_error.hpp>

namespace railbook::vehicle {

namespace {

// The three tables as one law of the displacement with three values, over both signs.
cycles::PiecewiseLinear both_sides(const wheelset::ConstraintFunctions& table) {
  const auto& r = table.R.values();
  const auto& d = table.D.values();
  const auto& phi = table.Phi.values();
  if (r.size() < 2 || d.size() != r.size() || phi.size() != r.size())
    throw InputError("constraint functions: " + std::to_string(r.size()) + ", " +
                     std::to_string(d.size()) + " and " + std::to_string(phi.size()) +
                     " values; allowed: at least 2, as many of each");
  const auto n = Eigen::Index(r.size());
  Eigen::VectorXd knots(2 * n - 1);
  Eigen::MatrixXd values(3, 2 * n - 1);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto k = std::size_t(i);
    const Eigen::Vector3d f{r[k], d[k], phi[k]};
    knots[n - 1 + i] = table.R.step() * double(i);
    knots[n - 1 - i] = -knots[n - 1 + i];
    Eigen::Vector3d even = Eigen::Vector3d::Zero();
    if (!table.symmetric()) even << table.even.R[k], table.even.D[k], table.even.Phi[k];
    values.col(n - 1 - i) = even - f;
    values.col(n - 1 + i) = even + f;
  }
  return cycles::simplified({std::move(knots), std::move(values)});
}

}  // namespace

cycles::Oscillator car_on_track(const FreightCar& car, const wheelset::ConstraintFunctions& table,
                                double speed) {
  cycles::Oscillator o;
  o.mass = car.mass;
  o.damping = car.suspension_damping;
  o.damping_by_speed = car.creep_damping;
  o.stiffness = car.suspension_stiffness + car.creep_stiffness;
  const cycles::PiecewiseLinear law = both_sides(table);
  for (const Wheelset& w : car.wheels) {
    Eigen::MatrixXd force(coordinates, 3);
    force << w.g_r, w.g_d, w.g_phi;
    o.channels.push_back({w.lateral, false, std::move(force), law, table.end()});
  }
  for (const Joint& joint : car.joint)
    if (joint.friction > 0)
      o.channels.push_back(
          {joint.row, true, -joint.row, cycles::saturation(joint.friction, joint.stick)});
  return at_speed(std::move(o), speed);
}

}  // namespace railbook::vehicle
