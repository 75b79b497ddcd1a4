#include <railbook/table/line_source.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <utility>

#include <railbook/files/outside.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/units/printable.hpp>

namespace railbook::table {
namespace {

constexpr std::size_t longest_line = 64 << 20, buffer_size = 1 << 18;

// A text of lines that end as on old Macs. In quotes a carriage return is a cell's.
bool ends_in_returns(std::string_view text) {
  const std::size_t end = text.find_first_of("\r\n");
  return end != text.npos && text[end] == '\r' && end + 1 < text.size() &&
         text.find('\n') == text.npos && text.substr(0, end).find('"') == text.npos;
}

}  // namespace

std::string quoted_name(const std::filesystem::path& file) {
  if (file == "-") return "standard input";
  return fmt::format("file \"{}\"", units::printable(file.string(), 300));
}

LineSource::LineSource(const std::filesystem::path& file, std::unique_ptr<ByteSource> bytes,
                       const std::string& encoding)
    : file_(file), bytes_(std::move(bytes)), buffer_(buffer_size + 2 * margin) {
  const auto read_some = [&] {
    const std::size_t got = fill(data() + end_, room() / 2 - end_);
    end_ += got;
    return got > 0;
  };
  if (!encoding.empty()) bytes_ = decoded(std::move(bytes_), encoding);
  while (end_ < 2 && read_some()) {
  }
  const std::string_view first{data(), end_};
  if (encoding.empty() && (first.starts_with("\xFF\xFE") || first.starts_with("\xFE\xFF"))) {
    bytes_ = decoded(std::move(bytes_), "UTF-16", first);
    end_ = 0;
    read_some();
  }
  const auto undecided = [&] {
    const std::string_view text{data(), end_};
    return text.find('\n') == text.npos && end_ < room() / 2;
  };
  while (undecided() && read_some()) {
  }
  returns_ = ends_in_returns({data(), end_});
  if (returns_) std::replace(data(), data() + end_, '\r', '\n');
}

std::string LineSource::here() const {
  return fmt::format("{}, line {}", quoted_name(file_), line_ + 1);
}

// The next bytes of the text: 0 at its end.
std::size_t LineSource::fill(char* to, std::size_t size) {
  try {
    const std::size_t got = bytes_->read(to, size);
    if (returns_) std::replace(to, to + got, '\r', '\n');
    return got;
  } catch (const InputError& error) {
    throw InputError{here() + ": cannot be read further: " + error.what()};
  } catch (const files::OutsideError& error) {
    throw files::OutsideError{here() + ": cannot be read further: " + error.what()};
  }
}

std::string_view LineSource::lines_ahead() {
  if (whole_ <= begin_) {
    const std::string_view rest{data() + begin_, end_ - begin_};
    const std::size_t feed = rest.rfind('\n');
    whole_ = feed == std::string_view::npos ? begin_ : begin_ + feed + 1;
  }
  return {data() + begin_, whole_ - begin_};
}

bool LineSource::next(std::string_view& line) {
  std::size_t searched = begin_;
  while (true) {
    const char* from = data() + searched;
    const auto* feed = static_cast<const char*>(std::memchr(from, '\n', end_ - searched));
    const std::size_t end = feed != nullptr ? static_cast<std::size_t>(feed - data()) : end_;
    if (end - begin_ > longest_line)
      throw InputError{fmt::format("{}: longer than {} bytes", here(), longest_line)};
    if (feed != nullptr) {
      line = {data() + begin_, end - begin_};
      begin_ = end + 1;
      ++line_;
      return true;
    }
    // What is left goes to the front, where the rest of the line joins it.
    std::memmove(data(), data() + begin_, end_ - begin_);
    end_ -= begin_;
    begin_ = whole_ = 0;
    searched = end_;
    if (end_ == room()) buffer_.resize(2 * buffer_.size());
    const std::size_t got = fill(data() + end_, room() - end_);
    end_ += got;
    if (got > 0) continue;
    if (end_ == 0) return false;
    line = {data(), end_};
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
