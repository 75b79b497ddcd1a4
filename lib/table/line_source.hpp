// The lines of a text file, one at a time, with the system's word when reading fails.
#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <railbook/table/byte_source.hpp>

namespace railbook::table {

// A file as errors name it: standard input, or file "NAME".
std::string quoted_name(const std::filesystem::path& file);

// Reads a file, a pipe or a FIFO from its beginning to its end, once, in the memory of its longest
// line; - is standard input. A file packed by gzip is unpacked as it is read. A byte order mark of
// UTF-16 is obeyed; lines that end in a carriage return alone, as in old files, are lines.
class LineSource {
 public:
  // Throws InputError with the system's reason when `file` cannot be opened, or is a folder
  // (OutsideError when the machine is at its end: no descriptors, no memory); also for a FIFO that
  // nobody has opened to write to within `patience`. A writer that is there is waited for.
  explicit LineSource(const std::filesystem::path& file,
                      std::chrono::milliseconds patience = std::chrono::seconds{10})
      : LineSource(file, open_bytes(file, patience)) {}
  // Other bytes, in an encoding that iconv knows (none: UTF-8); `file` is their name in errors.
  LineSource(const std::filesystem::path& file, std::unique_ptr<ByteSource> bytes,
             const std::string& encoding = {});

  // The next line, without its line feed; false at the end. The view holds until the next call.
  // Throws files::OutsideError when reading fails in mid-file, and InputError for a line of more
  // than 64 MiB and for gzip data that are damaged or cut off: all name file, line and reason.
  bool next(std::string_view& line);
  bool next(std::string& line);

  // What is in memory of the next lines, whole ones with their line feeds, maybe none (so many
  // bytes before and behind may be read, too); and how much of it has been used.
  static constexpr std::size_t margin = 64;
  std::string_view lines_ahead();
  void use(std::size_t bytes, std::size_t lines) { begin_ += bytes, line_ += lines; }

  std::size_t line() const { return line_; }  // number of the last line read, from 1
  const std::filesystem::path& file() const { return file_; }
  // How much of the file has been read, 0 to 1; -1 where its size is not known.
  double share() const { return bytes_->share(); }

 private:
  std::size_t fill(char* to, std::size_t size);
  char* data() { return buffer_.data() + margin; }
  std::size_t room() const { return buffer_.size() - 2 * margin; }
  std::string here() const;

  std::filesystem::path file_;
  std::unique_ptr<ByteSource> bytes_;
  std::vector<char> buffer_;         // with a margin before and behind
  std::size_t begin_ = 0, end_ = 0;  // of what is read but not used
  std::size_t whole_ = 0;            // end of its last whole line, once looked for
  std::size_t line_ = 0;
  bool returns_ = false;  // lines end in a carriage return alone
};

}  // namespace railbook::table
