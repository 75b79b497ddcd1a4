// What `railbook quality measures` answers of a record: a summary, rows, tables and a picture.
#pragma once

#include <string>
#include <vector>

#include <railbook/tool/batch.hpp>
#include <railbook/tool/summary.hpp>

#include "quality/measured_record.hpp"

namespace railbook::quality_tool {

tool::Summary summary_of(const MeasuresOptions& options, const Measured& measured);
// One of the record, then one a section.
std::vector<tool::Row> rows_of(const MeasuresOptions& options, const Measured& measured);
std::string table_of(const std::vector<tool::Row>& sections);
std::string exceptions_of(const Measured& measured);
// What the picture shows: the deviations in the first band, and of all that has no band.
std::string picture_of(const MeasuresOptions& options, const Measured& measured);

}  // namespace railbook::quality_tool
