#include "wheels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <railbook/rolling/contact.hpp>
#include <railbook/rolling/material_pair.hpp>
#include <railbook/rolling/theory.hpp>
#include <railbook/table/csv.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/wheel_contact/wheel.hpp>

namespace railbook::peer_bank {

using namespace railbook::wheel_contact;

namespace {

long cells_of(double length) {
  return std::clamp(std::lround(length / (0.2 * mm)), 8L, 128L);
}

// The creep forces of a patch on cells that just fill it, with the spin a sixth of a cell ahead of
// their middles, as the bank has them.
rolling::CreepForces first_order(const PatchResult& p, const WheelInput& input) {
  const auto steel = rolling::combine(input.wheel, input.rail);
  rolling::RollingCase c;
  c.shear_modulus = steel.shear_modulus, c.poisson = steel.poisson, c.friction = p.friction;
  c.creepage = p.creepage;
  c.creepage.lateral -= c.creepage.spin * p.grid.dx / 3;
  return rolling::solve_rolling(p.grid, p.pressure, c, {.remedy = false, .estimate = false});
}

}  // namespace

WheelAnswers answer_wheels(const std::string& file) {
  const ProfilePair pair = s1002_on_60e1(1.0 / 40, profiles::Rail60::benchmark);
  table::CsvReader csv(file);
  const auto at = [&](const char* column) { return csv.number(csv.column(column)); };
  WheelAnswers out;
  while (csv.next()) {
    const std::string name(csv.cell(csv.column("file")));
    const int number = int(at("case"));
    const double side = csv.cell(csv.column("side")) == "right" ? 1 : -1;
    Pose pose{at("y_mm") * mm, 1e-3 * at("yaw_mrad"), 1e-6 * at("roll_urad")};
    if (side < 0) pose = mirrored(pose);
    WheelInput input;
    input.load = at("load_N"), input.speed = 2;
    input.angular_velocity = at("angular_velocity_rad_per_s");
    input.wheel = input.rail = {2 * 82e9 * 1.28, 0.28};
    input.along = input.across = 64;
    const WheelResult fine = solve_wheel(pair, pose, input);
    if (!fine.converged)
      throw std::runtime_error(fmt::format("{} {}: {}", name, number, fine.reason));
    const PatchResult& f = fine.patches.front();
    if (fine.patches.size() > 1) continue;  // one plane for both areas there, two planes here
    ++out.answered;
    const contact::Box& box = f.patch.overlap;
    input.along =
        cells_of(0.7 * (box.x_max - box.x_min));  // a Hertzian patch is 0.7 of its overlap
    input.across = cells_of(0.7 * (box.y_max - box.y_min));
    const WheelResult same = solve_wheel(pair, pose, input);
    if (!same.converged)
      throw std::runtime_error(fmt::format("{} {}: {}", name, number, same.reason));
    const PatchResult& s = same.patches.front();
    const rolling::CreepForces forces = first_order(s, input);
    const double bound = 0.3 * f.load, moment = bound * std::sqrt(f.area / units::pi);
    const auto compare = [&](const char* quantity, double theirs, double ours, double finer,
                             double largest) {
      out.comparisons.push_back(
          {name, number, quantity, theirs, ours, finer, std::abs(theirs) < 0.02 * largest});
    };
    compare("normal force", at("normal_N"), s.load, f.load, 0);
    compare("approach", at("approach_mm"), s.approach / mm, f.approach / mm, 0);
    compare("largest pressure", at("p_max_MPa"), s.p_max / mpa, f.p_max / mpa, 0);
    compare("contact area", at("contact_cells") * 0.04, s.area / (mm * mm), f.area / (mm * mm), 0);
    compare("longitudinal force", at("fx_N"), forces.fx, f.forces.fx, bound);
    compare("lateral force", at("fs_N"), side * forces.fy, side * f.forces.fy, bound);
    compare("moment", at("mn_Nmm"), side * forces.mz / mm, side * f.forces.mz / mm, moment / mm);
    compare("stick area", at("stick_cells") / at("contact_cells"), forces.stick_share,
            f.forces.stick_share, 1);
    compare("power of friction", -at("power_W"), 2 * s.wear_number, 2 * f.wear_number, 0.02);
  }
  return out;
}

}  // namespace railbook::peer_bank
