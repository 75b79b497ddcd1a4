// Turns with the clock, between two processes that share a folder.
#include <railbook/report/turn.hpp>

#include <fcntl.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>

#include "support/set_variable.hpp"
#include "support/temporary_folder.hpp"

using namespace railbook;

TEST_CASE("the two processes", "[.turn]") {  // hidden: run by the one below
  const TemporaryFolder folder("turn");
  REQUIRE(setenv("RAILBOOK_TURNS", folder.path.c_str(), 1) == 0);
  std::array<int, 2> pipe_ends{};
  REQUIRE(pipe(pipe_ends.data()) == 0);
  const pid_t child = fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    const report::WorkSlot turn;
    if (write(pipe_ends[1], "b", 1) != 1) _exit(1);
    usleep(100000);
    const bool said_so = write(pipe_ends[1], "e", 1) == 1;
    _exit(said_so ? 0 : 1);  // with its turn: the lock goes with the process
  }
  char said = 0;
  REQUIRE(read(pipe_ends[0], &said, 1) == 1);
  const report::WorkSlot beside;  // side by side with the child
  {
    const report::TimingLock alone;
    pollfd ready{pipe_ends[0], POLLIN, 0};
    REQUIRE(poll(&ready, 1, 0) == 1);
    REQUIRE(read(pipe_ends[0], &said, 1) == 1);
    CHECK(said == 'e');
  }
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  CHECK(status == 0);
}

TEST_CASE("turns from within", "[.turn]") {  // hidden: run by the last one
  umask(022);
  const TemporaryFolder folder("turns");
  REQUIRE(setenv("RAILBOOK_TURNS", folder.path.c_str(), 1) == 0);
  const auto free_for = [&](int how, const char* name) {
    const int other = open((folder.path / name).c_str(), O_RDWR | O_CREAT, 0666);
    const bool got = flock(other, how | LOCK_NB) == 0;
    close(other);
    return got;
  };
  const auto all_free = [&] {
    return free_for(LOCK_EX, "room") && free_for(LOCK_EX, "place-1") &&
           free_for(LOCK_EX, "place-2");
  };
  for (const char* place : {"place-1", "place-2", "place-4"}) REQUIRE(free_for(LOCK_EX, place));
  { const report::TimingLock without_work; }
  CHECK(all_free());
  {
    const report::WorkSlot work;
    for (int k = 0; k < 2; ++k) {
      CHECK_FALSE(free_for(LOCK_EX, "place-1"));
      CHECK(free_for(LOCK_EX, "place-2"));
      CHECK(free_for(LOCK_SH, "room"));
      CHECK_FALSE(free_for(LOCK_EX, "room"));
      const report::TimingLock clock;
      CHECK(free_for(LOCK_EX, "place-1"));  // others may do nothing with it
      CHECK_FALSE(free_for(LOCK_SH, "room"));
    }
  }
  CHECK(all_free());
  { const report::TimingLock after_work; }
  CHECK(all_free());
  CHECK(report::seconds_waited() < 1);
  CHECK(std::filesystem::status(folder.path / "room").permissions() ==
        std::filesystem::perms(0644));
  // Who finds a place taken has another; who finds none waits for one, and whoever wants the clock
  // waits for him.
  std::array<int, 2> places{};
  const auto take = [&](std::size_t k, const char* name) {
    places[k] = open((folder.path / name).c_str(), O_RDWR);
    REQUIRE(flock(places[k], LOCK_EX) == 0);
  };
  take(0, "place-1");
  {
    const report::WorkSlot beside;
    CHECK_FALSE(free_for(LOCK_EX, "place-2"));
    CHECK(free_for(LOCK_EX, "place-4"));  // there are two places: the numbers end there
  }
  take(1, "place-2");
  std::array<int, 2> ends{};
  REQUIRE(pipe(ends.data()) == 0);
  const pid_t child = fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    const report::WorkSlot behind;
    const bool long_enough = report::seconds_waited() > 0.04;
    _exit(write(ends[1], "w", 1) == 1 && long_enough ? 0 : 1);
  }
  while (free_for(LOCK_EX, "room")) usleep(1000);
  pollfd ready{ends[0], POLLIN, 0};
  CHECK(poll(&ready, 1, 50) == 0);
  CHECK_FALSE(free_for(LOCK_EX, "room"));
  CHECK(flock(places[1], LOCK_UN) == 0);
  char said = 0;
  CHECK(read(ends[0], &said, 1) == 1);
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  CHECK(status == 0);
}

TEST_CASE("no turns", "[.turn]") {  // hidden: run by the last one
  const SetVariable turns("RAILBOOK_TURNS");
  turns.to(nullptr);
  const TemporaryFolder at("none");
  // A stream is no lock: it does not matter who has locked the file behind it.
  const int stream = dup(1), file = open((at.path / "f").c_str(), O_RDWR | O_CREAT, 0600);
  const int other = open((at.path / "f").c_str(), O_RDWR);
  REQUIRE(flock(other, LOCK_EX) == 0);
  dup2(file, 1);
  alarm(5);  // instead of waiting for it
  {
    const report::WorkSlot work;
    const report::TimingLock clock;
  }
  alarm(0);
  dup2(stream, 1);
}

// A process opens its locks once, and a test before this one may have done so where there were
// none.
TEST_CASE("who measures time waits until the others have done their item") {
  for (const char* name : {"the two processes", "turns from within", "no turns"}) {
    const pid_t fresh = fork();
    REQUIRE(fresh >= 0);
    if (fresh == 0) {
      execl("/proc/self/exe", "test_report", name, static_cast<char*>(nullptr));
      _exit(127);
    }
    int status = 0;
    REQUIRE(waitpid(fresh, &status, 0) == fresh);
    CAPTURE(name);
    CHECK(status == 0);
  }
}
