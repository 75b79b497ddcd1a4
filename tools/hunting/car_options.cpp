/*
Both tools below take a car as options, on the command line or in a TOML file (`hunting speed car.toml`), with the paper's car as the default: every name in
`car_data()` with two dashes. Wheel radius and half gauge are those of the geometry, `--radius` and `--half-spacing`. Dampers follow from the
friction levels and the motion at which they are linearized, unless given themselves; with `--suspension friction` the frictions act.
*/

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>

#include <railbook/units/constants.hpp>
#include <railbook/vehicle/linear_stability.hpp>

#include "hunting/car_options.hpp"
#include "tools.hpp"

namespace railbook::hunting_tool {

using namespace vehicle;

namespace {

// The two that belong to the geometry.
bool of_the_pair(const CarDatum& datum) {
  return datum.member == &CarParameters::half_gauge || datum.member == &CarParameters::wheel_radius;
}

struct DamperOption {
  const char* name;
  const char* help;
  units::Dimension dimension;
  std::optional<double> CarOptions::*given;
  double Dampers::*value;
};
const units::Dimension angular_damping = units::moment * units::time / units::angle;
const std::array<DamperOption, 4> dampers{
    {{"--lateral-damper", "a side frame; without it from the friction", units::damping,
      &CarOptions::lateral_damper, &Dampers::lateral},
     {"--vertical-damper", "a side frame; without it from the friction", units::damping,
      &CarOptions::vertical_damper, &Dampers::vertical},
     {"--warp-damper", "a truck; without it from the friction", angular_damping,
      &CarOptions::warp_damper, &Dampers::warp},
     {"--centre-plate-damper", "a truck; without it from the friction", angular_damping,
      &CarOptions::centre_plate_damper, &Dampers::centre_plate}}};

}  // namespace

void add_car_options(tool::OptionParser& parser, CarOptions& options) {
  add_pair_options(parser, options.pair);
  tools::add_right_options(parser, options.pair);
  // A factor of ten thousand either way is no freight car any more, and spoils the arithmetic.
  for (const CarDatum& datum : car_data()) {
    double& value = options.data.*datum.member;
    if (!of_the_pair(datum))
      parser.quantity(fmt::format("--{}", datum.key), value, datum.dimension, datum.name,
                      tool::Range{datum.positive ? 1e-4 * value : 0, 1e4 * value});
  }
  parser.choice("--suspension", options.suspension, {"dampers", "friction"},
                "equivalent dampers, or dry friction regularized");
  for (const auto& damper : dampers)
    parser.quantity(damper.name, options.*damper.given, damper.dimension, damper.help,
                    tool::Range{0, 1e10});
}

CarCase read_case(const CarOptions& options) {
  CarParameters data = options.data;
  data.half_gauge = options.pair.half_spacing;
  data.wheel_radius = options.pair.radius;
  require_valid(data);
  Dampers c = equivalent_dampers(data);
  for (const auto& damper : dampers)
    if (options.*damper.given) {
      if (options.suspension == "friction")
        throw InputError(fmt::format(
            "{} is for --suspension dampers; friction is given by its level", damper.name + 2));
      c.*damper.value = *(options.*damper.given);
    }
  auto [pair, fits] = read_pair(options.pair);
  auto geometry = table_of(pair, options.pair);
  auto car =
      options.suspension == "friction" ? assemble(data, Suspension::friction) : assemble(data, c);
  QuasiLinearCar quasi{std::move(car), geometry};
  return {std::move(geometry), std::move(quasi), std::move(fits)};
}

void flag_smoothing(tool::Summary& answer, const CarOptions& options, const CarCase& c,
                    double lowest, double highest) {
  flag_smoothing(answer, options.pair, c.fits,
                 {{"critical_speed", "the first critical speed", "m/s", 0.02, 0}},
                 [&](const PairOptions& w) -> std::vector<double> {
                   CarOptions other = options;
                   other.pair = w;
                   const auto found = hopf_points(read_case(other).car, lowest, highest);
                   if (found.empty()) return {std::numeric_limits<double>::quiet_NaN()};
                   return {found.front().motion.speed};
                 });
}

void describe_case(tool::Summary& answer, const CarOptions& options, const CarCase& c) {
  describe_pair(answer, options.pair, c.fits);
  flag_points(answer, c.fits, [](const auto&, const auto&) { return std::string{}; });
  const double a = c.table.half_spacing;
  answer.add("slope_R", "slope of R at the centre, per x/a", a * c.table.R.slope(0), "");
  answer.add("slope_D", "slope of D", a * c.table.D.slope(0), "rad");
  answer.add("slope_Phi", "slope of the roll angle", a * c.table.Phi.slope(0), "rad");
  if (!c.table.symmetric()) {
    const auto& car = c.car.car();
    std::string text;
    for (const auto& w : car.wheels)
      text += fmt::format("{}{:.4f}", text.empty() ? "" : ", ",
                          w.lateral.dot(c.car.rest()) / units::millimetre);
    answer.add("rest_mm", "  at rest the wheelsets stand, front to rear", text + " mm to the left");
  }
  answer.add("suspension", "suspension",
             options.suspension == "friction" ? "dry friction, regularized" : "dampers");
  const CarParameters usual;
  for (const CarDatum& datum : car_data()) {
    const double value = c.car.car().data.*datum.member;
    if (std::abs(value - usual.*datum.member) > 1e-12 * std::abs(value))
      answer.add(datum.key, datum.name, value, units::si_name(datum.dimension), "not the paper's");
  }
}

}  // namespace railbook::hunting_tool
