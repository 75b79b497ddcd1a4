#include <railbook/files/staged.hpp>

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>
#include <system_error>
#include <utility>

#include <railbook/files/outside.hpp>

namespace railbook::files {
namespace {

// All that a signal handler may touch: names in fixed places, and a process.
constexpr std::size_t slots = 4096;
constexpr std::size_t none = slots;  // the place behind them, which stays empty
std::array<std::atomic<char*>, slots + 1> names{};
std::atomic<pid_t> child{0};
constexpr std::array fatal{SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGXCPU};

void remove_name(const char* name) {
  unlink(name), rmdir(name);  // one of them is refused
}

void remove_names() {  // later ones first: files before their folders
  for (std::size_t i = slots; i-- > 0;)
    if (const char* name = names[i].exchange(nullptr)) remove_name(name);
}

// Async-signal-safe: only atomics, kill, unlink, rmdir, signal and raise.
extern "C" void end_by_signal(int signal) {
  if (const pid_t running = child.load(); running > 1)
    kill(-running, SIGKILL);  // -1 were everybody
  remove_names();
  ::signal(signal, SIG_DFL);
  raise(signal);
}

// An exception that nobody catches: before main begins, or in a thread. Without memory there is
// nothing to debug.
[[noreturn]] void end_by_exception() {
  try {
    if (const std::exception_ptr thrown = std::current_exception()) std::rethrow_exception(thrown);
  } catch (const std::bad_alloc&) {
    remove_names();
    constexpr std::string_view text = "not enough memory\n";
    [[maybe_unused]] const ssize_t said = ::write(STDERR_FILENO, text.data(), text.size());
    _exit(3);
  } catch (...) {
  }
  std::abort();
}

// Before the constructors of global objects, which may find no memory either.
[[gnu::constructor(101)]] void set_terminate_early() {
  std::set_terminate(end_by_exception);
}

// Slots are handed out upwards, so that what was made later is removed first.
std::size_t take_slot(const std::filesystem::path& path) {
  std::size_t last = slots;
  while (last > 0 && names[last - 1].load() == nullptr) --last;
  if (last == slots) throw OutsideError("too many temporary files at a time");
  char* const name = strdup(path.c_str());
  if (name == nullptr) throw std::bad_alloc();
  names[last].store(name);
  return last;
}

[[noreturn]] void no_temporary(const std::filesystem::path& path, int error) {
  throw OutsideError("temporary file " + quoted_name(path) + ": " +
                     std::generic_category().message(error));
}

std::filesystem::path temporary_folder() {
  const char* base = std::getenv("TMPDIR");
  std::string pattern = base != nullptr && base[0] == '/' ? base : "/tmp";
  pattern += "/railbook-XXXXXX";
  const BlockSignals wait;
  if (mkdtemp(pattern.data()) == nullptr) no_temporary(pattern, errno);
  return pattern;
}

}  // namespace

TemporaryPath::TemporaryPath(std::filesystem::path name)
    : path_(std::move(name)), slot_(take_slot(path_)) {}

TemporaryPath::TemporaryPath(TemporaryPath&& other) noexcept
    : path_(std::move(other.path_)), slot_(std::exchange(other.slot_, none)) {}

TemporaryPath::~TemporaryPath() {
  char* name = names[slot_].exchange(nullptr);
  if (name != nullptr) remove_name(name);
  std::free(name);
}

void TemporaryPath::keep() {
  std::free(names[std::exchange(slot_, none)].exchange(nullptr));
}

ChildGuard::ChildGuard(pid_t process) {
  child = process;
}
ChildGuard::~ChildGuard() {
  child = 0;
}

namespace {

sigset_t fatal_set() {
  sigset_t set;
  sigemptyset(&set);
  for (const int signal : fatal) sigaddset(&set, signal);
  return set;
}

int waiting = 0;

}  // namespace

BlockSignals::BlockSignals() {
  const sigset_t set = fatal_set();
  if (waiting++ == 0) sigprocmask(SIG_BLOCK, &set, nullptr);
}

BlockSignals::~BlockSignals() {
  const sigset_t set = fatal_set();
  if (--waiting == 0) sigprocmask(SIG_UNBLOCK, &set, nullptr);
}

int write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t n = TEMP_FAILURE_RETRY(::write(descriptor, text.data(), text.size()));
    if (n < 0) return errno;
    text.remove_prefix(static_cast<std::size_t>(n));
  }
  return 0;
}

PrivateFolder::PrivateFolder() {
  const BlockSignals wait;
  doomed_.emplace_back(temporary_folder());
}

PrivateFolder::~PrivateFolder() {
  while (!doomed_.empty()) doomed_.pop_back();
}

std::filesystem::path PrivateFolder::expect(std::string_view name) {
  doomed_.emplace_back(path() / name);
  return doomed_.back().path();
}

std::filesystem::path PrivateFolder::write(std::string_view name, std::string_view text) {
  std::filesystem::path file = expect(name);
  const int descriptor = open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  if (descriptor < 0) no_temporary(file, errno);
  int error = write_all(descriptor, text);
  if (close(descriptor) != 0) error = errno;
  if (error != 0) no_temporary(file, error);
  return file;
}

std::filesystem::path PrivateFolder::link(std::string_view name,
                                          const std::filesystem::path& file) {
  std::filesystem::path here = expect(name);
  if (symlink(std::filesystem::absolute(file).c_str(), here.c_str()) != 0)
    no_temporary(here, errno);
  return here;
}

void prepare_process() {
  // A closed standard stream is held by /dev/null opened for the other direction: uses of it fail,
  // as they should.
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(descriptor, F_GETFD) < 0)
      if (open("/dev/null", descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY) < 0) break;
  ::signal(SIGXFSZ, SIG_IGN);
  struct sigaction action {};
  action.sa_handler = end_by_signal;
  sigfillset(&action.sa_mask);
  for (const int signal : fatal) {
    struct sigaction before {};
    sigaction(signal, nullptr, &before);
    if (before.sa_handler != SIG_IGN) sigaction(signal, &action, nullptr);
  }
}

}  // namespace railbook::files
