// Chapter 2: the freight car of nine coordinates on the paper's three pairs of wheel and rail.
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <map>

#include <railbook/cycles/history.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/vehicle/car_families.hpp>
#include <railbook/vehicle/car_on_track.hpp>
#include <railbook/vehicle/cycle_branch.hpp>
#include <railbook/wheelset/paper_pairs.hpp>

#include "live.hpp"

namespace railbook::live {
namespace {

using namespace vehicle;
using units::foot, units::inch;

constexpr Input wheels{"wheels", "", 0, 0, 2};  // new, CN A, modified Heumann

const wheelset::NamedPair& pair(const Inputs& in) {
  return wheelset::paper_pairs[static_cast<std::size_t>(in.whole("wheels"))];
}

const FreightCar& car() {
  static const FreightCar assembled = assemble({}, Suspension::dampers);
  return assembled;
}

void hunting(const Inputs& in, Answer& out) {
  const auto oscillator = car_on_track(car(), pair(in).table(), in["speed"]);
  Eigen::VectorXd y = Eigen::VectorXd::Zero(2 * coordinates);
  y[X_TF] = in["front"];
  y[X_TR] = in["rear"];
  cycles::HistoryOptions options;
  options.sample_step = in["step"];
  for (std::size_t i = 0; i < wheelsets; ++i) options.watch.push_back(oscillator.channels[i].row);
  for (int i = 0; i < wheelsets; ++i) options.watch.emplace_back(wheelset_yaw(i));
  for (int i = 0; i < coordinates; ++i)
    options.watch.emplace_back(Eigen::VectorXd::Unit(coordinates, i));
  const cycles::History h = cycles::integrate(oscillator, y, in["duration"], options);
  cycles::Swing largest;
  for (std::size_t i = 0; i < wheelsets; ++i)
    if (const auto s = cycles::swing(h, i, 3); s.found && s.amplitude > largest.amplitude)
      largest = s;
  const bool complete = h.end == cycles::History::End::completed;
  out.value("end", complete ? 0 : h.end == cycles::History::End::left_table ? 1 : 2);
  out.value("t_end", h.t);
  out.value("amplitude", largest.found ? largest.amplitude : units::nan);
  out.value("omega", largest.found ? largest.omega : units::nan);
  out.value("settled", complete && largest.found && largest.spread < 0.01 * largest.amplitude);
  out.table("motion",
            {"t", "w1", "w2", "w3", "w4", "yaw1", "yaw2", "yaw3", "yaw4", "front", "rear",
             "front_yaw", "rear_yaw", "front_warp", "rear_warp", "body", "body_yaw", "body_roll"});
  for (std::size_t k = 0; k < h.sample_times.size(); ++k) {
    const auto s = h.samples.col(static_cast<Eigen::Index>(k));
    out.row({h.sample_times[k], s[0], s[1], s[2], s[3], s[4], s[5], s[6], s[7], s[8], s[9], s[10],
             s[11], s[12], s[13], s[14], s[15], s[16]});
  }
}

const QuasiLinearCar& quasi_linear(const Inputs& in) {
  static std::map<int, QuasiLinearCar> known;
  return known.try_emplace(in.whole("wheels"), car(), pair(in).table()).first->second;
}

void critical(const Inputs& in, Answer& out) {
  out.table("speeds", {"speed", "omega", "phase"});
  for (const HopfPoint& p : hopf_points(quasi_linear(in), 1 * foot, 400 * foot))
    out.row({p.motion.speed, p.motion.lambda.imag(),
             std::abs(std::arg(p.motion.shape[X_TF] / p.motion.shape[X_TR]))});
}

// Limit cycles by describing functions, from the first critical speed.
void branch(const Inputs& in, Answer& out) {
  const QuasiLinearCar& c = quasi_linear(in);
  const auto hopf = hopf_points(c, 1 * foot, 400 * foot);
  out.table("points", {"speed", "amplitude", "stable"});
  for (const CyclePoint& p : trace_from(c, hopf.at(0), {}).points)
    out.row({p.motion.speed, p.largest, p.stable ? 1.0 : 0.0});
}

// The branch of limit cycles of the full equations from the first critical speed, stability not
// asked.
struct FullBranch {
  cycles::Family family;
  cycles::LimitCycleBranch branch;

