// What must not outlive the program: temporary files and folders, and a child. For the sources of lib/files and lib/plot.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace railbook::files {

// A name that is removed (a file, or an empty folder) when this object goes or a signal ends the program first.
class Doomed {
 public:
  explicit Doomed(std::filesystem::path name);
  ~Doomed();
  Doomed(Doomed&& other) noexcept;
  Doomed(const Doomed&) = delete;
  Doomed& operator=(Doomed&&) = delete;
  const std::filesystem::path& path() const { return path_; }
  void keep();  // it stays after all

 private:
  std::filesystem::path path_;
  std::size_t slot_;
};

// While it lives, the child and its process group are killed when a signal ends the program. At most one at a time.
class DoomedChild {
 public:
  explicit DoomedChild(pid_t child);
  ~DoomedChild();
  DoomedChild(const DoomedChild&) = delete;
  DoomedChild& operator=(const DoomedChild&) = delete;
};

// The signals of prepare_process wait while it lives: for a few renames that belong together.
class SignalsWait {
 public:
  SignalsWait();
  ~SignalsWait();
  SignalsWait(const SignalsWait&) = delete;
  SignalsWait& operator=(const SignalsWait&) = delete;
};

// Writes all of it: 0, or the error's number.
int write_all(int descriptor, std::string_view text);

// A private folder in TMPDIR (else /tmp), removed with all that was put there under the names given to it.
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
  std::vector<Doomed> doomed_;
};

}  // namespace railbook::files
