#include <railbook/files/out_file.hpp>

#include <dirent.h>
#include <fcntl.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <railbook/units/input_error.hpp>

namespace railbook::files {
namespace {

namespace fs = std::filesystem;

std::string reason(int error) {
  return std::generic_category().message(error);
}

[[noreturn]] void refuse(const char* what, const fs::path& file, const std::string& why) {
  throw InputError(std::string(what) + " " + quoted_name(file) + ": cannot be written: " + why);
}

// A destination that the system refuses.
[[noreturn]] void refuse(const char* what, const fs::path& file, int error) {
  if (is_of_machine(error))
    throw OutsideError(std::string(what) + " " + quoted_name(file) +
                       ": cannot be written: " + reason(error));
  refuse(what, file, reason(error));
}

fs::path folder_of(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

constexpr std::string_view temporary_start = ".railbook-", temporary_end = ".part";

// A hidden name beside `file`. At random: the numbers of processes are the same in two containers
// that share a folder.
fs::path temporary_beside(const fs::path& file) {
  std::uint64_t number = 0;
  if (getrandom(&number, sizeof number, 0) != sizeof number)
    throw OutsideError("no random name for a temporary file: " + reason(errno));
  std::array<char, 16> digits{};
  const auto [end, status] = std::to_chars(digits.begin(), digits.end(), number, 16);
  std::string name{temporary_start};
  name.append(digits.begin(), end).append(temporary_end);
  return folder_of(file) / name;
}

// A file that was made now, under a name that was nobody's: only then it may be removed.
struct Temporary {
  int descriptor = -1;  // -1: the system refused, errno says why
  std::optional<TemporaryPath> name;
};

Temporary make_beside(const fs::path& file) {
  Temporary made;
  const BlockSignals wait;  // between the file and its owner
  do {
    const fs::path name = temporary_beside(file);
    made.descriptor =
        open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (made.descriptor < 0) continue;
    try {
      made.name.emplace(name);
    } catch (...) {  // nobody else would remove it
      close(made.descriptor);
      unlink(name.c_str());
      throw;
    }
  } while (made.descriptor < 0 && errno == EEXIST);
  return made;
}

// Removes what programs that were killed have left in a folder: temporary files that nobody has
// written to for a day.
void sweep(const fs::path& folder) {
  const fs::file_time_type yesterday = fs::file_time_type::clock::now() - std::chrono::hours{24};
  for (const std::string& name : names_in(folder)) {
    if (!name.starts_with(temporary_start) || !name.ends_with(temporary_end)) continue;
    const fs::path file = folder / name;
    std::error_code failed;
    if (!fs::is_regular_file(fs::symlink_status(file, failed))) continue;
    const fs::file_time_type written = fs::last_write_time(file, failed);
    if (!failed && written < yesterday) unlink(file.c_str());
  }
}

}  // namespace

std::vector<std::string> names_in(const fs::path& folder) {
  const std::unique_ptr<DIR, int (*)(DIR*)> open(opendir(folder.c_str()), closedir);
  std::vector<std::string> names;
  while (open) {
    const dirent* entry = readdir(open.get());
    if (entry == nullptr) break;
    const std::string_view name = entry->d_name;
    if (name != "." && name != "..") names.emplace_back(name);
  }
  std::ranges::sort(names);
  return names;
}

bool is_standard_output(const fs::path& file) {
  for (const char* name : {"-", "/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"})
    if (file == name) return true;
  return false;
}

void require_replaceable(const fs::path& file) {
  if (file.empty()) throw InputError("file \"\": the name is empty; allowed: the name of a file");
  if (!file.has_filename()) refuse("file", file, "it names a folder");
  struct stat now {};
  if (lstat(file.c_str(), &now) != 0) {
    if (errno == ENOENT) return;
    refuse("file", file, errno);
  }
  if (S_ISLNK(now.st_mode)) {
    std::error_code ignored;
    refuse("file", file,
           "it is a symbolic link, to " + quoted_name(fs::read_symlink(file, ignored)) +
               "; give the name of the file itself");
  }
  if (S_ISDIR(now.st_mode)) refuse("file", file, "it is a folder");
  if (!S_ISREG(now.st_mode))
    refuse("file", file,
           "it is a device, a pipe or a socket; allowed: a regular file, or - for standard output");
  if ((now.st_mode & 0222) == 0 || access(file.c_str(), W_OK) != 0)
    refuse("file", file, "it is read-only");
}

void require_no_link(const fs::path& folder) {
  struct stat now {};
  if (lstat(folder.c_str(), &now) != 0 || !S_ISLNK(now.st_mode)) return;
  std::error_code ignored;
  refuse("folder", folder,
         "it is a symbolic link, to " + quoted_name(fs::read_symlink(folder, ignored)) +
             "; end the name in a slash to follow it");
}

void require_makeable(const fs::path& folder) {
  fs::path there;  // the innermost part that exists
  struct stat now {};
  for (const fs::path& part : folder) {
    const fs::path next = there / part;
    if (stat(next.c_str(), &now) != 0) {
      if (errno == ENOENT) break;
      refuse("folder", folder, errno);
    }
    if (!S_ISDIR(now.st_mode)) refuse("folder", folder, ENOTDIR);
    there = next;
  }
  const Temporary trial = make_beside(there / "trial");
  if (trial.descriptor < 0) refuse("folder", folder, errno);
  close(trial.descriptor);
  sweep(there.empty() ? "." : there);
}

MadeFolder::MadeFolder(const fs::path& folder) {
  require_makeable(folder);
  fs::path so_far;
  for (const fs::path& part : folder) {
    so_far /= part;
    const BlockSignals wait;
    if (mkdir(so_far.c_str(), 0777) == 0) {
      made_.emplace_back(so_far);
      continue;
    }
    const int error = errno;
    std::error_code ignored;
    if (!fs::is_directory(so_far, ignored)) refuse("folder", folder, error);
  }
}

MadeFolder::~MadeFolder() {
  while (!made_.empty()) made_.pop_back();  // the innermost first
}

void MadeFolder::keep() {
  for (TemporaryPath& folder : made_) folder.keep();
}

struct OutFile::State {
  explicit State(fs::path file)
      : destination(std::move(file)), standard(is_standard_output(destination)) {
    if (standard) return;
    require_replaceable(destination);
    Temporary made = make_beside(destination);
    if (made.descriptor < 0) refuse("file", destination, errno);
    descriptor = made.descriptor;
    part.emplace(std::move(*made.name));
    struct stat old {};
    if (lstat(destination.c_str(), &old) != 0) return;
    if (fchmod(descriptor, old.st_mode & 07777) != 0) refuse("file", destination, errno);
    // Whose it was, where we may.
    [[maybe_unused]] const int given = fchown(descriptor, old.st_uid, old.st_gid);
  }
  ~State() {
    close(descriptor);  // standard output, or what is finished, has none: the system refuses
  }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  [[noreturn]] void fail(int error) const {
    const std::string who = standard ? "standard output" : "file " + quoted_name(destination);
    const std::string text = who + ": cannot be written: " + reason(error);
    if (standard && error == EPIPE) throw ClosedPipe(text);
    throw OutsideError(text);
  }