  explicit FullBranch(const Inputs& in) : family(by_speed(car(), pair(in).table())) {
    const Motion motion = hopf_points(quasi_linear(in), 1 * foot, 400 * foot).at(0).motion;
    cycles::ContinuationOptions options;
    options.lowest = 1 * foot;
    options.highest = 250 * foot;
    options.first_amplitude = 0.036 * inch;
    options.largest_amplitude = 0.6 * inch;
    options.multiplier_steps = 0;
    branch = follow_from_hopf(family, motion.shape, motion.lambda.imag(), motion.speed, options);
  }
};

// Its first cycle at a speed, with its multipliers; `found` is 0 where there is none.
void cycle(const Inputs& in, Answer& out) {
  static std::map<int, FullBranch> known;
  const FullBranch& full = known.try_emplace(in.whole("wheels"), in).first->second;
  out.table("branch", {"speed", "amplitude"});
  for (const cycles::LimitCycle& p : full.branch.points) out.row({p.parameter, p.largest});
  const auto found = cycles_at(full.family, full.branch, in["speed"], {});
  out.value("found", found.empty() ? 0 : 1);
  out.value("amplitude", found.empty() ? units::nan : found[0].largest);
  out.value("omega", found.empty() ? units::nan : found[0].cycle.omega);
  out.value("stable", !found.empty() && found[0].stable ? 1 : 0);
  out.table("multipliers", {"real", "imaginary"});
  if (found.empty()) return;
  for (const Complex& m : found[0].multipliers.map) out.row({m.real(), m.imag()});
}

void wheelset_contact(const Inputs& in, Answer& out) {
  const wheelset::WheelsetOnTrack& p = pair(in).pair();
  const wheelset::WheelsetContact c = p.contact(in["x"]);
  out.value("converged", c.converged ? 1 : 0);
  out.value("roll", c.roll);
  out.value("height", c.height);
  out.value("left_radius", c.left.radius);
  out.value("left_angle", c.left.delta);
  out.value("right_radius", c.right.radius);
  out.value("right_angle", c.right.delta);
  // Points on the rails in the track's frame, y to the left; a side counts from the track's centre
  // outwards, towards negative u.
  out.value("left_y", -c.left.on_rail.u);
  out.value("left_z", c.left.on_rail.z);
  out.value("right_y", c.right.on_rail.u);
  out.value("right_z", c.right.on_rail.z);
}

void add_curve(const char* name, const profiles::Curve& curve, double dz, Answer& out) {
  out.table(name, {"y", "z"});
  for (const profiles::Piece& p : curve.pieces()) {
    const int n = p.is_line() ? 1 : 12;
    for (int i = 0; i < n; ++i) {
      const double u = std::lerp(p.start.u, p.end.u, static_cast<double>(i) / n);
      out.row({-u, curve.height(u) + dz});
    }
  }
  out.row({-curve.end().u, curve.end().z + dz});
}

// The left side, the wheelset in the middle of the track.
void profiles_answer(const Inputs& in, Answer& out) {
  const wheelset::WheelsetOnTrack& p = pair(in).pair();
  const wheelset::WheelsetContact c = p.contact(0);
  out.value("half_spacing", wheelset::paper_track.half_spacing);
  out.value("height", c.height);
  add_curve("wheel", p.wheel(), c.height, out);
  add_curve("rail", p.rail(), 0, out);
}

}  // namespace

std::span<const Function> hunting_functions() {
  static const std::array<Function, 6> all{
      {{"hunting",
        nullptr,
        {{"speed", "m/s", 150 * foot, 1, 100},
         {"front", "m", 0.3 * inch, -0.74 * inch, 0.74 * inch},
         {"rear", "m", 0.3 * inch, -0.74 * inch, 0.74 * inch},
         wheels,
         {"duration", "s", 3, 0.1, 20},
         {"step", "s", 0.01, 0.001, 1}},
        hunting},
       {"critical", nullptr, {wheels}, critical},
       {"branch", nullptr, {wheels}, branch},
       {"cycle", nullptr, {{"speed", "m/s", 150 * foot, 1, 100}, wheels}, cycle},
       {"wheelset", nullptr, {{"x", "m", 0, -0.75 * inch, 0.75 * inch}, wheels}, wheelset_contact},
       {"profiles", nullptr, {wheels}, profiles_answer}}};
  return all;
}

}  // namespace railbook::live
