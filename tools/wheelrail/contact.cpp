/*
### `wheelrail contact`

One position of a wheelset on its rails, from the profiles to the creep forces: where each wheel touches, the patches with
their own angles, pressures, creepages, forces on the rail in the track's axes (x forward, y right, z down), wear number,
stick, the largest traction; with the full theory also the largest von Mises and shear stress in rail and wheel, and how deep they lie.

    wheelrail contact --shift 4mm --yaw 5mrad --load 50kN --speed 30m/s --out mine
    wheelrail contact --wheel wheel.csv --rail rail.csv --load 80kN --speed 20m/s --slip 0.002 --roll 0mrad

The wheelset turns freely and rolls until both wheels stand at one height, unless `--slip` or `--roll` say otherwise.
`--out` adds the cells with their pressures, tractions and the largest von Mises stress in the rail below each, the answer as JSON, and a
figure: the sections with their patches, and the pressures seen from above. The JSON of the full theory says with
`model_error_...` how far this program is from CONTACT over that program's test bank: mean (`bias`) and standard deviation
(`scatter`) of ln(ours/theirs), the mean with ours for cells of no size (`limit`), and the number of values behind them (`count`). Warnings are printed above the answer: the verge of a second contact, areas that share a frame, a conformal patch. A wheel that
touches at the end of a profile is refused.
*/

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <tuple>

#include <railbook/tool/out_folder.hpp>
#include <railbook/tool/summary.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/units/warning.hpp>
#include <railbook/wheel_contact/model_error.hpp>

#include "tools.hpp"
#include "wheelrail/contact_drawing.hpp"
#include "wheelrail/pair.hpp"

