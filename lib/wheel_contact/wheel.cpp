#include <railbook/wheel_contact/wheel.hpp>

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <string_view>
#include <utility>

#include <railbook/rolling/material_pair.hpp>
#include <railbook/rolling/unlike_materials.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/wheel_contact/detail/cells.hpp>

namespace railbook::wheel_contact {

using Eigen::Index;
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

// What does not change while the wheel is lowered.
struct Work {
  const PlacedWheel& wheel;
  const ContactSearch& touch;
  const WheelInput& input;
  rolling::MaterialPair material;
};

// The wheel's rigid creepages over the rail at a patch (rolling_case.hpp), and the speed of
// rolling.
struct Motion {
  rolling::Creepage creepage;
  double speed;
};
Motion motion_of(const Work& w, const Frame& frame, double approach, double z) {
  const Vector3d centre(0, w.wheel.pose.y, z - w.wheel.pair->radius);
  const Vector3d spin = w.wheel.turn * Vector3d(0, -w.input.angular_velocity, 0);
  const Vector3d arm = frame.origin + approach * frame.normal() - centre;
  const Vector3d v = Vector3d(w.input.speed, 0, 0) + spin.cross(arm);
  const double speed = w.input.speed - 0.5 * v.x();
  return {{v.x() / speed, v.dot(frame.across()) / speed, spin.dot(frame.normal()) / speed}, speed};
}

rolling::RollingCase case_of(const Work& w, PatchResult& p, double z) {
  const Motion m = motion_of(w, p.patch.frame, p.approach, z);
  p.creepage = m.creepage;
  const double slip =
      std::sqrt(std::pow(m.creepage.longitudinal, 2) + std::pow(m.creepage.lateral, 2) +
                std::pow(m.creepage.spin, 2) * p.area / (2 * units::pi));
  p.friction = w.input.friction.at(std::abs(m.speed) * slip, -p.patch.frame.angle);
  return {.a = 1,
          .b = 1,
          .load = 1,
          .shear_modulus = w.material.shear_modulus,
          .poisson = w.material.poisson,
          .friction = p.friction,
          .creepage = m.creepage};
}

// Vertical force on the rail for a unit of normal force, with what friction bears.
double vertical(const PatchResult& p) {
  const double angle = p.patch.frame.angle;
  return std::cos(angle) + (p.load > 0 ? p.forces.fy / p.load : 0) * std::sin(angle);
}
double vertical_force(const std::vector<PatchResult>& all) {
  double sum = 0;
  for (const PatchResult& p : all) sum += p.load * vertical(p);
  return sum;
}

// All patches at a depth by an approximate method, with frames made at the depth `frames`.
std::vector<PatchResult> approximate(const Work& w, double z, double frames, bool friction,
                                     bool keep = false) {
  std::vector<PatchResult> all;
  const double modulus = w.material.effective_modulus;
  for (Patch& patch : patches(w.wheel, w.touch, frames, w.input.patches)) {
    const double down = (z - frames) * std::cos(patch.frame.angle);
    PatchResult p;
    p.strips = w.input.method == Method::hertz ? hertzian(patch, modulus, down)
                                               : semi_hertzian(patch, modulus, down);
    if (p.strips.strips.empty()) continue;
    p.patch = std::move(patch);
    p.load = p.strips.load, p.approach = p.strips.approach;
    p.p_max = p.strips.p_max, p.area = p.strips.area;
    if (friction) p.forces = fastsim(p.strips, case_of(w, p, z), keep);
    all.push_back(std::move(p));
  }
  return all;
}

// With n cells across a patch the error of p_max is at least the first over n^2; that of the forces
// and of the moment, over n.
constexpr double least_p_max_error = 2, least_force_error = 0.16, least_moment_error = 0.1;

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
// frames of that depth are kept, with which it does not jump.
struct Approximate {
  double z, frames;
  bool converged, too_deep;
};
Approximate approximate_depth(const Work& w, bool friction) {
  const double zero = w.touch.z();
  const auto share = [&](double z, double frames) {
    return vertical_force(approximate(w, z, frames, friction)) / w.input.load;
  };
  const Depths first = find_depth([&](double z) { return share(z, z); }, zero,
                                  zero + 5e-5 * std::pow(w.input.load / 5e4, 2.0 / 3), 1e-5);
  if (first.converged || first.too_deep) return {first.z, first.z, first.converged, first.too_deep};
  const Depths kept = find_depth([&](double z) { return share(z, first.z); }, zero, first.z, 1e-5);
  return {kept.z, first.z, kept.converged, kept.too_deep};
}

struct Full {
  const Work& w;
  double z0;  // at which the frames are made and the overlaps hold
  std::vector<PatchResult>& all;
  std::vector<std::unique_ptr<Cells>> cells;
  double down = 0;                    // below z0
  std::vector<PatchResult> coarse{};  // on half the cells along and across

