/*
### `filters simulate`: a record to order

    filters simulate --out sensors.csv --length 1mi --speeds 60mph --config car.toml --truth truth.csv
    filters simulate --out hard.csv --speeds 40mph 0mph -40mph --distances 1500ft 1ft 1200ft --stand 30s

drives our car over our track and writes what its sensors say: typical sensors with `--sensors typical`, perfect ones by default. The car cruises at each speed over each
distance, changes speed at a constant rate between them, stands at a speed of zero, and backs at a negative one.
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <railbook/files/out_file.hpp>
#include <railbook/geometry_car/reconstruct.hpp>
#include <railbook/geometry_car/sensors.hpp>
#include <railbook/geometry_car/simulate.hpp>
#include <railbook/table/csv.hpp>
#include <railbook/tool/session.hpp>
#include <railbook/tool/summary.hpp>
#include <railbook/units/constants.hpp>

#include "filters/car_options.hpp"
#include "tools.hpp"

namespace railbook::filters_tool {

using namespace geometry_car;
using units::foot;
using units::mph;

namespace {

struct Order {
  std::filesystem::path file, truth;
  TrackDescription track;
  Car car;
  std::vector<double> speeds{60 * mph}, distances;
  double rate = 0.5, stand = 10;
  long seed = 1;
  std::string sensors = "ideal";
};

constexpr double longest_journey = 1e5;  // s
constexpr double most_samples = 1e6;     // of track

Motion motion_of(const Order& order, double length) {
  const double first = order.car.layout.truck_spacing + 20 * foot;
  Motion motion{.start = order.speeds[0] < 0 ? length - 1e-3 : first, .speed = order.speeds[0]};
  std::vector<double> distances = order.distances;
  if (distances.empty() && order.speeds.size() == 1) distances = {length - first - 1e-3};
  if (distances.size() != order.speeds.size())
    throw InputError{fmt::format("there are {} distances for {} speeds; allowed: one each",
                                 distances.size(), order.speeds.size())};
  for (std::size_t i = 0; i < distances.size(); ++i) {
    motion.change_speed(order.speeds[i], order.rate);
    if (order.speeds[i] == 0)
      motion.stand(order.stand);
    else
      motion.cruise(distances[i]);
  }
  double duration = 0;
  for (const Leg& leg : motion.legs) duration += leg.duration;
  units::require_between("time of the journey", duration, 0, longest_journey, "s");
  return motion;
}

std::string sensor_table(const Record& r, double sample) {
  std::string text = "distance_m,elapsed_s";
  for (const ChannelInfo& c : channel_list()) text += fmt::format(",{}_{}", c.name, c.unit);
  text += "\n";
  for (std::size_t i = 0; i < r.size(); ++i) {
    text += fmt::format("{:.9g},{:.12g}", static_cast<double>(r.mark[i]) * sample, r.elapsed[i]);
    for (const ChannelInfo& c : channel_list())
      text += fmt::format(",{:.12g}", r[c.channel][i] / c.si);
    text += "\n";
  }
  return text;
}

std::string truth_table(const Measurement& t, double sample) {
  std::string text = "distance_m";
  for (const ParameterInfo& p : parameter_list()) text += fmt::format(",{}_{}", p.name, p.unit);
  text += "\n";
  for (std::size_t i = 0; i < t.size(); ++i) {
    text += fmt::format("{:.9g}", static_cast<double>(t.mark[i]) * sample);
    for (const ParameterInfo& p : parameter_list())
      text += "," + table::csv_number(t[p.parameter][i] / p.si);
    text += "\n";
  }
  return text;
}

void simulate(Order order) {
  if (order.truth == order.file)
    throw InputError{fmt::format("truth is \"{}\", the record's own file; allowed: another",
                                 order.truth.string())};
  std::vector<files::OutFile> out;
  out.emplace_back(order.file);
  if (!order.truth.empty()) out.emplace_back(order.truth);
  order.track.seed = static_cast<std::uint64_t>(order.seed);
  order.track.sample = order.car.layout.sample;
  order.track.base = order.car.layout.base;
  units::require_between("truck spacing", order.car.layout.truck_spacing,
                         2 * order.car.layout.sample, 100, "m");
  units::require_between("length of the track over the distance between samples",
                         order.track.length / order.track.sample, 100, most_samples);
  const Track track = build(order.track);
  const Motion motion = motion_of(order, track.length());
  Record record = drive(track, order.car, motion);
  if (record.size() < 2) throw InputError{"speeds: the car does not travel a foot"};
  if (order.sensors == "typical")
    record = measured(record, order.car.layout, typical_sensors(), order.track.seed);
  out[0].write(sensor_table(record, order.car.layout.sample));
  if (out.size() > 1)
    out[1].write(truth_table(truth(track, {.layout = order.car.layout}), order.car.layout.sample));
  tool::session().taken = std::any_of(out.begin(), out.end(),
                                      [](const auto& file) { return file.to_standard_output(); });
  tool::Summary answer{"sensors in " + order.file.string()};
  answer.add("rows", "rows", static_cast<double>(record.size()), "");
  answer.add("seed", "seed", static_cast<double>(order.seed), "");
  answer.print();
  files::commit(out);
}

}  // namespace

tool::Tool simulate_tool() {
  return {
      "simulate", "a record of the car's sensors to order", [](tool::OptionParser& o) {
        auto order = std::make_shared<Order>();
        auto& t = order->track;
        o.file("--out", order->file, "CSV file to write; - is standard output");
        o.required();
        o.file("--truth", order->truth, "CSV file for the true geometry");
        add_layout(o, order->car.layout);
        o.quantity("--length", t.length, units::length, "of the track", tool::Range{200, 2e5});
        o.count("--seed", order->seed, "number of the track and of the noise", 0, 1L << 62);
        o.quantity("--roughness", t.surface.A, units::area * units::wavenumber,
                   "A of the surface, as in 5e-7m^2*cycle/m", {0, 1e-2});
        o.quantity("--dip", t.dip, units::length, "of the joints", {-1, 1});
        o.quantity("--grade", t.grade, units::number, "before and after the vertical curve",
                   {-0.1, 0.1});
        o.quantity("--line-roughness", t.line.A, units::area * units::wavenumber,
                   "A of the centre line", {0, 1e-2});
        o.quantity("--gage", t.gage, units::length, "of the track", tool::positive);
        o.quantity("--curvature", t.curvature, units::angle / units::length,
                   "of the curve, left positive, as in -0.04deg/ft", {-0.02, 0.02});
        o.quantity("--superelevation", t.superelevation, units::length, "of the outer rail",
                   {-0.3, 0.3});
        o.quantities("--speeds", order->speeds, units::speed, "to cruise at, in this order",
                     {-200, 200});
        o.quantities("--distances", order->distances, units::length, "to cruise over, one each",
                     tool::positive);
        o.quantity("--rate", order->rate, units::acceleration, "of changes of speed", {1e-4, 100});
        o.quantity("--stand", order->stand, units::time, "time at a speed of 0",
                   {1e-3, longest_journey});
        o.choice("--sensors", order->sensors, {"ideal", "typical"}, "with their errors");
        o.help(
            "Columns: distance_m; elapsed_s, the encoder's time; vertical_left and vertical_right, "
            "the "
            "body's accelerations, positive upwards, without gravity; lateral, of the truck's "
            "beam, and "
            "inclinometer, of the body's floor, positive to the left; yaw_rate, positive turning "
            "left, "
            "and roll_rate, with the left side rising; height_left and height_right of the body "
            "over "
            "the axle, positive upwards; sway_front_a, sway_front_b and sway_rear of the body over "
            "its "
            "trucks, positive to the left; gage_left and gage_right from the beam to the rail's "
            "face, "
            "positive outwards.");
        return [order] { simulate(*order); };
      }};
}

}  // namespace railbook::filters_tool
