/*** # Wheel on rail: what it costs, and where it holds

## Error against run time

Which method gives the largest pressure to one per cent in the least time?

{{cost}}

{{cost-answer}} This is the right wheel of the benchmark at 3 mm, where the profiles curve evenly below the
patch and suit Hertz. On the 21 wheels compared on the first page Hertz is up to {{hertz-pressure}} from
CONTACT and the full theory up to {{worst-pressure}}. **Take the full theory where it is not known that the
profiles curve evenly**, and strips or Hertz for tables of positions that have been compared with it.

The reference comes from another solver, CG-FFT of chapter 01, on the plane and under the normal load that
the full theory finds with 40 × 40 cells. Its grids become finer by $\sqrt2$ and are extrapolated to cells
of no size. It states its own error as {{reference-error}}; errors in the grey band are less than a hundred
times that.

{{work-precision: cost}}

## Stability

Which poses and loads defeat the solver? A case *holds* when its error stays within the bound set for it,
and is *refused* when the program says why it has no number. The error is that of the load only; what a
result says of its own pressures stands beside it.

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

void cost(report::Item& item) {
  item.added("cost of the solvers");
  const Wheel third = wheel_of(item.printed("case-a.csv"), "right", 3);
  const auto peak = [&](Method method, long cells) {
    const WheelResult r = solve(third, method, cells);
    return bench::Outcome{{r.patches.front().p_max},
                          method == Method::full ? double(cells * cells) : 60,
                          r.converged,
                          r.reason};
  };
  const auto best = extrapolated(third);
  const std::vector<bench::Method> methods{
      bench::sweep("full theory", {12, 20, 32, 48}, [&](int n) { return peak(Method::full, n); })
          .labelled("{0} x {0} cells")
          .counts("cells"),
      bench::sweep("strips", {60}, [&](int) { return peak(Method::strips, 40); })
          .labelled("{} strips")
          .counts("strips"),
      bench::sweep("Hertz", {60}, [&](int) { return peak(Method::hertz, 40); })
          .labelled("{} strips")
          .counts("strips")};
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

void extremes(report::Item& item) {
  item.added("stiff and extreme cases of our own");
  const auto at = [&](const char* id, const char* what, const char* stress, const Pose& pose,
                      double load, report::Expected stands) {
    item.stability({.id = id,
                    .what = what,
                    .stress = stress,
                    .expect = stands,
                    .allowed = stands == report::refused ? units::nan : 2e-3,
                    .reference = "the load asked for"},
                   [=] { return load_kept(solve_wheel(pair(), pose, wish_of(load)), load); });
  };
  at("verge", "50 kN at a shift of 5 mm", "a second place touches", {5e-3, 0, -3.5e-4}, 50e3,
     report::accurate);
  at("root", "100 kN at a shift of 6.2 mm", "the root of the flange, nearly conformal",
     {6.2e-3, 0, -1.5e-3}, 100e3, report::accurate);
  at("feather", "1 N on the tread", "a patch of a fifth of a millimetre", {1e-3, 0, 0}, 1,
     report::accurate);
  at("flange", "100 kN on the flange at 8 mm with 40 mrad of yaw", "a slender patch far ahead",
     {8e-3, 0.04, -8.6e-3}, 100e3, report::accurate);
  at("crush", "10 GN", "sinking in by millimetres", {1e-3, 0, 0}, 1e10, report::refused);
  item.stability({.id = "off",
                  .what = "rails 150 mm too far apart",
                  .stress = "the end of the tread",
                  .expect = report::refused},
                 [] {
                   ProfilePair wide = pair();
                   wide.half_spacing -= 0.075;
                   return load_kept(solve_wheel(wide, {}, wish_of(50e3)), 50e3);
                 });
}

}  // namespace

extern const report::Section study;
const report::Section study{
    report::figure("cost",
                   "Where the profiles suit Hertz, his formulas are the fastest. Error of the "
                   "largest pressure against run time, for all three methods, right wheel at 3 mm; "
                   "the best stands at the lower left.",
                   cost),
    report::table("extremes",
                  "All loads from 1 N to 100 kN are met, and what cannot be is refused. Stiff and "
                  "extreme cases",
                  extremes)};
