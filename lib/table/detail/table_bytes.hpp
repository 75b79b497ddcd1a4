#pragma once

#include <filesystem>
#include <memory>

#include <railbook/table/byte_source.hpp>
#include <railbook/table/csv.hpp>

namespace railbook::table {

// The text of a table in a file: the file's own bytes or, of a workbook (.xlsx), a sheet, by name
// or number, the first where none is named; of an HDF5 or MAT file a data set. Throws InputError
// naming the file for one of these that cannot be read, and for options that are not for it.
std::unique_ptr<ByteSource> table_bytes(const std::filesystem::path& file,
                                        const TextOptions& options);

}  // namespace railbook::table
