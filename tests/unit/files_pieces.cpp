// Folders that go again, lines that are kept, a process that is ended with its child.
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <catch2/catch.hpp>
#include <csignal>
#include <new>
#include <system_error>
#include <utility>

#include "../support/temporary_folder.hpp"
#include "files/journal.hpp"
#include "files/out_file.hpp"
#include "files/outside.hpp"
#include "files/spool.hpp"
#include "files/staged.hpp"
#include "units/input_error.hpp"

using namespace railbook;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

namespace {

bool open_still(int descriptor) {
  return fcntl(descriptor, F_GETFD) >= 0;
}

// What `work` prints on a stream (1 or 2) and how it ends, in a process of its own.
template <class Work>
std::pair<int, std::string> apart(int stream, const Work& work) {
  const TemporaryFolder at("apart");
  const fs::path said = at.path / "said";
  std::fflush(nullptr);  // or the child says it once more
  const pid_t child = fork();
  if (child == 0) {
    const int file = open(said.c_str(), O_WRONLY | O_CREAT, 0600);
    dup2(file, stream);
    _exit(work());
  }
  int status = 0;
  waitpid(child, &status, 0);
  return {status, at.read("said")};
}

int status_of(const std::function<void()>& fault) {
  try {
    fault();
  } catch (...) {
    return files::status_of_exception("prog");
  }
  return 77;
}

}  // namespace

TEST_CASE("unit: only the names of standard output are its own") {
  for (const char* name : {"-", "/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"})
    CHECK(files::is_standard_output(name));
  for (const char* name : {"", "--", "./-", "/dev/stderr", "x"})
    CHECK_FALSE(files::is_standard_output(name));
}

TEST_CASE("unit: folders that were made go again, innermost first, unless kept") {
  const TemporaryFolder at("made");
  const fs::path old = at.path / "old", deep = old / "a" / "b" / "";
  fs::create_directory(old);
  {
    const files::MadeFolder made(deep);
    CHECK(fs::is_directory(deep));
  }
  CHECK(fs::exists(old));
  CHECK_FALSE(fs::exists(old / "a"));
  {
    files::MadeFolder made(deep);
    made.keep();
  }
  CHECK(fs::is_directory(deep));
  CHECK(at.files_in(deep) == 0);
  const fs::path file = at.write("file", "x");
  CHECK_THROWS_WITH(files::MadeFolder(file / "below"), Contains("Not a directory"));
  CHECK_THROWS_WITH(files::require_makeable(file), Contains("Not a directory"));
  if (geteuid() != 0) {
    REQUIRE(chmod(old.c_str(), 0500) == 0);
    CHECK_THROWS_WITH(files::MadeFolder(old / "c"), Contains("Permission denied"));
    REQUIRE(chmod(old.c_str(), 0700) == 0);
  }
}

TEST_CASE("unit: a journal ends a line that was cut off, and goes on after a whole one") {
  const TemporaryFolder at("journal");
  const fs::path file = at.path / "rows";
  files::Journal(file).append("one\n");
  files::Journal(file).append("two\n");
  CHECK(at.read("rows") == "one\ntwo\n");
  at.write("rows", "one\ntw");
  files::Journal(file).append("three\n");
  CHECK(at.read("rows") == "one\ntw\nthree\n");
  CHECK_THROWS_WITH(files::Journal(at.path), Contains("it is a folder"));
  CHECK_THROWS_AS(files::Journal(at.path / "no" / "rows"), files::OutsideError);

  struct rlimit before {};
  REQUIRE(getrlimit(RLIMIT_FSIZE, &before) == 0);
  const rlimit small{100, before.rlim_max};
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  files::Journal full(file);
  REQUIRE(setrlimit(RLIMIT_FSIZE, &small) == 0);
  std::string message;
  try {
    full.append(std::string(200, 'x') + "\n");
  } catch (const files::OutsideError& error) {
    message = error.what();
  }
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  CHECK_THAT(message, Contains("rows") && Contains("File too large"));
  CHECK(at.read("rows") == "one\ntw\nthree\n");  // what was written is taken back
}

