// Chapter 6: a body with bump stops on a wave of the track, which may begin suddenly or slowly.
#include <array>
#include <cmath>

#include <railbook/num/log_spaced.hpp>
#include <railbook/quality/bump_stops.hpp>
#include <railbook/quality/descriptor.hpp>
#include <railbook/units/constants.hpp>

#include "live.hpp"

namespace railbook::live {
namespace {

using namespace quality;

constexpr double limit = 0.0254;  // of the paper's stroke [m]

StoppedBody body_of(const Inputs& in) {
  return {{in["natural"], in["damping"]}, in["gap"], in["kappa"]};
}

void stops(const Inputs& in, Answer& out) {
  const StoppedBody body = body_of(in);
  const Wave wave{in["amplitude"], in["frequency"], 0};
  const double end = in["duration"], watch = end - 6 / wave.frequency;
  const Track sudden{{wave}, 0}, slow{{wave}, in["ramp"]};
  const auto settled = [&](const Track& track) {
    return run(body, track, at_rest(track), end, {.watch_from = std::max(0.0, watch)}).largest;
  };
  out.value("sudden", settled(sudden));
  out.value("slow", settled(slow));
  out.value("linear", wave.amplitude * stroke_gain(body.suspension, wave.frequency));
  out.value("limit", limit);
  out.table("motion", {"t", "z_sudden", "z_slow", "sudden", "slow"});
  const int points = in.whole("points");
  Motion one = at_rest(sudden), two = at_rest(slow);
  for (int i = 0; i <= points; ++i) {
    const double t = end * i / points;
    if (i > 0) one = run(body, sudden, one, t).end, two = run(body, slow, two, t).end;
    out.row({t, height(sudden, t), height(slow, t), one.x, two.x});
  }
}

// The settled stroke while the frequency is moved in steps, up and down again; the phase goes on.
void stops_curve(const Inputs& in, Answer& out) {
  const StoppedBody body = body_of(in);
  const int points = in.whole("points");
  const auto frequency = [&](int i) {
    return in["from"] * std::pow(in["to"] / in["from"], static_cast<double>(i) / points);
  };
  std::vector<double> up, down;
  Motion state;
  double phase = 0;
  const auto settle = [&](int i) {
    const double f = frequency(i), waves = in["waves"];
    const Track track{{{in["amplitude"], f, phase}}, 0};
    const Run r =
        run(body, track, {0, state.x, state.v}, waves / f, {.watch_from = 0.6 * waves / f});
    state = r.end;
    phase = std::fmod(phase + 2 * units::pi * waves, 2 * units::pi);
    return r.largest;
  };
  for (int i = 0; i <= points; ++i) up.push_back(settle(i));
  for (int i = points; i >= 0; --i) down.insert(down.begin(), settle(i));
  out.table("curve", {"frequency", "up", "down", "linear"});
  for (int i = 0; i <= points; ++i) {
    const auto k = static_cast<std::size_t>(i);
    out.row({frequency(i), up[k], down[k],
             in["amplitude"] * stroke_gain(body.suspension, frequency(i))});
  }
}

// The amplitude of the track that a posted speed leaves, by the stroke and by the force on a wheel.
void allowance(const Inputs& in, Answer& out) {
  const StrokeLimit stroke = stroke_limit_of_level({in["roll"], in["roll_damping"]}, in["level"]);
  const ForceLimit force{make_car(in["wheel_mass"], in["body_mass"], {in["bounce"], in["damping"]}),
                         in["force"]};
  const Descriptor descriptor{stroke, force, in["speed"]};
  const Envelope envelope{descriptor};
  out.value("from", lower_corner(descriptor));
  out.value("until", flat_until(stroke, descriptor.speed));
  out.table("allowed", {"wavelength", "amplitude"});
  for (const double w : num::log_spaced(0.5, 1000, 20))
    out.row({w, allowed_amplitude(envelope(1 / w))});
}

std::vector<Input> with_body(std::vector<Input> inputs) {
  inputs.insert(inputs.end(), {{"amplitude", "m", 0.0104, 1e-5, 0.1},
                               {"natural", "Hz", 0.5, 0.1, 5},
                               {"damping", "", 0.2, 0.02, 2},
                               {"gap", "m", 0.6 * limit, 0.001, 0.1},
                               {"kappa", "", 10, 0, 200}});
  return inputs;
}

}  // namespace

std::span<const Function> quality_functions() {
  static const std::array<Function, 3> all{{{"allowance",
                                             nullptr,
                                             {{"speed", "m/s", 100 / 3.6, 1, 100},
                                              {"body_mass", "kg", 7000, 100, 14500},
                                              {"wheel_mass", "kg", 800, 100, 3000},
                                              {"bounce", "Hz", 2, 0.2, 10},
                                              {"damping", "", 0.5, 0.02, 2},
                                              {"roll", "Hz", 0.5, 0.1, 5},
                                              {"roll_damping", "", 0.2, 0.02, 2},
                                              {"level", "m", 0.016, 1e-4, 0.1},
                                              {"force", "N", 143e3, 1e3, 1e6}},
                                             allowance},
                                            {"stops", nullptr,
                                             with_body({{"frequency", "Hz", 0.9, 0.05, 10},
                                                        {"ramp", "s", 20, 0.1, 100},
                                                        {"duration", "s", 40, 1, 200},
                                                        {"points", "", 800, 10, 4000}}),
                                             stops},
                                            {"stops_curve", nullptr,
                                             with_body({{"from", "Hz", 0.2, 0.05, 5},
                                                        {"to", "Hz", 3, 0.1, 10},
                                                        {"points", "", 60, 2, 400},
                                                        {"waves", "", 20, 5, 100}}),
                                             stops_curve}}};
  return all;
}

}  // namespace railbook::live
