// Chapter 3: creep forces of the rig's ellipse, by FASTSIM and by the full theory.
#include <array>
#include <cmath>
#include <memory>

#include <railbook/contact/hertz.hpp>
#include <railbook/contact/material.hpp>
#include <railbook/rolling/contact.hpp>
#include <railbook/rolling/fastsim.hpp>
#include <railbook/units/constants.hpp>

#include "live.hpp"

namespace railbook::live {
namespace {

using namespace rolling;

constexpr contact::Material steel{207e9, 0.3};

// The rig's rollers at the load of Appendix B: the profile of the small one makes the ellipse
// 1.568 times as long along rolling as across (rig.cpp).
constexpr double load = 1000 * 0.45359 * 9.81, axis_ratio = 1.568;
constexpr double rolling_radius = 1 / (2 / 0.201097 + 2 / 0.898957);

contact::HertzContact rig_ellipse() {
  const double log_m1 = -2 * std::log(axis_ratio);
  const auto integrals = contact::elliptic_integrals(log_m1);
  const double ratio = integrals.b / (std::exp(log_m1) * integrals.d);
  return contact::hertz_from_force({.a = 0.5 / rolling_radius, .b = 0.5 * ratio / rolling_radius},
                                   contact::effective_modulus(steel, steel), load);
}

RollingCase case_of(const Inputs& in) {
  return {.a = in["a"],
          .b = in["b"],
          .load = in["load"],
          .shear_modulus = steel.shear_modulus(),
          .poisson = steel.poisson,
          .friction = in["friction"],
          .creepage = {}};
}

// Solves one case; what a shape needs is made once.
class Solver {
 public:
  explicit Solver(const Inputs& in)
      : full_(in.whole("theory") == 1), along_(in.whole("along")), rows_(in.whole("rows")) {}

  CreepForces solve(const RollingCase& c) const {
    if (!full_)
      return fastsim_grid(c, kalker_table(c.a / c.b, c.poisson),
                          {.along = along_, .strips = rows_, .keep_tractions = true});
    static std::unique_ptr<EllipseRolling> kept;
    static std::array<double, 3> shape{};
    const std::array<double, 3> wanted{c.a / c.b, double(along_), double(rows_)};
    if (kept == nullptr || shape != wanted) {
      kept = std::make_unique<EllipseRolling>(wanted[0], c.poisson,
                                              RollingOptions{.along = along_, .rows = rows_});
      shape = wanted;
    }
    return kept->solve(c);
  }

 private:
  bool full_;
  int along_, rows_;
};

void rolling_answer(const Inputs& in, Answer& out) {
  RollingCase c = case_of(in);
  c.creepage = {in["creep"], in["lateral"], in["spin"]};
  const CreepForces f = Solver(in).solve(c);
  out.value("fx", f.fx);
  out.value("fy", f.fy);
  out.value("mz", f.mz);
  out.value("limit", c.friction * c.load);
  out.value("stick_share", f.stick_share);
  out.value("converged", f.converged ? 1 : 0);
  const Creepage reduced = reduced_creepage(c);
  out.value("reduced", reduced.longitudinal);
  out.value("reduced_lateral", reduced.lateral);
  out.value("reduced_spin", reduced.spin);
  out.table("cells", {"x", "y", "dx", "dy", "px", "py", "bound", "stick"});
  const Tractions& t = f.tractions;
  for (Eigen::Index i = 0; i < t.x.size(); ++i)
    out.row({t.x[i], t.y[i], t.dx[i], t.dy[i], t.px[i], t.py[i], t.bound[i], t.stick[i]});
}

void creep_curve(const Inputs& in, Answer& out) {
  const RollingCase at = case_of(in);
  const Solver solver(in);
  const int points = in.whole("points");
  out.table("curve", {"reduced", "creep", "fx", "fy"});
  for (int i = 0; i <= points; ++i) {
    const double x = in["to"] * i / points;
    RollingCase c = with_reduced_creepage(at, {x, 0, 0});
    c.creepage.lateral = in["lateral"];
    c.creepage.spin = in["spin"];
    const CreepForces f = solver.solve(c);
    out.row(
        {x, c.creepage.longitudinal, f.fx / (c.friction * c.load), f.fy / (c.friction * c.load)});
  }
}

std::vector<Input> with_contact(std::vector<Input> inputs, double along, double rows) {
  const contact::HertzContact rig = rig_ellipse();
  inputs.insert(inputs.end(), {{"theory", "", 0, 0, 1},
                               {"lateral", "", 0, -0.05, 0.05},
                               {"spin", "1/m", 0, -100, 100},
                               {"a", "m", rig.a, 1e-4, 0.02},
                               {"b", "m", rig.b, 1e-4, 0.02},
                               {"load", "N", load, 10, 300e3},
                               {"friction", "", 0.3, 0.01, 1},
                               {"along", "", along, 4, 64},
                               {"rows", "", rows, 3, 64}});
  return inputs;
}

}  // namespace

std::span<const Function> creep_functions() {
  static const std::array<Function, 2> all{
      {{"rolling", nullptr, with_contact({{"creep", "", 0.001, -0.05, 0.05}}, 24, 15),
        rolling_answer},
       {"creep_curve", nullptr,
        with_contact({{"points", "", 40, 4, 200}, {"to", "", 2, 0.1, 20}}, 24, 15), creep_curve}}};
  return all;
}

}  // namespace railbook::live
