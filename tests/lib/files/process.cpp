// How a process starts and ends: its streams, its signals, its child, its last words.
#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <catch2/catch.hpp>
#include <functional>
#include <new>
#include <system_error>

#include <railbook/files/out_file.hpp>
#include <railbook/files/outside.hpp>
#include <railbook/files/staged.hpp>
#include <railbook/units/input_error.hpp>

#include "support/apart.hpp"

using namespace railbook;
namespace fs = std::filesystem;

namespace {

int status_of(const std::function<void()>& fault) {
  try {
    fault();
  } catch (...) {
    return files::status_of_exception("prog");
  }
  return 77;
}

}  // namespace

TEST_CASE("unit: a signal removes what is staged and ends the child, then the process") {
  const TemporaryFolder at("signal");
  const fs::path staged = at.path / "staged", folder = at.path / "folder";
  const auto [status, said] = apart(2, [&] {
    files::prepare_process();
    fs::create_directory(folder);
    at.write("staged", "x"), at.write("kept", "x"), at.write("folder/file", "x");
    const files::TemporaryPath doomed(staged), outer_one(folder), inner_one(folder / "file");
    files::TemporaryPath stays(at.path / "kept");
    stays.keep();
    const pid_t child = sleeper(), beside = fork();
    if (beside == 0) {
      setpgid(0, child);  // what the child may have started
      for (;;) pause();
    }
    setpgid(beside, child);
    const files::ChildGuard with(child);
    std::ofstream(at.path / "pids") << child << ' ' << beside;
    {
      const files::BlockSignals outer;
      {
        const files::BlockSignals inner;
        kill(getpid(), SIGTERM);
      }
      if (!fs::exists(staged)) return 9;  // not before the outer one ends
    }
    pause();
    return 8;
  });
  CHECK(WIFSIGNALED(status));
  CHECK(WTERMSIG(status) == SIGTERM);
  CHECK_FALSE(fs::exists(staged));
  CHECK_FALSE(fs::exists(folder));
  CHECK(fs::exists(at.path / "kept"));
  CHECK(said.empty());
  pid_t child = 0, beside = 0;
  std::ifstream(at.path / "pids") >> child >> beside;
  REQUIRE(beside > 0);
  CHECK(ends(child));
  CHECK(ends(beside));
}

TEST_CASE("unit: a closed standard stream is held, for the other direction, and an open one left") {
  const auto [status, said] = apart(2, [] {
    const auto direction = [](int stream) { return fcntl(stream, F_GETFL) & O_ACCMODE; };
    const int before = dup(0);
    close(before);
    files::prepare_process();
    const int after = dup(0);
    close(after);
    close(0), close(1), close(2);
    files::prepare_process();
    const bool held =
        direction(0) == O_WRONLY && direction(1) == O_RDONLY && direction(2) == O_RDONLY;
    return (before == after ? 0 : 1) + (held ? 0 : 2);
  });
  CHECK(status == 0);
}

TEST_CASE("unit: each kind of failure has its status and its words") {
  const auto [none, said] = apart(2, [] {
    int wrong = 0;
    wrong += status_of([] { throw InputError{"bad"}; }) != 2;
    wrong += status_of([] { throw files::OutsideError{"full"}; }) != 3;
    wrong += status_of([] { throw files::ClosedPipe{"silent"}; }) != 3;
    wrong += status_of([] { throw std::bad_alloc{}; }) != 3;
    wrong +=
        status_of([] { throw std::system_error{std::make_error_code(std::errc::io_error)}; }) != 3;
    wrong += status_of([] {
               throw std::system_error{std::make_error_code(std::errc::broken_pipe)};
             }) != 3;
    wrong += status_of([] { throw std::logic_error{"ours"}; }) != 1;
    wrong += status_of([] { throw files::OutsideError{std::string(2001, 'n')}; }) != 3;
    std::fflush(stderr);
    return wrong;
  });
  CHECK(none == 0);
  CHECK(said ==
        "prog: bad\nprog: full\nprog: not enough memory for this (a limit of the shell, ulimit -v, "
        "or of the machine)\n"
        "prog: Input/output error\nprog: ours\nprog: " +
            std::string(2000, 'n') + "... (2001 bytes)\n");
  CHECK(files::finish_process("prog", 3) == 3);
  CHECK(files::finish_process("prog", 0) == 0);
  CHECK(files::finish_process("prog", 1) == 1);
  const auto [full, message] = apart(2, [] {
    const int device = open("/dev/full", O_WRONLY);
    dup2(device, 1);
    std::printf("text");
    return files::finish_process("prog", 0);
  });
  CHECK(WEXITSTATUS(full) == 3);
  CHECK(message == "prog: standard output: No space left on device\n");
  const auto [closed, silent] = apart(2, [] {
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0) return 9;
    std::signal(SIGPIPE, SIG_IGN);
    dup2(ends[1], 1);
    close(ends[0]), close(ends[1]);
    std::printf("text");
    return files::finish_process("prog", 0);  // the reader went away: nothing is said
  });
  CHECK(WEXITSTATUS(closed) == 3);
  CHECK(silent.empty());
  const auto [again, nothing] = apart(2, [] {
    const int device = open("/dev/full", O_WRONLY);
    dup2(device, 1);
    std::printf("text");
    return files::finish_process("prog", 3);  // what failed before has been said
  });
  CHECK(WEXITSTATUS(again) == 3);
  CHECK(nothing.empty());
}

TEST_CASE("unit: large texts go to standard output in order, once") {
  const auto [status, said] = apart(1, [] {
    std::printf("before\n");
    files::OutFile out("/dev/stdout");
    if (!out.to_standard_output()) return 9;
    out.write(std::string(100000, 'a'));
    out.write("b\n");
    out.commit();
    std::printf("after\n");
    return std::fflush(stdout) == 0 ? 0 : 8;
  });
  CHECK(status == 0);
  CHECK(said == "before\n" + std::string(100000, 'a') + "b\nafter\n");
}

TEST_CASE(
    "unit: a reader of standard output that goes away is no failure to tell, a full disk is") {
  const auto fails = [](int into) {
    dup2(into, 1);
    files::OutFile out("-");
    out.write("text");
    try {
      out.commit();
    } catch (const files::ClosedPipe& closed) {
      std::fputs(closed.what(), stderr);
      return 1;
    } catch (const files::OutsideError& error) {
      std::fputs(error.what(), stderr);
      return 2;
    }
    return 0;
  };
  const auto [closed, silent] = apart(2, [&] {
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0) return 9;
    std::signal(SIGPIPE, SIG_IGN);
    close(ends[0]);
    return fails(ends[1]);
  });
  CHECK(WEXITSTATUS(closed) == 1);
  CHECK(silent == "standard output: cannot be written: Broken pipe");
  const auto [full, said] = apart(2, [&] { return fails(open("/dev/full", O_WRONLY)); });
  CHECK(WEXITSTATUS(full) == 2);
  CHECK(said == "standard output: cannot be written: No space left on device");
}

TEST_CASE(
    "unit: what was printed and lost long ago fails at the end, and a file of one's own not") {
  const TemporaryFolder at("lost");
  const auto [status, said] = apart(2, [&] {
    dup2(open("/dev/full", O_WRONLY), 1);
    std::setvbuf(stdout, nullptr, _IONBF, 0);
    std::printf("text");
    files::OutFile out(at.path / "file");
    out.write("text");
    return out.staged().empty() ? 9 : files::finish_process("prog", 0);
  });
  CHECK(WEXITSTATUS(status) == 3);
  CHECK(said == "prog: standard output: Input/output error\n");
}
