/*** ## Short waves: the wheel force

A level that stays at 1.6 cm down to any wavelength would pass a 1.6-cm step every half metre. What such waves do is load
the contact. The force on the wheel set is $g=m\ddot z-b\dot x-kx$, equation (2). Eliminating $x$ gives the paper's (5), and (6) for a sine. We evaluate it as

$$\frac GZ=-(2\pi f)^2\left(m+M\frac YZ\right),\qquad \frac YZ=\frac{1+2i\rho\eta}{1-\eta^2+2i\rho\eta},$$

which says what it is: the wheel mass and as much of the body as moves along, each times its acceleration. The printed (6) divides by $m$ on the way
($r=M/m$) and is $0\cdot\infty$ for a wheel without mass. Together with the static load the force shall stay below 143 kN.

{{fig-06}}

All vehicle data are ours here; the paper prints none. Its claim that these curves do not cross holds for them: crossing means a gain $|G/Z|$
that falls with frequency somewhere. Whether it does is the sign of a quartic in $\eta^2$, and the least damping that prevents it depends on $r$ alone:

{{table-damping}}

With the damping of the roll example, 0.2, none of these cars would have curves that do not cross; the paper must have used more in this mode.
Where they cross, the envelope is again the curve at full speed, or the peak once passed, whichever demands more.

The force that is left for the track is 143 kN less the static load: {{margin-A}} for car A, {{margin-B}} for the loaded 70-ton car B. The
loaded 100-ton car C has nothing left: its static {{static-C}} exceed the limit. The answer then is not a negative
amplitude but *{{refusal-C}}*.
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "items.hpp"
#include "num/log_spaced.hpp"
#include "units/input_error.hpp"

namespace railbook::quality_chapter {

using namespace railbook;
using quality::allowed_amplitude;

namespace {

void fig_06(report::Item& item) {
  const table::CsvTable printed = item.printed("printed.csv");
  const quality::ForceLimit A = car(item, "A"), B = car(item, "B"), C = car(item, "C");
  item.expect_checks(4);
  auto& data = item.data({"speed_kmh", "wavelength_m", "amplitude_cm"});
  for (const double v : speeds(item)) {
    for (const double w : num::log_spaced(0.5, 1000, 60))
      data.add(v / kmh, w, allowed_amplitude(severity(A, v, 1 / w)) / cm);
    data.gap();
  }
  item.check_text("cross", "do curves of different speeds cross",
                  printed.at("cross-force", "printed"),
                  quality::force_peak(A.car).found ? "yes" : "no");
  const auto power = [&](double w) {
    const auto log_amplitude = [&](double x) {
      return std::log(allowed_amplitude(severity(A, track_speed, 1 / x)));
    };
    return (log_amplitude(1.01 * w) - log_amplitude(w / 1.01)) / (2 * std::log(1.01));
  };
  item.row(printed, "tail-short")
      .check("printed", power(0.05),
             report::absolute(0.01, "at 5 cm; at 0.5 m the suspension still shows"));
  const double rate = 2 * units::pi * track_speed;
  const auto limit = [&](double mass, double w) {
    return force_margin(A) * w * w / (mass * rate * rate);
  };
  item.agree("short", "amplitude at 1 mm wavelength", "m",
             allowed_amplitude(severity(A, track_speed, 1e3)), limit(A.car.wheel, 1e-3), 1e-5,
             "the wheel mass alone");
  item.agree("long", "amplitude at 100 km wavelength", "m",
             allowed_amplitude(severity(A, track_speed, 1e-5)),
             limit(A.car.wheel + A.car.body, 1e5), 1e-5, "the whole mass");
  item.value("margin-A", force_margin(A) / kN, "kN", "{:.1f}");
  item.value("margin-B", force_margin(B) / kN, "kN", "{:.1f}");
  item.value("static-C", static_force(C.car) / kN, "kN", "{:.1f}");
  std::string refusal = "an amplitude";
  try {
    static_cast<void>(force_margin(C));
  } catch (const InputError& error) {
    refusal = std::string{error.what()}.substr(0, std::string{error.what()}.find(':'));
  }
  item.value("refusal-C", refusal);
  item.reconstructed("masses, spring, damper and speeds are ours (car A); the paper prints none");
}

// Does |G/Z| ever fall between neighbouring points of a fine grid? No closed form in it.
bool falls(double mass_ratio, double damping) {
  const quality::Car car = quality::make_car(1, mass_ratio, {1, damping});
  double last = 0;
  for (double f = 0.2; f < 200; f *= 1.0005) {
    const double gain = std::abs(quality::force_gain(car, f));
    if (gain < last) return true;
    last = gain;
  }
  return false;
}

void table_damping(report::Item& item) {
  item.columns(
      {"M/m", "least damping ρ without crossing", "search at ρ − 0.002", "search at ρ + 0.002"});
  const std::vector<double> ratios{2, 5, 8.75, 14.6, 20, 100};
  item.expect_checks(2 * static_cast<int>(ratios.size()) + 1);
  double least = 1;
  for (const double r : ratios) {
    const double bound = quality::least_damping_without_peak(r);
    least = std::min(least, bound);
    if (r == 8.75) item.value("damping-A", bound, "", "{:.3f}");
    const auto answer = [&](double damping) { return falls(r, damping) ? "crosses" : "does not"; };
    item.check_text(fmt::format("below-{:g}", r),
                    fmt::format("M/m = {:g}, a little less damping", r), "crosses",
                    answer(bound - 0.002));
    item.check_text(fmt::format("above-{:g}", r),
                    fmt::format("M/m = {:g}, a little more damping", r), "does not",
                    answer(bound + 0.002));
    item.add_row({fmt::format("{:g}", r), fmt::format("{:.4f}", bound), answer(bound - 0.002),
                  answer(bound + 0.002)});
  }
  item.check("least", "least of these bounds; above the damping of the roll mode", "", "0.2", least,
             report::at_least("the damping the paper prints, for the roll mode"));
  item.reconstructed("the paper states that its curves do not cross, not when");
}

}  // namespace

void add_force(report::Chapter& chapter) {
  chapter.figure("fig-06", "Figure 6. Allowed amplitude by track speed, wheel-force mode", fig_06);
  chapter.table("table-damping", "Damping from which the curves of the force mode do not cross",
                table_damping);
}

}  // namespace railbook::quality_chapter
