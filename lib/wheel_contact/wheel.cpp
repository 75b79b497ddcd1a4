#include <railbook/wheel_contact/wheel.hpp>

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/wheel_contact/detail/full_wheel.hpp>
#include <railbook/wheel_contact/detail/wheel_solver.hpp>

namespace railbook::wheel_contact {

using Eigen::Vector3d;

double Friction::at(double slip_speed, double angle) const {
  constexpr double tread_to = 20 * units::degree, flange_from = 40 * units::degree;
  const double share = std::clamp((angle - tread_to) / (flange_from - tread_to), 0.0, 1.0);
  const double dry = std::lerp(coefficient, flange.value_or(coefficient), share);
  return dry * (high_speed_share + (1 - high_speed_share) * std::exp(-slip_speed / speed));
}

namespace {

void check(const ProfilePair& pair, const Pose& pose, const WheelInput& input) {
  using namespace units;
  require_between("shift", pose.y, -0.05, 0.05, "m");
  require_between("yaw", pose.yaw, -0.1, 0.1, "rad");
  require_between("roll", pose.roll, -0.1, 0.1, "rad");
  require_positive("load", input.load, "N");
  require_positive("speed", input.speed, "m/s");
  require_finite("angular velocity", input.angular_velocity, "rad/s");
  require_between("friction", input.friction.coefficient, 0, 2);
  require_between("friction of the flange", input.friction.flange.value_or(0), 0, 2);
  require_between("friction's share at high speed", input.friction.high_speed_share, 0, 1);
  require_positive("friction's speed", input.friction.speed, "m/s");
  require_positive("wheel radius", pair.radius, "m");
  require_between("cells along", static_cast<double>(input.along), 8, 512);
  require_between("cells across", static_cast<double>(input.across), 8, 512);
}

// All patches at a depth by an approximate method, with frames made at the depth `frames`;
// `continuous` as semi_hertzian().
std::vector<PatchResult> approximate(const Work& w, double z, double frames, bool friction,
                                     bool continuous, bool keep = false) {
  std::vector<PatchResult> all;
  const double modulus = w.material.effective_modulus;
  for (Patch& patch : patches(w.wheel, w.touch, frames, w.input.patches)) {
    const double down = (z - frames) * std::cos(patch.frame.angle);
    PatchResult p;
    p.strips = w.input.method == Method::hertz ? hertzian(patch, modulus, down)
                                               : semi_hertzian(patch, modulus, down, continuous);
    if (p.strips.strips.empty()) continue;
    p.patch = std::move(patch);
    p.load = p.strips.load, p.approach = p.strips.approach;
    p.p_max = p.strips.p_max, p.area = p.strips.area;
    if (friction) p.forces = fastsim(p.strips, case_of(w, p, z), keep);
    all.push_back(std::move(p));
  }
  return all;
}

constexpr double deepest_sinking = 2e-3;  // m: half-spaces that sink in by millimetres are none

// The root of a growing function near `guess`, where it grows like a power 3/2 of the distance from
// `zero`: f gives force over load.
struct Depths {
  double z = 0;
  bool converged = false, too_deep = false;  // too_deep: the deepest place bears less
};
Depths find_depth(const std::function<double(double)>& share, double zero, double guess,
                  double tolerance) {
  const double deepest = zero + deepest_sinking;
  double low = zero, high = units::infinity, z = std::min(guess, deepest);
  for (int k = 0; k < 60; ++k) {
    const double f = share(z);
    if (std::abs(f - 1) < tolerance) return {z, true};
    if (f < 1 && z == deepest) return {z, false, true};
    (f < 1 ? low : high) = z;
    double next = f > 1e-3 ? zero + (z - zero) * std::pow(f, -2.0 / 3) : zero + 4 * (z - zero);
    if (k % 4 == 3 && std::isfinite(high)) next = 0.5 * (low + high);
    if (!(next > low && next < high))
      next = std::isfinite(high) ? 0.5 * (low + high) : low + 2 * (low - zero);
    next = std::min(next, deepest);
    if (next == z || high - low < 1e-15) break;
    z = next;
  }
  return {z, false};
}

// Where areas merge into one patch the force jumps, and no depth may bear just the load: then the
// frames of that depth are kept, with which it does not jump, and where it still does, strips that
// are continuous.
struct Approximate {
  double z, frames;
  bool converged, too_deep, continuous;
};
Approximate approximate_depth(const Work& w, bool friction, double guess, bool continuous) {
  const double zero = w.touch.z();
  const auto at = [&](double from, std::optional<double> frames) {
    const auto share = [&](double z) {
      return vertical_force(approximate(w, z, frames.value_or(z), friction, continuous)) /
             w.input.load;
    };
    const Depths d = find_depth(share, zero, from, 1e-5);
    return Approximate{d.z, frames.value_or(d.z), d.converged, d.too_deep, continuous};
  };
  Approximate found = at(zero + guess, std::nullopt);
  for (const bool last : {false, true}) {
    continuous = continuous || last;
    if (!found.converged && !found.too_deep) found = at(found.frames, found.frames);
  }
  return found;
}

// What the wheel would bear at the greatest depth without friction [N].
double bearable(const Work& w) {
  const double z = w.touch.z() + deepest_sinking;
  return vertical_force(approximate(w, z, z, false, false));
}

void complete(const Work& w, WheelResult& out) {
  const Vector3d centre(0, w.wheel.pose.y, out.z - w.wheel.pair->radius);
  const Vector3d axle = w.wheel.turn.col(1);
  out.force.setZero(), out.axle_moment = 0;
  for (PatchResult& p : out.patches) {
    const Vector3d n = p.patch.frame.normal();
    const Vector3d force =
        p.forces.fx * Vector3d::UnitX() + p.forces.fy * p.patch.frame.across() + p.load * n;
    const Vector3d arm = p.patch.frame.origin + p.approach * n - centre;
    out.force += force;
    // On the wheel: the opposite; forward turning is about -axle.
    out.axle_moment += axle.dot(arm.cross(-force) - p.forces.mz * n);
    p.wear_number = p.forces.fx * p.creepage.longitudinal + p.forces.fy * p.creepage.lateral +
                    p.forces.mz * p.creepage.spin;
    const auto& t = p.forces.tractions;
    p.largest_shear =
        t.px.size() > 0 ? std::sqrt((t.px.array().square() + t.py.array().square()).maxCoeff()) : 0;
  }
  std::ranges::stable_sort(out.patches, std::greater{},
                           [](const PatchResult& p) { return p.load; });
}

}  // namespace

struct WheelSolver::Parts {
  WheelInput input;
  PlacedWheel wheel;
  ContactSearch touch{};
  Work w{wheel, touch, input, rolling::combine(input.wheel, input.rail)};
  Full full{w, 0};
  double depth = 0;         // the first guess
  bool continuous = false;  // strips

