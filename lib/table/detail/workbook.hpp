#pragma once

#include <string>

namespace railbook::table {

// A sheet of a workbook (Office Open XML, .xlsx) as a table of text, row for line; by its name
// or number, else the first. Numbers
// come as the file has them, formulas as their last result, dates as days since 1900. Throws
// InputError for an archive that is damaged, holds no such sheet, or unpacks to more than 512 MiB.
std::string sheet_text(const std::string& archive, const std::string& sheet = {});

}  // namespace railbook::table
