#pragma once

// What a file is that is no table of text, by its first line.

#include <string_view>

namespace railbook::table {

// What a file with this first line is and how to make a text file of it ("an HDF5 file; write
// ..."), or nothing where the line may be a table's. The line comes without a byte order mark of
// UTF-8.
std::string_view foreign_format(std::string_view first_line);

}  // namespace railbook::table
