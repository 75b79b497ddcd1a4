#include <railbook/table/byte_source.hpp>

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <new>
#include <system_error>
#include <utility>
#include <vector>

#include <railbook/files/outside.hpp>
#include <railbook/table/line_source.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::table {
namespace {

constexpr std::size_t packed_size = 1 << 16;

std::string reason(int error) {
  return std::error_code(error, std::generic_category()).message();
}

class FileBytes : public ByteSource {
 public:
  FileBytes(const std::filesystem::path& file, std::chrono::milliseconds patience);
  ~FileBytes() override {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  FileBytes(const FileBytes&) = delete;
  FileBytes& operator=(const FileBytes&) = delete;

  std::size_t read(char* to, std::size_t size) override {
    if (const std::size_t n = std::min(size, first_.size()); n > 0) {
      std::copy_n(first_.begin(), n, to);
      first_.erase(0, n);
      return n;
    }
    return read_file(to, size);
  }

  double share() const override { return size_ > 0 ? std::min(1.0, done_ / size_) : -1; }

  bool is_gzip() {
    char next[2];
    while (first_.size() < 2) {
      const std::size_t got = read_file(next, 2 - first_.size());
      if (got == 0) return false;
      first_.append(next, got);
    }
    return first_.starts_with("\x1f\x8b");
  }

 private:
  std::size_t read_file(char* to, std::size_t size) {
    ssize_t got = 0;
    do {
      got = ::read(descriptor_, to, size);
    } while (got < 0 && errno == EINTR);
    if (got < 0) throw files::OutsideError{reason(errno)};
    done_ += static_cast<double>(got);
    return static_cast<std::size_t>(got);
  }

  int descriptor_ = -1;
  double size_ = 0, done_ = 0;  // bytes
  std::string first_;           // read, but not handed on
};

FileBytes::FileBytes(const std::filesystem::path& file, std::chrono::milliseconds patience) {
  const auto refuse = [&](const std::string& why) {
    throw InputError{quoted_name(file) + ": cannot be read: " + why};
  };
  const auto refuse_error = [&](int error) {
    if (files::is_of_machine(error))
      throw files::OutsideError{quoted_name(file) + ": cannot be read: " + reason(error)};
    refuse(reason(error));
  };
  do {
    descriptor_ = file == "-" ? ::fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, 3)
                              : ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  } while (descriptor_ < 0 && errno == EINTR);
  struct stat status {};
  if (descriptor_ < 0 || ::fstat(descriptor_, &status) != 0) refuse_error(errno);
  if (S_ISDIR(status.st_mode)) refuse(reason(EISDIR));
  if (S_ISREG(status.st_mode)) size_ = static_cast<double>(status.st_size);
  if (S_ISFIFO(status.st_mode) && file != "-") {
    pollfd wait{descriptor_, POLLIN, 0};
    if (::poll(&wait, 1, static_cast<int>(patience.count())) == 0) {
      // Nothing came. Without a writer a read is at its end, with one it would block.
      char byte = 0;
      const ssize_t got = ::read(descriptor_, &byte, 1);
      if (got == 0)
        refuse(fmt::format("a pipe that nobody writes to (waited {:g} s)",
                           static_cast<double>(patience.count()) / 1000));
      if (got > 0) first_ += byte;
    }
  }
  if (file != "-") ::fcntl(descriptor_, F_SETFL, ::fcntl(descriptor_, F_GETFL) & ~O_NONBLOCK);
}

// What a gzip file holds.
class Unpacked : public ByteSource {
 public:
  explicit Unpacked(std::unique_ptr<ByteSource> packed) : packed_(std::move(packed)) {
    if (inflateInit2(&stream_, 15 + 16) != Z_OK) throw std::bad_alloc();
  }
  ~Unpacked() override { inflateEnd(&stream_); }
  Unpacked(const Unpacked&) = delete;
  Unpacked& operator=(const Unpacked&) = delete;

  std::size_t read(char* to, std::size_t size) override {
    z_stream& z = stream_;
    z.next_out = reinterpret_cast<Bytef*>(to);
    z.avail_out = static_cast<uInt>(size);
    while (z.avail_out == size) {
      if (z.avail_in == 0) {
        z.next_in = reinterpret_cast<Bytef*>(buffer_.data());
        z.avail_in = static_cast<uInt>(packed_->read(buffer_.data(), packed_size));
        if (z.avail_in == 0 && between_) return 0;
        if (z.avail_in == 0) throw InputError{"the gzip data are cut off"};
      }
      if (between_ && *z.next_in == 0) return 0;  // padding behind the last
      between_ = false;
      const int status = inflate(&z, Z_NO_FLUSH);
      if (status == Z_STREAM_END) {
        between_ = true;
        inflateReset(&z);
      } else if (status != Z_OK && status != Z_BUF_ERROR) {
        throw InputError{"the gzip data are damaged"};
      }
    }
    return size - z.avail_out;
  }

  double share() const override { return packed_->share(); }

 private:
  std::unique_ptr<ByteSource> packed_;
  z_stream stream_{};
  std::vector<char> buffer_ = std::vector<char>(packed_size);
  bool between_ = false;  // two members of the file, or behind the last
};

class TextBytes : public ByteSource {
 public:
  explicit TextBytes(std::string text) : text_(std::move(text)) {}
  std::size_t read(char* to, std::size_t size) override {
    const std::size_t n = text_.copy(to, size, at_);
    at_ += n;
    return n;
  }

 private:
  std::string text_;
  std::size_t at_ = 0;
};

// Bytes that have been read, and those behind them.
class Joined : public ByteSource {
 public:
  Joined(std::string first, std::unique_ptr<ByteSource> rest)
      : first_(std::move(first)), rest_(std::move(rest)) {}
  std::size_t read(char* to, std::size_t size) override {
    const std::size_t n = first_.copy(to, size, at_);
    at_ += n;
    return n > 0 ? n : rest_->read(to, size);
  }
  double share() const override { return rest_->share(); }

 private:
  std::string first_;
  std::unique_ptr<ByteSource> rest_;
  std::size_t at_ = 0;
};

}  // namespace

std::unique_ptr<ByteSource> joined(std::string first, std::unique_ptr<ByteSource> rest) {
  return std::make_unique<Joined>(std::move(first), std::move(rest));
}

std::unique_ptr<ByteSource> open_bytes(const std::filesystem::path& file,
                                       std::chrono::milliseconds patience) {
  auto bytes = std::make_unique<FileBytes>(file, patience);
  try {
    if (!bytes->is_gzip()) return bytes;
  } catch (const files::OutsideError& error) {
    throw files::OutsideError{quoted_name(file) +
                              ", line 1: cannot be read further: " + error.what()};
  }
  return std::make_unique<Unpacked>(std::move(bytes));
}

std::unique_ptr<ByteSource> bytes_of(std::string text) {
  return std::make_unique<TextBytes>(std::move(text));
}

}  // namespace railbook::table