  void flush() {
    if (standard) flush_standard_output();
    const int error = write_all(standard ? STDOUT_FILENO : descriptor, buffer);
    if (error != 0) fail(error);
    buffer.clear();
  }

  // All of it is on its way to the disk.
  void finish() {
    flush();
    if (descriptor >= 0 && close(std::exchange(descriptor, -1)) != 0) fail(errno);
  }

  fs::path destination;
  bool standard;
  std::optional<TemporaryPath> part;
  int descriptor = -1;
  std::string buffer;
};

OutFile::OutFile(fs::path destination) : state_(std::make_unique<State>(std::move(destination))) {}
OutFile::~OutFile() = default;
OutFile::OutFile(OutFile&&) noexcept = default;

void OutFile::write(std::string_view text) {
  constexpr std::size_t enough = 1 << 16;
  state_->buffer += text;
  if (state_->buffer.size() >= enough) state_->flush();
}

const fs::path& OutFile::destination() const {
  return state_->destination;
}

const fs::path& OutFile::staged() {
  state_->flush();
  return state_->part.value().path();
}

bool OutFile::to_standard_output() const {
  return state_->standard;
}

void OutFile::commit() {
  files::commit(std::span(this, 1));
}

void commit(std::span<OutFile> all) {
  flush_standard_output();
  for (OutFile& file : all) file.state_->finish();
  for (const OutFile& file : all)
    if (!file.state_->standard) require_replaceable(file.state_->destination);
  // The old files step aside until all the new ones are in place (for one file, a rename does both
  // at once). What needs memory is done before the first is moved.
  struct Move {
    OutFile::State* file;
    fs::path aside;  // empty: no old file
    bool stepped = false, placed = false;
  };
  std::vector<Move> moves;
  for (OutFile& file : all) {
    if (file.state_->standard) continue;
    std::error_code ignored;
    const bool old = all.size() > 1 && fs::exists(file.state_->destination, ignored);
    moves.push_back(
        {file.state_.get(), old ? temporary_beside(file.state_->destination) : fs::path{}});
  }
  const auto moved = [](const fs::path& from, const fs::path& to) {
    return rename(from.c_str(), to.c_str()) == 0;
  };
  const BlockSignals wait;
  for (Move& m : moves) {
    m.stepped = !m.aside.empty() && moved(m.file->destination, m.aside);
    m.placed = m.stepped == !m.aside.empty() && moved(m.file->part->path(), m.file->destination);
    if (m.placed) continue;
    const int error = errno;
    for (const Move& done : moves)
      if (done.placed) moved(done.file->destination, done.file->part->path());
    for (const Move& done : moves)
      if (done.stepped) moved(done.aside, done.file->destination);
    m.file->fail(error);
  }
  for (const Move& m : moves)
    if (m.stepped) unlink(m.aside.c_str());
}

void remove(const fs::path& file) {
  require_replaceable(file);
  if (unlink(file.c_str()) != 0 && errno != ENOENT)
    throw OutsideError("file " + quoted_name(file) + ": cannot be removed: " + reason(errno));
}

void write(const fs::path& file, std::string_view text) {
  require_replaceable(file);
  MadeFolder folder(folder_of(file));
  OutFile out(file);
  out.write(text);
  out.commit();
  folder.keep();
}

}  // namespace railbook::files