  // The loads at the depth `down`, with the shares that friction bears as they are.
  bool press() {
    for (std::size_t i = 0; i < all.size(); ++i) {
      const double before = all[i].load;
      const double load = cells[i]->solve(down * std::cos(all[i].patch.frame.angle));
      if (load < 0) return false;
      const double ratio = before > 0 ? load / before : 0;
      all[i].load = load;  // friction as a share of it
      for (double* f : {&all[i].forces.fx, &all[i].forces.fy, &all[i].forces.mz}) *f *= ratio;
    }
    return true;
  }

  // Lowers the wheel until it bears the load, with the shares that friction bears as they are.
  bool balance(double tolerance) {
    double last = 0, last_share = 0;
    for (int k = 0; k < 25; ++k) {
      if (!press()) return false;
      const double share = vertical_force(all) / w.input.load;
      if (std::abs(share - 1) < tolerance) return true;
      const double depth = std::max(z0 + down - w.touch.z(), 0.0);
      double slope = 1.5 * std::max(share, 0.05) / std::max(depth, 1e-9);
      if (k > 0 && std::abs(down - last) > 1e-12) {
        const double secant = (share - last_share) / (down - last);
        if (secant > 0.3 * slope && secant < 5 * slope) slope = secant;
      }
      last = down, last_share = share;
      down += std::clamp((1 - share) / slope, -0.5 * depth - 1e-7, depth + 1e-7);
    }
    return false;
  }

  // The patches anew, at the depth found; friction as shares of the load as before where they are
  // the same patches.
  void lower_frames() {
    z0 += down, down = 0;
    std::vector<Patch> anew = patches(w.wheel, w.touch, z0, w.input.patches);
    if (anew.size() != all.size()) all.assign(anew.size(), {});
    for (std::size_t i = 0; i < all.size(); ++i) all[i].patch = std::move(anew[i]);
    cells.clear();
  }

  void mesh(Index nx, Index ny) {
    for (std::size_t i = 0; i < all.size(); ++i) {
      std::unique_ptr<Cells>& c = i < cells.size() ? cells[i] : cells.emplace_back();
      const contact::Box box = c ? c->around(nx, ny) : all[i].patch.overlap;
      auto finer = std::make_unique<Cells>(w.wheel, w.material.effective_modulus,
                                           all[i].patch.frame, z0, box, nx, ny);
      if (c) finer->pressure = contact::transfer(c->grid, c->pressure, finer->grid);
      c = std::move(finer);
    }
  }
  void describe() {
    for (std::size_t i = 0; i < all.size(); ++i) {
      cells[i]->describe();
      PatchResult& p = all[i];
      p.p_max = cells[i]->region.p_max, p.area = cells[i]->region.area;
      p.approach = cells[i]->lowered.maxCoeff();
    }
  }
  // Friction on the pressures.
  bool roll() {
    for (std::size_t i = 0; i < all.size(); ++i) {
      PatchResult& p = all[i];
      const rolling::RollingCase c = case_of(w, p, z0 + down);
      if (p.friction == 0) {
        p.forces = {};
        continue;
      }
      p.forces = rolling::solve_rolling_unlike(cells[i]->grid, cells[i]->pressure, c,
                                               {.estimate = false, .solver = {.tolerance = 1e-7}},
                                               w.material.dissimilarity);
      if (!p.forces.converged) return false;
    }
    return true;
  }
  // From the changes since the coarse grid, forces and moments as shares of what friction bears.
  // Two grids may agree by chance, and both be a part of a cell off at the rows where slip begins:
  // no error is less than what cells of this size leave in 95 of 100 contacts.
  void state_errors() {
    for (std::size_t i = 0; i < all.size(); ++i) {
      PatchResult& p = all[i];
      const PatchResult& c = coarse[i];
      const auto n = static_cast<double>(std::min(cells[i]->grid.nx, cells[i]->grid.ny));
      p.p_max_error = std::abs(p.p_max / c.p_max - 1) + least_p_max_error / (n * n);
      if (p.friction == 0) continue;
      const auto share = [](const PatchResult& r) {
        const double bound = r.friction * r.load, arm = std::sqrt(r.area / units::pi);
        return Vector3d{r.forces.fx / bound, r.forces.fy / bound, r.forces.mz / (bound * arm)};
      };
      const Vector3d change = share(p) - share(c);
      p.forces.error = std::max(1.5 * change.head<2>().norm(), least_force_error / n);
      p.forces.mz_error = std::max(1.5 * std::abs(change.z()), least_moment_error / n);
    }
  }
  void forget_unloaded() {
    for (std::size_t i = all.size(); i-- > 0;)
      if (!(all[i].load > 0)) {
        all.erase(all.begin() + static_cast<std::ptrdiff_t>(i));
        cells.erase(cells.begin() + static_cast<std::ptrdiff_t>(i));
      }
  }
  bool touches_edge() const {
    return std::ranges::any_of(cells, [](const auto& c) { return c->region.touches_edge(); });
  }

