// The full theory of one wheel: planes, cells, pressures and friction.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include <railbook/units/constants.hpp>
#include <railbook/wheel_contact/detail/full_wheel.hpp>

namespace railbook::wheel_contact {

using Eigen::Index;
using Eigen::Vector3d;

namespace {

// With n cells across a patch the error of p_max is at least the first over n^2; that of the forces
// and of the moment, over n.
constexpr double least_p_max_error = 2, least_force_error = 0.16, least_moment_error = 0.1;

constexpr const char* unborne = "the load was not met by the half-space's pressures";
constexpr const char* unsettled = "the stick and slip areas did not settle";

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

}  // namespace

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

namespace {

// Vertical force on the rail for a unit of normal force, with what friction bears.
double vertical(const PatchResult& p) {
  const double angle = p.patch.frame.angle;
  return std::cos(angle) + (p.load > 0 ? p.forces.fy / p.load : 0) * std::sin(angle);
}

}  // namespace

double vertical_force(const std::vector<PatchResult>& all) {
  double sum = 0;
  for (const PatchResult& p : all) sum += p.load * vertical(p);
  return sum;
}

// The loads at the depth `down`, with the shares that friction bears as they are.
bool Full::press() {
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

// Lowers the wheel until it bears `target` of the load, with the shares that friction bears as they
// are.
bool Full::balance(double tolerance, double target) {
  double last = 0, last_share = 0;
  for (int k = 0; k < 25; ++k) {
    if (!press()) return false;
    const double share = vertical_force(all) / w.input.load;
    if (std::abs(share - target) < tolerance) return true;
    const double depth = std::max(z0 + down - w.touch.z(), 0.0);
    double slope = 1.5 * std::max(share, 0.05) / std::max(depth, 1e-9);
    if (k > 0 && std::abs(down - last) > 1e-12) {
      const double secant = (share - last_share) / (down - last);
      if (secant > 0.3 * slope && secant < 5 * slope) slope = secant;
    }
    last = down, last_share = share;
    down += std::clamp((target - share) / slope, -0.5 * depth - 1e-7, depth + 1e-7);
  }
  return false;
}

// The patches anew, at the depth found; friction as shares of the load as before where they are
// the same patches.
void Full::lower_frames() {
  z0 += down, down = 0;
  std::vector<Patch> anew = patches(w.wheel, w.touch, z0, w.input.patches);
  if (anew.size() != all.size()) all.assign(anew.size(), {});
  for (std::size_t i = 0; i < all.size(); ++i) all[i].patch = std::move(anew[i]);
  cells.clear();
}

void Full::mesh(Index nx, Index ny) {
  for (std::size_t i = 0; i < all.size(); ++i) {
    std::unique_ptr<Cells>& c = i < cells.size() ? cells[i] : cells.emplace_back();
    const contact::Box box = c ? c->around(nx, ny) : all[i].patch.overlap;
    auto finer = std::make_unique<Cells>(w.wheel, w.material.effective_modulus, all[i].patch.frame,
                                         z0, box, nx, ny);
    if (c) finer->pressure = contact::transfer(c->grid, c->pressure, finer->grid);
    c = std::move(finer);
  }
}

void Full::describe() {
  for (std::size_t i = 0; i < all.size(); ++i) {
    cells[i]->describe();
    PatchResult& p = all[i];
    p.p_max = cells[i]->region.p_max, p.area = cells[i]->region.area;
    p.approach = cells[i]->lowered.maxCoeff();
    p.grid = cells[i]->grid, p.pressure = cells[i]->pressure;
  }
}

// Friction on the pressures.
bool Full::roll(std::vector<PatchResult>& on, std::vector<rolling::RollingSeries>& series) {
  for (std::size_t i = 0; i < on.size(); ++i) {
    PatchResult& p = on[i];
    const rolling::RollingCase c = case_of(w, p, z0 + down);
    if (p.friction == 0) {
      p.forces = {};
      continue;
    }
    p.forces = series[i].solve(p.grid, p.pressure, c,
                               {.estimate = false, .solver = {.tolerance = slip_tolerance}},
                               w.material.dissimilarity);
    if (!p.forces.converged) return false;
  }
  return true;
}

// From the changes since the coarse grid, forces and moments as shares of what friction bears.
// Two grids may agree by chance, and both be a part of a cell off at the rows where slip begins:
// no error is less than what cells of this size leave in 95 of 100 contacts.
void Full::state_errors() {
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

void Full::forget_unloaded() {
  for (std::size_t i = all.size(); i-- > 0;)
    if (!(all[i].load > 0)) {
      all.erase(all.begin() + static_cast<std::ptrdiff_t>(i));
      cells.erase(cells.begin() + static_cast<std::ptrdiff_t>(i));
    }
}

bool Full::touches_edge() const {
  return std::ranges::any_of(cells, [](const auto& c) { return c->region.touches_edge(); });
}

// Planes at the depth so far, and the coarse answer.
const char* Full::place_planes() {
  lower_frames();
  mesh(w.input.along / 2, w.input.across / 2);
  if (!balance(1e-3)) return unborne;
  forget_unloaded();
  describe();
  if (rolled_coarse.size() != all.size()) {
    rolled_coarse.clear(), rolled.clear();
    rolled_coarse.resize(all.size());
    if (w.input.friction.largest() > 0 && !roll(all, rolled_coarse)) return unsettled;
    rolled = std::vector<rolling::RollingSeries>(rolled_coarse);
  }
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

// Pressure and friction in turn until the load is met. The depth that balances friction's shares as
// they are is beside the one that balances its own by how friction responds: near Nadal's edge it
// bears nearly as much as the flange presses, and its share falls as the load grows.
const char* Full::settle_friction(double tolerance) {
  double off = 0, change = 0;
  for (int k = 0; w.input.friction.largest() > 0; ++k) {
    if (!roll(all, rolled)) return unsettled;
    const double last = off;
    off = vertical_force(all) / w.input.load - 1;
    if (std::abs(off) < tolerance) break;
    if (k == 15) return "friction and load did not settle";
    if (std::abs(change) > 1e-4) response = std::clamp((off - last) / change, 0.5, 5.0);
    change = -off / response;
    if (!balance(std::max(0.1 * tolerance, 2e-2 * std::abs(off)), 1 + off + change)) return unborne;
    describe();
  }
  return nullptr;
}

const char* Full::solve() {
  down = 0, response = 1;
  cells.clear();
  mesh(w.input.along / 2, w.input.across / 2);
  if (!balance(1e-2)) return unborne;
  const char* failed = place_planes();
  if (!failed) failed = fit_grid();
  if (!failed) failed = settle_friction(1e-3);
  if (!failed) state_errors();
  return failed;
}

const char* Full::solve_again() {
  const char* failed = place_planes();
  if (!failed) failed = fit_grid();
  return failed ? failed : settle_friction(1e-5);
}

const char* Full::solve_nearby() {
  for (std::size_t i = 0; i < all.size(); ++i)
    cells[i]->overlap = overlap(w.wheel, all[i].patch.frame, z0, cells[i]->grid);
  if (!balance(1e-6)) return unborne;
  describe();
  const char* failed = settle_friction(1e-5);
  return !failed && touches_edge() ? "the contact left its grid" : failed;
}

const char* Full::refine() {
  if (w.input.friction.largest() > 0 && (!roll(coarse, rolled_coarse) || !roll(all, rolled)))
    return unsettled;
  state_errors();
  return nullptr;
}

}  // namespace railbook::wheel_contact
