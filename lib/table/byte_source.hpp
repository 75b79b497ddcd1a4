// Where the bytes of a text come from: a file or a pipe, unpacked and decoded on the way.
#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace railbook::table {

// Bytes, once from their beginning to their end.
class ByteSource {
 public:
  virtual ~ByteSource() = default;
  // The next bytes, `size` at the most; 0 at the end. Throws InputError for damaged data and
  // files::OutsideError when the system fails; the messages name neither file nor line.
  virtual std::size_t read(char* to, std::size_t size) = 0;
  // How much has been read, 0 to 1; -1 where the size is not known.
  virtual double share() const { return -1; }
};

// A file, a pipe or a FIFO; - is standard input. Data packed by gzip are unpacked. Throws as
// LineSource does.
std::unique_ptr<ByteSource> open_bytes(const std::filesystem::path& file,
                                       std::chrono::milliseconds patience);

// A text in memory.
std::unique_ptr<ByteSource> bytes_of(std::string text);

// Bytes that have been read, and those behind them.
std::unique_ptr<ByteSource> joined(std::string first, std::unique_ptr<ByteSource> rest);

// Text in another encoding ("cp1252", "GBK": what iconv knows), as UTF-8. `first` are bytes of it
// that have been read before. Throws InputError when iconv does not know the encoding.
std::unique_ptr<ByteSource> decoded(std::unique_ptr<ByteSource> source, const std::string& encoding,
                                    std::string_view first = {});

}  // namespace railbook::table
