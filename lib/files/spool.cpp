#include <railbook/files/spool.hpp>

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include <railbook/files/outside.hpp>
#include <railbook/files/staged.hpp>

namespace railbook::files {
namespace {

[[noreturn]] void fail(int error, const char* what) {
  throw OutsideError{std::string{"temporary file: cannot be "} + what + ": " +
                     std::error_code(error, std::generic_category()).message()};
}

int nameless_file() {
  const char* folder = std::getenv("TMPDIR");
  std::string name{folder != nullptr && *folder != 0 ? folder : "/tmp"};
  name += "/railbook-XXXXXX";
  const BlockSignals wait;  // between its name and its removal
  const int descriptor = ::mkostemp(name.data(), O_CLOEXEC);
  if (descriptor < 0) fail(errno, "made");
  ::unlink(name.c_str());
  return descriptor;
}

}  // namespace

Spool::Spool() : descriptor_(nameless_file()) {}

Spool::~Spool() {
  ::close(descriptor_);  // none, where it was moved from: the system refuses
}

Spool::Spool(Spool&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)), size_(other.size_) {}

void Spool::append(std::span<const double> values) {
  const int error =
      write_all(descriptor_, {reinterpret_cast<const char*>(values.data()), values.size_bytes()});
  if (error != 0) fail(error, "written");
  size_ += values.size();
}

void Spool::read(std::size_t from, std::span<double> values) const {
  auto* to = reinterpret_cast<char*>(values.data());
  std::size_t left = values.size_bytes(), at = from * sizeof(double);
  while (left > 0) {
    const ssize_t got = TEMP_FAILURE_RETRY(::pread(descriptor_, to, left, static_cast<off_t>(at)));
    if (got <= 0) fail(got < 0 ? errno : EIO, "read");
    to += got;
    at += static_cast<std::size_t>(got);
    left -= static_cast<std::size_t>(got);
  }
}

}  // namespace railbook::files
