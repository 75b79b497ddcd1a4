// The one place that writes results: checked first, staged beside the destination, renamed at the
// end.
//
//   files::write("out/limit.csv", text);
//
//   files::OutFile record("track.csv");          // refuses now what cannot be written
//   while (...) record.write(block);
//   record.commit();                             // without it, nothing happened
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <railbook/files/outside.hpp>
#include <railbook/files/staged.hpp>

namespace railbook::files {

// The names in a folder, sorted; none if it cannot be read. (std::filesystem's iterator ends the
// program where memory runs out.)
std::vector<std::string> names_in(const std::filesystem::path& folder);

// "-", "/dev/stdout" and what else names descriptor 1.
bool is_standard_output(const std::filesystem::path& file);

// Throws InputError, with the reason, when `file` exists and is not a regular file that may be
// replaced: a folder, a device, a pipe, a symbolic link, a read-only file; or when its name is
// empty.
void require_replaceable(const std::filesystem::path& file);

// Throws InputError when `folder` is a symbolic link and its name does not end in a slash.
void require_no_link(const std::filesystem::path& folder);

// Throws InputError, with the reason, when `folder` cannot be written to, or made where it is not
// there yet.
void require_makeable(const std::filesystem::path& folder);

// A folder and its parents, made now; those that were made are removed again unless kept. Throws
// like require_makeable.
class MadeFolder {
 public:
  explicit MadeFolder(const std::filesystem::path& folder);
  ~MadeFolder();
  MadeFolder(const MadeFolder&) = delete;
  MadeFolder& operator=(const MadeFolder&) = delete;
  void keep();

 private:
  std::vector<TemporaryPath> made_;
};

class OutFile {
 public:
  // Checks the destination and opens a temporary name beside it (standard output is written to as
  // it is). Throws InputError for a destination that is refused, OutsideError when the disk is
  // full.
  explicit OutFile(std::filesystem::path destination);
  ~OutFile();
  OutFile(OutFile&& other) noexcept;
  OutFile& operator=(OutFile&&) = delete;

  // Throws OutsideError with the system's reason.
  void write(std::string_view text);

  const std::filesystem::path& destination() const;
  // The file that holds what was written so far; not for standard output.
  const std::filesystem::path& staged();
  bool to_standard_output() const;
  void commit();

 private:
  struct State;
  std::unique_ptr<State> state_;
  friend void commit(std::span<OutFile> all);
};

// All of them, or none: when one cannot be renamed, those before it are put back. Standard output
// is flushed first.
void commit(std::span<OutFile> all);

// Removes a regular file, and nothing else; throws like require_replaceable, or OutsideError.
void remove(const std::filesystem::path& file);

// One whole file; its folder is made if need be.
void write(const std::filesystem::path& file, std::string_view text);

}  // namespace railbook::files
