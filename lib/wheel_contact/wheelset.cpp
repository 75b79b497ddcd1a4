#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

#include <railbook/num/roots.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/wheel_contact/detail/wheel_solver.hpp>
#include <railbook/wheel_contact/wheel.hpp>

namespace railbook::wheel_contact {

using Eigen::Vector2d;

namespace {

// approximate: by strips, or Hertz's method; afresh: by the full theory, for what follows; again:
// on planes and cells made anew from the last solution; nearby: on those of the last solution;
// answer: the last pose to the accuracy of an answer.
enum class How { approximate, afresh, again, nearby, answer };

struct Balance {
  const ProfilePair &left, &right;
  const WheelInput& input;
  WheelsetResult& out;
  std::array<WheelSolver, 2> quick, full;  // left, right
  // Of the right wheel over the left [m], and about the axle [N m]; by an approximate method as
  // known for a roll and an angular velocity.
  Vector2d off = {};
  std::map<std::pair<double, double>, Vector2d> known = {};

  const Vector2d& solve(double roll, double angular_velocity, How how) {
    out.pose.roll = roll, out.angular_velocity = angular_velocity;
    const auto solved = [&](std::size_t side, const Pose& pose) {
      const bool by_full = input.method == Method::full;
      if (how == How::again) return full[side].solve_again(pose, angular_velocity);
      if (how == How::nearby) return full[side].solve_nearby(pose, angular_velocity);
      if (how == How::answer && by_full) return full[side].refine();
      return (how == How::afresh ? full : quick)[side].solve(
          pose, angular_velocity,
          by_full ? WheelSolver::Purpose::step : WheelSolver::Purpose::answer);
    };
    out.right = solved(1, out.pose);
    out.left = solved(0, mirrored(out.pose));
    // A wheel's z is counted from where the axle would be on its running circle.
    off = {out.right.z - right.radius - (out.left.z - left.radius),
           out.right.axle_moment + out.left.axle_moment};
    return off;
  }
  const Vector2d& approximate(double roll, double angular_velocity) {
    const auto [place, anew] = known.try_emplace({roll, angular_velocity});
    if (anew) place->second = solve(roll, angular_velocity, How::approximate);
    return place->second;
  }
  bool converged() const { return out.left.converged && out.right.converged; }
  double radius() const { return 0.5 * (left.radius + right.radius); }

  // By brackets, with an approximate method; `turns` gives the angular velocity at a roll.
  template <class Turns>
  double roll_by(double guess, const Turns& turns, double relative = 1e-6) {
    const auto f = [&](double roll) { return approximate(roll, turns(roll))[0]; };
    for (double reach = 2e-5; reach < 0.02; reach *= 3)
      if ((f(guess - reach) > 0) != (f(guess + reach) > 0))
        return guess +
               num::find_root([&](double d) { return f(guess + d); }, -reach, reach, relative).x;
    throw InputError{"no roll near the rigid wheelset's has both wheels at one height"};
  }
  double roll(double guess, double angular_velocity) {
    return roll_by(guess, [&](double) { return angular_velocity; });
  }
  double angular_velocity(double roll, double relative) {
    const double nominal = input.speed / radius();
    const auto f = [&](double angular_velocity) { return approximate(roll, angular_velocity)[1]; };
    return num::find_root(f, 0.9 * nominal, 1.1 * nominal, relative).x;
  }

  // Where friction bears much of a wheel, as on a flange, the roll depends on how fast the axle
  // turns, and either of them is steep: by brackets, the angular velocity within the roll.
  void settle_flange(double rigid) {
    for (WheelSolver& wheel : quick) wheel.use_continuous_strips();
    known.clear();
    const auto turns = [&](double roll) { return angular_velocity(roll, 1e-9); };
    const double at = roll_by(rigid, turns, 1e-9);
    solve(at, turns(at), How::answer);
  }

  // Broyden's method on a roll and an angular velocity, which counts in `unit`s.
  struct Search {
    double &roll, &angular_velocity;
    bool friction;
    Vector2d unit{1e-5, 1e-4 * angular_velocity};
    Eigen::Matrix2d slopes = Eigen::Matrix2d::Identity();

    Vector2d move(const Vector2d& off) {
      const Vector2d most(50, 300);
      Vector2d step = -slopes.fullPivLu().solve(off).cwiseMax(-most).cwiseMin(most);
      roll += step[0] * unit[0];
      if (friction) angular_velocity += step[1] * unit[1];
      return step;
    }
    void renew(const Vector2d& change, const Vector2d& step) {
      if (step != Vector2d::Zero())
        slopes += (change - slopes * step) * step.transpose() / step.squaredNorm();
    }
    // f(roll, angular velocity), whose value here is `at`; false where it fails.
    template <class F>
    bool find_slopes(const Vector2d& at, const F& f) {
      Vector2d off;
      if (!f(roll + unit[0], angular_velocity, off)) return false;
      slopes.col(0) = off - at;
      if (!friction) return true;
      if (!f(roll, angular_velocity + unit[1], off)) return false;
      slopes.col(1) = off - at;
      return true;
    }
  };
  bool good(const Vector2d& small) const {
    return std::abs(off[0]) < small[0] &&
           (std::abs(off[1]) < small[1] || input.friction.largest() == 0);
  }

