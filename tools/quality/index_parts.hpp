// The tool `index`: what it is asked for, and its answer.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "quality/car_options.hpp"
#include "quality/descriptor_filter.hpp"
#include "quality/quality_index.hpp"
#include "tool/out_folder.hpp"

namespace railbook::quality_tool {

struct IndexWish {
  CarWish car;
  std::filesystem::path file;
  std::string column = "profile", distance = "distance";
  std::optional<double> spacing, shortest;
  double threshold = 1, accept = 0.5, segment = 200;
  long bridge = 0;
  tool::Destination out;
};

// What the record held.
struct Reading {
  double first = 0, spacing = 0;  // m
  std::size_t samples = 0, missing = 0, bridged = 0;
};

// An exceedance on the track.
struct Place {
  railbook::quality::Exceedance e;
  double at = 0;  // m, as the record counts
  bool unsure = false;
  const char* limit = "";
};

// The wavelength of the resonance at posted speed, m.
double resonant_wave(const railbook::quality::Descriptor& d);

std::vector<Place> places(const railbook::quality::IndexBuilder& builder, double first,
                          const railbook::quality::Descriptor& d);

struct IndexAnswer {
  const IndexWish& wish;
  const railbook::quality::Descriptor& descriptor;
  const Reading& reading;
  const railbook::quality::FilterTaps& taps;
  double shortest;  // wavelength, m
  const railbook::quality::IndexBuilder& builder;
  const std::vector<Place>& found;
};
tool::Summary summary_of(const IndexAnswer& answer);
// exceedances.csv, segments.csv, histogram.csv and threshold.csv.
void write_lists(tool::OutFolder& out, const IndexAnswer& answer);

}  // namespace railbook::quality_tool
