/* ## Track to order

`psd synthesize track.csv` writes a profile record with known parameters, to try an estimator on, this one or another:

    psd synthesize track.csv --length 20km --roughness 5e-7m^2*cycle/m --corner 0.13cycle/m --dip 11mm --gaps 2%

The dip is given in the printed convention of Table 1, like everything about $B$ on the command line. The columns are `distance_m` and
`profile_mm`; samples lost in gaps are `nan`. The same options and seed give the same file on every machine of the same kind, whatever
the compiler. Records of any length stream through the memory of one filter block.
*/
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <railbook/files/out_file.hpp>
#include <railbook/spectra/synthetic_track.hpp>
#include <railbook/table/csv.hpp>
#include <railbook/tool/session.hpp>
#include <railbook/tool/summary.hpp>
#include <railbook/units/constants.hpp>

#include "tools.hpp"

namespace railbook::psd_tool {

namespace {

struct Order {
  std::filesystem::path file;
  double length = 10 * units::kilometre;
  double B = 0.0;         // printed convention
  double memory_B = 0.0;  // printed convention
  long seed = 1;
  spectra::SyntheticTrack track;
};

void add_options(tool::OptionParser& o, Order& order) {
  const tool::Range height{-1e3, 1e3};
  auto& t = order.track;
  o.file("track", order.file, "the CSV file to write; - is standard output");
  o.required();
  o.quantity("--length", order.length, units::length, "length of the record", {0, 1e9, true});
  o.quantity("--spacing", t.spacing, units::length, "distance between samples", {1e-3, 10});
  o.count("--seed", order.seed, "number of the record: same seed, same record", 0, 1L << 62);
  o.quantity("--roughness", t.A, units::area * units::wavenumber,
             "A of equation (4), as in 5e-7m^2*cycle/m", {0, 1});
  o.quantity("--corner", t.phi_c, units::wavenumber, "corner wavenumber; left out: one slope",
             {1e-6, 1e6});
  o.quantity("--rail", t.rail_length, units::length, "rail length", {0.1, 1e6});
  o.quantity("--dip", order.B, units::length, "joint dip B as in Table 1, twice the physical one",
             height);
  o.quantity("--scatter", t.dip_scatter, units::number,
             "standard deviation of the dips over their mean", {0, 10});
  o.quantity("--correlation", t.dip_correlation, units::number,
             "of the dips of neighbouring joints", {-0.9999, 0.9999});
  o.quantity("--old-rail", t.memory_length, units::length, "rail length the ballast remembers",
             {0.1, 1e6});
  o.quantity("--memory", order.memory_B, units::length, "linear memory: B of the old rail", height);
  o.quantity("--modulation", t.memory_modulation, units::number, "nonlinear memory: m", {0, 10});
  o.quantity("--grade", t.grade, units::number, "straight grade", {-1, 1});
  o.quantity("--wave", t.wave_amplitude, units::length, "amplitude of a long vertical wave",
             height);
  o.quantity("--wave-length", t.wave_length, units::length, "its length", {0.1, 1e9});
  o.quantity("--noise", t.sensor_noise, units::length, "standard deviation of white noise",
             {0, 1e3});
  o.quantity("--gaps", t.gap_share, units::number, "share of samples lost, in gaps of 20",
             {0.0, 0.95});
}

/* The record is written block by block; it has its name when it is whole. `-` is standard output. */
void write_track(const Order& order) {
  files::OutFile out(order.file);
  spectra::SyntheticTrack track = order.track;
  track.seed = static_cast<std::uint64_t>(order.seed);
  const auto physical = [](double B) {
    return spectra::convert_dip(B, spectra::LineConvention::printed,
                                spectra::LineConvention::exact_one_sided);
  };
  track.dip = physical(order.B);
  track.memory_dip = physical(order.memory_B);
  const double wanted =
      units::require_between("length over spacing", order.length / track.spacing, 1, 1e9);
  spectra::TrackGenerator generator{track};
  const auto samples = static_cast<std::size_t>(wanted);
  out.write("distance_m,profile_mm\n");
  std::vector<double> z(4096);
  for (std::size_t done = 0; done < samples;) {
    const auto block = std::span{z}.first(std::min(z.size(), samples - done));
    generator.fill(block);
    for (std::size_t i = 0; i < block.size(); ++i)
      out.write(fmt::format("{},{}\n",
                            table::csv_number(static_cast<double>(done + i) * track.spacing),
                            table::csv_number(block[i] / units::millimetre)));
    done += block.size();
  }
  tool::session().taken = out.to_standard_output();
  tool::Summary answer{"synthetic track in " + order.file.string()};
  answer.add("samples", "samples", static_cast<double>(samples), "");
  answer.add("length_km", "length", static_cast<double>(samples) * track.spacing / units::kilometre,
             "km");
  answer.add("seed", "seed", static_cast<double>(order.seed), "");
  answer.print();
  out.commit();
}

}  // namespace

tool::Tool synthesize_tool() {
  return {"synthesize", "write a synthetic track record with known parameters",
          [](tool::OptionParser& o) {
            auto order = std::make_shared<Order>();
            add_options(o, *order);
            return [order] { write_track(*order); };
          }};
}

}  // namespace railbook::psd_tool
