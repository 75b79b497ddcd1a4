#include "table/line_source.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>

#include "files/outside.hpp"
#include "units/input_error.hpp"
#include "units/printable.hpp"

namespace railbook::table {
namespace {

constexpr std::size_t longest_line = 64 << 20, buffer_size = 1 << 16;

std::string reason(int error) {
  return std::error_code(error, std::generic_category()).message();
}

}  // namespace

LineSource::Descriptor::~Descriptor() {
  if (value >= 0) ::close(value);
}

LineSource::LineSource(const std::filesystem::path& file, std::chrono::milliseconds patience)
    : file_(file), buffer_(buffer_size) {
  const auto refuse = [&](const std::string& why) {
    throw InputError{
        fmt::format("file \"{}\": cannot be read: {}", units::printable(file.string(), 300), why)};
  };
  do {
    descriptor_ =
        std::make_unique<Descriptor>(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  } while (descriptor_->value < 0 && errno == EINTR);
  const int fd = descriptor_->value;
  struct stat status {};
  if (fd < 0 || ::fstat(fd, &status) != 0) refuse(reason(errno));
  if (S_ISDIR(status.st_mode)) refuse(reason(EISDIR));
  if (S_ISFIFO(status.st_mode)) {
    pollfd wait{fd, POLLIN, 0};
    if (::poll(&wait, 1, static_cast<int>(patience.count())) == 0) {
      // Nothing came. Without a writer a read is at its end, with one it would block.
      const ssize_t got = ::read(fd, buffer_.data(), buffer_.size());
      if (got == 0)
        refuse(fmt::format("a pipe that nobody writes to (waited {:g} s)",
                           static_cast<double>(patience.count()) / 1000));
      if (got > 0) end_ = static_cast<std::size_t>(got);
    }
  }
  ::fcntl(fd, F_SETFL, ::fcntl(fd, F_GETFL) & ~O_NONBLOCK);
}

std::string LineSource::here() const {
  return fmt::format("file \"{}\", line {}", units::printable(file_.string(), 300), line_ + 1);
}

bool LineSource::fill() {
  ssize_t got = 0;
  do {
    got = ::read(descriptor_->value, buffer_.data(), buffer_.size());
  } while (got < 0 && errno == EINTR);
  if (got < 0)
    throw files::OutsideError{fmt::format("{}: cannot be read further: {}", here(), reason(errno))};
  begin_ = 0;
  end_ = static_cast<std::size_t>(got);
  return got > 0;
}

bool LineSource::next(std::string& line) {
  line.clear();
  while (begin_ < end_ || fill()) {
    const char* from = buffer_.data() + begin_;
    const auto* feed = static_cast<const char*>(std::memchr(from, '\n', end_ - begin_));
    const std::size_t size = feed ? static_cast<std::size_t>(feed - from) : end_ - begin_;
    if (line.size() + size > longest_line)
      throw InputError{fmt::format("{}: longer than {} bytes", here(), longest_line)};
    line.append(from, size);
    begin_ += size + (feed ? 1 : 0);
    if (feed) {
      ++line_;
      return true;
    }
  }
  if (line.empty()) return false;
  ++line_;
  return true;
}

}  // namespace railbook::table
