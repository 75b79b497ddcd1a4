// Work in a process of its own, what it prints, and whether a process has ended.
#pragma once

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <utility>

#include "temporary_folder.hpp"

// What `work` prints on a stream (1 or 2) and the status of its process, whose exit status is what
// it returns.
template <class Work>
std::pair<int, std::string> apart(int stream, const Work& work) {
  const TemporaryFolder at("apart");
  const std::filesystem::path said = at.path / "said";
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

// Whether a process is gone, or a zombie that nobody has asked for.
inline bool has_ended(pid_t process) {
  std::ifstream stat("/proc/" + std::to_string(process) + "/stat");
  std::string all;
  std::getline(stat, all);
  return !stat || all.find(") Z") != all.npos;
}

// The same, waiting up to 5 s for it.
inline bool ends(pid_t process) {
  for (int k = 0; k < 500 && !has_ended(process); ++k) usleep(10000);
  return has_ended(process);
}

// A process that sleeps until it is ended, in a group of its own.
inline pid_t sleeper() {
  const pid_t child = fork();
  if (child < 0) std::abort();  // nobody may end process -1
  if (child == 0) {
    setpgid(0, 0);
    for (;;) pause();
  }
  setpgid(child, child);
  return child;
}
