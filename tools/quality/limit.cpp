/* ## Your own car and track

### `quality limit`

The allowed amplitude against wavelength for a car of your own:

    quality limit --speed 100km/h --car examples/quality/freight.toml
    quality limit --speed 80mph --roll-frequency 0.6Hz --roll-damping 0.15 --stroke 1.5in --wavelength 39ft 78ft
    quality limit --speed 100km/h --car examples/quality/freight.toml --body-mass 15t

The car may stand in a file of its own (`--car`); what the command line says wins. The stroke limit is given directly (`--stroke`) or by the flat level it
leaves (`--level`). The suspension under the wheel-force mode is given by stiffness and damping or by bounce frequency and its share of critical damping. Without masses only the stroke mode counts. The
third line is a car whose static load exceeds the limit: it is refused, *no admissible amplitude*, status 2.
*/
#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <memory>
#include <vector>

#include <railbook/num/log_spaced.hpp>
#include <railbook/table/csv.hpp>
#include <railbook/tool/out_folder.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

#include "quality/car_options.hpp"
#include "tools.hpp"

namespace railbook::quality_tool {

void add_car_options(tool::OptionParser& o, CarOptions& w) {
  const tool::Range ratio{1e-6, 1e3};
  o.quantity("--speed", w.speed, units::speed, "posted speed of the track", {0.1, 200});
  o.required();
  o.toml("--car", "the car's options from a TOML file");
  o.choice("--mode", w.mode, {"auto", "stroke", "force", "combined"},
           "limit that counts; auto: combined if masses are given, else stroke");
  o.quantity("--roll-frequency", w.roll.frequency, units::frequency,
             "natural frequency of the stroke mode", {1e-3, 1e3});
  o.quantity("--roll-damping", w.roll.damping, units::number, "its share of critical damping",
             ratio);
  o.quantity("--level", w.level, units::length,
             "allowed amplitude of short waves; without it 1.6 cm", {1e-6, 10});
  o.quantity("--stroke", w.stroke, units::length, "stroke limit, instead of the level", {1e-6, 10});
  o.quantity("--wheel-mass", w.wheel_mass, units::mass, "unsprung mass on a wheel", {0, 1e5});
  o.quantity("--body-mass", w.body_mass, units::mass, "sprung mass on a wheel", {1, 1e6});
  o.quantity("--stiffness", w.stiffness, units::stiffness, "suspension at a wheel", {1, 1e12});
  o.quantity("--damping", w.damping, units::damping, "suspension at a wheel", {1e-3, 1e12});
  o.quantity("--bounce-frequency", w.bounce_frequency, units::frequency, "instead of the stiffness",
             {1e-3, 1e3});
  o.quantity("--bounce-damping", w.bounce_damping, units::number,
             "share of critical, instead of the damping", ratio);
  o.quantity("--wheel-force", w.wheel_force, units::force, "limit of static and dynamic force",
             {1, 1e9});
}

namespace {

quality::ForceLimit force_limit(const CarOptions& w) {
  if (!w.wheel_mass || !w.body_mass)
    throw InputError{"the wheel-force mode needs --wheel-mass and --body-mass"};
  if (w.stiffness.has_value() == w.bounce_frequency.has_value())
    throw InputError{"suspension: give one of --stiffness and --bounce-frequency"};
  if (w.damping.has_value() == w.bounce_damping.has_value())
    throw InputError{"suspension: give one of --damping and --bounce-damping"};
  const double rate = 2 * units::pi * w.bounce_frequency.value_or(0);
  const double k = w.stiffness.value_or(*w.body_mass * rate * rate);
  const double b =
      w.damping.value_or(2 * w.bounce_damping.value_or(0) * std::sqrt(k * *w.body_mass));
  const quality::ForceLimit limit{{*w.wheel_mass, *w.body_mass, k, b}, w.wheel_force};
  static_cast<void>(force_margin(limit));
  return limit;
}

}  // namespace

quality::Descriptor descriptor(const CarOptions& w) {
  const bool masses = w.wheel_mass || w.body_mass;
  const bool force = w.mode == "force" || w.mode == "combined" || (w.mode == "auto" && masses);
  quality::Descriptor d{{}, {}, w.speed};
  if (w.mode != "force") {
    if (w.level && w.stroke) throw InputError{"stroke limit: give one of --level and --stroke"};
    d.stroke = w.stroke ? quality::StrokeLimit{w.roll, *w.stroke}
                        : quality::stroke_limit_of_level(w.roll, w.level.value_or(1.6 * cm));
  }
  if (force) d.force = force_limit(w);
  return d;
}

void add_car(tool::Summary& s, const quality::Descriptor& d) {
  s.add("speed_km_per_h", "posted speed", d.speed / kmh, "km/h");
  if (d.stroke) {
    s.add("stroke_limit_cm", "stroke limit", d.stroke->stroke / cm, "cm",
          fmt::format("{:g} Hz, damping {:g}", d.stroke->suspension.frequency,
                      d.stroke->suspension.damping));
    s.add("level_cm", "amplitude allowed for short waves",
          d.stroke->stroke / quality::stroke_peak(d.stroke->suspension.damping).gain / cm, "cm");
    if (const double wave = flat_until(*d.stroke, d.speed); wave > 0)
      s.add("flat_until_m", "  up to the wavelength", wave, "m");
  }
  if (d.force) {
    s.add("static_force_kN", "static wheel force", static_force(d.force->car) / kN, "kN");
    s.add("force_margin_kN", "left for the dynamic force", force_margin(*d.force) / kN, "kN");
    if (quality::force_peak(d.force->car).found)
      s.add("force_note", "note", "the wheel force has a resonance: slower trains may need more");
  }
  if (d.stroke && d.force)
    s.add("corner_m", "wheel force counts below", quality::lower_corner(d), "m");
}

namespace {

struct Options {
  CarOptions car;
  std::vector<double> wavelengths{1, 2, 5, 10, 20, 50, 100, 200};
  tool::Destination out;
};

void write_files(tool::OutFolder& out, const quality::Descriptor& d,
                 const quality::Envelope& envelope, const tool::Summary& answer) {
  std::string text = fmt::format("wavelength_m,amplitude_cm{}{}\n", d.stroke ? ",stroke_cm" : "",
                                 d.force ? ",force_cm" : "");
  std::string drawn = "wavelength_m,amplitude_cm,stroke_cm,force_cm\n";  // all columns, some empty
  for (const double w : num::log_spaced(0.5, 1000, 80)) {
    const auto mode = [&](const auto& one) {
      return one ? fmt::format(",{:.6g}",
                               quality::allowed_amplitude(severity(*one, d.speed, 1 / w)) / cm)
                 : std::string{};
    };
    const std::string both =
        fmt::format("{:.6g},{:.6g}", w, quality::allowed_amplitude(envelope(1 / w)) / cm);
    const std::string stroke = mode(d.stroke), force = mode(d.force);
    text += both + stroke + force + "\n";
    drawn += both + (d.stroke ? stroke : ",nan") + (d.force ? force : ",nan") + "\n";
  }
  out.add("limit.csv", text);
  out.scratch("drawn.csv", drawn);
  out.add("limit.json", answer.json());
  out.figure(tools::scripts("quality") / "limit.gp", {"drawn.csv"}, "limit.png");
}

void limit(const Options& options) {
  tool::OutFolder out(options.out, {"limit.csv", "limit.json", "limit.png"});
  const quality::Descriptor d = descriptor(options.car);
  const quality::Envelope envelope{d};
  tool::Summary answer{"amplitude allowed in the track"};
  add_car(answer, d);
  for (const double w : options.wavelengths) {
    const double all = envelope(1 / w);
    const bool by_force = d.force && severity(*d.force, d.speed, 1 / w) >= all;
    answer.add(fmt::format("amplitude_cm_at_{:.4g}_m", w), fmt::format("at {:.4g} m", w),
               quality::allowed_amplitude(all) / cm, "cm", by_force ? "wheel force" : "stroke");
  }
  answer.print();
  if (out) write_files(out, d, envelope, answer);
  out.commit();
}

}  // namespace

tool::Tool limit_tool() {
  return {
      "limit", "allowed amplitude of the track for a car of your own", [](tool::OptionParser& o) {
        auto options = std::make_shared<Options>();
        add_car_options(o, options->car);
        o.quantities("--wavelength", options->wavelengths, units::length, "wavelengths to print",
                     {1e-3, 1e6});
        o.out(options->out);
        o.help(
            "limit.csv has a row a wavelength: amplitude_cm is what is allowed, half of what the "
            "wave goes up and down, stroke_cm and force_cm what the suspension's stroke and the "
            "wheel force alone allow. All are positive.");
        return [options] { limit(*options); };
      }};
}

}  // namespace railbook::quality_tool
