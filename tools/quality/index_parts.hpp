// The tool `index`: what it is asked for, and its answer.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <railbook/filters/fir_filter.hpp>
#include <railbook/quality/descriptor_filter.hpp>
#include <railbook/quality/quality_index.hpp>
#include <railbook/tool/batch.hpp>
#include <railbook/tool/out_folder.hpp>

#include "quality/car_options.hpp"
#include "record_options.hpp"

namespace railbook::quality_tool {

struct IndexOptions {
  CarOptions car;
  tools::TrackRecordOptions record;
  std::optional<double> shortest;
  double threshold = 1, accept = 0.5, segment = 200;
  tool::Destination out;
};

// An exceedance on the track.
struct Place {
  railbook::quality::Exceedance e;
  double at = 0;  // m, as the record counts
  bool unsure = false;
  const char* limit = "";
};

// Beyond this distance (m) from an end or a gap a wave within the limit is not taken for one beyond
// it: the wavelength of the resonance at posted speed, or more.
double unsure_margin(const railbook::quality::Descriptor& d,
                     const railbook::filters::FilterTaps& taps);

// `spacing` and `margin`: the builder's.
std::vector<Place> places(const railbook::quality::IndexBuilder& builder,
                          const records::RecordStream& record,
                          const railbook::quality::Descriptor& d, double spacing, double margin);

struct IndexAnswer {
  const IndexOptions& options;
  const railbook::quality::Descriptor& descriptor;
  const records::RecordStream& record;
  const railbook::filters::FilterTaps& taps;
  double shortest;  // wavelength, m
  const railbook::quality::IndexBuilder& builder;
  const std::vector<Place>& found;
  std::optional<double> short_waves;  // see ShortWaves
};
tool::Summary summary_of(const IndexAnswer& answer);
// The record as a row of a table of many, and its segments as rows after it.
void add_rows(std::vector<tool::Row>& rows, const IndexAnswer& answer, const std::string& column);
// exceedances.csv, segments.csv, histogram.csv and threshold.csv.
void write_lists(tool::OutFolder& out, const IndexAnswer& answer);

}  // namespace railbook::quality_tool
