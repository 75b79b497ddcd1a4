#include <railbook/table/detail/container_bytes.hpp>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <system_error>
#include <utility>

#include <railbook/files/outside.hpp>
#include <railbook/table/line_source.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/units/printable.hpp>

namespace railbook::table {
namespace {

namespace fs = std::filesystem;

constexpr int patience = 60000;  // ms
constexpr std::size_t first_block = 1 << 16;

std::string system_reason(int error) {
  return std::generic_category().message(error);
}

// The program that reads containers; empty where there is none.
fs::path reader_program() {
  std::error_code ignored;
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
  for (fs::path at = program.parent_path(); at.has_relative_path(); at = at.parent_path())
    if (fs::path reader = at / "libexec/railbook/containers"; fs::exists(reader, ignored))
      return reader;
  return {};
}

struct Descriptor {
  int number = -1;
  ~Descriptor() {
    if (number >= 0) ::close(number);
  }
};

std::pair<int, int> make_pipe() {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0)
    throw files::OutsideError{"cannot make a pipe: " + system_reason(errno)};
  return {ends[0], ends[1]};
}

// What the program writes; when it ends badly, its message.
class ReaderOutput : public ByteSource {
 public:
  ReaderOutput(const fs::path& program, const fs::path& file, const std::string& dataset) {
    const auto [output, output_end] = make_pipe();
    output_.number = output;
    const Descriptor writing{output_end};
    const auto [messages, messages_end] = make_pipe();
    messages_.number = messages;
    const Descriptor complaining{messages_end};
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, output_end, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, messages_end, STDERR_FILENO);
    // A plain environment, so that no variable changes what the libraries do. Signals act as by
    // default.
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    sigset_t all, none;
    sigfillset(&all);
    sigemptyset(&none);
    posix_spawnattr_setsigdefault(&attributes, &all);
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK);
    std::string own = program.string(), name = file == "-" ? "/dev/stdin" : file.string();
    std::string wanted = dataset, locale = "LC_ALL=C.UTF-8";
    std::array<char*, 4> arguments{own.data(), name.data(), wanted.data(), nullptr};
    std::array<char*, 2> environment{locale.data(), nullptr};
    const int error = ::posix_spawn(&child_, own.c_str(), &actions, &attributes, arguments.data(),
                                    environment.data());
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    if (error == 0) return;
    child_ = 0;
    throw files::OutsideError{"cannot run " + own + ": " + system_reason(error)};
  }
  ~ReaderOutput() override {
    if (child_ <= 0) return;
    ::kill(child_, SIGKILL);
    int ignored = 0;
    while (::waitpid(child_, &ignored, 0) < 0 && errno == EINTR) {
    }
  }
  ReaderOutput(const ReaderOutput&) = delete;
  ReaderOutput& operator=(const ReaderOutput&) = delete;

  std::size_t read(char* to, std::size_t size) override {
    if (child_ == 0) return 0;
    pollfd ready{output_.number, POLLIN, 0};
    int came = 0;
    do {
      came = ::poll(&ready, 1, patience);
    } while (came < 0 && errno == EINTR);
    if (came == 0) throw InputError{"its reader gave nothing for a minute; it may be damaged"};
    ssize_t got = 0;
    do {
      got = ::read(output_.number, to, size);
    } while (got < 0 && errno == EINTR);
    if (got < 0) throw files::OutsideError{system_reason(errno)};
    if (got == 0) require_success();
    return static_cast<std::size_t>(got);
  }

 private:
  void require_success() {
    int status = 0;
    while (::waitpid(child_, &status, 0) < 0 && errno == EINTR) {
    }
    child_ = 0;
    if (WIFSIGNALED(status))
      throw InputError{"its reader was ended by signal " + std::to_string(WTERMSIG(status)) + " (" +
                       strsignal(WTERMSIG(status)) + "): the file is damaged, or made to harm"};
    if (WEXITSTATUS(status) == 0) return;
    std::array<char, 4096> message{};
    ssize_t got = 0;
    do {
      got = ::read(messages_.number, message.data(), message.size());
    } while (got < 0 && errno == EINTR);
    const std::string text(message.data(), static_cast<std::size_t>(got > 0 ? got : 0));
    if (WEXITSTATUS(status) == 2) throw InputError{text};
    throw files::OutsideError{text.empty() ? "its reader failed" : text};
  }

  Descriptor output_, messages_;
  pid_t child_ = 0;
};

}  // namespace

std::string_view container_name(std::string_view first) {
  if (first.starts_with("\x89HDF\r\n\x1a\n")) return "an HDF5 file";
  if (first.starts_with("MATLAB 5.0 MAT-file") || first.starts_with("MATLAB 7.3 MAT-file"))
    return "a MAT file";
  // Version 4 has no mark: type, rows, columns, whether complex and the length of the first name.
  if (first.size() < container_mark) return {};
  std::array<std::uint32_t, 5> words{};
  std::memcpy(words.data(), first.data(), sizeof words);
  if (words[0] > 4052)  // written on a machine of the other order of bytes
    for (std::uint32_t& word : words) word = __builtin_bswap32(word);
  const bool is_version_4 = words[0] <= 4052 && words[0] % 10 <= 2 && words[0] / 10 % 10 <= 5 &&
                            words[3] <= 1 && words[4] >= 1 && words[4] <= 64;
  return is_version_4 ? "a MAT file" : "";
}

std::unique_ptr<ByteSource> container_bytes(const fs::path& file, const std::string& dataset,
                                            std::string_view name) {
  const fs::path program = reader_program();
  if (program.empty())
    throw InputError{quoted_name(file) + ": this is " + std::string{name} +
                     ", and this railbook was built without libhdf5; write the numbers as CSV, for "
                     "example by h5dump or h5py, or in MATLAB by writetable or writematrix"};
  try {
    auto output = std::make_unique<ReaderOutput>(program, file, dataset);
    std::string first(first_block, '\0');  // what is wrong at once is no matter of a line
    first.resize(output->read(first.data(), first.size()));
    return joined(std::move(first), std::move(output));
  } catch (const InputError& error) {
    throw InputError{quoted_name(file) + ": " + error.what()};
  } catch (const files::OutsideError& error) {
    throw files::OutsideError{quoted_name(file) + ": " + error.what()};
  }
}

}  // namespace railbook::table
