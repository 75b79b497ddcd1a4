// The options of a record of track, shared by the tools that read one.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <railbook/records/record_file.hpp>
#include <railbook/tool/batch.hpp>
#include <railbook/tool/options.hpp>
#include <railbook/tool/summary.hpp>
#include <railbook/units/constants.hpp>

namespace railbook::tools {

// The option --bridge is kept apart until record_file(): a file has a number of samples or none.
struct TrackRecordOptions {
  tool::RecordFiles batch;
  records::RecordFile record;
  std::vector<std::string> columns{"profile"}, screen{"codes"};
  std::string resync = "refuse", decimal = "either";
  std::optional<double> bridge, section;  // samples, m
  long skip = 0, header_lines = 1;
};

void add_record_options(tool::OptionParser& parser, TrackRecordOptions& options);

// What was asked for of one file; what is read of it is shown as progress. Throws InputError when
// the gap to bridge is no whole number.
records::RecordFile record_file(const TrackRecordOptions& options,
                                const std::filesystem::path& file);

// What --help says of the files.
extern const char* const record_help;

// Length, spacing and samples of the record as lines of the answer, and its warnings.
void add_record(tool::Summary& answer, const records::RecordStream& record);
void add_record(tool::Row& row, const records::RecordStream& record);

// The warnings of one of several columns, with its name before them; of a single one, without.
void add_warnings(tool::Summary& answer, const records::RecordStream& record,
                  const std::string& column, bool several);
std::string key_of(const std::string& column, const std::string& warning, bool several);

// warnings.csv: a row for each place that is suspected or was taken out; sizes in `unit`, m or the
// SI unit of the column, of the header in mm.
extern const char* const warnings_header;
std::string warning_rows(const std::string& column, const records::RecordStream& record,
                         const std::string& before = "", double unit = units::millimetre);

// The same of several columns of one file: losses are those of all.
using Records = std::vector<std::unique_ptr<const records::RecordStream>>;
void add_records(tool::Summary& answer, const std::vector<std::string>& columns,
                 const Records& records);
void add_records(tool::Row& row, const std::vector<std::string>& columns, const Records& records);
std::string warnings_of(const std::vector<std::string>& columns, const Records& records);

}  // namespace railbook::tools
