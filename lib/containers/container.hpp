// Tables in files of arrays (HDF5, netCDF-4 and MATLAB's): which arrays make one table, and its
// text. The libraries that open them serve the program `containers` only; the command starts it
// where it meets such a file (table/detail/container_bytes.hpp), so that it waits for none of them
// and outlives what a hostile file makes of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <variant>
#include <vector>

namespace railbook::containers {

// Of what is read of a file: objects or arrays, groups in groups, columns of an array.
inline constexpr std::size_t most_objects = 20000, most_depth = 16, most_columns = 16384;

struct Column {
  std::string name, unit;  // the unit as the file has it; empty where it names none
};

// Of one column: numbers as wide as they are in the file, or texts. NaN is a lost sample.
using Values = std::variant<std::vector<double>, std::vector<float>, std::vector<std::int64_t>,
                            std::vector<std::uint64_t>, std::vector<std::string>>;

// An array of a file: a vector is a column, a matrix or an array of compounds several.
struct DataSet {
  std::string group, name;  // "run/1" and "left"; no group at the top
  std::size_t rows = 0;
  std::vector<Column> columns;
  // The rows [first, first + count): values a column. Throws InputError for damaged data.
  std::function<std::vector<Values>(std::size_t first, std::size_t count)> read;

  std::string path() const { return group.empty() ? name : group + "/" + name; }
};

struct Contents {
  std::vector<DataSet> sets;        // of two rows or more
  std::vector<std::string> unread;  // what else there is, with the reason: "x (complex)"
};

// What a file holds, by its first bytes. Throws InputError for one that is neither, or damaged.
Contents contents_of(const std::filesystem::path& file);
Contents hdf5_contents(const std::filesystem::path& file);
Contents mat_contents(const std::filesystem::path& file);  // of version 4 to 7

// Takes the text of a table in pieces.
using TextSink = std::function<void(const std::string& text)>;

// The table named, as CSV with a line of headers: arrays of one length in a group ("run/1"), or
// those listed with commas ("x,run/1/left"); none named, the only one there is. Numbers are the
// shortest decimals that are read back as the same number of their width. Memory: some ten thousand
// cells, a row of the file's chunks, and the whole of a variable of MATLAB before 7.3. Throws
// InputError that lists what there is.
void write_table(const Contents& contents, const std::string& wanted, const TextSink& sink);

}  // namespace railbook::containers
