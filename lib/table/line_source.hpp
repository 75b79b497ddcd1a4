// The lines of a text file, one at a time, with the system's word when reading fails.
#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace railbook::table {

// Reads a file, a pipe or a FIFO from its beginning to its end, once, in the memory of its longest line.
class LineSource {
 public:
  // Throws InputError with the system's reason when `file` cannot be opened, or is a folder; also for a FIFO that nobody has
  // opened to write to within `patience`. A writer that is there is waited for.
  explicit LineSource(const std::filesystem::path& file,
                      std::chrono::milliseconds patience = std::chrono::seconds{10});

  // The next line into `line`, without its line feed; false at the end. Throws files::OutsideError when reading fails in
  // mid-file, and InputError for a line of more than 64 MiB: both name file, line and reason.
  bool next(std::string& line);

  std::size_t line() const { return line_; }  // number of the last line read, from 1
  const std::filesystem::path& file() const { return file_; }

 private:
  bool fill();
  std::string here() const;

  struct Descriptor {
    explicit Descriptor(int number) : value(number) {}
    ~Descriptor();
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    int value;
  };
  std::filesystem::path file_;
  std::unique_ptr<Descriptor> descriptor_;
  std::vector<char> buffer_;
  std::size_t begin_ = 0, end_ = 0;  // of what is read but not used
  std::size_t line_ = 0;
};

}  // namespace railbook::table
