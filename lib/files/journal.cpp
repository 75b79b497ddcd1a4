#include "files/journal.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include "files/out_file.hpp"

namespace railbook::files {
namespace {

[[noreturn]] void fail(const std::filesystem::path& file, int error) {
  throw OutsideError("file " + shown(file) +
                     ": cannot be written: " + std::generic_category().message(error));
}

int opened(const std::filesystem::path& file) {
  require_replaceable(file);
  const int how = O_RDWR | O_CREAT | O_APPEND | O_NOFOLLOW | O_CLOEXEC;
  const int descriptor = open(file.c_str(), how, 0666);
  if (descriptor < 0) fail(file, errno);
  return descriptor;
}

}  // namespace

Journal::Journal(std::filesystem::path file) : file_(std::move(file)), descriptor_(opened(file_)) {
  const off_t end = lseek(descriptor_, 0, SEEK_END);
  char last = '\n';
  if (end > 0 && pread(descriptor_, &last, 1, end - 1) != 1) fail(file_, errno);
  if (last != '\n') append("\n");
}

Journal::~Journal() {
  close(descriptor_);
}

void Journal::append(std::string_view lines) {
  const off_t end = lseek(descriptor_, 0, SEEK_END);
  const int error = write_all(descriptor_, lines);
  if (error == 0) return;
  [[maybe_unused]] const int taken_back = ftruncate(descriptor_, end);
  fail(file_, error);
}

}  // namespace railbook::files
