/*
### `track stiffness`

The same formulas for a track of your own. Whatever is not given is taken from the typical track and marked as
assumed in the answer. Quantities carry their unit; a TOML file (`--config`) may hold the same options.

    track stiffness --rail 136RE --tie-spacing 19.5in \
                    --ballast-depth 12in --soil-modulus "150 lbf/in^3"
    track stiffness --foundation-modulus 2000psi --wheels 0in 66in \
                    --joint hinge --joint-at 30in --out mine
*/

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <railbook/table/csv.hpp>
#include <railbook/tool/out_folder.hpp>
#include <railbook/tool/summary.hpp>
#include <railbook/track/beam_elements.hpp>
#include <railbook/track/joint.hpp>
#include <railbook/track/typical_track.hpp>
#include <railbook/track/wheel_on_track.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

#include "tools.hpp"

namespace railbook::track_tool {

using namespace track;

namespace {

constexpr double lbf_per_in = units::lbf / units::inch;
constexpr tool::Range along{-1e4, 1e4};  // positions along the rail [m]

// One datum of the support as an option: absent means the typical value.
struct Part {
  const char* option;
  const char* key;
  const char* name;
  const char* help;
  units::Dimension dimension;
  const char* unit;
  double si;
  double TieSupport::*member;
  tool::Range range;
};

// Far wide of any track, and far from where a double overflows; SI.
constexpr tool::Range lengths{1e-3, 100}, depths{0, 100}, angles{0, 85 * units::degree},
    moduli{1, 1e15}, stiffnesses{1, 1e20};

const std::array<Part, 9> parts{{
    {"--tie-spacing", "tie_spacing_in", "tie spacing l_t", "distance between ties", units::length,
     "in", units::inch, &TieSupport::tie_spacing, lengths},
    {"--tie-width", "tie_width_in", "tie width w", "width of a tie", units::length, "in",
     units::inch, &TieSupport::tie_width, lengths},
    {"--loaded-length", "loaded_length_in", "loaded length l", "length of the tie end that carries",
     units::length, "in", units::inch, &TieSupport::loaded_length, lengths},
    {"--ballast-depth", "ballast_depth_in", "ballast depth h", "ballast below the tie",
     units::length, "in", units::inch, &TieSupport::ballast_depth, depths},
    {"--ballast-modulus", "ballast_modulus_psi", "ballast modulus E_b",
     "Young's modulus of the ballast", units::pressure, "psi", units::psi,
     &TieSupport::ballast_modulus, moduli},
    {"--friction-angle", "friction_angle_deg", "friction angle",
     "of the ballast pyramid to the vertical", units::angle, "deg", units::degree,
     &TieSupport::friction_angle, angles},
    {"--soil-modulus", "soil_modulus_lbf_per_in3", "soil modulus K_0",
     "pressure on the subgrade per deflection", units::subgrade_modulus, "lbf/in^3",
     units::psi / units::inch, &TieSupport::soil_modulus, moduli},
    {"--tie-stiffness", "tie_stiffness_lbf_per_in", "tie k_tie", "of a tie in compression",
     units::stiffness, "lbf/in", lbf_per_in, &TieSupport::tie_stiffness, stiffnesses},
    {"--pad-stiffness", "pad_stiffness_lbf_per_in", "pad k_pad", "of a rail pad", units::stiffness,
     "lbf/in", lbf_per_in, &TieSupport::pad_stiffness, stiffnesses},
}};

struct Options {
  std::string rail = "132RE";
  std::optional<double> rail_moment, rail_mass;
  std::array<std::optional<double>, parts.size()> given;
  std::optional<double> modulus;
  std::optional<double> tie_mass;
  double wheel_load = typical_wheel_load;
  std::vector<double> wheels{0.0};
  std::string joint = "none";
  std::optional<double> joint_rotation, joint_at;
  tool::Destination out;
};

Joint joint_of(const Options& options) {
  const bool sprung = options.joint == "sprung";
  if (sprung != options.joint_rotation.has_value())
    throw InputError(
        "joint sprung needs joint rotation (such as 5 MN*m), and no other joint takes it");
  if (options.joint == "none" && options.joint_at)
    throw InputError("joint at is given but no joint; choose --joint free, hinge or sprung");
  if (sprung) return sprung_joint(*options.joint_rotation);
  return options.joint == "free" ? free_joint : options.joint == "hinge" ? hinge : Joint{};
}

// The chain below the rail; every datum that was not given is marked.
double modulus_from_chain(const Options& options, TieSupport& support, tool::Summary& answer) {
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto& part = parts[i];
    if (options.given[i]) support.*part.member = *options.given[i];
    if (support.*part.member == rigid)
      answer.add(part.key, part.name, "rigid (assumed)");
    else
      answer.add(part.key, part.name, support.*part.member / part.si, part.unit,
                 options.given[i] ? "" : "assumed");
  }
  const auto chain = stiffness_chain(support);
  const auto add = [&](const char* key, const char* what, double value, const char* source) {
    if (value == rigid)
      answer.add(key, what, "rigid");
    else
      answer.add(key, what, value / lbf_per_in, "lbf/in", source);
  };
  add("ballast_lbf_per_in", "ballast k_b", chain.ballast, "eq. (6)");
  add("subgrade_lbf_per_in", "subgrade k_s", chain.subgrade, "eq. (7)");
  add("bed_lbf_per_in", "ballast on subgrade k_bs", chain.bed, "eq. (5)");
  add("seat_lbf_per_in", "rail seat k", chain.seat, "eq. (4)");
  if (support.ballast_depth > overlap_depth(support))
    answer.warn("overlap", fmt::format("pyramids of neighbouring ties overlap below {:.1f} in of "
                                       "ballast: eqs (6) and (7) count that ballast twice",
                                       overlap_depth(support) / units::inch));
  return chain.foundation_modulus;
}

// Equation (2) smears the ties along the rail. What discrete ties make of it is known exactly; 2 %
// is the end of its range.
void discrete_ties(const WinklerBeam& beam, double spacing, tool::Summary& answer) {
  const double reach = std::clamp(beam.beta() * spacing, 1e-3, 50.0);
  const double over = discrete_tie_ratio(reach, LoadPlace::over_tie),
               between = discrete_tie_ratio(reach, LoadPlace::midspan);
  answer.add("discrete_over_tie", "on discrete ties, K_r over a tie", over, "", "of eq. (2)");
  answer.add("discrete_midspan", "on discrete ties, K_r between ties", between, "", "of eq. (2)");
  const double worst = std::max(std::abs(over - 1), std::abs(between - 1));
  if (worst > 0.02)
    answer.warn("discrete-ties",
                fmt::format("the ties are too far apart for eq. (2), which smears them: beta l_t = "
                            "{:.2g}, and the stiffness under a wheel is off by up to {:.2g} %",
                            beam.beta() * spacing, 100 * worst));
}

// The two-mass model of the same track for impact, eqs (15) to (19).
void lumped(const Options& options, const RailSection& rail, const TieSupport& support,
            tool::Summary& answer) {
  if (support.friction_angle < 1e-3) {
    answer.add("lumped", "lumped model", "none: eq. (18) needs a friction angle above zero");
    return;
  }
  const double tie_mass = options.tie_mass.value_or(typical_tie_mass);
  const auto model = rail_on_bed(rail, support, typical_ballast, tie_mass);
  answer.add("tie_mass_kg", "tie mass", tie_mass, "kg", options.tie_mass ? "" : "assumed");
  answer.add("rail_mass_kg", "lumped: rail mass", model.rail_mass, "kg", "eqs (16), (17)");
  answer.add("bed_mass_kg", "lumped: tie and ballast", model.bed_mass, "kg",
             "eqs (18), (19); ballast 100 lb/ft^3 on 270 in^2, N = 6, assumed");
  answer.add("rail_stiffness_MN_per_m", "lumped: rail to tie", model.rail_stiffness / 1e6, "MN/m");
  answer.add("bed_stiffness_MN_per_m", "lumped: tie to ground", model.bed_stiffness / 1e6, "MN/m");
}

double deflection(const WinklerBeam& beam, const Joint& joint, const Options& options, double x) {
  const double joint_at = options.joint_at.value_or(0);
  double sum = 0;
  for (const double wheel : options.wheels)
    sum += jointed_deflection(beam, joint, options.wheel_load, wheel - joint_at, x - joint_at);
  return sum;
}

void write_files(tool::OutFolder& out, const WinklerBeam& beam, const Joint& joint,
                 const Options& options, const tool::Summary& answer) {
  const auto [first, last] = std::ranges::minmax(options.wheels);
  const double margin = 5 / beam.beta();
  std::string text = "distance_m,deflection_mm,support_kN_per_m\n";
  constexpr int steps = 1000;
  for (int i = 0; i <= steps; ++i) {
    const double x = first - margin + (last - first + 2 * margin) * i / steps;
    const double y = deflection(beam, joint, options, x);
    text += fmt::format("{:.6g},{:.6g},{:.6g}\n", x, y / units::millimetre,
                        beam.foundation_modulus * y / units::kilonewton);
  }
  out.add("stiffness.csv", text);
  out.add("stiffness.json", answer.json());
  out.figure(tools::scripts("track") / "stiffness.gp", {"stiffness.csv"}, "stiffness.png");
}

// Wheels are named by their position to the millimetre.
void require_apart(std::vector<double> wheels) {
  if (wheels.empty()) throw InputError("wheels: give at least one position");
  std::ranges::sort(wheels);
  for (std::size_t i = 1; i < wheels.size(); ++i)
    units::require_between("distance between wheels", wheels[i] - wheels[i - 1], 1e-3,
                           units::infinity, "m");
}

void run(const Options& options) {
  tool::OutFolder out(options.out, {"stiffness.csv", "stiffness.json", "stiffness.png"});
  if (options.rail_moment.has_value() != options.rail_mass.has_value())
    throw InputError("a section of your own needs both, rail moment and rail mass");
  const RailSection rail = options.rail_moment
                               ? RailSection{"your own", *options.rail_moment, *options.rail_mass}
                               : rail_section(options.rail);
  const Joint joint = joint_of(options);
  const bool parts_given =
      std::ranges::any_of(options.given, [](const auto& part) { return part.has_value(); });
  if (options.modulus && parts_given)
    throw InputError(
        "foundation modulus is given and so are parts it would be made of; give one or the other");
  if (options.modulus && options.tie_mass)
    throw InputError(
        "tie mass serves the lumped model, which a foundation modulus alone does not give");
  require_apart(options.wheels);
  tool::Summary answer("Track stiffness, one rail");
  auto support = typical_support();
  answer.add("rail", "rail", std::string(rail.name));
  const double modulus =
      options.modulus ? *options.modulus : modulus_from_chain(options, support, answer);
  const WinklerBeam beam = require_valid(WinklerBeam{rail.bending_stiffness(), modulus});
  answer.add("foundation_modulus_psi", "foundation modulus K", modulus / units::psi, "psi",
             options.modulus ? "given" : "eq. (3)");
  answer.add("foundation_modulus_MPa", "", modulus / units::megapascal, "MPa");
  answer.add("beta_per_in", "beta", beam.beta() * units::inch, "1/in", "eq. (1)");
  answer.add("beta_per_m", "", beam.beta(), "1/m");
  answer.add("point_stiffness_lbf_per_in", "stiffness under one wheel K_r",
             beam.point_stiffness() / lbf_per_in, "lbf/in", "eq. (2)");
  answer.add("point_stiffness_MN_per_m", "", beam.point_stiffness() / 1e6, "MN/m");
  if (!options.modulus) discrete_ties(beam, support.tie_spacing, answer);
  answer.add("zero_distance_ft", "zero deflection at", beam.zero_distance() / units::foot, "ft");
  answer.add("zero_distance_m", "", beam.zero_distance(), "m");
  answer.add("wheel_load_kN", "wheel load", options.wheel_load / units::kilonewton, "kN");
  if (options.joint == "none" && options.wheels.size() == 1)
    answer.add("moment_kN_m", "rail moment under the wheel",
               beam_state(beam, options.wheel_load, 0).moment / units::kilonewton, "kN*m");
  for (const double wheel : options.wheels) {
    const double y = deflection(beam, joint, options, wheel);
    const std::string at = fmt::format("{:.3f}", wheel);
    answer.add("deflection_mm_at_" + at, "deflection under the wheel at " + at + " m",
               y / units::millimetre, "mm");
    answer.add("stiffness_MN_per_m_at_" + at, "stiffness that wheel feels",
               options.wheel_load / y / 1e6, "MN/m");
  }
  if (!options.modulus) lumped(options, rail, support, answer);
  answer.print();
  if (out) write_files(out, beam, joint, options, answer);
  out.commit();
}

std::function<void()> declare(tool::OptionParser& parser) {
  const auto options = std::make_shared<Options>();
  parser.text("--rail", options->rail, "rail section: 115RE, 119RE, 132RE, 136RE or 60E1 (UIC60)");
  parser.quantity("--rail-moment", options->rail_moment, units::second_moment_of_area,
                  "second moment of a section of your own, with --rail-mass", tool::Range{1e-9, 1});
  parser.quantity("--rail-mass", options->rail_mass, units::mass_per_length, "its mass per length",
                  tool::Range{1e-3, 1e4});
  for (std::size_t i = 0; i < parts.size(); ++i)
    parser.quantity(parts[i].option, options->given[i], parts[i].dimension,
                    std::string(parts[i].help) + "; without it the typical track's",
                    parts[i].range);
  parser.quantity("--foundation-modulus", options->modulus, units::pressure,
                  "K itself, instead of all below the rail", tool::Range{1e-3, 1e15});
  parser.quantity("--tie-mass", options->tie_mass, units::mass,
                  "of a whole tie; without it the typical track's", tool::Range{1e-3, 1e5});
  parser.quantity("--wheel-load", options->wheel_load, units::force, "on every wheel",
                  tool::Range{1e-3, 1e9});
  parser.quantities("--wheels", options->wheels, units::length, "their positions along the rail",
                    along);
  parser.choice("--joint", options->joint, {"none", "free", "hinge", "sprung"}, "a rail joint");
  parser.quantity("--joint-rotation", options->joint_rotation, units::moment,
                  "rotational stiffness of a sprung joint, per radian", tool::Range{0, 1e15});
  parser.quantity("--joint-at", options->joint_at, units::length,
                  "its position along the rail; without it 0", along);
  parser.out(options->out);
  parser.help(
      "stiffness.csv: distance along the rail as the wheels' and the joint's; deflection of the "
      "rail, positive downwards, and support, the foundation's force on a length of it, positive "
      "upwards on the rail.");
  return [options] { run(*options); };
}

}  // namespace

tool::Tool stiffness_tool() {
  return {"stiffness", "stiffness and deflection of a track of your own", declare};
}

}  // namespace railbook::track_tool
