// What is printed while something runs, on standard output and standard error.
#pragma once

#include <unistd.h>

#include <array>
#include <cstdio>
#include <functional>
#include <iostream>
#include <string>

#include "temporary_folder.hpp"

struct Captured {
  int status = 0;
  std::string out, err;
};

inline Captured captured(const std::function<int()>& run) {
  const TemporaryFolder at("captured");
  const std::array<int, 2> streams{STDOUT_FILENO, STDERR_FILENO};
  std::array<int, 2> kept{};
  const auto flush = [] {
    std::cout << std::flush;
    std::fflush(stdout);
    std::fflush(stderr);
  };
  flush();
  for (std::size_t i = 0; i < streams.size(); ++i) {
    kept[i] = dup(streams[i]);
    std::FILE* const file = std::fopen((at.path / std::to_string(i)).c_str(), "w");
    dup2(fileno(file), streams[i]);
    std::fclose(file);
  }
  const int status = run();
  flush();
  for (std::size_t i = 0; i < streams.size(); ++i) {
    dup2(kept[i], streams[i]);
    close(kept[i]);
  }
  return {status, at.read("0"), at.read("1")};
}
