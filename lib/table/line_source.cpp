#include <railbook/table/line_source.hpp>

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <new>
#include <system_error>

#include <railbook/files/outside.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/units/printable.hpp>

namespace railbook::table {
namespace {

constexpr std::size_t longest_line = 64 << 20, buffer_size = 1 << 18, packed_size = 1 << 16;

std::string reason(int error) {
  return std::error_code(error, std::generic_category()).message();
}

// A stream of zlib's.
struct Unpacker {
  z_stream stream{};
  std::vector<char> packed = std::vector<char>(packed_size);
  bool between = false;  // two members of the file, or behind the last
  Unpacker() {
    if (inflateInit2(&stream, 15 + 16) != Z_OK) throw std::bad_alloc();
  }
  ~Unpacker() { inflateEnd(&stream); }
  Unpacker(const Unpacker&) = delete;
  Unpacker& operator=(const Unpacker&) = delete;
};

}  // namespace

std::string quoted_name(const std::filesystem::path& file) {
  if (file == "-") return "standard input";
  return fmt::format("file \"{}\"", units::printable(file.string(), 300));
}

struct LineSource::Input {
  explicit Input(int number) : descriptor(number) {}
  ~Input() {
    if (descriptor >= 0) ::close(descriptor);
  }
  Input(const Input&) = delete;
  Input& operator=(const Input&) = delete;
  int descriptor;
  double size = 0, done = 0;  // bytes
  std::unique_ptr<Unpacker> unpacker;
};

LineSource::~LineSource() = default;

LineSource::LineSource(const std::filesystem::path& file, std::chrono::milliseconds patience)
    : file_(file), buffer_(buffer_size) {
  const auto refuse = [&](const std::string& why) {
    throw InputError{quoted_name(file) + ": cannot be read: " + why};
  };
  const auto refuse_error = [&](int error) {
    if (files::is_of_machine(error))
      throw files::OutsideError{quoted_name(file) + ": cannot be read: " + reason(error)};
    refuse(reason(error));
  };
  do {
    input_ = std::make_unique<Input>(file == "-"
                                         ? ::fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, 3)
                                         : ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  } while (input_->descriptor < 0 && errno == EINTR);
  const int fd = input_->descriptor;
  struct stat status {};
  if (fd < 0 || ::fstat(fd, &status) != 0) refuse_error(errno);
  if (S_ISDIR(status.st_mode)) refuse(reason(EISDIR));
  if (S_ISREG(status.st_mode)) input_->size = static_cast<double>(status.st_size);
  if (S_ISFIFO(status.st_mode) && file != "-") {
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
  if (file != "-") ::fcntl(fd, F_SETFL, ::fcntl(fd, F_GETFL) & ~O_NONBLOCK);
  while (end_ < 2) {  // gzip's mark
    const std::size_t got = read(buffer_.data() + end_, buffer_.size() - end_);
    if (got == 0) break;
    end_ += got;
  }
  if (end_ < 2 || buffer_[0] != '\x1f' || buffer_[1] != '\x8b') return;
  input_->unpacker = std::make_unique<Unpacker>();
  Unpacker& u = *input_->unpacker;
  u.packed.assign(buffer_.begin(), buffer_.begin() + static_cast<std::ptrdiff_t>(end_));
  u.stream.next_in = reinterpret_cast<Bytef*>(u.packed.data());
  u.stream.avail_in = static_cast<uInt>(end_);
  end_ = 0;
}

std::string LineSource::here() const {
  return fmt::format("{}, line {}", quoted_name(file_), line_ + 1);
}

double LineSource::share() const {
  return input_->size > 0 ? std::min(1.0, input_->done / input_->size) : -1;
}

std::size_t LineSource::read(char* to, std::size_t size) {
  ssize_t got = 0;
  do {
    got = ::read(input_->descriptor, to, size);
  } while (got < 0 && errno == EINTR);
  if (got < 0)
    throw files::OutsideError{fmt::format("{}: cannot be read further: {}", here(), reason(errno))};
  input_->done += static_cast<double>(got);
  return static_cast<std::size_t>(got);
}

// The next bytes of the text: 0 at its end.
std::size_t LineSource::fill(char* to, std::size_t size) {
  if (!input_->unpacker) return read(to, size);
  Unpacker& u = *input_->unpacker;
  z_stream& z = u.stream;
  z.next_out = reinterpret_cast<Bytef*>(to);
  z.avail_out = static_cast<uInt>(size);
  while (z.avail_out == size) {
    if (z.avail_in == 0) {
      u.packed.resize(packed_size);
      z.next_in = reinterpret_cast<Bytef*>(u.packed.data());
      z.avail_in = static_cast<uInt>(read(u.packed.data(), u.packed.size()));
      if (z.avail_in == 0 && u.between) return 0;
      if (z.avail_in == 0)
        throw InputError{here() + ": cannot be read further: the gzip data are cut off"};
    }
    if (u.between && *z.next_in == 0) return 0;  // padding behind the last
    u.between = false;
    const int status = inflate(&z, Z_NO_FLUSH);
    if (status == Z_STREAM_END) {
      u.between = true;
      inflateReset(&z);
    } else if (status != Z_OK && status != Z_BUF_ERROR) {
      throw InputError{here() + ": cannot be read further: the gzip data are damaged"};
    }
  }
  return size - z.avail_out;
}

std::string_view LineSource::lines_ahead() {
  if (whole_ <= begin_) {
    const std::string_view rest{buffer_.data() + begin_, end_ - begin_};
    const std::size_t feed = rest.rfind('\n');
    whole_ = feed == std::string_view::npos ? begin_ : begin_ + feed + 1;
  }
  return {buffer_.data() + begin_, whole_ - begin_};
}

bool LineSource::next(std::string_view& line) {
  std::size_t searched = begin_;
  while (true) {
    const char* from = buffer_.data() + searched;
    const auto* feed = static_cast<const char*>(std::memchr(from, '\n', end_ - searched));
    const std::size_t end =
        feed != nullptr ? static_cast<std::size_t>(feed - buffer_.data()) : end_;
    if (end - begin_ > longest_line)
      throw InputError{fmt::format("{}: longer than {} bytes", here(), longest_line)};
    if (feed != nullptr) {
      line = {buffer_.data() + begin_, end - begin_};
      begin_ = end + 1;
      ++line_;
      return true;
    }
    // What is left goes to the front, where the rest of the line joins it.
    std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
    end_ -= begin_;
    begin_ = whole_ = 0;
    searched = end_;
    if (end_ == buffer_.size()) buffer_.resize(2 * buffer_.size());
    const std::size_t got = fill(buffer_.data() + end_, buffer_.size() - end_);
    end_ += got;
    if (got > 0) continue;
    if (end_ == 0) return false;
    line = {buffer_.data(), end_};
    begin_ = end_;
    ++line_;
    return true;
  }
}

bool LineSource::next(std::string& line) {
  std::string_view view;
  const bool found = next(view);
  line = found ? view : std::string_view{};
  return found;
}

}  // namespace railbook::table
