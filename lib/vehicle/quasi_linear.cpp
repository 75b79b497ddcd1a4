#include <railbook/vehicle/quasi_linear.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

#include <railbook/units/input_error.hpp>
#include <railbook/vehicle/car_on_track.hpp>

namespace railbook::vehicle {

namespace {

PiecewiseLinearGain gains_of(const wheelset::ConstraintFunctions& geometry) {
  std::vector<double> x;
  for (std::size_t k = 0; k < geometry.R.values().size(); ++k)
    x.push_back(geometry.R.step() * static_cast<double>(k));
  const std::vector<std::vector<double>> values{geometry.R.values(), geometry.D.values(),
                                                geometry.Phi.values()};
  return {x, values};
}

Complex along(const Vector9& row, const Vector9c& q) {
  return row.cast<Complex>().dot(q);
}

Vector9 wheel_force(const Wheelset& w, double r, double d, double phi) {
  return w.g_r * r + w.g_d * d + w.g_phi * phi;
}

using Real18 = Eigen::Matrix<double, 18, 1>;
Real18 stacked(const Vector9& re, const Vector9& im) {
  Real18 both;
  both << re, im;
  return both;
}

// column * direction as seen from d|z|, z = row q: adds force z d|z| / |z| * slope.
void add_amplitude_term(Eigen::Matrix<double, 18, 18>& jacobian, const Vector9& force,
                        Complex carried, const Vector9& row, Complex z) {
  const double size = std::abs(z);
  jacobian += stacked(carried.real() * force, carried.imag() * force) *
              stacked(z.real() / size * row, z.imag() / size * row).transpose();
}

}  // namespace

std::array<double, wheelsets> wheelset_amplitudes(const FreightCar& car, const Vector9c& shape) {
  std::array<double, wheelsets> result{};
  for (std::size_t i = 0; i < wheelsets; ++i)
    result[i] = std::abs(along(car.wheels[i].lateral, shape));
  return result;
}

int largest_wheelset(const FreightCar& car, const Vector9c& shape) {
  const auto amplitude = wheelset_amplitudes(car, shape);
  return static_cast<int>(std::max_element(amplitude.begin(), amplitude.end()) - amplitude.begin());
}

QuasiLinearCar::QuasiLinearCar(FreightCar car, const wheelset::ConstraintFunctions& geometry)
    : car_(std::move(car)), table_(gains_of(geometry)) {
  if (geometry.half_spacing > 0)
    units::require_between("half spacing of the wheel/rail geometry over the car's half gauge",
                           geometry.half_spacing / car_.data.half_gauge, 1 - 1e-6, 1 + 1e-6);
  symmetric_ = geometry.symmetric();
  if (symmetric_) return;
  rest_ = cycles::rest(car_on_track(car_, geometry, 1));
  for (std::size_t i = 0; i < wheelsets; ++i) {
    const auto c = geometry.at(car_.wheels[i].lateral.dot(rest_));
    at_rest_[i] = {Gain{c.dR, 0}, Gain{c.dD, 0}, Gain{c.dPhi, 0}};
  }
}

QuasiLinearCar::Gains QuasiLinearCar::small() const {
  return at(Vector9c::Zero(), 1);
}

QuasiLinearCar::Gains QuasiLinearCar::at(const Vector9c& shape, double frequency) const {
  Gains gains{};
  gains.wheel = at_rest_;
  if (!symmetric_ && !shape.isZero(0))
    throw InputError("describing functions: left and right differ; allowed: odd functions only");
  for (std::size_t i = 0; symmetric_ && i < wheelsets; ++i)
    table_.evaluate(std::abs(along(car_.wheels[i].lateral, shape)), gains.wheel[i]);
  if (car_.has_friction)
    for (std::size_t j = 0; j < joints; ++j) {
      const Joint& joint = car_.joint[j];
      gains.joint[j] = regularized_friction(joint.friction, joint.stick,
                                            frequency * std::abs(along(joint.row, shape)));
    }
  return gains;
}

QuasiLinearCar::Matrices QuasiLinearCar::matrices(const Gains& gains, double speed) const {
  Matrices m{car_.suspension_stiffness + car_.creep_stiffness,
             car_.suspension_damping + car_.creep_damping / speed};
  for (std::size_t i = 0; i < wheelsets; ++i) {
    const auto& n = gains.wheel[i];
    m.stiffness -= wheel_force(car_.wheels[i], n[0].value, n[1].value, n[2].value) *
                   car_.wheels[i].lateral.transpose();
  }
  if (car_.has_friction)
    for (std::size_t j = 0; j < joints; ++j)
      m.damping += gains.joint[j].value * car_.joint[j].row * car_.joint[j].row.transpose();
  return m;
}

Matrix9c QuasiLinearCar::dynamic_stiffness(const Gains& gains, Complex lambda, double speed) const {
  const Matrices m = matrices(gains, speed);
  return m.stiffness.cast<Complex>() + lambda * m.damping.cast<Complex>() +
         lambda * lambda * car_.mass.cast<Complex>();
}

QuasiLinearCar::Equations QuasiLinearCar::evaluate(const Motion& motion, const Gains& gains) const {
  const auto& [q, lambda, speed] = motion;
  const Matrices m = matrices(gains, speed);
  const Matrix9c z = m.stiffness.cast<Complex>() + lambda * m.damping.cast<Complex>() +
                     lambda * lambda * car_.mass.cast<Complex>();
  Equations e;
  e.residual = z * q;
  e.by_lambda = (m.damping.cast<Complex>() + 2.0 * lambda * car_.mass.cast<Complex>()) * q;
  e.by_frequency = Complex{0, 1} * e.by_lambda;
  e.by_speed = (-lambda / (speed * speed)) * (car_.creep_damping.cast<Complex>() * q);
  e.by_shape << z.real(), -z.imag(), z.imag(), z.real();
  for (std::size_t i = 0; i < wheelsets; ++i) {
    const auto& n = gains.wheel[i];
    if (n[0].slope == 0 && n[1].slope == 0 && n[2].slope == 0) continue;
    const Wheelset& w = car_.wheels[i];
    const Complex x = along(w.lateral, q);
    add_amplitude_term(e.by_shape, -wheel_force(w, n[0].slope, n[1].slope, n[2].slope), x,
                       w.lateral, x);
  }
  for (std::size_t j = 0; j < joints; ++j) {
    const Gain& n = gains.joint[j];
    if (n.slope == 0) continue;
    const Vector9& row = car_.joint[j].row;
    const Complex x = along(row, q);
    const double frequency = lambda.imag();
    add_amplitude_term(e.by_shape, n.slope * frequency * row, lambda * x, row, x);
    e.by_frequency += (n.slope * std::abs(x) * lambda * x) * row.cast<Complex>();
  }
  return e;
}

}  // namespace railbook::vehicle
