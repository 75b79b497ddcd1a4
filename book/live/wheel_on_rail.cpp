// Chapter 8: the right wheel of a wheelset S1002 on its rail 60E1.
#include <array>
#include <cmath>

#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/wheel_contact/wheel.hpp>

#include "live.hpp"

namespace railbook::live {
namespace {

using namespace wheel_contact;

const ProfilePair& pair() {
  static const ProfilePair p = s1002_on_60e1(1.0 / 40, profiles::Rail60::benchmark);
  return p;
}

void add_cells(const WheelResult& found, Answer& out) {
  out.table("cells", {"patch", "along", "across", "y", "d_along", "d_across", "p"});
  for (std::size_t k = 0; k < found.patches.size(); ++k) {
    const PatchResult& p = found.patches[k];
    const Frame& f = p.patch.frame;
    const auto add = [&](double x, double t, double dx, double dt, double pressure) {
      out.row({static_cast<double>(k), f.origin.x() + x, t, f.origin.y() + t * std::cos(f.angle),
               dx, dt, pressure});
    };
    for (Eigen::Index i = 0; i < p.pressure.size(); ++i)
      if (p.pressure[i] > 0)
        add(p.grid.x(i % p.grid.nx), p.grid.y(i / p.grid.nx), p.grid.dx, p.grid.dy, p.pressure[i]);
    constexpr int n = 24;  // cells of a strip
    for (const Strip& s : p.strips.strips)
      for (int i = 0; i < n; ++i) {
        const double dx = 2 * s.half_length / n, x = s.x - s.half_length + (i + 0.5) * dx;
        add(x, s.t, dx, p.strips.width, p.strips.pressure(s, x - s.x));
      }
  }
}

void wheel_on_rail(const Inputs& in, Answer& out) {
  Pose pose{in["shift"], in["yaw"], 0};
  pose.roll = rigid_roll(pair(), pose.y, pose.yaw);
  WheelInput input;
  input.load = in["load"];
  input.speed = in["speed"];
  input.angular_velocity = input.speed / pair().radius;
  input.friction.coefficient = in["friction"];
  input.method = std::array{Method::hertz, Method::strips,
                            Method::full}[static_cast<std::size_t>(in.whole("method"))];
  input.along = input.across = in.whole("cells");
  const WheelResult found = solve_wheel(pair(), pose, input);
  if (!found.converged) throw InputError(found.reason);
  out.value("roll", pose.roll);
  out.value("z", found.z);
  out.value("force_x", found.force.x());
  out.value("force_y", found.force.y());
  out.value("force_z", found.force.z());
  out.table("patches", {"y", "z", "angle", "load", "p_max", "area", "fx", "fy", "creep_along",
                        "creep_across", "spin", "wear"});
  for (const PatchResult& p : found.patches) {
    const Frame& f = p.patch.frame;
    out.row({f.origin.y(), f.origin.z(), f.angle, p.load, p.p_max, p.area, p.forces.fx, p.forces.fy,
             p.creepage.longitudinal, p.creepage.lateral, p.creepage.spin, p.wear_number});
  }
  add_cells(found, out);
  // Wheel, at its depth, and rail in section; depths in the track's frame.
  out.table("wheel", {"y", "z"});
  const ContactSearch search = find_contact(PlacedWheel(pair(), pose));
  for (std::size_t i = 0; i < search.locus.size(); i += 4) {
    const auto& at = search.locus[i].at;
    out.row({at.y(), at.z() + found.z});
  }
  out.table("rail", {"y", "z"});
  const profiles::Profile& head = pair().rail;
  constexpr int n = 200;
  for (int i = 0; i <= n; ++i) {
    const double y = std::lerp(head.from(), head.to(), static_cast<double>(i) / n);
    out.row({y, head.at(y).depth});
  }
}

}  // namespace

std::span<const Function> wheel_on_rail_functions() {
  static const std::array<Function, 1> all{{{"wheel_on_rail",
                                             nullptr,
                                             {{"shift", "m", 0, -0.01, 0.01},
                                              {"yaw", "rad", 0, -0.03, 0.03},
                                              {"load", "N", 80e3, 1e3, 200e3},
                                              {"speed", "m/s", 20, 0.1, 120},
                                              {"friction", "", 0.3, 0, 1},
                                              {"method", "", 2, 0, 2},
                                              {"cells", "", 20, 8, 40}},
                                             wheel_on_rail}}};
  return all;
}

}  // namespace railbook::live
