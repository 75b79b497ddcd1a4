// Folders that go again, lines that are kept.
#include <fcntl.h>
#include <sys/inotify.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <catch2/catch.hpp>
#include <cerrno>
#include <csignal>
#include <functional>
#include <vector>

#include <railbook/files/out_file.hpp>
#include <railbook/files/outside.hpp>
#include <railbook/files/staged.hpp>
#include <railbook/units/input_error.hpp>

#include "support/set_variable.hpp"
#include "support/temporary_folder.hpp"

using namespace railbook;
using namespace Catch::Matchers;
namespace fs = std::filesystem;

namespace {

bool open_still(int descriptor) {
  return fcntl(descriptor, F_GETFD) >= 0;
}

// The next file to be opened gets it.
int lowest_free() {
  const int descriptor = dup(STDERR_FILENO);
  close(descriptor);
  return descriptor;
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
  // A name that is too long, of a folder that is there, and of one that is made first and goes
  // again.
  const std::string endless(300, 'x');
  CHECK_THROWS_WITH(files::require_makeable(old / endless), Contains("File name too long"));
  CHECK_THROWS_AS(files::MadeFolder(old / "new" / endless), InputError);
  CHECK_FALSE(fs::exists(old / "new"));
  CHECK_THROWS_AS(files::require_makeable("/proc/none"), InputError);  // asked there, not here
  if (geteuid() != 0) {
    REQUIRE(chmod(old.c_str(), 0500) == 0);
    CHECK_THROWS_WITH(files::MadeFolder(old / "c"), Contains("Permission denied"));
    REQUIRE(chmod(old.c_str(), 0700) == 0);
  }
}

TEST_CASE("unit: temporary names are unique, and leftovers of a killed program are removed") {
  const TemporaryFolder at("sweep");
  at.write(".railbook-1-1.part", "of a program that was killed");
  at.write(".railbook-2.part", "of one that is running");
  at.write("mine.part", "not ours");
  const auto days_ago = [&](const char* name, int days) {
    fs::last_write_time(at.path / name,
                        fs::file_time_type::clock::now() - std::chrono::hours{24 * days + 1});
  };
  days_ago(".railbook-1-1.part", 1), days_ago("mine.part", 2);
  files::require_makeable(at.path);
  CHECK_FALSE(fs::exists(at.path / ".railbook-1-1.part"));
  CHECK(fs::exists(at.path / ".railbook-2.part"));
  CHECK(fs::exists(at.path / "mine.part"));
  files::OutFile one(at.path / "file"), two(at.path / "file");
  CHECK(one.staged() != two.staged());
}

TEST_CASE("unit: a moved or closed file closes its own descriptor only") {
  const TemporaryFolder at("closed");
  const int free = lowest_free();
  {
    files::OutFile out(at.path / "new");
    out.write("text");
    CHECK_FALSE(out.to_standard_output());
    CHECK(out.destination() == at.path / "new");
    const fs::path part = out.staged();
    CHECK(part.parent_path() == at.path);
    CHECK(at.read(part.filename().string()) == "text");
    out.commit();
    CHECK(lowest_free() == free);  // closed already
  }
  CHECK(at.read("new") == "text");
  for (const int stream : {0, 1, 2}) CHECK(open_still(stream));
  { const files::OutFile dropped(at.path / "dropped"); }
  { const files::PrivateFolder folder; }
  { const files::MadeFolder made(at.path / "made"); }
  CHECK(lowest_free() == free);  // nothing was left open
  CHECK(at.files_in(at.path) == 1);
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

TEST_CASE("unit: one file is replaced in one step, several step aside for a moment") {
  const TemporaryFolder at("step");
  at.write("one", "old"), at.write("two", "old");
  const int watch = inotify_init1(IN_NONBLOCK | IN_CLOEXEC);
  REQUIRE(inotify_add_watch(watch, at.path.c_str(), IN_MOVED_FROM) >= 0);
  const auto moved_away =
      [&] {  // the files that were not there for a moment; ours have names with a dot
        alignas(inotify_event) std::array<char, 4096> bytes{};
        std::string names;
        const ssize_t n = read(watch, bytes.data(), bytes.size());
        for (ssize_t i = 0; i < n;) {
          const auto* event = reinterpret_cast<const inotify_event*>(bytes.data() + i);
          if (event->name[0] != '.') names += event->name + std::string(" ");
          i += static_cast<ssize_t>(sizeof(inotify_event) + event->len);
        }
        return names;
      };
  files::write(at.path / "one", "new");
  CHECK(moved_away().empty());
  std::vector<files::OutFile> all;
  all.reserve(2);
  for (const char* name : {"one", "two"}) all.emplace_back(at.path / name).write("newer");
  files::commit(all);
  CHECK(moved_away() == "one two ");
  close(watch);
  CHECK(at.read("one") + at.read("two") == "newernewer");
  CHECK(at.files_in(at.path) == 2);
}

TEST_CASE("unit: with no descriptor left, files and folders fail as the machine does") {
  const TemporaryFolder at("descriptors");
  struct rlimit before {};
  REQUIRE(getrlimit(RLIMIT_NOFILE, &before) == 0);
  const rlimit none{static_cast<rlim_t>(lowest_free()), before.rlim_max};
  REQUIRE(setrlimit(RLIMIT_NOFILE, &none) == 0);
  std::string told;
  for (const std::function<void()>& work : std::vector<std::function<void()>>{
           [&] { files::OutFile{at.path / "file"}; }, [&] { files::require_makeable(at.path); }})
    try {
      work();
    } catch (const files::OutsideError& error) {
      told += std::string(error.what()) + "\n";
    }
  setrlimit(RLIMIT_NOFILE, &before);
  CHECK(told == "file " + files::quoted_name(at.path / "file") +
                    ": cannot be written: Too many open files\nfolder " +
                    files::quoted_name(at.path) + ": cannot be written: Too many open files\n");
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
    CHECK(fs::status(text).permissions() == fs::perms(0600));
    CHECK(fs::read_symlink(folder.link("link", data)) == data);
    CHECK_FALSE(fs::exists(folder.expect("later")));
    CHECK_THROWS_WITH(folder.write("text", "again"), Contains("/text\": File exists"));
    CHECK_THROWS_WITH(folder.link("link", data), Contains("/link\": File exists"));
    errno = EDOM;  // of something else before
    CHECK_NOTHROW(folder.write("more", "abc"));
  }
  CHECK_FALSE(fs::exists(where));
  CHECK(at.read("data") == "123");
}

TEST_CASE("unit: temporary files are in TMPDIR, or in /tmp where it is none") {
  const TemporaryFolder at("tmpdir");
  const SetVariable tmpdir("TMPDIR");
  const auto private_in = [&](const char* folder) {
    tmpdir.to(folder);
    return files::PrivateFolder().path().parent_path();
  };
  for (const char* none : {"", static_cast<const char*>(nullptr)}) {
    CHECK(private_in(none) == "/tmp");
  }
  CHECK(private_in("relative") == "/tmp");
  CHECK(private_in(at.path.c_str()) == at.path);
  CHECK_THROWS_WITH(private_in("/nowhere"), StartsWith("temporary file \"/nowhere/railbook-") &&
                                                EndsWith("\": No such file or directory"));
}
