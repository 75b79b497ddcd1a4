/*
### `hunting geometry`

Constraint functions, jumps and equivalent conicity of a wheelset on rails, of the paper's pairs or of profiles from
files.

    hunting geometry --pair cn --average 0in
    hunting geometry --wheel wheel.csv --rail rail.csv --gauge 1435mm --gauge-depth 14mm \
                     --radius 460mm --half-spacing 750mm --noise 0.01mm \
                     --end 8mm --step 0.05mm --average 0mm --out mine

With `--out`, the functions go to `wheelset.csv` and its picture, the points that touch to `contacts.csv`, the conicity
against amplitude to `conicity.csv`, the places of two-point contact to `jumps.csv`, and what is printed to
`wheelset.json`.
*/

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "hunting/profile_file.hpp"
#include "table/csv.hpp"
#include "tool/out_folder.hpp"
#include "tool/summary.hpp"
#include "tools.hpp"
#include "units/constants.hpp"
#include "wheelrail/conicity.hpp"

namespace railbook::hunting_tool {

using namespace wheelrail;
using units::millimetre;

namespace {

struct Wish : PairWish {
  tool::Destination out;
};

constexpr double smallest_jump = 1e-4;  // m, along the wheel

// Whole steps up to the table's end; the end itself where that is less than a step.
std::vector<double> amplitudes(const ConstraintFunctions& f, double step) {
  std::vector<double> all;
  for (double A = step; A < f.end() * (1 + 1e-9); A += step) all.push_back(std::min(A, f.end()));
  if (all.empty()) all.push_back(f.end());
  return all;
}

void write_files(tool::OutFolder& out, const Wish& wish, const WheelsetOnTrack& pair,
                 const ConstraintFunctions& f, const std::vector<ContactJump>& jumps,
                 const tool::Summary& answer) {
  std::string text = "x_mm,r_L_mm,r_R_mm,difference_mm,delta_L_rad,delta_R_rad,phi_rad,R,D_rad\n";
  const std::size_t middle = f.r_left.size() / 2;
  for (std::size_t k = 0; k < f.R.values().size(); ++k)
    text += fmt::format("{:.6g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g}\n",
                        f.R.step() * double(k) / millimetre, f.r_left[middle + k] / millimetre,
                        f.r_left[middle - k] / millimetre,
                        (f.r_left[middle + k] - f.r_left[middle - k]) / millimetre,
                        f.delta_left[middle + k], f.delta_left[middle - k], f.Phi.values()[k],
                        f.R.values()[k], f.D.values()[k]);
  out.add("wheelset.csv", text);
  text = "amplitude_mm,conicity,first_harmonic,fitted_line,wavelength_m\n";
  for (const double A : amplitudes(f, 0.1 * millimetre)) {
    const Conicity c = conicity(f, A);
    text += fmt::format("{:.6g},{:.6g},{:.6g},{:.6g},{:.6g}\n", A / millimetre, c.kinematic,
                        c.harmonic, c.regression, c.wavelength);
  }
  out.add("conicity.csv", text);
  text = "x_mm,delta_before_rad,delta_after_rad,r_before_mm,r_after_mm\n";
  for (const auto& jump : jumps)
    text += fmt::format("{:.9g},{:.9g},{:.9g},{:.9g},{:.9g}\n", jump.x / millimetre,
                        jump.before.delta, jump.after.delta, jump.before.radius / millimetre,
                        jump.after.radius / millimetre);
  out.add("jumps.csv", text);
  // Where wheel and rail touch, outward from the middle of the axle and of the track.
  text = "x_mm,wheel_L_mm,rail_L_mm,wheel_R_mm,rail_R_mm,axle_height_mm\n";
  for (std::size_t k = 0; k < f.R.values().size(); ++k) {
    const double x = f.R.step() * double(k);
    const auto at = wish.level ? pair.level_contact(x) : pair.contact(x);
    text += fmt::format("{:.6g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g}\n", x / millimetre,
                        -at.left.on_wheel.u / millimetre, -at.left.on_rail.u / millimetre,
                        -at.right.on_wheel.u / millimetre, -at.right.on_rail.u / millimetre,
                        at.height / millimetre);
  }
  out.add("contacts.csv", text);
  out.add("wheelset.json", answer.json());
  out.figure(tools::scripts("hunting") / "geometry.gp", {"wheelset.csv"}, "wheelset.png");
}

void flag_geometry(tool::Summary& answer, const Wish& wish, const std::vector<ProfileFit>& fits) {
  std::vector<Smoothed> numbers{{"slope_R", "slope of R at the centre", "", 0.1, 0.01}};
  for (const double A : {1.0, 3.0})
    if (A * millimetre <= wish.end)
      numbers.push_back({fmt::format("conicity_at_{:g}_mm", A),
                         fmt::format("conicity at {:g} mm", A), "", 0.05, 0.005});
  flag_smoothing(answer, wish, fits, numbers, [&](const PairWish& w) {
    const ConstraintFunctions f = table_of(read_pair(w).pair, w);
    std::vector<double> values{f.half_spacing * f.R.slope(0)};
    for (const double A : {1.0, 3.0})
      if (A * millimetre <= wish.end) values.push_back(conicity(f, A * millimetre).kinematic);
    return values;
  });
}

void run(const Wish& wish) {
  tool::OutFolder out(wish.out, {"wheelset.csv", "conicity.csv", "jumps.csv", "contacts.csv",
                                 "wheelset.json", "wheelset.png"});
  const auto [pair, fits] = read_pair(wish);
  const ConstraintFunctions f = table_of(pair, wish);
  tool::Summary answer("Wheelset on rails");
  describe_pair(answer, wish, fits);
  flag_geometry(answer, wish, fits);
  const auto centred = pair.contact(0);
  answer.add("contact_mm", "centred contact, from the middle", -centred.left.on_rail.u / millimetre,
             "mm");
  answer.add("delta_rad", "its angle to the axle", centred.left.delta, "rad");
  answer.add("radius_mm", "rolling radius", centred.left.radius / millimetre, "mm");
  answer.add("slope_R", "slope of R at the centre, per x/a", f.half_spacing * f.R.slope(0), "",
             "over the table's first step");
  answer.add("slope_D", "slope of D", f.half_spacing * f.D.slope(0), "rad");
  answer.add("slope_Phi", "slope of the roll angle", f.half_spacing * f.Phi.slope(0), "rad");
  for (const double A : amplitudes(f, millimetre)) {
    const Conicity c = conicity(f, A);
    const std::string at = fmt::format("{:.4g}", A / millimetre);
    if (c.oscillates)
      answer.add("conicity_at_" + at + "_mm", "equivalent conicity at " + at + " mm", c.kinematic,
                 "",
                 fmt::format("first harmonic {:.4f}, fitted line {:.4f}, wavelength {:.2f} m",
                             c.harmonic, c.regression, c.wavelength));
    else
      answer.add("conicity_at_" + at + "_mm", "equivalent conicity at " + at + " mm",
                 "none: the wheelset is not steered back");
  }
  const auto jumps = contact_jumps(pair, -wish.end, wish.end, smallest_jump);
  answer.add(
      "jumps", "two-point contacts", double(jumps.size()), "",
      fmt::format("the left wheel's, jumps of more than {:.1f} mm", smallest_jump / millimetre));
  for (std::size_t i = 0; i < std::min<std::size_t>(jumps.size(), 12); ++i)
    answer.add(fmt::format("jump_{}_mm", i + 1), "  at", jumps[i].x / millimetre, "mm",
               fmt::format("contact angle {:.4f} to {:.4f} rad", jumps[i].before.delta,
                           jumps[i].after.delta));
  answer.print();
  if (out) write_files(out, wish, pair, f, jumps, answer);
  out.commit();
}

std::function<void()> declare(tool::Options& options) {
  const auto wish = std::make_shared<Wish>();
  wish->average = 0;
  add_pair_options(options, *wish);
  options.flag("--level", wish->level,
               "keep the axle from rolling, as EN 15302 does for the conicity");
  options.out(wish->out);
  return [wish] { run(*wish); };
}

}  // namespace

tool::Tool geometry_tool() {
  return {"geometry", "constraint functions and conicity of your own wheel and rail", declare};
}

}  // namespace railbook::hunting_tool