TEST_CASE("unit: what is moved or ended closes its own file and no other") {
  const TemporaryFolder at("closed");
  {
    files::Spool one;
    const files::Spool two = std::move(one);
  }
  {
    files::OutFile out(at.path / "new");
    out.write("text");
    CHECK_FALSE(out.to_standard_output());
    CHECK(out.destination() == at.path / "new");
    const fs::path part = out.staged();
    CHECK(part.parent_path() == at.path);
    CHECK(at.read(part.filename().string()) == "text");
    out.commit();
  }
  CHECK(at.read("new") == "text");
  for (const int stream : {0, 1, 2}) CHECK(open_still(stream));
  const int free = open("/dev/null", O_RDONLY);
  close(free);
  { const files::OutFile dropped(at.path / "dropped"); }
  { files::Journal(at.path / "lines").append("a\n"); }
  { const files::PrivateFolder folder; }
  const int again = open("/dev/null", O_RDONLY);
  close(again);
  CHECK(again == free);  // nothing was left open
  CHECK(at.files_in(at.path) == 2);
}

TEST_CASE("unit: a file is the owner's and has the modes of the old one") {
  const TemporaryFolder at("owner");
  const fs::path file = at.write("file", "old");
  REQUIRE(chmod(file.c_str(), 0604) == 0);
  if (geteuid() == 0) REQUIRE(chown(file.c_str(), 12, 34) == 0);
  struct stat before {
  }, after{};
  REQUIRE(stat(file.c_str(), &before) == 0);
  files::write(file, "new");
  REQUIRE(stat(file.c_str(), &after) == 0);
  CHECK(after.st_mode == before.st_mode);
  CHECK(after.st_uid == before.st_uid);
  CHECK(after.st_gid == before.st_gid);
  CHECK(after.st_ino != before.st_ino);
  files::remove(file);
  CHECK_FALSE(fs::exists(file));
  CHECK_NOTHROW(files::remove(file));
  CHECK_THROWS_AS(files::remove(at.path), InputError);
  CHECK_THROWS_WITH(files::remove("/proc/self/comm"),
                    Contains("cannot be removed: ") && Contains("ermi"));
}

TEST_CASE("unit: a private folder goes with all that was put there") {
  const TemporaryFolder at("private");
  const fs::path data = at.write("data", "123");
  fs::path where;
  {
    files::PrivateFolder folder;
    where = folder.path();
    CHECK((fs::status(where).permissions() & fs::perms(0077)) == fs::perms::none);
    const fs::path text = folder.write("text", "abc");
    CHECK(fs::file_size(text) == 3);
    CHECK(fs::read_symlink(folder.link("link", data)) == data);
    CHECK_FALSE(fs::exists(folder.expect("later")));
    CHECK_THROWS_AS(folder.write("text", "again"), files::OutsideError);
  }
  CHECK_FALSE(fs::exists(where));
  CHECK(at.read("data") == "123");
}

TEST_CASE("unit: a signal removes what is staged and ends the child, then the process") {
  const TemporaryFolder at("signal");
  const fs::path staged = at.path / "staged", kept = at.path / "kept", pid = at.path / "pid";
  const auto [status, said] = apart(2, [&] {
    files::prepare_process();
    at.write("staged", "x"), at.write("kept", "x");
    const files::Doomed doomed(staged);
    files::Doomed stays(kept);
    stays.keep();
    const pid_t child = fork();
    if (child == 0) {
      setpgid(0, 0);
      pause();
      _exit(0);
    }
    setpgid(child, child);
    const files::DoomedChild with(child);
    at.write("pid", std::to_string(child));
    {
      const files::SignalsWait outer;
      {
        const files::SignalsWait inner;
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
  CHECK(fs::exists(kept));
  // The child is dead, or a zombie whose parent is.
  const int child = std::stoi(at.read("pid"));
  bool ended = false;
  for (int k = 0; k < 500 && !ended; ++k) {
    std::ifstream stat("/proc/" + std::to_string(child) + "/stat");
    std::string all;
    std::getline(stat, all);
    ended = !stat || all.find(") Z") != all.npos;
    usleep(10000);
  }
  CHECK(ended);
  CHECK(said.empty());
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
    std::fflush(stderr);
    return wrong;
  });
  CHECK(none == 0);
  CHECK(said ==
        "prog: bad\nprog: full\nprog: not enough memory for this (a limit of the shell, ulimit -v, "
        "or of the machine)\n"
        "prog: Input/output error\nprog: ours\n");
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
    files::OutFile out("-");
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
