// A preload that lets the allocation of the number in FAIL_AT fail, once, in the program itself and
// not in its children. With COUNT_TO it writes the number of all allocations to that file at the
// end.
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstdlib>

extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* block, std::size_t size);
}

namespace {

std::atomic<long> allocations{0};

bool fails() {
  static const long at = std::getenv("FAIL_AT") != nullptr ? std::atol(std::getenv("FAIL_AT")) : 0;
  static const pid_t process = getpid();
  if (++allocations != at || getpid() != process) return false;
  errno = ENOMEM;
  return true;
}

[[gnu::destructor]] void write_count() {
  const char* file = std::getenv("COUNT_TO");
  if (file == nullptr) return;
  const long count = allocations;
  if (std::FILE* to = std::fopen(file, "w")) std::fprintf(to, "%ld\n", count), std::fclose(to);
}

}  // namespace

extern "C" {
void* malloc(std::size_t size) {
  return fails() ? nullptr : __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) {
  return fails() ? nullptr : __libc_calloc(count, size);
}
void* realloc(void* block, std::size_t size) {
  return fails() ? nullptr : __libc_realloc(block, size);
}
}
