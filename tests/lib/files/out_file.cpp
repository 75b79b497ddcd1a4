#include <railbook/files/out_file.hpp>

#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <csignal>
#include <vector>

#include <railbook/units/input_error.hpp>

#include "support/temporary_folder.hpp"

using namespace railbook;
using Catch::Matchers::Contains;

namespace {

// Nothing but `expected` files is in the folder.
bool holds_only(const TemporaryFolder& at, long expected) {
  return at.files_in(at.path) == expected;
}

}  // namespace

TEST_CASE("input: a destination that is no regular file is refused and left as it is") {
  const TemporaryFolder at("kinds");
  const auto fifo = at.path / "fifo", link = at.path / "link", folder = at.path / "folder";
  const auto dangling = at.path / "dangling", real = at.write("real.csv", "old");
  REQUIRE(mkfifo(fifo.c_str(), 0600) == 0);
  std::filesystem::create_symlink(real, link);
  std::filesystem::create_symlink(at.path / "nowhere", dangling);
  std::filesystem::create_directory(folder);
  CHECK_THROWS_WITH(files::write(fifo, "x"), Contains("fifo") && Contains("a pipe"));
  CHECK_THROWS_WITH(files::write(link, "x"), Contains("symbolic link") && Contains("real.csv"));
  CHECK_THROWS_WITH(files::write(dangling, "x"), Contains("symbolic link"));
  CHECK_THROWS_WITH(files::write(folder, "x"), Contains("it is a folder"));
  CHECK_THROWS_WITH(files::write(at.path / "", "x"), Contains("it names a folder"));
  CHECK_THROWS_WITH(files::write("", "x"), Contains("the name is empty"));
  CHECK_THROWS_WITH(files::write("/dev/null", "x"), Contains("a device"));
  CHECK_THROWS_AS(files::write(real / "below.csv", "x"), InputError);
  CHECK(std::filesystem::is_fifo(fifo));
  CHECK(std::filesystem::is_symlink(link));
  CHECK(at.read("real.csv") == "old");
  CHECK_FALSE(std::filesystem::exists(at.path / "nowhere"));
  CHECK(holds_only(at, 5));
}

TEST_CASE("input: a read-only file is kept, and another keeps its permissions") {
  const TemporaryFolder at("modes");
  const auto kept = at.write("kept.csv", "old"), mine = at.write("mine.csv", "old");
  REQUIRE(chmod(kept.c_str(), 0444) == 0);
  REQUIRE(chmod(mine.c_str(), 0640) == 0);
  CHECK_THROWS_WITH(files::write(kept, "new"), Contains("read-only"));
  CHECK(at.read("kept.csv") == "old");
  files::write(mine, "new");
  CHECK(at.read("mine.csv") == "new");
  CHECK(std::filesystem::status(mine).permissions() == std::filesystem::perms(0640));
}

TEST_CASE("input: a name is only a name") {
  const TemporaryFolder at("names");
  for (const char* name : {"<touch p;echo ", "|touch p;cat ", "x';touch p;'", "$HOME", "it's mine",
                           "line\nbreak", "-rf", "`touch p`", "Gleis über Öl", "\xff\xfe", "*"}) {
    files::write(at.path / name / name, "text");
    CHECK(at.read(std::string(name) + "/" + name) == "text");
  }
  CHECK(holds_only(at, 11));
  CHECK(files::quoted_name(std::string(1001, 'n')) ==
        "\"" + std::string(1000, 'n') + "... (1001 bytes)\"");
  CHECK(files::quoted_name("line\nbreak\x1b[2J") == "\"line\\x0abreak\\x1b[2J\"");
}

TEST_CASE("input: a file that is not committed was never there") {
  const TemporaryFolder at("uncommitted");
  const auto old = at.write("old.csv", "old");
  {
    files::OutFile one(old), two(at.path / "new.csv");
    one.write("new");
    two.write(std::string(200000, 'x'));
  }
  CHECK(at.read("old.csv") == "old");
  CHECK(holds_only(at, 1));
}

TEST_CASE("input: several files come together or not at all") {
  const TemporaryFolder at("together");
  at.write("one.csv", "old");
  {
    std::vector<files::OutFile> all;
    for (const char* name : {"one.csv", "two.csv", "three.csv"}) {
      all.emplace_back(at.path / name);
      all.back().write("new");
    }
    std::filesystem::create_directory(at.path / "three.csv");  // comes in between
    CHECK_THROWS_WITH(files::commit(all), Contains("three.csv") && Contains("folder"));
  }
  CHECK(at.read("one.csv") == "old");
  CHECK(holds_only(at, 2));
}

TEST_CASE("input: files of which one was taken away leave the old ones") {
  for (const std::size_t gone : {0U, 1U}) {
    const TemporaryFolder at("taken");
    at.write("one.csv", "old"), at.write("two.csv", "old");
    {
      std::vector<files::OutFile> all;
      for (const char* name : {"one.csv", "two.csv"}) {
        all.emplace_back(at.path / name);
        all.back().write("new");
      }
      std::filesystem::remove(all[gone].staged());
      CHECK_THROWS_WITH(files::commit(all), Contains("No such file"));
    }
    CHECK(at.read("one.csv") == "old");
    CHECK(at.read("two.csv") == "old");
    CHECK(holds_only(at, 2));
  }
}

TEST_CASE(
    "input: a size limit is an error with the system's reason, and leaves nothing half-written") {
  const TemporaryFolder at("limit");
  const auto file = at.write("big.csv", "old");
  struct rlimit before {};
  REQUIRE(getrlimit(RLIMIT_FSIZE, &before) == 0);
  const rlimit small{100000, before.rlim_max};
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  REQUIRE(setrlimit(RLIMIT_FSIZE, &small) == 0);
  std::string message;
  try {
    files::write(file, std::string(300000, 'x'));
  } catch (const files::OutsideError& error) {
    message = error.what();
  }
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  CHECK_THAT(message, Contains("big.csv") && Contains("File too large"));
  CHECK(at.read("big.csv") == "old");
  CHECK(holds_only(at, 1));
}

TEST_CASE("input: a link to a folder is followed only by a name that ends in a slash") {
  const TemporaryFolder at("links");
  std::filesystem::create_directory(at.path / "real");
  std::filesystem::create_directory_symlink(at.path / "real", at.path / "link");
  CHECK_THROWS_WITH(files::require_no_link(at.path / "link"), Contains("symbolic link"));
  for (const char* name : {"link/", "real", "none"})
    CHECK_NOTHROW(files::require_no_link(at.path / name));
}
