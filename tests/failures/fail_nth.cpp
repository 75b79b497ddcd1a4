// A preload that lets the call of the number in FAIL_AT fail once, in the program itself and not in
// its children; FAIL_CALL names the kind: memory, open, read, write, rename, close or fork. With
// COUNT_TO it writes the number of all such calls to that file at the end.
#include <dlfcn.h>
#include <fcntl.h>
#include <spawn.h>
#include <sys/types.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>

extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* block, std::size_t size);
}

namespace {

std::atomic<long> calls{0};

bool fails(const char* kind, int error) {
  static const char* const chosen = std::getenv("FAIL_CALL");
  static const char* const number = std::getenv("FAIL_AT");
  static const long at = number != nullptr ? std::atol(number) : 0;
  static const pid_t process = getpid();
  if (chosen == nullptr || std::strcmp(chosen, kind) != 0 || ++calls != at || getpid() != process)
    return false;
  errno = error;
  return true;
}

template <class Function>
Function* real(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

[[gnu::destructor]] void write_count() {
  const char* file = std::getenv("COUNT_TO");
  if (file == nullptr) return;
  const long count = calls;
  if (std::FILE* to = std::fopen(file, "w")) std::fprintf(to, "%ld\n", count), std::fclose(to);
}

mode_t mode_of(int flags, va_list more) {
  return (flags & (O_CREAT | O_TMPFILE)) != 0 ? static_cast<mode_t>(va_arg(more, int)) : 0;
}

}  // namespace

extern "C" {
void* malloc(std::size_t size) {
  return fails("memory", ENOMEM) ? nullptr : __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) {
  return fails("memory", ENOMEM) ? nullptr : __libc_calloc(count, size);
}
void* realloc(void* block, std::size_t size) {
  return fails("memory", ENOMEM) ? nullptr : __libc_realloc(block, size);
}

int open(const char* name, int flags, ...) {
  va_list more;
  va_start(more, flags);
  const mode_t mode = mode_of(flags, more);
  va_end(more);
  static const auto call = real<int(const char*, int, ...)>("open");
  return fails("open", EMFILE) ? -1 : call(name, flags, mode);
}
int open64(const char* name, int flags, ...) {
  va_list more;
  va_start(more, flags);
  const mode_t mode = mode_of(flags, more);
  va_end(more);
  static const auto call = real<int(const char*, int, ...)>("open64");
  return fails("open", EMFILE) ? -1 : call(name, flags, mode);
}
// What std::ifstream and std::ofstream call.
std::FILE* fopen(const char* name, const char* mode) {
  static const auto call = real<std::FILE*(const char*, const char*)>("fopen");
  return fails("open", EMFILE) ? nullptr : call(name, mode);
}
std::FILE* fopen64(const char* name, const char* mode) {
  static const auto call = real<std::FILE*(const char*, const char*)>("fopen64");
  return fails("open", EMFILE) ? nullptr : call(name, mode);
}
int mkostemp(char* name, int flags) {
  static const auto call = real<int(char*, int)>("mkostemp");
  return fails("open", EMFILE) ? -1 : call(name, flags);
}
ssize_t read(int file, void* to, std::size_t size) {
  static const auto call = real<ssize_t(int, void*, std::size_t)>("read");
  return fails("read", EIO) ? -1 : call(file, to, size);
}
ssize_t write(int file, const void* from, std::size_t size) {
  static const auto call = real<ssize_t(int, const void*, std::size_t)>("write");
  return fails("write", ENOSPC) ? -1 : call(file, from, size);
}
int rename(const char* from, const char* to) {
  static const auto call = real<int(const char*, const char*)>("rename");
  return fails("rename", EIO) ? -1 : call(from, to);
}
int close(int file) {
  static const auto call = real<int(int)>("close");
  if (!fails("close", EIO)) return call(file);
  call(file);  // Linux has closed it when it reports an error
  errno = EIO;
  return -1;
}
pid_t fork() {
  static const auto call = real<pid_t()>("fork");
  return fails("fork", EAGAIN) ? -1 : call();
}
int posix_spawn(pid_t* child, const char* program, const posix_spawn_file_actions_t* actions,
                const posix_spawnattr_t* attributes, char* const words[],
                char* const environment[]) {
  static const auto call =
      real<int(pid_t*, const char*, const posix_spawn_file_actions_t*, const posix_spawnattr_t*,
               char* const[], char* const[])>("posix_spawn");
  if (fails("fork", EAGAIN)) return EAGAIN;
  return call(child, program, actions, attributes, words, environment);
}
int posix_spawnp(pid_t* child, const char* program, const posix_spawn_file_actions_t* actions,
                 const posix_spawnattr_t* attributes, char* const words[],
                 char* const environment[]) {
  static const auto call =
      real<int(pid_t*, const char*, const posix_spawn_file_actions_t*, const posix_spawnattr_t*,
               char* const[], char* const[])>("posix_spawnp");
  if (fails("fork", EAGAIN)) return EAGAIN;
  return call(child, program, actions, attributes, words, environment);
}
}
