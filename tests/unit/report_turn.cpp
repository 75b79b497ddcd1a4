// Turns with the clock, between two processes that share a folder.
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>

#include "../support/temporary_folder.hpp"
#include "report/turn.hpp"

using namespace railbook;

TEST_CASE("the two processes", "[.turn]") {  // hidden: run by the one below
  const TemporaryFolder folder("turn");
  REQUIRE(setenv("RAILBOOK_TURNS", folder.path.c_str(), 1) == 0);
  std::array<int, 2> pipe_ends{};
  REQUIRE(pipe(pipe_ends.data()) == 0);
  const pid_t child = fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    const report::WorkTurn turn;
    if (write(pipe_ends[1], "b", 1) != 1) _exit(1);
    usleep(100000);
    const bool said_so = write(pipe_ends[1], "e", 1) == 1;
    _exit(said_so ? 0 : 1);  // with its turn: the lock goes with the process
  }
  char said = 0;
  REQUIRE(read(pipe_ends[0], &said, 1) == 1);
  const report::WorkTurn beside;  // side by side with the child
  {
    const report::ClockTurn alone;
    pollfd ready{pipe_ends[0], POLLIN, 0};
    REQUIRE(poll(&ready, 1, 0) == 1);
    REQUIRE(read(pipe_ends[0], &said, 1) == 1);
    CHECK(said == 'e');
  }
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  CHECK(status == 0);
}

// A process opens its locks once, and a test before this one may have done so where there were none.
TEST_CASE("who measures time waits until the others have done their item") {
  const pid_t fresh = fork();
  REQUIRE(fresh >= 0);
  if (fresh == 0) {
    execl("/proc/self/exe", "test_report", "the two processes", static_cast<char*>(nullptr));
    _exit(127);
  }
  int status = 0;
  REQUIRE(waitpid(fresh, &status, 0) == fresh);
  CHECK(status == 0);
}