  // The three steps of the solution. Each says why it failed; nullptr: it did not.
  const char* place_planes();
  const char* fit_grid();
  const char* settle_friction();
  static constexpr const char* unborne = "the load was not met by the half-space's pressures";
  static constexpr const char* unsettled = "the stick and slip areas did not settle";
};

// The depth on a coarse grid, planes at that depth, and the coarse answer.
const char* Full::place_planes() {
  const Index nx = w.input.along / 2, ny = w.input.across / 2;
  mesh(nx, ny);
  if (!balance(1e-2)) return unborne;
  lower_frames();
  mesh(nx, ny);
  if (!balance(1e-3)) return unborne;
  forget_unloaded();
  describe();
  if (w.input.friction.largest() > 0 && !roll()) return unsettled;
  coarse = all;
  return nullptr;
}

// The depth on the cells asked for, on larger grids until the contact fits.
const char* Full::fit_grid() {
  for (int k = 0; k < 4; ++k) {
    mesh(w.input.along, w.input.across);
    if (!balance(1e-5)) return unborne;
    describe();
    if (!touches_edge()) return nullptr;
  }
  return "the contact did not fit its grid";
}

// Pressure and friction in turn until the load is met. Near Nadal's edge friction bears nearly as
// much as the flange presses, and its share falls as the load grows: the depth that balances one
// share swings about that which balances its own. Where that has not ended, it is sought between
// the last two.
const char* Full::settle_friction() {
  double last = 0, last_off = 0;
  for (int k = 0; w.input.friction.largest() > 0; ++k) {
    if (!roll()) return unsettled;
    const double off = vertical_force(all) / w.input.load - 1, here = down;
    if (std::abs(off) < 1e-3) break;
    if (k == 15) return "friction and load did not settle";
    const bool swings = k >= 7 && off * last_off < 0;
    if (swings) down = here + (last - here) * off / (off - last_off);
    if (!(swings ? press() : balance(1e-5))) return unborne;
    describe();
    last = here, last_off = off;
  }
  return nullptr;
}

void solve_full(const Work& w, double z, WheelResult& out) {
  Full f{w, z, out.patches, {}};
  const char* failed = f.place_planes();
  if (!failed) failed = f.fit_grid();
  if (!failed) failed = f.settle_friction();
  if (failed) {
    out.converged = false, out.reason = failed;
    return;
  }
  f.state_errors();
  out.z = f.z0 + f.down;
  for (std::size_t i = 0; i < f.all.size(); ++i) {
    f.all[i].grid = f.cells[i]->grid;
    f.all[i].pressure = f.cells[i]->pressure;
  }
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

// How much less the smaller of two patches would carry if both pressed on one half-space, over its
// load: each sinks in by the other's load over pi E* distance, and the wheel comes down until both
// bear what they did together. Loads grow as approach^(3/2).
double neighbour_effect(const Work& w, const PatchResult& large, const PatchResult& small) {
  const double distance = (large.patch.frame.origin - small.patch.frame.origin).norm();
  const double sinking = (large.load - small.load) /
                         (units::pi * w.material.effective_modulus * distance) *
                         std::cos(large.patch.frame.angle - small.patch.frame.angle);
  const double a = 1.5 * large.load / large.approach, b = 1.5 * small.load / small.approach;
  return std::max(0.0, a * b / (a + b) * sinking / small.load);
}

void add_warnings(const Work& w, WheelResult& out) {
  const auto warn = [&](const char* key, std::string text) {
    out.warnings.push_back({key, std::move(text)});
  };
  for (const PlacedWheel::Point& p : w.touch.least) {
    const double clear = p.gap - out.z;
    if (clear > 0 && clear < 0.5 * (out.z - out.z_touch))
      warn("verge",
           fmt::format(
               "verge of a second contact: at {:.2f} mm across the wheel only {:.1f} um clear",
               p.s / units::millimetre, clear / units::micrometre));
  }
  const double unlike = w.material.dissimilarity;
  if (std::abs(unlike) > 0.02)
    warn("unlike", fmt::format("unlike materials (K = {:.3f}): {}", unlike,
                               w.input.method == Method::full
                                   ? "what their tractions do to the pressure is left out"
                                   : "left out by this method; take the full theory"));
  for (const PatchResult& p : out.patches) {
    if (out.patches.size() > 1 && p.load < 0.1 * out.patches.front().load)
      warn("verge",
           fmt::format("verge of a second contact: a patch carries only {:.0f} N", p.load));
    const double effect =
        &p == &out.patches.front() ? 0 : neighbour_effect(w, out.patches.front(), p);
    if (effect > 0.02)
      warn("neighbour",
           fmt::format("patches apart are half-spaces of their own: on one, the patch of {:.0f} N "
                       "would carry about "
                       "{:.0f} % less, and the largest one that much more",
                       p.load, std::min(100.0, 100 * effect)));
    const contact::Box& box = p.patch.overlap;  // sqrt(2) as large as the contact
    const double width = (box.y_max - box.y_min) / std::sqrt(2.0),
                 length = (box.x_max - box.x_min) / std::sqrt(2.0);
    const double head = w.wheel.pair->rail.to() - w.wheel.pair->rail.from();
    if (width > 0.3 * head || length > 0.4 * p.patch.radius)
      warn("half_space",
           fmt::format("half-space: the contact is {:.0f} mm wide and {:.0f} mm long, the rail's "
                       "profile {:.0f} mm "
                       "wide, the wheel's radius {:.0f} mm: too large for half-spaces",
                       width / units::millimetre, length / units::millimetre,
                       head / units::millimetre, p.patch.radius / units::millimetre));
    if (p.strips.two_lobes && w.input.method != Method::full)
      warn("two_areas",
           "two areas of overlap in one patch: rough by this method; take the full theory");
    if (p.patch.merged)
      warn("shared_frame", "two areas of overlap are near one another and share one frame");
    if (p.patch.at_end)
      warn("off_profile",
           "off the profile: the overlap reaches an end of one, beyond which no body is taken");
    if (p.patch.turn > 0.35)
      warn("conformal",
           fmt::format(
               "conformal: the rail turns by {:.2f} rad over the patch, whose frame is plane",
               p.patch.turn));
    if (!p.forces.warning.empty()) warn("theory_range", std::string(p.forces.warning));
    if (p.p_max_error > 0.02 && std::isfinite(p.p_max_error))
      warn("coarse",
           fmt::format("coarse: the peak pressure may be off by {:.1f} %", 100 * p.p_max_error));
  }
}

}  // namespace

WheelResult solve_wheel(const ProfilePair& pair, const Pose& pose, const WheelInput& input) {
  check(pair, pose, input);
  const PlacedWheel wheel(pair, pose);
  const ContactSearch touch = find_contact(wheel);
  if (at_end(pair, touch.least.front()))
    throw InputError{
        fmt::format("the wheel touches at an end of a profile, {:.2f} mm across the wheel; "
                    "allowed: more than 0.5 mm "
                    "from the ends; is the pose right, and the profile long enough?",
                    touch.least.front().s / units::millimetre)};
  const Work w{wheel, touch, input, rolling::combine(input.wheel, input.rail)};
  WheelResult out;
  out.z_touch = touch.z();
  const bool friction = input.friction.largest() > 0;
  const Approximate depth = approximate_depth(w, friction);
  out.z = depth.z;
  if (depth.too_deep) {
    out.reason = "no depth up to 2 mm bears the load";
    return out;
  }
  if (!depth.converged && input.method != Method::full) {
    out.reason = "verge of a second contact: by this method the load jumps; take the full theory";
    return out;
  }
  out.converged = true;
  out.patches = approximate(w, depth.z, depth.frames, friction, input.method != Method::full);
  if (input.method == Method::full) solve_full(w, depth.z, out);
  complete(w, out);
  add_warnings(w, out);
  return out;
}

}  // namespace railbook::wheel_contact
