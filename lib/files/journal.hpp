// A file that grows line by line and keeps what it has when the program is killed: for work that is taken up again.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace railbook::files {

class Journal {
 public:
  // Opens the file to write at its end; it is made if missing. What stands behind its last line feed, of a line that a kill
  // cut off, is ended by one. Throws like require_replaceable, or OutsideError.
  explicit Journal(std::filesystem::path file);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  // All of the text, whole lines, or OutsideError with the system's reason; what was written of it then is taken back.
  void append(std::string_view lines);

 private:
  std::filesystem::path file_;
  int descriptor_;
};

}  // namespace railbook::files
