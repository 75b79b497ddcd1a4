/*
### `hunting speed`

All critical speeds of a car, with frequency and mode, from eigenvalues of the linear car.

    hunting speed
    hunting speed car.toml --wheel wheel.csv --rail rail.csv --half-spacing 750mm --radius 460mm
    hunting speed --pair cn --warp-stiffness 10MN*m/rad --speed 40m/s --out mine

With `--speed` it lists the modes at that speed. `--out` writes `speed.json`, the two least damped eigenvalues against
speed (`speed.csv`) and their figure. With friction the linear car is the one that sticks: its joints are as stiff as the
regularization makes them, and its critical speeds mean little.
*/

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include <railbook/table/csv.hpp>
#include <railbook/tool/digits.hpp>
#include <railbook/tool/out_folder.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/vehicle/linear_stability.hpp>

#include "hunting/car_options.hpp"
#include "tools.hpp"

namespace railbook::hunting_tool {

using namespace vehicle;

namespace {

struct Options : CarOptions {
  double lowest = 1, highest = 120;
  std::optional<double> speed;
  tool::Destination out;
};

std::string shape_text(const QuasiLinearCar& car, const Vector9c& q) {
  const auto a = wheelset_amplitudes(car.car(), q);
  return fmt::format("{:.3f}, {:.3f}, {:.3f}, {:.3f}", a[0], a[1], a[2], a[3]);
}

std::string body_text(const Vector9c& q) {
  return fmt::format("lateral {:.3f}, yaw {:.4f} rad/m, roll {:.4f} rad/m", std::abs(q[X_C]),
                     std::abs(q[TH_C]), std::abs(q[PHI_C]));
}

void add_hopf(tool::Summary& answer, const QuasiLinearCar& car, const std::vector<HopfPoint>& found,
              const Options& options) {
  answer.add("critical_speeds", "critical speeds", static_cast<double>(found.size()), "",
             fmt::format("from {:g} to {:g} m/s", options.lowest, options.highest));
  for (std::size_t k = 0; k < found.size(); ++k) {
    const auto& m = found[k].motion;
    const std::string id = fmt::format("hopf_{}_", k + 1);
    answer.add(id + "m_per_s", fmt::format("critical speed {}", k + 1), m.speed, "m/s",
               fmt::format("{} ft/s, {} km/h; {}", tool::to_text(m.speed / units::foot),
                           tool::to_text(m.speed / units::kilometre_per_hour),
                           found[k].rate_by_speed.real() > 0 ? "grows above" : "grows below"));
    answer.add(id + "rad_per_s", "  frequency", m.lambda.imag(), "rad/s",
               tool::to_text(m.lambda.imag() / (2 * units::pi)) + " Hz");
    answer.add(id + "wheelsets", "  wheelsets, front to rear", shape_text(car, m.shape));
    answer.add(id + "body", "  body", body_text(m.shape));
  }
  const auto least_damped = modes(car, car.small(), options.lowest).front();
  const double growth = least_damped.lambda.real(), rounding = growth_rounding(car, least_damped);
  if (found.empty() || growth > -rounding)
    answer.add("growth_lowest", "largest growth rate at the lowest speed", growth, "1/s",
               growth > rounding ? "already unstable there"
               : growth > -rounding
                   ? "zero within rounding: nothing holds this motion back or drives it"
                   : "stable throughout");
}

void add_modes_at(tool::Summary& answer, const QuasiLinearCar& car, double speed) {
  auto all = modes(car, car.small(), speed);
  for (std::size_t k = 0; k < all.size(); ++k) {
    const bool oscillates = all[k].lambda.imag() > 0;
    const bool zero = std::abs(all[k].lambda.real()) < growth_rounding(car, all[k]);
    answer.add(fmt::format("mode_{}_growth", k + 1), fmt::format("mode {}: growth rate", k + 1),
               all[k].lambda.real(), "1/s",
               oscillates
                   ? fmt::format("{} rad/s; wheelsets {}", tool::to_text(all[k].lambda.imag()),
                                 shape_text(car, all[k].shape))
                   : "does not oscillate" + std::string(zero ? "; zero within rounding" : ""));
  }
}

void write_files(tool::OutFolder& out, const Options& options, const QuasiLinearCar& car,
                 const tool::Summary& answer) {
  std::string text = "V_m_per_s,growth_1_per_s,omega_rad_per_s,growth_second,omega_second\n";
  constexpr int points = 240;
  for (int k = 0; k <= points; ++k) {
    const double v = options.lowest + (options.highest - options.lowest) * k / points;
    auto all = modes(car, car.small(), v);
    std::erase_if(all, [](const Motion& m) { return m.lambda.imag() < 1e-9; });
    all.resize(std::max<std::size_t>(2, all.size()));
    text += fmt::format("{:.8g},{:.8g},{:.8g},{:.8g},{:.8g}\n", v, all[0].lambda.real(),
                        all[0].lambda.imag(), all[1].lambda.real(), all[1].lambda.imag());
  }
  out.add("speed.csv", text);
  out.add("speed.json", answer.json());
  out.figure(tools::scripts("hunting") / "speed.gp", {"speed.csv"}, "speed.png");
}

void run(const Options& options) {
  tool::OutFolder out(options.out, {"speed.csv", "speed.json", "speed.png"});
  units::require_between("highest speed", options.highest, options.lowest, 1e4, "m/s");
  const CarCase c = read_case(options);
  tool::Summary answer("Critical speeds of a freight car");
  describe_case(answer, options, c);
  flag_smoothing(answer, options, c, options.lowest, options.highest);
  add_hopf(answer, c.car, hopf_points(c.car, options.lowest, options.highest), options);
  if (options.speed) add_modes_at(answer, c.car, *options.speed);
  answer.print();
  if (out) write_files(out, options, c.car, answer);
  out.commit();
}

std::function<void()> declare(tool::OptionParser& parser) {
  const auto options = std::make_shared<Options>();
  add_car_options(parser, *options);
  const tool::Range speeds{0.01, 1e4};
  parser.quantity("--lowest", options->lowest, units::speed, "of the range searched", speeds);
  parser.quantity("--highest", options->highest, units::speed, "of the range searched", speeds);
  parser.quantity("--speed", options->speed, units::speed, "lists the modes there", speeds);
  parser.out(options->out);
  parser.help(
      "A growth rate is positive where the motion grows: the straight run is unstable. Lateral "
      "displacements are positive to the left, yaw is positive turning left, roll with the left "
      "side up. speed.csv: growth_1_per_s and omega_rad_per_s of the motion that grows most at the "
      "speed V, growth_second and omega_second of the next one.");
  return [options] { run(*options); };
}

}  // namespace

tool::Tool speed_tool() {
  return {"speed", "critical speeds and modes of your own car", declare};
}

}  // namespace railbook::hunting_tool
