#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

namespace railbook::table {

// The files of a zip archive in memory, stored or deflated.
class Zip {
 public:
  // Throws InputError when the archive has no directory or one that is damaged.
  explicit Zip(std::string_view archive);

  bool holds(const std::string& name) const { return files_.contains(name); }
  // Throws InputError for a file that is not there, damaged or encrypted, and when all that was
  // asked for comes to more than 512 MiB.
  std::string read(const std::string& name);

 private:
  struct File {
    std::size_t method = 0, packed = 0, size = 0, at = 0;
    bool encrypted = false;
  };
  std::string_view archive_;
  std::map<std::string, File> files_;
  std::size_t left_ = std::size_t{512} << 20;  // bytes that may still be unpacked
};

}  // namespace railbook::table
