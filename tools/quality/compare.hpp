// What `railbook quality compare` was asked for, and the runs that it compares.
#pragma once

#include <deque>
#include <memory>
#include <string>
#include <vector>

#include <railbook/quality/alignment.hpp>
#include <railbook/quality/growth.hpp>
#include <railbook/quality/runs.hpp>
#include <railbook/tool/options.hpp>
#include <railbook/tool/out_folder.hpp>
#include <railbook/tool/summary.hpp>

#include "record_options.hpp"

namespace railbook::quality_tool {

struct CompareOptions {
  tools::TrackRecordOptions record;
  quality::AlignmentOptions alignment;
  quality::GrowthOptions growth;
  double section = 200;
  std::vector<std::string> dates;
  tool::Destination out;
};

// A column in all runs.
struct ComparedColumn {
  std::string name;
  std::vector<std::unique_ptr<const records::RecordStream>> records;
  std::vector<quality::ComparedRun> runs;
};
using ComparedColumns = std::deque<ComparedColumn>;

// The records of an answer with their warnings.
void add_runs(tool::Summary& answer, const ComparedColumns& columns);

// warnings.csv, compare.json and compare.png, the deviations of all runs under such names.
void add_files(tool::OutFolder& out, const CompareOptions& options, const ComparedColumns& columns,
               const tool::Summary& answer, const std::vector<std::string>& names);

// The answer of two runs without dates: what has grown from one to the other; compare.csv.
void answer_pair(const CompareOptions& options, const ComparedColumns& columns,
                 tool::OutFolder& out);

// Of runs with dates: growth a year, and where the track was tamped; growth.csv, deviations.csv.
void answer_growth(const CompareOptions& options, const ComparedColumns& columns,
                   const std::vector<double>& years, tool::OutFolder& out);

}  // namespace railbook::quality_tool
