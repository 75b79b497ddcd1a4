#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include <railbook/table/byte_source.hpp>

namespace railbook::table {

// The text of a table in a file: the file's own bytes or, of a workbook (.xlsx), a sheet, by name
// or number, the first where none is named. Throws InputError naming the file for a workbook that
// cannot be read, and for a sheet of what is no workbook.
std::unique_ptr<ByteSource> table_bytes(const std::filesystem::path& file,
                                        const std::string& sheet);

}  // namespace railbook::table
