#include <railbook/report/timing_lock.hpp>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>

#include "support/temporary_folder.hpp"

using namespace railbook;

namespace {

bool free_for(int how, const TemporaryFolder& folder) {
  const int other = open(folder.path.c_str(), O_RDONLY | O_DIRECTORY);
  const bool got = flock(other, how | LOCK_NB) == 0;
  close(other);
  return got;
}

}  // namespace

TEST_CASE("unit: many compute at once, and who measures time is alone") {
  const TemporaryFolder folder("timing");
  report::share_machine(folder.path);
  {
    const report::WorkSlot work;
    for (int k = 0; k < 2; ++k) {
      CHECK(free_for(LOCK_SH, folder));
      CHECK_FALSE(free_for(LOCK_EX, folder));
      const report::TimingLock alone;
      CHECK_FALSE(free_for(LOCK_SH, folder));
    }
    CHECK(free_for(LOCK_SH, folder));  // its work goes on
    CHECK_FALSE(free_for(LOCK_EX, folder));
  }
  CHECK(free_for(LOCK_EX, folder));
  { const report::TimingLock without_work; }
  CHECK(free_for(LOCK_EX, folder));
}

TEST_CASE("unit: who measures time waits for another process, and counts the wait") {
  const TemporaryFolder folder("timing-two");
  report::share_machine(folder.path);
  int ends[2] = {};
  REQUIRE(pipe(ends) == 0);
  const pid_t child = fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    report::share_machine(folder.path);  // its own
    const report::WorkSlot work;
    if (write(ends[1], "b", 1) != 1) _exit(1);
    usleep(100000);
    _exit(0);  // a process that ends frees the lock
  }
  char byte = 0;
  REQUIRE(read(ends[0], &byte, 1) == 1);
  const double before = report::seconds_waited();
  const report::WorkSlot beside;  // beside the child
  CHECK(report::seconds_waited() - before < 0.05);
  { const report::TimingLock alone; }
  CHECK(report::seconds_waited() - before > 0.05);
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  CHECK(status == 0);
  close(ends[0]), close(ends[1]);
}

TEST_CASE("unit: a folder that is not there is nobody to wait for") {
  report::share_machine("/nowhere");
  const report::WorkSlot work;
  const report::TimingLock alone;
  SUCCEED();
}
