#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include <railbook/table/byte_source.hpp>

namespace railbook::table {

// As many bytes of a file say whether it is a container.
constexpr std::size_t container_mark = 20;

// "an HDF5 file" or "a MAT file" by the first bytes; empty where it is neither.
std::string_view container_name(std::string_view first_bytes);

// A table of an HDF5 or MAT file as CSV, from the program libexec/railbook/containers beside this
// one, or above it; `dataset` as containers::write_table takes it. Throws InputError naming the
// file, and what converts it where there is no such program; also for a file on which the program
// fails, or gives nothing for a minute.
std::unique_ptr<ByteSource> container_bytes(const std::filesystem::path& file,
                                            const std::string& dataset, std::string_view name);

}  // namespace railbook::table
