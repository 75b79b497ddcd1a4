#include <railbook/table/detail/table_bytes.hpp>

#include <chrono>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

#include <railbook/files/outside.hpp>
#include <railbook/table/detail/workbook.hpp>
#include <railbook/table/line_source.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::table {
namespace {

constexpr std::string_view zip_mark = "PK\x03\x04";
constexpr std::size_t longest = std::size_t{256} << 20, chunk = 1 << 16;  // bytes

// Bytes that have been read, and those behind them.
class Joined : public ByteSource {
 public:
  Joined(std::string first, std::unique_ptr<ByteSource> rest)
      : first_(std::move(first)), rest_(std::move(rest)) {}
  std::size_t read(char* to, std::size_t size) override {
    const std::size_t n = first_.copy(to, size, at_);
    at_ += n;
    return n > 0 ? n : rest_->read(to, size);
  }
  double share() const override { return rest_->share(); }

 private:
  std::string first_;
  std::unique_ptr<ByteSource> rest_;
  std::size_t at_ = 0;
};

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
                                        const std::string& sheet) {
  auto source = open_bytes(file, std::chrono::seconds{10});
  std::string first;
  try {
    while (first.size() < zip_mark.size() &&
           read_some(*source, first, zip_mark.size() - first.size())) {
    }
    while (first.starts_with(zip_mark) && read_some(*source, first, chunk))
      if (first.size() > longest) throw InputError{"a workbook of more than 256 MiB"};
  } catch (const InputError& error) {
    throw InputError{quoted_name(file) + ", line 1: cannot be read further: " + error.what()};
  } catch (const files::OutsideError& error) {
    throw files::OutsideError{quoted_name(file) +
                              ", line 1: cannot be read further: " + error.what()};
  }
  if (!first.starts_with(zip_mark) && !sheet.empty())
    throw InputError{quoted_name(file) + ": this is no workbook (.xlsx); allowed: no --sheet"};
  if (!first.starts_with(zip_mark))
    return std::make_unique<Joined>(std::move(first), std::move(source));
  try {
    return bytes_of(sheet_text(first, sheet));
  } catch (const InputError& error) {
    throw InputError{quoted_name(file) + ": " + error.what()};
  }
}

}  // namespace railbook::table
