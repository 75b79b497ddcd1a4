#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <utility>

#include <railbook/contact/cg_fft.hpp>
#include <railbook/contact/hertz.hpp>
#include <railbook/profiles/measured_curve.hpp>
#include <railbook/rolling/kalker_coefficients.hpp>
#include <railbook/rolling/parts.hpp>
#include <railbook/rolling/theory.hpp>
#include <railbook/rolling/transient.hpp>
#include <railbook/table/csv.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/wheel_contact/wheel.hpp>
#include <railbook/wheelset/conicity.hpp>
#include <railbook/wheelset/tabulate.hpp>

#include "verify/references.hpp"

namespace railbook::verify_tool {
namespace {

template <class Result>
Result converged(Result result) {
  if (!result.converged) throw std::runtime_error("did not converge: " + result.reason);
  return result;
}

// The last result, for numbers of one solution that follow one another.
template <class Result, class Solve>
std::function<Result(const At&)> keeping(Solve solve) {
  auto kept = std::make_shared<std::pair<std::vector<std::string>, Result>>();
  return [kept, solve](const At& at) {
    if (kept->first != at.words || at.words.empty()) *kept = {at.words, solve(at)};
    return kept->second;
  };
}

// A sphere of a radius on a plane, by cells.
contact::NormalContact sphere(const At& at) {
  const double curvature = 1 / (2 * at[0]);
  return converged(
      contact::solve_cg_fft(contact::quadratic_gap({curvature, curvature, 0}), at[2], at[1])
          .contact);
}

// Carter's plane problem: one row of an ellipse 1e6 times as wide as long, G = 1, nu = 0: E* = 1.
struct Row {
  double force = 0, stick = 0;
};
Row carter(const At& at) {
  using namespace rolling;
  constexpr double ratio = 2.5e-6;
  constexpr Eigen::Index cells = 200;
  const RollingGrid grid = ellipse_grid(ratio, cells, 1, true);
  const double half = std::sqrt(ratio * 2 / 3), width = grid.mesh.dy[0];
  const double creepage = at[0] * 4 / (units::pi * half * width);
  const TangentialInfluence influence(grid.mesh, 0, true);
  const StickSlip s =
      solve_stick_slip(influence, grid.mesh, grid.bound, rigid_slip(grid.mesh, {creepage, 0, 0}));
  if (!s.converged) throw std::runtime_error("Carter's row did not converge");
  const auto sticking = std::ranges::count(s.slides, false);
  return {resultants(grid.mesh, s.p).fx, static_cast<double>(sticking) / double(cells)};
}

// Cattaneo's and Mindlin's: spheres at rest under a share at[0] of the friction. The shift is over
// that at which all slides.
struct Shift {
  double stick = 0, motion = 0;
};
Shift cattaneo(const At& at) {
  constexpr Eigen::Index n = 47;
  constexpr double poisson = 0.28, friction = 0.4, half = 1.1;
  const contact::Grid grid{-half, -half, 2 * half / double(n), 2 * half / double(n), n, n};
  const contact::HertzContact hertz =
      contact::hertz_from_force({0.01, 0.01, 0}, 1 / (1 - poisson), 1);
  Eigen::VectorXd pressure(grid.cells());
  for (Eigen::Index j = 0; j < n; ++j)
    for (Eigen::Index i = 0; i < n; ++i)
      pressure[j * n + i] =
          contact::hertz_pressure(hertz, grid.x(i) * hertz.a, grid.y(j) * hertz.a);
  const double load = pressure.sum() * grid.dx * grid.dy;
  rolling::Transient contact(grid, pressure, {1, 1, load, 1, poisson, friction, {}});
  const auto step = contact.shift_for(at[0] * friction * load);
  converged(step.forces);
  const double all = 3 * (2 - poisson) * friction * load / 8;
  return {step.forces.tractions.stick.sum() / static_cast<double>((pressure.array() > 0).count()),
          step.motion / all};
}

double full_force(const At& at) {
  static const rolling::Solver solve = rolling::solver("full", 1.568, 0.3, 48);
  const auto c =
      rolling::with_reduced_creepage(rolling::normalised_case(1.568, 0.3), {at[0], 0, 0});
  return converged(solve(c)).fx;
}

// A wheel of the Manchester benchmark, case A2.2: side, shift [mm], roll [urad] and angular
// velocity.
struct Wheel {
  wheel_contact::PatchResult patch;
  double side = 1;
};
Wheel benchmark(const At& at) {
  using namespace wheel_contact;
  static const ProfilePair pair = s1002_on_60e1(1.0 / 40, profiles::Rail60::benchmark);
  WheelInput input;
  input.load = 10e3, input.speed = 2, input.angular_velocity = at[3];
  input.wheel = input.rail = {2 * 82e9 * 1.28, 0.28};
  const Pose pose{1e-3 * at[1], 2.4e-3 * at[1], 1e-6 * at[2]};
  const bool right = at.words[0] == "right";
  const WheelResult r = converged(solve_wheel(pair, right ? pose : mirrored(pose), input));
  if (r.patches.size() != 1)
    throw std::runtime_error(std::to_string(r.patches.size()) + " patches bear load, not one");
  return {r.patches.front(), right ? 1.0 : -1.0};
}

profiles::Curve profile(const std::filesystem::path& file) {
  std::vector<profiles::Point> points;
  table::CsvReader reader(file);
  while (reader.next())
    points.push_back({-0.75 - 1e-3 * reader.number(0), 1e-3 * reader.number(1)});
  return profiles::measured_curve(std::move(points), 1e-6).curve;
}

}  // namespace

Quantities solvers(const std::filesystem::path& data) {
  const auto by_row = keeping<Row>(carter);
  const auto by_shift = keeping<Shift>(cattaneo);
  const auto by_cells = keeping<contact::NormalContact>(sphere);
  const auto by_wheel = keeping<Wheel>(benchmark);
  const auto coefficients = keeping<rolling::ComputedCoefficients>(
      [](const At& at) { return rolling::kalker_coefficients(at[0], at[1]); });
  // EN 15302 keeps the axle level.
  const auto weave = keeping<wheelset::ConstraintFunctions>([data](const At& wheel) {
    return wheelset::tabulate(
        wheelset::with_radius(profile(data / ("profile-wheel-" + wheel.words[0] + ".csv")),
                              profile(data / "profile-rail-a.csv"), 0.46),
        {.half_spacing = 0.75, .end = 6.5e-3, .step = 0.05e-3, .level = true});
  });
  const auto conicity = [=](const char* wheel, const At& at) {
    return wheelset::conicity(weave({{wheel}}), 1e-3 * at[0]).kinematic;
  };
  return {
      {"sphere-force", [=](const At& at) { return by_cells(at).force; }},
      {"sphere-pressure", [=](const At& at) { return by_cells(at).p_max; }},
      {"carter-force", [=](const At& at) { return by_row(at).force; }},
      {"carter-stick", [=](const At& at) { return by_row(at).stick; }},
      {"cattaneo-stick", [=](const At& at) { return by_shift(at).stick; }},
      {"cattaneo-shift", [=](const At& at) { return by_shift(at).motion; }},
      {"full-force", full_force},
      {"c11", [=](const At& at) { return coefficients(at).c11; }},
      {"c22", [=](const At& at) { return coefficients(at).c22; }},
      {"c23", [=](const At& at) { return coefficients(at).c23; }},
      {"c33", [=](const At& at) { return coefficients(at).c33; }},
      {"wheel-normal", [=](const At& at) { return by_wheel(at).patch.load; }},
      {"wheel-p-max", [=](const At& at) { return by_wheel(at).patch.p_max / 1e6; }},
      {"wheel-approach", [=](const At& at) { return by_wheel(at).patch.approach / 1e-6; }},
      {"wheel-fx", [=](const At& at) { return by_wheel(at).patch.forces.fx; }},
      {"wheel-fy", [=](const At& at) { return by_wheel(at).side * by_wheel(at).patch.forces.fy; }},
      {"conicity", [=](const At& at) { return conicity("a", at); }},
      {"conicity-b", [=](const At& at) { return conicity("b", at); }},
      {"conicity-h", [=](const At& at) { return conicity("h", at); }},
      {"conicity-i", [=](const At& at) { return conicity("i", at); }},
  };
}

}  // namespace railbook::verify_tool
