#include <cmath>
#include <functional>
#include <optional>

#include <railbook/num/roots.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/wheel_contact/wheel.hpp>

namespace railbook::wheel_contact {
namespace {

// The root of a function that is nearly straight, from two places near it; the better of the last
// two.
double secant(const std::function<double(double)>& f, double x0, double x1, double small) {
  double f0 = f(x0);
  if (std::abs(f0) < small) return x0;
  double f1 = f(x1);
  for (int k = 0; k < 12 && std::abs(f1) >= small && f1 != f0; ++k) {
    const double next = x1 - f1 * (x1 - x0) / (f1 - f0);
    x0 = x1, f0 = f1, x1 = next, f1 = f(x1);
  }
  return x1;
}

struct Balance {
  const ProfilePair &left, &right;
  const WheelInput& input;
  WheelsetResult& out;
  std::optional<Method> last = {};  // by which `out` was found

  void solve(double roll, double angular_velocity, Method method) {
    if (last == method && roll == out.pose.roll && angular_velocity == out.angular_velocity) return;
    last = method;
    WheelInput w = input;
    w.angular_velocity = angular_velocity, w.method = method;
    out.pose.roll = roll, out.angular_velocity = angular_velocity;
    out.right = solve_wheel(right, out.pose, w);
    out.left = solve_wheel(left, mirrored(out.pose), w);
  }
  // A wheel's z is counted from where the axle would be on its running circle.
  double heights() const { return out.right.z - right.radius - (out.left.z - left.radius); }
  double radius() const { return 0.5 * (left.radius + right.radius); }
  double moments() const { return out.right.axle_moment + out.left.axle_moment; }

  // By brackets, with an approximate method.
  double roll(double guess, double angular_velocity, Method method) {
    const auto f = [&](double roll) { return solve(roll, angular_velocity, method), heights(); };
    for (double reach = 2e-5; reach < 0.02; reach *= 3)
      if ((f(guess - reach) > 0) != (f(guess + reach) > 0))
        return guess +
               num::find_root([&](double d) { return f(guess + d); }, -reach, reach, 1e-6).x;
    throw InputError{"no roll near the rigid wheelset's has both wheels at one height"};
  }
  double angular_velocity(double roll, Method method) {
    const double nominal = input.speed / radius();
    const auto f = [&](double angular_velocity) {
      return solve(roll, angular_velocity, method), moments();
    };
    return num::find_root(f, 0.9 * nominal, 1.1 * nominal, 1e-9).x;
  }
};

}  // namespace

WheelsetResult solve_wheelset(const ProfilePair& pair, const Pose& pose, const WheelInput& input) {
  return solve_wheelset(pair, pair, pose, input);
}

WheelsetResult solve_wheelset(const ProfilePair& left, const ProfilePair& right, const Pose& at,
                              const WheelInput& input) {
  units::require_positive("load", input.load, "N");
  units::require_positive("speed", input.speed, "m/s");
  units::require_between("shift", at.y, -0.05, 0.05, "m");
  units::require_between("yaw", at.yaw, -0.1, 0.1, "rad");
  WheelsetResult out;
  out.pose = at;
  Balance b{left, right, input, out};
  const bool friction = input.friction.largest() > 0, full = input.method == Method::full;
  const Method quick = full ? Method::strips : input.method;
  double roll = rigid_roll(left, right, at.y, at.yaw);
  double angular_velocity = input.speed / b.radius();
  for (int k = 0; k < (friction ? 2 : 1); ++k) {
    roll = b.roll(roll, angular_velocity, quick);
    if (friction) angular_velocity = b.angular_velocity(roll, quick);
  }
  const double small_height = 2e-8;  // m
  const double small_moment = 1e-4 * input.friction.largest() * input.load * b.radius();
  for (int k = 0; full && k < 3; ++k) {
    const auto height = [&](double r) {
      return b.solve(r, angular_velocity, Method::full), b.heights();
    };
    roll = secant(height, roll, roll + 1e-6, small_height);
    const auto moment = [&](double t) { return b.solve(roll, t, Method::full), b.moments(); };
    if (friction)
      angular_velocity =
          secant(moment, angular_velocity, angular_velocity * (1 + 1e-6), small_moment);
    if (!friction || std::abs(b.heights()) < 10 * small_height) break;
  }
  b.solve(roll, angular_velocity, input.method);
  if (std::abs(b.heights()) > 1e-6) out.reason = "the wheels do not come to one height";
  if (friction && std::abs(b.moments()) > 10 * small_moment)
    out.reason = "the moments about the axle do not balance";
  for (const WheelResult* wheel : {&out.left, &out.right})
    if (!wheel->converged) out.reason = wheel->reason;
  out.converged = out.reason.empty();
  return out;
}

}  // namespace railbook::wheel_contact