  void place(const Pose& pose, double angular_velocity) {
    input.angular_velocity = angular_velocity;
    check(*wheel.pair, pose, input);
    if (pose == wheel.pose && !touch.least.empty()) return;
    wheel = PlacedWheel(*wheel.pair, pose);
    touch = find_contact(wheel);
    depth = 5e-5 * std::pow(input.load / 5e4, 2.0 / 3);
  }
  WheelResult result(const char* failed) const {
    WheelResult out;
    out.z_touch = touch.z();
    take(failed, out);
    complete(w, out);
    return out;
  }
  void take(const char* failed, WheelResult& out) const {
    out.converged = !failed;
    if (failed) out.reason = failed;
    out.patches = full.all;
    if (!failed) out.z = full.z0 + full.down;
  }
};

WheelSolver::WheelSolver(const ProfilePair& pair, const WheelInput& input)
    : parts_(new Parts{input, PlacedWheel(pair, {})}) {}
WheelSolver::~WheelSolver() = default;

void WheelSolver::use_continuous_strips() {
  parts_->continuous = true;
}

WheelResult WheelSolver::solve(const Pose& pose, double angular_velocity, Purpose purpose) {
  Parts& s = *parts_;
  s.full.slip_tolerance = purpose == Purpose::answer ? 1e-7 : 1e-5;
  s.place(pose, angular_velocity);
  if (at_end(*s.wheel.pair, s.touch.least.front()))
    throw InputError{
        fmt::format("the wheel touches at an end of a profile, {:.2f} mm across the wheel; "
                    "allowed: more than 0.5 mm "
                    "from the ends; is the pose right, and the profile long enough?",
                    s.touch.least.front().s / units::millimetre)};
  const bool friction = s.input.friction.largest() > 0, full = s.input.method == Method::full;
  WheelResult out;
  out.z_touch = s.touch.z();
  const Approximate depth = approximate_depth(s.w, friction, s.depth, s.continuous);
  out.z = depth.z;
  if (purpose == Purpose::step && !full && depth.converged) s.depth = out.z - out.z_touch;
  if (depth.too_deep) {
    out.bearable = bearable(s.w);
    out.reason = fmt::format(
        "no depth up to {:g} mm bears the load of {:.6g} N (--load): friction holds the wheel up; "
        "allowed: less friction (--mu), or another pose",
        deepest_sinking / units::millimetre, s.input.load);
    return out;
  }
  if (!depth.converged && !full) {
    out.reason = fmt::format(
        "verge of a second contact: by this method the load jumps at {:.6g} N; take the full "
        "theory (--method full)",
        s.input.load);
    return out;
  }
  out.converged = true;
  out.patches = approximate(s.w, depth.z, depth.frames, friction, depth.continuous, !full);
  if (full) {
    s.full.z0 = out.z;
    s.full.all = std::move(out.patches);
    s.take(s.full.solve(), out);
  }
  complete(s.w, out);
  add_warnings(s.w, out);
  return out;
}

WheelResult WheelSolver::solve_again(const Pose& pose, double angular_velocity) {
  parts_->full.slip_tolerance = 1e-5;
  parts_->place(pose, angular_velocity);
  return parts_->result(parts_->full.solve_again());
}

WheelResult WheelSolver::solve_nearby(const Pose& pose, double angular_velocity) {
  parts_->full.slip_tolerance = 1e-5;
  parts_->place(pose, angular_velocity);
  return parts_->result(parts_->full.solve_nearby());
}

WheelResult WheelSolver::refine() {
  parts_->full.slip_tolerance = 1e-7;
  WheelResult out = parts_->result(parts_->full.refine());
  add_warnings(parts_->w, out);
  return out;
}

void require_bearable(const WheelInput& input, const WheelResult& wheel) {
  if (!wheel.converged && input.load > wheel.bearable)
    throw InputError{fmt::format(
        "load is {:.6g} N; allowed (--load): up to {:.3g} N, which the contact bears {:g} mm deep, "
        "where half-spaces end",
        input.load, wheel.bearable, deepest_sinking / units::millimetre)};
}

WheelResult solve_wheel(const ProfilePair& pair, const Pose& pose, const WheelInput& input) {
  WheelResult out =
      WheelSolver(pair, input).solve(pose, input.angular_velocity, WheelSolver::Purpose::answer);
  require_bearable(input, out);
  return out;
}

}  // namespace railbook::wheel_contact
