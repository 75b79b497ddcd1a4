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
#include <string_view>
#include <utility>

#include <railbook/table/csv.hpp>
#include <railbook/tool/digits.hpp>
#include <railbook/tool/out_folder.hpp>
#include <railbook/tool/summary.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/wheelset/conicity.hpp>

#include "hunting/profile_file.hpp"
#include "tools.hpp"

namespace railbook::hunting_tool {

using namespace profiles;
using namespace wheelset;
using units::millimetre;

namespace {

struct Options : PairOptions {
  std::string standard = "none";
  tool::Destination out;
};

constexpr double smallest_jump = 1e-4;  // m, along the wheel

// Whole steps up to where the table ends on one side; the end itself where that is less than a
// step.
std::vector<double> amplitudes(const ConstraintFunctions& f, double step) {
  double end = f.end();
  if (!f.symmetric()) {
    const double centre = conicity(f, 0.01 * f.end()).centre;
    if (!std::isnan(centre)) end -= std::abs(centre);
  }
  std::vector<double> all;
  for (double A = step; A < end * (1 + 1e-9); A += step) all.push_back(std::min(A, end));
  if (all.empty()) all.push_back(end);
  return all;
}

std::string cell(double value) {  // none: empty
  return std::isnan(value) ? "" : fmt::format("{:.6g}", value);
}

void write_files(tool::OutFolder& out, const Options& options, const WheelsetOnTrack& pair,
                 const ConstraintFunctions& f, const std::vector<ContactJump>& jumps,
                 const tool::Summary& answer) {
  std::string text = "x_mm,r_L_mm,r_R_mm,difference_mm,delta_L_rad,delta_R_rad,phi_rad,R,D_rad\n";
  const std::size_t middle = f.r_left.size() / 2;
  // Of a symmetric wheelset to one side only.
  for (std::size_t k = f.symmetric() ? middle : 0; k < f.r_left.size(); ++k) {
    const double x = f.R.step() * (double(k) - double(middle));
    const double r_right = f.symmetric() ? f.r_left[2 * middle - k] : f.r_right[k];
    const double delta_right = f.symmetric() ? f.delta_left[2 * middle - k] : f.delta_right[k];
    const ConstraintValues at = f.at(x);
    text += fmt::format("{:.6g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g}\n",
                        x / millimetre, f.r_left[k] / millimetre, r_right / millimetre,
                        (f.r_left[k] - r_right) / millimetre, f.delta_left[k], delta_right, at.Phi,
                        at.R, at.D);
  }
  out.add("wheelset.csv", text);
  text = "amplitude_mm,conicity,first_harmonic,fitted_line,wavelength_m\n";
  for (const double A : amplitudes(f, 0.1 * millimetre)) {
    const Conicity c = conicity(f, A);
    text += fmt::format("{:.6g},{:.6g},{},{},{:.6g}\n", A / millimetre, c.kinematic,
                        cell(c.harmonic), cell(c.regression), c.wavelength);
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
    const auto at = options.level ? pair.level_contact(x) : pair.contact(x);
    text += fmt::format("{:.6g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g}\n", x / millimetre,
                        -at.left.on_wheel.u / millimetre, -at.left.on_rail.u / millimetre,
                        -at.right.on_wheel.u / millimetre, -at.right.on_rail.u / millimetre,
                        at.height / millimetre);
  }
  out.add("contacts.csv", text);
  out.add("wheelset.json", answer.json());
  out.figure(tools::scripts("hunting") / "geometry.gp", {"wheelset.csv"}, "wheelset.png");
}

// At which shifts of the table the wheelset stands on a suspected place of a profile, in the file's
// own coordinates. A rail is turned by its cant when it is put in its place, which moves a point
// across by less than the margin.
std::string stands_on(const Options& options, const WheelsetOnTrack& pair, const ProfileFit& fit,
                      const PointsWarning& warning) {
  constexpr double margin = millimetre;
  const bool right = std::string_view{fit.what}.starts_with("right");
  const bool wheel = std::string_view{fit.what}.ends_with("wheel");
  const Curve& placed = wheel ? pair.wheel() : pair.rail();
  // Where the file's inner end came to lie.
  const double moved = fit.inner_end - placed.end().u;
  double least = units::infinity, most = -units::infinity;
  for (double x = -options.end; x <= options.end * (1 + 1e-9); x += 0.02 * options.end) {
    const WheelsetContact at = options.level ? pair.level_contact(x) : pair.contact(x);
    if (!at.converged) continue;
    for (const SideContact* side : {&at.left, &at.right}) {
      const bool of_both = !sides_differ(options);
      if (!of_both && (side == &at.right) != right) continue;
      const double u = (wheel ? side->on_wheel.u : side->on_rail.u) + moved;
      if (u < warning.from - margin || u > warning.to + margin) continue;
      least = std::min(least, std::abs(x)), most = std::max(most, std::abs(x));
    }
  }
  if (most < 0) return "";
  return fmt::format("at shifts of {:.1f} to {:.1f} mm", least / millimetre, most / millimetre);
}

void flag_geometry(tool::Summary& answer, const Options& options,
                   const std::vector<ProfileFit>& fits) {
  std::vector<Smoothed> numbers{{"slope_R", "slope of R at the centre", "", 0.1, 0.01}};
  for (const double A : {1.0, 3.0})
    if (A * millimetre <= options.end)
      numbers.push_back({fmt::format("conicity_at_{:g}_mm", A),
                         fmt::format("conicity at {:g} mm", A), "", 0.05, 0.005});
  flag_smoothing(answer, options, fits, numbers, [&](const PairOptions& w) {
    const ConstraintFunctions f = table_of(read_pair(w).pair, w);
    std::vector<double> values{f.half_spacing * f.R.slope(0)};
    for (const double A : {1.0, 3.0})
      if (A * millimetre <= options.end) values.push_back(conicity(f, A * millimetre).kinematic);
    return values;
  });
}

// By Klingel's wavelength; EN 15302 keeps the axle level while it moves, a free one rolls.
void add_conicity(tool::Summary& answer, const Options& options, const ConstraintFunctions& f) {
  const char* axle = options.level ? "level axle" : "rolling axle";
  const auto key_of = [](const std::string& at) { return "conicity_at_" + at + "_mm"; };
  const auto what_of = [&](const std::string& at) {
    return fmt::format("equivalent conicity at {} mm, {}", at, axle);
  };
  bool first = true;
  const auto all = amplitudes(f, millimetre);
  for (const double A : all) {
    const Conicity c = conicity(f, A);
    const std::string at = fmt::format("{:.4g}", A / millimetre);
    if (first && !f.symmetric() && !std::isnan(c.centre))
      answer.add("runs_about_mm", "the wheelset runs about", c.centre / millimetre, "mm",
                 "to the left; amplitudes are about it");
    first = false;
    const std::string key = key_of(at), what = what_of(at);
    std::string note = fmt::format("wavelength {} m", tool::to_text(c.wavelength));
    if (f.symmetric())
      note = fmt::format("first harmonic {}, fitted line {}, {}", tool::to_text(c.harmonic),
                         tool::to_text(c.regression), note);
    if (c.oscillates)
      answer.add(key, what, c.kinematic, "", note);
    else
      answer.add(key, what, "none: the wheelset is not steered back");
  }
  // A wheelset that runs aside of the middle leaves the table at amplitudes within it.
  for (double A = all.back() + millimetre; A < f.end() * (1 + 1e-9); A += millimetre) {
    const std::string at = fmt::format("{:.4g}", A / millimetre);
    answer.absent(key_of(at), what_of(at),
                  "none: the wheelset runs aside, and the table ends before; give a larger --end");
  }
}

// The conicity at 3 mm of EN 15302, and Polach's nonlinearity parameter, (conicity at 4 mm -
// conicity at 2 mm)/2 mm. Neither the standard nor his paper was at hand for the second one.
void add_standard(tool::Summary& answer, const ConstraintFunctions& f) {
  const auto at = [&](double A) { return conicity(f, A * millimetre).kinematic; };
  const double largest = amplitudes(f, millimetre).back() / millimetre;
  if (largest < 4)
    throw InputError(
        fmt::format("amplitude, largest of the table: {:.3g} mm; allowed with --standard: 4 mm or "
                    "more, see --end",
                    largest));
  answer.add("en_15302_conicity", "EN 15302: equivalent conicity at 3 mm", at(3), "", "level axle");
  answer.add("en_15302_nonlinearity_per_mm", "  nonlinearity parameter", 0.5 * (at(4) - at(2)),
             "1/mm", "Polach: (conicity at 4 mm less that at 2 mm)/2 mm");
}

// One wheelset, and what its answer is made of.
struct Solved {
  ReadPair read;
  ConstraintFunctions functions;
  std::vector<ContactJump> jumps;
};
Solved solve(const Options& options) {
  ReadPair read = read_pair(options);
  ConstraintFunctions functions = table_of(read.pair, options);
  auto jumps = contact_jumps(read.pair, -options.end, options.end, smallest_jump);
  return {std::move(read), std::move(functions), std::move(jumps)};
}

tool::Summary answer_of(const Options& options, const Solved& solved) {
  const auto& [read, f, jumps] = solved;
  tool::Summary answer("Wheelset on rails");
  describe_pair(answer, options, read.fits);
  flag_points(answer, read.fits, [&](const ProfileFit& fit, const PointsWarning& warning) {
    return stands_on(options, solved.read.pair, fit, warning);
  });
  flag_geometry(answer, options, read.fits);
  const auto centred = read.pair.contact(0);
  answer.add("contact_mm", "centred contact, from the middle", -centred.left.on_rail.u / millimetre,
             "mm");
  answer.add("delta_rad", "its angle to the axle", centred.left.delta, "rad");
  answer.add("radius_mm", "rolling radius", centred.left.radius / millimetre, "mm");
  answer.add("slope_R", "slope of R at the centre, per x/a", f.half_spacing * f.R.slope(0), "",
             "over the table's first step");
  answer.add("slope_D", "slope of D", f.half_spacing * f.D.slope(0), "rad");
  answer.add("slope_Phi", "slope of the roll angle", f.half_spacing * f.Phi.slope(0), "rad");
  if (options.standard == "en-15302") add_standard(answer, f);
  add_conicity(answer, options, f);
  answer.add(
      "jumps", "two-point contacts", double(jumps.size()), "",
      fmt::format("the left wheel's, jumps of more than {:.1f} mm", smallest_jump / millimetre));
  for (std::size_t i = 0; i < std::min<std::size_t>(jumps.size(), 12); ++i)
    answer.add(fmt::format("jump_{}_mm", i + 1), "  at", jumps[i].x / millimetre, "mm",
               fmt::format("contact angle {} to {} rad", tool::to_text(jumps[i].before.delta),
                           tool::to_text(jumps[i].after.delta)));
  return answer;
}

void run(Options options) {
  const bool standard = options.standard == "en-15302";
  if (standard && options.average > 0)
    throw InputError("average: EN 15302 takes no running mean; leave --average out");
  options.level = options.level || standard;
  if (tools::answer_pairs(options, "geometry",
                          [](const Options& one) { return answer_of(one, solve(one)); }))
    return;
  tool::OutFolder out(options.out, {"wheelset.csv", "conicity.csv", "jumps.csv", "contacts.csv",
                                    "wheelset.json", "wheelset.png"});
  const Solved solved = solve(options);
  const tool::Summary answer = answer_of(options, solved);
  answer.print();
  if (out) write_files(out, options, solved.read.pair, solved.functions, solved.jumps, answer);
  out.commit();
}

std::function<void()> declare(tool::OptionParser& parser) {
  const auto options = std::make_shared<Options>();
  options->average = 0;
  add_pair_options(parser, *options, true);
  tools::add_right_options(parser, *options);
  parser.flag("--level", options->level,
              "keep the axle from rolling, as EN 15302 does for the conicity");
  parser.choice("--standard", options->standard, {"none", "en-15302"},
                "en-15302: the axle level, the conicity at 3 mm, and the nonlinearity parameter");
  parser.out(options->out);
  parser.help(
      "x is the wheelset's displacement to the left, L its left wheel and R its right one. "
      "wheelset.csv: rolling radii r, their difference left less right, contact angles delta to "
      "the axle, phi the roll of the axle, positive with the left side up, R half the difference "
      "of the radii over half the spacing, D half the difference of the angles. contacts.csv: "
      "where wheel and rail touch, outward from the middle of the axle and of the track. "
      "jumps.csv: "
      "delta_before, delta_after, r_before and r_after are the left wheel's angle and radius "
      "before "
      "and after, as it goes to the left. conicity.csv: amplitude of the wheelset, conicity by the "
      "chosen rule, by the first_harmonic of the difference of radii and by a fitted_line, and the "
      "wavelength of the motion. r_L, r_R, delta_L and delta_R are of the left and right wheel, "
      "wheel_L and rail_L where they touch, axle_height that of the axle's middle. Of several "
      "wheels "
      "or rails: geometry-table.csv and .jsonl, a row a pair.");
  return [options] { run(*options); };
}

}  // namespace

tool::Tool geometry_tool() {
  return {"geometry", "constraint functions and conicity of your own wheel and rail", declare};
}

}  // namespace railbook::hunting_tool
