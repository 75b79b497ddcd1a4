#include <railbook/spectra/joint_dips.hpp>

#include <cmath>

#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::spectra {
namespace {

void require_joints(const JointDips& joints) {
  units::require_positive("rail length", joints.rail_length, "m");
  units::require_finite("dip", joints.dip, "m");
  units::require_non_negative("scatter of the dips", joints.scatter);
  units::require_between("correlation of neighbouring joints", joints.correlation, -0.9999, 0.9999);
}

}  // namespace

double dip_shape(double u) {
  if (std::abs(u) > 0.5) return 0.0;
  if (std::abs(u) < 0.25) return 1.0 - std::sin(units::pi * std::abs(u));
  const double s = std::sin(0.5 * units::pi * (0.5 - std::abs(u)));  // next to the crest
  return 2.0 * s * s;
}

double dip_transform(double nu) {
  const double t = units::pi * std::abs(nu);
  const double box = t < 1e-8 ? 1.0 : std::sin(t) / t;
  // |sin| over the rail: (1 + sin t)/(a + b) + (1 - sin t)/(a - b) with a = pi, b = 2 t; 0/0 at b =
  // a.
  const double gap = units::pi - 2.0 * t;
  const double s = std::sin(0.25 * gap);
  const double last = std::abs(gap) < 1e-8 ? 0.0 : 2.0 * s * s / gap;
  return box - (1.0 + std::sin(t)) / (units::pi + 2.0 * t) - last;
}

double joint_scatter_psd(const JointDips& joints, double phi) {
  require_joints(joints);
  units::require_positive("wavenumber", phi, "cycle/m");
  const double nu = phi * joints.rail_length;
  const double rho = joints.correlation;
  const double lift = joints.scatter * joints.dip * dip_transform(nu);
  // The denominator 1 - 2 rho cos(2 pi nu) + rho^2, which cancels at the lines of joints that
  // hardly differ.
  const double s = std::sin(units::pi * std::remainder(nu, 1.0));
  const double memory = (1.0 - rho) * (1.0 + rho) / ((1.0 - rho) * (1.0 - rho) + 4.0 * rho * s * s);
  return 2.0 * lift * lift * joints.rail_length * memory;
}

JointSequence::JointSequence(const JointDips& joints, double spacing,
                             const num::RandomSource& source)
    : joints_(joints), spacing_(spacing), source_(source) {
  require_joints(joints);
  units::require_positive("spacing", spacing, "m");
  units::require_between("rail length", joints.rail_length, 2.0 * spacing, units::infinity, "m");
  deviation_ = joints_.scatter > 0 ? source_.normal(0) : 0.0;
  depth_ = joints_.dip * (1.0 + joints_.scatter * deviation_);
}

void JointSequence::next_joint() {
  ++joint_;
  if (joints_.scatter == 0) return;
  const double rho = joints_.correlation;
  deviation_ = rho * deviation_ + std::sqrt(1.0 - rho * rho) * source_.normal(joint_);
  depth_ = joints_.dip * (1.0 + joints_.scatter * deviation_);
}

void JointSequence::add(std::span<double> z) {
  for (double& value : z) {
    const double rails = static_cast<double>(sample_++) * spacing_ / joints_.rail_length;
    while (rails - static_cast<double>(joint_) > 0.5) next_joint();
    value -= depth_ * dip_shape(rails - static_cast<double>(joint_));
  }
}

}  // namespace railbook::spectra
