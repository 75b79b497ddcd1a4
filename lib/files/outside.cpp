#include "files/outside.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <system_error>

#include "units/printable.hpp"

namespace railbook::files {

std::string shown(const std::filesystem::path& name) {
  return "\"" + units::printable(name.string(), 1000) + "\"";
}

void flush_standard_output() {
  errno = 0;
  const bool failed = std::fflush(stdout) != 0 || std::ferror(stdout) != 0;
  if (!failed) return;
  const int error = errno == 0 ? EIO : errno;
  std::clearerr(stdout);
  const std::string text = "standard output: " + std::generic_category().message(error);
  if (error == EPIPE) throw ClosedPipe(text);
  throw OutsideError(text);
}

int report(const std::string& program, const OutsideError& error) {
  if (dynamic_cast<const ClosedPipe*>(&error) == nullptr)
    std::fprintf(stderr, "%s: %s\n", program.c_str(), error.what());
  return 3;
}

int report(const std::string& program, const std::system_error& error) {
  if (error.code() == std::errc::broken_pipe) return 3;
  return report(program, OutsideError(error.what()));
}

int finish_process(const std::string& program, int status) {
  if (status == 3) return status;  // that has been said
  try {
    flush_standard_output();
  } catch (const OutsideError& error) {
    return report(program, error);
  }
  return status;
}

}  // namespace railbook::files