namespace railbook::wheelrail_tool {

using namespace profiles;
using namespace wheel_contact;
using units::millimetre;

namespace {

struct Options : PairOptions {
  double shift = 0, yaw = 0, load = 0, friction = 0.3;
  std::optional<double> roll, slip;
  tool::Destination out;
};

WheelInput options_of(const Options& options) {
  WheelInput w = wheel_input(options);
  w.load = options.load, w.friction.coefficient = options.friction;
  return w;
}

WheelsetResult solve(const Options& options, const ReadPair& read) {
  WheelInput w = options_of(options);
  const Pose pose{options.shift, options.yaw, options.roll.value_or(0)};
  if (!options.roll && !options.slip) return solve_wheelset(read.left, read.right, pose, w);
  if (!options.roll || !options.slip)
    throw InputError{"give both roll and slip, or neither for a wheelset free to roll and turn"};
  WheelsetResult r;
  r.pose = pose;
  r.angular_velocity = w.angular_velocity = options.speed / read.radius() * (1 + *options.slip);
  r.left = solve_wheel(read.left, mirrored(pose), w);
  r.right = solve_wheel(read.right, pose, w);
  r.converged = r.left.converged && r.right.converged;
  r.reason = r.left.converged ? r.right.reason : r.left.reason;
  return r;
}

// On which wheels a patch lies on a suspected place of the wheel's profile.
std::string sides_on(const Options& options, const WheelsetResult& r,
                     const profiles::ProfileFit& fit, const profiles::PointsWarning& warning) {
  std::string sides;
  for (const auto& [name, side, wheel, shift] :
       {std::tuple{"left", tools::Side::left, &r.left, -options.shift},
        {"right", tools::Side::right, &r.right, options.shift}})
    if (stands_on(options, side, *wheel, shift, fit, warning))
      sides += fmt::format("{}on the {}", sides.empty() ? "" : " and ", name);
  return sides;
}

// How far the pressures and forces of a wheel's patches stand on the smoothing of its profiles.
struct ProfileError {
  double p_max = 0, force = 0;  // [Pa], [N]
  double x = 0, y = 0;          // of the patch's place [m]
};
std::vector<ProfileError> profile_errors(const Options& options, const ReadPair& half,
                                         const WheelsetResult& r, const WheelResult& wheel,
                                         bool left) {
  WheelInput w = options_of(options);
  w.angular_velocity = r.angular_velocity;
  std::vector<ProfileError> errors(
      wheel.patches.size(), {units::infinity, units::infinity, units::infinity, units::infinity});
  try {
    const WheelResult other =
        solve_wheel(left ? half.left : half.right, left ? mirrored(r.pose) : r.pose, w);
    if (!other.converged || other.patches.size() != errors.size()) return errors;
    for (std::size_t k = 0; k < errors.size(); ++k) {
      const PatchResult &a = wheel.patches[k], &b = other.patches[k];
      errors[k] = {2 * std::abs(a.p_max - b.p_max),
                   2 * std::hypot(a.forces.fx - b.forces.fx, a.forces.fy - b.forces.fy),
                   2 * std::abs(a.patch.frame.origin.x() - b.patch.frame.origin.x()),
                   2 * std::abs(a.patch.frame.origin.y() - b.patch.frame.origin.y())};
    }
  } catch (const InputError&) {
    // Not known: the closer profile has no contact there.
  }
  return errors;
}

// How far aside the patches' places may be [m] because the grid's error of the pressure, or at
// least a thousandth, is one of the depth at which the wheel stands; infinite where a patch is not
// there at the other depth.
std::vector<ProfileError> place_errors(const ProfilePair& pair, const Pose& pose,
                                       const WheelResult& wheel) {
  const PlacedWheel placed(pair, pose);
  const ContactSearch touching = find_contact(placed);
  double share = 1e-3;
  for (const PatchResult& p : wheel.patches)
    if (std::isfinite(p.p_max_error)) share = std::max(share, p.p_max_error);
  const double depth = wheel.z - wheel.z_touch;
  const auto other = patches(placed, touching, wheel.z + share * depth);
  std::vector<ProfileError> errors;
  for (const PatchResult& p : wheel.patches) {
    ProfileError error{0, 0, units::infinity, units::infinity};
    const Eigen::Vector3d& here = p.patch.frame.origin;
    for (const Patch& patch : other) {
      const Eigen::Vector3d aside = patch.frame.origin - here;
      if (std::abs(aside.y()) >= error.y) continue;
      error.x = std::abs(aside.x()), error.y = std::abs(aside.y());
    }
    errors.push_back(error);
  }
  return errors;
}

// Of the creep force in a patch, from the grid [N].
double grid_error(const PatchResult& p) {
  return p.friction > 0 ? p.forces.error * p.friction * p.load : 0;
}

// Of a wheel's force: the sum of its patches'.
double force_error(const WheelResult& wheel, const std::vector<ProfileError>& profiles) {
  double sum = 0;
  for (const PatchResult& p : wheel.patches) sum += grid_error(p);
  for (const ProfileError& profile : profiles) sum += profile.force;
  return sum;
}

void add_wheel(tool::Summary& answer, const Side& shown, const std::vector<ProfileError>& profiles,
               const std::vector<ProfileError>& places) {
  const std::string s = shown.name;
  const WheelResult& wheel = shown.wheel;
  const double sign = shown.sign;
  int count = 0;
  for (const units::Warning& warning : wheel.warnings)
    answer.warn(fmt::format("{}_{}", s, ++count), fmt::format("{} wheel: {}", s, warning.text));
  const double error = force_error(wheel, profiles);
  answer.add(s + "_x_N", s + " rail: force along", tool::Estimate{wheel.force.x(), error}, "N");
  answer.add(s + "_y_N", "  to the right", tool::Estimate{sign * wheel.force.y(), error}, "N");
  answer.add(s + "_z_N", "  down", wheel.force.z(), "N");
  answer.add(s + "_Y_over_Q", "  Y/Q, outward over down", wheel.force.y() / wheel.force.z(), "");
  int k = 0;
  for (const PatchResult& p : wheel.patches) {
    const std::string key = fmt::format("{}_{}_", s, ++k);
    const auto add = [&](const char* name, const char* what, double value, const char* unit,
                         const std::string& note = "") {
      answer.add(key + name, what, value, unit, note);
    };
    const ProfileError profile =
        profiles.empty() ? ProfileError{} : profiles[static_cast<std::size_t>(k - 1)];
    const auto& at = p.patch.frame.origin;
    const ProfileError& place = places[static_cast<std::size_t>(k - 1)];
    answer.add(key + "x_mm", fmt::format("{} patch {}: place along", s, k),
               tool::Estimate{at.x() / millimetre, (place.x + profile.x) / millimetre}, "mm");
    answer.add(key + "y_mm", "  to the right",
               tool::Estimate{sign * at.y() / millimetre, (place.y + profile.y) / millimetre},
               "mm");
    add("angle_mrad", "  contact angle", 1e3 * sign * p.patch.frame.angle, "mrad");
    add("normal_N", "  normal force", p.load, "N");
    const auto estimate = [&](const char* name, const char* what, double value, double grid,
                              double of_profile, const char* unit) {
      answer.add(key + name, what, tool::Estimate{value, grid + of_profile}, unit,
                 of_profile > 0 && std::isfinite(of_profile)
                     ? fmt::format("{:.0f} % of the error from the smoothing of the profiles",
                                   100 * of_profile / (grid + of_profile))
                     : "");
    };
    estimate("p_max_MPa", "  largest pressure", p.p_max / units::megapascal,
             p.p_max_error * p.p_max / units::megapascal, profile.p_max / units::megapascal, "MPa");
    if (std::isfinite(profile.p_max) && profile.p_max > 0.05 * p.p_max)
      answer.warn(
          key + "profile",
          fmt::format("{} patch {}: with profiles half as smooth the largest pressure would "
                      "change by {:.0f} %: see --noise",
                      s, k, 50 * profile.p_max / p.p_max));
    if (std::isinf(profile.p_max))
      answer.warn(
          key + "profile",
          fmt::format("{} wheel: with profiles half as smooth it touches in another way: see "
                      "--noise",
                      s));
    add("area_mm2", "  area", p.area / (millimetre * millimetre), "mm^2");
    add("approach_um", "  approach", p.approach / units::micrometre, "um");
    add("creepage_x", "  creepage along", p.creepage.longitudinal, "");
    add("creepage_y", "  across", sign * p.creepage.lateral, "");
    add("spin_1_per_m", "  spin", sign * p.creepage.spin, "1/m");
    const double bound = p.friction * p.load;
    estimate("fx_N", "  force along", p.forces.fx, grid_error(p), profile.force, "N");
    estimate("fy_N", "  across, in the patch", sign * p.forces.fy, grid_error(p), profile.force,
             "N");
    answer.add(key + "mz_N_m", "  moment about its normal",
               tool::Estimate{
                   sign * p.forces.mz,
                   p.friction > 0 ? p.forces.mz_error * bound * std::sqrt(p.area / units::pi) : 0},
               "N*m");
    add("friction", "  friction", p.friction, "");
    add("stick_share", "  fraction that sticks", p.forces.stick_share, "");
    add("shear_MPa", "  largest shear traction", p.largest_shear / units::megapascal, "MPa");
    add("wear_N", "  wear number", p.wear_number, "N", "T gamma, J per metre run");
    if (shown.stress.empty()) continue;
    const PatchStress& stress = shown.stress[static_cast<std::size_t>(k - 1)];
    for (const auto& [name, body] : {std::pair{"rail", &stress.rail}, {"wheel", &stress.wheel}}) {
      const std::string of = name;
      const auto both = [&](const std::string& kind, const std::string& what,
                            const contact::LargestStress::Place& deepest) {
        add((of + "_" + kind + "_MPa").c_str(), ("  largest " + what + " in the " + of).c_str(),
            deepest.value / units::megapascal, "MPa");
        add((of + "_" + kind + "_depth_mm").c_str(), "    at a depth of",
            deepest.depth / millimetre, "mm");
      };
      both("von_mises", "von Mises stress", body->von_mises);
      both("shear", "shear stress", body->shear);
    }
  }
}

// How far the full theory's answers are from another program's, for the JSON.
void add_model_errors(tool::Summary& answer) {
  for (const ModelError& m : model_errors) {
    const std::string key = fmt::format("model_error_{}_", m.key);
    answer.add_to_json(key + "bias", m.bias, "");
    answer.add_to_json(key + "scatter", m.scatter, "");
    answer.add_to_json(key + "limit", m.limit, "");
    answer.add_to_json(key + "count", m.count, "");
  }
}

WheelsetResult solved(const Options& options, const ReadPair& read) {
  WheelsetResult r = solve(options, read);
  if (!r.converged) throw std::runtime_error(fmt::format("no answer: {}", r.reason));
  return r;
}

std::array<Side, 2> sides_of(const Options& options, const WheelsetResult& r) {
  return {Side("left", -1, r.left, options_of(options)),
          Side("right", 1, r.right, options_of(options))};
}

tool::Summary answer_of(const Options& options, const ReadPair& read, const WheelsetResult& r,
                        const std::array<Side, 2>& sides) {
  tool::Summary answer("Wheelset on its rails");
  const auto& fits = read.fits;
  describe_pair(answer, options, fits);
  tools::flag_points(answer, fits, [&](const auto& fit, const auto& warning) {
    return sides_on(options, r, fit, warning);
  });
  answer.add("roll_mrad", "roll, right wheel down", 1e3 * r.pose.roll, "mrad");
  answer.add("angular_velocity_rad_per_s", "angular velocity", r.angular_velocity, "rad/s");
  answer.add("lowered_mm", "axle below its height on the running circles", r.right.z / millimetre,
             "mm", options.roll ? fmt::format("left wheel {:.6g} mm", r.left.z / millimetre) : "");
  const auto add_nadal = [&](const char* key, const char* what, const ProfilePair& pair) {
    const double flange = flange_angle(pair.wheel),
                 mu = options.wheel_input.friction.flange.value_or(options.friction);
    if (flange < 45 * units::degree)  // those of rolling stock have 60 to 75
      return answer.warn(key, fmt::format("the wheel has no flange, its steepest place rises by "
                                          "{:.1f} degrees: is the profile whole?",
                                          flange / units::degree));
    answer.add(key, what, nadal_limit(flange, mu), "",
               fmt::format("flange of {:.1f} degrees, friction {:g}", flange / units::degree, mu));
  };
  add_nadal("nadal_limit", "Nadal's limit of Y/Q", read.left);
  if (!options.right_wheel.empty())
    add_nadal("right_nadal_limit", "  of the right wheel", read.right);
  std::array<std::vector<ProfileError>, 2> errors;
  if (!fits.empty()) {
    const ReadPair half = half_as_smooth(options);
    errors = {profile_errors(options, half, r, r.left, true),
              profile_errors(options, half, r, r.right, false)};
  }
  const std::array<std::vector<ProfileError>, 2> places{
      place_errors(read.left, mirrored(r.pose), r.left), place_errors(read.right, r.pose, r.right)};
  for (std::size_t k = 0; k < sides.size(); ++k) add_wheel(answer, sides[k], errors[k], places[k]);
  if (options_of(options).method == Method::full) add_model_errors(answer);
  return answer;
}

void run(Options options) {
  if (tools::answer_pairs(options, "contact", [](const Options& one) {
        const ReadPair read = read_pair(one);
        const WheelsetResult r = solved(one, read);
        return answer_of(one, read, r, sides_of(one, r));
      }))
    return;
  tool::OutFolder out(
      options.out, {"patches.csv", "patches.vtp", "wheelset-contact.json", "wheelset-contact.png"});
  const ReadPair read = read_pair(options);
  const WheelsetResult r = solved(options, read);
  const auto sides = sides_of(options, r);
  const tool::Summary answer = answer_of(options, read, r, sides);
  answer.print();
  if (out) {
    out.add("patches.csv", cells_csv(sides));
    out.add("patches.vtp", cells_vtp(sides));
    out.add("wheelset-contact.json", answer.json());
    draw(read.left, read.right, r.pose, sides, out);
  }
  out.commit();
}

std::function<void()> declare(tool::OptionParser& parser) {
  const auto options = std::make_shared<Options>();
  add_pair_options(parser, *options, true);
  parser.quantity("--shift", options->shift, units::length, "of the wheelset to the right",
                  tool::Range{-0.05, 0.05});
  parser.quantity("--yaw", options->yaw, units::angle, "front to the right",
                  tool::Range{-0.1, 0.1});
  parser.quantity("--roll", options->roll, units::angle, "right wheel down; free without it",
                  tool::Range{-0.1, 0.1});
  parser.quantity("--slip", options->slip, units::number,
                  "the wheelset turns by this share faster than speed over radius; free without it",
                  tool::Range{-1, 10});
  parser.quantity("--load", options->load, units::force, "vertical, on each wheel",
                  tool::Range{1, 1e9});
  parser.required();
  parser.quantity("--mu", options->friction, units::number, "friction", tool::Range{0, 2});
  parser.out(options->out);
  parser.help(
      "Axes: x forward, y to the right, z down; forces are those on the rail. Creepages are the "
      "wheel's over the "
      "rail. Y/Q is positive where the wheel presses outwards. With --out DIR: DIR/patches.csv has "
      "a "
      "row a cell: along_mm forward and across_mm to the right of the patch's place, pressure_MPa "
      "positive as the bodies press, shear_x_MPa and shear_y_MPa on the rail in the same "
      "directions, stick 1 where the wheel does not slide, rail_von_mises_MPa the largest below "
      "the cell; patches.vtp is the same in the track's axes for ParaView; wheelset-contact.json "
      "has the answer with its errors. Of several wheels or rails DIR/contact-table.csv and .jsonl "
      "have a row a pair.\n\nExample: railbook "
      "wheelrail contact --shift 4mm --yaw 5mrad --load 50kN --speed "
      "30m/s");
  return [options] { run(*options); };
}

}  // namespace

tool::Tool contact_tool() {
  return {"contact", "patches and creep forces of a wheelset in one position", declare};
}

}  // namespace railbook::wheelrail_tool
