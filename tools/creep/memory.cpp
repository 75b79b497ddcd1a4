#include "memory.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "rolling/theory.hpp"

namespace railbook::creep_tool {

void say_memory(const std::string& theory, long cells) {
  const double gigabytes = rolling::full_theory_memory(cells) / 1e9;
  if (theory == "full" && gigabytes > 0.25)
    fmt::print(stderr, "full theory with {} cells along rolling: takes {:.1f} GB of memory\n",
               cells, gigabytes);
}

}  // namespace railbook::creep_tool
