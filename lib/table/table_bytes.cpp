#include <railbook/table/detail/table_bytes.hpp>

#include <chrono>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

#include <railbook/files/outside.hpp>
#include <railbook/table/detail/container_bytes.hpp>
#include <railbook/table/detail/workbook.hpp>
#include <railbook/table/line_source.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::table {
namespace {

constexpr std::string_view zip_mark = "PK\x03\x04";
constexpr std::size_t longest = std::size_t{256} << 20, chunk = 1 << 16;  // bytes

// Appends up to so many bytes; false at the end.
bool read_some(ByteSource& source, std::string& text, std::size_t size) {
  const std::size_t before = text.size();
  text.resize(before + size);
  const std::size_t got = source.read(text.data() + before, size);
  text.resize(before + got);
  return got > 0;
}

}  // namespace

std::unique_ptr<ByteSource> table_bytes(const std::filesystem::path& file,
                                        const TextOptions& options) {
  auto source = open_bytes(file, std::chrono::seconds{10});
  std::string first;
  try {
    while (first.size() < container_mark &&
           read_some(*source, first, container_mark - first.size())) {
    }
    while (first.starts_with(zip_mark) && read_some(*source, first, chunk))
      if (first.size() > longest) throw InputError{"a workbook of more than 256 MiB"};
  } catch (const InputError& error) {
    throw InputError{quoted_name(file) + ", line 1: cannot be read further: " + error.what()};
  } catch (const files::OutsideError& error) {
    throw files::OutsideError{quoted_name(file) +
                              ", line 1: cannot be read further: " + error.what()};
  }
  const std::string_view container = container_name(first);
  const bool workbook = first.starts_with(zip_mark);
  if (!workbook && !options.sheet.empty())
    throw InputError{quoted_name(file) + ": this is no workbook (.xlsx); allowed: no --sheet"};
  if (container.empty() && !options.dataset.empty())
    throw InputError{quoted_name(file) + ": this is no HDF5 or MAT file; allowed: no --dataset"};
  if (!container.empty() && (options.skip > 0 || options.header_lines != 1 ||
                             !options.encoding.empty() || options.decimal == ','))
    throw InputError{quoted_name(file) + ": this is " + std::string{container} +
                     "; allowed: none of --skip, --header-lines, --encoding and --decimal comma"};
  if (!container.empty()) return container_bytes(file, options.dataset, container);
  if (!workbook) return joined(std::move(first), std::move(source));
  try {
    return bytes_of(sheet_text(first, options.sheet));
  } catch (const InputError& error) {
    throw InputError{quoted_name(file) + ": " + error.what()};
  }
}

}  // namespace railbook::table
