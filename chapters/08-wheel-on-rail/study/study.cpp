/*** # Wheel on rail: what it costs, and where it holds

## Error against run time

Which method gives the largest pressure to one per cent in the least time? **Hertz is the fastest
where it is accurate, and only the full theory shows where that is. So begin with the full theory,
with so many cells that the error which it states is small enough; take Hertz or strips after a
comparison with it**, for instance to fill a table of many positions. The figure
compares them on one wheel, the right one of the benchmark at 3 mm, where the profiles curve evenly
below the patch and suit Hertz:

{{cost}}

On this wheel Hertz does well. {{cost-answer}}
(Hertz's curvatures are found from the same 60 strips.) On the 21 wheels compared on the first page
Hertz is up to {{hertz-pressure}} from CONTACT and the full theory up to {{worst-pressure}}. Creep
forces are not timed here. A vehicle program that asks thousands of times a second looks its forces
up in a table (`railbook wheelrail table`); none of these methods is quick enough to be called each
time.

The reference comes from another solver, CG-FFT of chapter 01. It takes the plane and the normal
load from the full theory with 40 × 40 cells, so it does not test those. Its grids are refined by
$\sqrt2$ each, and the pressure is extrapolated to cells of size zero. It states its own error as
{{reference-error}}; errors in the grey band are too near to that to be told apart.

{{work-precision: cost}}

## Stability

Which poses and loads defeat the solver? Here *holds* means no more than that the solver, which
iterates until it meets the load on the wheel, does so within the bound; the column *error* is that
of the load and says nothing of the pressure. A case is *refused* when the program says why it has
no answer.
Warnings that the program gives about the pressure stand in the column *result*: at 5 mm the grid is
too coarse for it, and at 6.2 mm the overlap of wheel and rail reaches the end of a profile. At 5 mm
one patch is found where the first page has two; yaw, roll and load differ there.

{{stability}}

{{extremes}}

{{fold}}
*/
#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include <railbook/bench/work_precision.hpp>
#include <railbook/contact/cg_fft.hpp>
#include <railbook/report/chapter.hpp>
#include <railbook/rolling/material_pair.hpp>

#include "../case_a.hpp"

using namespace railbook;
using namespace railbook::profiles;
using namespace railbook::wheel_contact;
using namespace railbook::wheel_on_rail_chapter;

namespace {

// The largest pressure between the same surfaces under the same load, by the grids of `contact`.
contact::NormalContact extrapolated(const Wheel& wheel) {
  const WheelResult found = solved(wheel, Method::full);
  const PatchResult& p = found.patches.front();
  const PlacedWheel placed(pair(), pose_of(wheel));
  const WheelInput input = wish_of(wheel, Method::full);
  const auto gap = [&](double x, double y) {
    return p.approach - overlap(placed, p.patch.frame, found.z, x, y);
  };
  const double modulus = rolling::combine(input.wheel, input.rail).effective_modulus;
  const auto best = contact::solve_cg_fft_load(gap, p.load, modulus, {.nx = 256, .ny = 256});
  if (!best.contact.converged) throw std::runtime_error(best.contact.reason);
  return best.contact;
}

// The largest pressure of the right wheel at 3 mm, with cells x cells cells or 60 strips.
bench::Outcome peak(const Wheel& wheel, Method method, long cells) {
  const WheelResult r = solve(wheel, method, cells);
  const double work = method == Method::full ? double(cells * cells) : 60;
  return {{r.patches.front().p_max}, work, r.converged, r.reason};
}

void cost(report::Item& item) {
  item.added("cost of the solvers");
  const Wheel third = wheel_of(item.printed("case-a.csv"), "right", 3);
  const auto method = [&](const char* name, std::vector<int> sizes, Method which) {
    return bench::sweep(name, sizes, [&third, which](int n) {
      return peak(third, which, which == Method::full ? n : 40);
    });
  };
  const auto best = extrapolated(third);
  const std::vector<bench::Method> methods{
      method("full theory", {12, 20, 32, 48}, Method::full)
          .labelled("{0} × {0} cells")
          .counts("cells"),
      method("strips", {60}, Method::strips).labelled("{} strips").counts("strips"),
      method("Hertz", {60}, Method::hertz).labelled("{} strips").counts("strips")};
  const auto points =
      bench::figure(item, {"largest pressure", best.p_max, best.p_max_error}, methods, 0.1);
  item.value("reference-error", 100 * best.p_max_error, "%", "{:.4f}");
  item.value("cost-answer", bench::answer(points, "largest pressure", {1e-2, 2e-3}));
}

report::Found load_kept(const WheelResult& r, double load) {
  if (!r.converged) throw report::NoAnswer(r.reason);
  return {fmt::format("{} patch{}; {}", r.patches.size(), r.patches.size() == 1 ? "" : "es",
                      r.warnings.empty() ? "no warning" : r.warnings.front().text),
          std::abs(r.force.z() / load - 1)};
}

WheelInput wish_of(double load, Method method = Method::full) {
  WheelInput w;
  w.load = load, w.speed = 30, w.angular_velocity = 30 / 0.46, w.method = method;
  w.along = w.across = 24;
  return w;
}

struct Extreme {
  const char *id, *what, *stress;
  Pose pose;
  double load;  // N
  report::Expected expect = report::accurate;
  double apart = 0;  // by how much the rails stand too far apart, m
};
const Extreme extreme_cases[] = {
    {"verge", "50 kN at a shift of 5 mm", "a second place touches", {5e-3, 0, -3.5e-4}, 50e3},
    {"root",
     "100 kN at a shift of 6.2 mm",
     "the root of the flange, nearly conformal",
     {6.2e-3, 0, -1.5e-3},
     100e3},
    {"feather", "1 N on the tread", "a patch of a fifth of a millimetre", {1e-3, 0, 0}, 1},
    {"flange",
     "100 kN on the flange at 8 mm with 40 mrad of yaw",
     "a slender patch, far ahead of the wheel's lowest point",
     {8e-3, 0.04, -8.6e-3},
     100e3},
    {"crush", "10 GN", "sinking in by millimetres", {1e-3, 0, 0}, 1e10, report::refused},
    {"off", "rails 150 mm too far apart", "the end of the tread", {}, 50e3, report::refused, 0.15}};

report::Found found_in(const Extreme& c) {
  ProfilePair profiles = pair();
  profiles.half_spacing -= c.apart / 2;
  return load_kept(solve_wheel(profiles, c.pose, wish_of(c.load)), c.load);
}

void extremes(report::Item& item) {
  item.added("stiff and extreme cases of our own");
  for (const Extreme& c : extreme_cases)
    item.stability({.id = c.id,
                    .what = c.what,
                    .stress = c.stress,
                    .expect = c.expect,
                    .allowed = c.expect == report::refused ? units::nan : 2e-3,
                    .reference = "the load asked for"},
                   [&c] { return found_in(c); });
}

}  // namespace

extern const report::Section study;
const report::Section study{report::figure("cost", cost), report::table("extremes", extremes)};