  // The start of the full theory, and its slopes if they can be had, by the approximate method.
  bool start(Search& s, const Vector2d& small) {
    Vector2d at;
    const auto f = [&](double roll, double angular_velocity, Vector2d& found) {
      found = off = approximate(roll, angular_velocity);
      return converged();
    };
    const auto search = [&] {
      bool going = f(s.roll, s.angular_velocity, at) && s.find_slopes(at, f);
      for (int k = 0; k < 12 && going; ++k) {
        const Vector2d before = at, step = s.move(at);
        going = f(s.roll, s.angular_velocity, at);
        s.renew(at - before, step);
        if (going && good(small)) return true;
      }
      return false;
    };
    const double rigid = s.roll, nominal = s.angular_velocity;
    try {
      if (search()) return true;
    } catch (const InputError&) {  // a step beyond the profiles
    }
    s.roll = roll(rigid, nominal), s.angular_velocity = nominal;
    if (s.friction) s.angular_velocity = angular_velocity(s.roll, 1e-3);
    return search();
  }

  // By the full theory on the planes and cells of one pose, and where that leads far from it, of
  // another.
  void settle(double& roll, double& angular_velocity, const Vector2d& small) {
    Search s{roll, angular_velocity, input.friction.largest() > 0};
    const auto f = [&](double r, double t, Vector2d& found) {
      found = solve(r, t, How::nearby);
      return converged();
    };
    bool sure = start(s, 100 * small);
    for (int k = 0; k < 8; ++k) {
      Vector2d at = solve(roll, angular_velocity, k > 0 ? How::again : How::afresh);
      if (k > 0 && !converged()) at = solve(roll, angular_velocity, How::afresh);
      if (!converged()) return;
      Vector2d way = Vector2d::Zero();
      if (!sure) sure = s.find_slopes(at, f);
      off = at;
      const auto far = [&] { return std::abs(way[0]) > 0.05 || std::abs(way[1]) > 1; };
      bool at_jump = false;  // of the moment, where a cell begins to bear
      for (int m = 0; m < 12 && !at_jump && !good(far() ? 10 * small : small); ++m) {
        const Vector2d before = at, step = s.move(at);
        way += step;
        if (!f(roll, angular_velocity, at)) break;
        at_jump = step.norm() < 1e-3 && good(10 * small);
        if (m > 0 || step.norm() > 0.1) s.renew(at - before, step);  // at first friction is rough
      }
      if (converged() && !far() && (at_jump || good(small))) break;
    }
    if (converged()) solve(roll, angular_velocity, How::answer);
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
  const bool friction = input.friction.largest() > 0, full = input.method == Method::full;
  WheelInput quick = input;
  if (full) quick.method = Method::strips;
  Balance b{left,
            right,
            input,
            out,
            {WheelSolver(left, quick), WheelSolver(right, quick)},
            {WheelSolver(left, input), WheelSolver(right, input)}};
  double roll = rigid_roll(left, right, at.y, at.yaw);
  double angular_velocity = input.speed / b.radius();
  const double rigid = roll;
  for (int k = 0; !full && k < (friction ? 2 : 1); ++k) {
    roll = b.roll(roll, angular_velocity);
    if (friction) angular_velocity = b.angular_velocity(roll, 1e-9);
  }
  const Vector2d small(2e-8, 1e-4 * input.friction.largest() * input.load * b.radius());
  if (full)
    b.settle(roll, angular_velocity, small);
  else
    b.solve(roll, angular_velocity, How::answer);
  const Vector2d allowed(1e-6, 10 * small[1]);
  if (!full && friction && !(b.converged() && b.good(allowed))) b.settle_flange(rigid);
  const char* advice = full ? "another number of --cells may do" : "take --method full";
  if (std::abs(b.off[0]) > allowed[0])
    out.reason = fmt::format(
        "the wheels do not come to one height: at a roll of {:.4g} mrad they are {:.3g} um apart; "
        "allowed: 1; {}",
        1e3 * out.pose.roll, std::abs(b.off[0]) / units::micrometre, advice);
  if (friction && std::abs(b.off[1]) > allowed[1])
    out.reason = fmt::format(
        "the moments about the axle do not balance: at {:.6g} rad/s {:.3g} N m are left; allowed: "
        "{:.2g}; {}",
        out.angular_velocity, std::abs(b.off[1]), allowed[1], advice);
  for (const WheelResult* wheel : {&out.left, &out.right}) require_bearable(input, *wheel);
  for (const WheelResult* wheel : {&out.left, &out.right})
    if (!wheel->converged) out.reason = wheel->reason;
  out.converged = out.reason.empty();
  return out;
}

}  // namespace railbook::wheel_contact
