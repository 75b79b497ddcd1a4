// What must not outlive the program: temporary files and folders, and a child. For the sources of
// lib/files and lib/plot.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace railbook::files {

// A name that is removed (a file, or an empty folder) when this object goes or a signal ends the
// program first.
class TemporaryPath {
 public:
  explicit TemporaryPath(std::filesystem::path name);
  ~TemporaryPath();
  TemporaryPath(TemporaryPath&& other) noexcept;
  TemporaryPath(const TemporaryPath&) = delete;
  TemporaryPath& operator=(TemporaryPath&&) = delete;
  const std::filesystem::path& path() const { return path_; }
  void keep();  // it stays after all

 private:
  std::filesystem::path path_;
  std::size_t slot_;
};

// While it lives, the child and its process group are killed when a signal ends the program. At
// most one at a time.
class ChildGuard {
 public:
  explicit ChildGuard(pid_t child);
  ~ChildGuard();
  ChildGuard(const ChildGuard&) = delete;
  ChildGuard& operator=(const ChildGuard&) = delete;
};

// The signals of prepare_process wait while it lives: for a few renames that belong together.
class BlockSignals {
 public:
  BlockSignals();
  ~BlockSignals();
  BlockSignals(const BlockSignals&) = delete;
  BlockSignals& operator=(const BlockSignals&) = delete;
};

// Writes all of it: 0, or the error's number.
int write_all(int descriptor, std::string_view text);

// A private folder in TMPDIR (else /tmp), removed with all that was put there under the names given
// to it.
class PrivateFolder {
 public:
  PrivateFolder();
  ~PrivateFolder();
  PrivateFolder(const PrivateFolder&) = delete;
  PrivateFolder& operator=(const PrivateFolder&) = delete;
  const std::filesystem::path& path() const { return doomed_.front().path(); }

  std::filesystem::path expect(std::string_view name);  // somebody else will write it
  std::filesystem::path write(std::string_view name, std::string_view text);
  std::filesystem::path link(std::string_view name, const std::filesystem::path& file);

 private:
  std::vector<TemporaryPath> doomed_;
};

}  // namespace railbook::files
