// Text in other encodings than UTF-8.
#include <fmt/format.h>
#include <iconv.h>

#include <algorithm>
#include <cerrno>
#include <utility>

#include <railbook/table/byte_source.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/units/printable.hpp>

namespace railbook::table {
namespace {

constexpr std::size_t block = 1 << 16;

class Decoded : public ByteSource {
 public:
  Decoded(std::unique_ptr<ByteSource> source, const std::string& encoding, std::string_view first)
      : source_(std::move(source)), encoding_(encoding), raw_(first) {
    const bool plain = !encoding.empty() && encoding.size() < 40 &&
                       encoding.find('/') == std::string::npos;  // "//IGNORE" would lose characters
    converter_ = plain ? ::iconv_open("UTF-8", encoding.c_str()) : none();
    if (converter_ == none())
      throw InputError{
          fmt::format("encoding is \"{}\"; allowed: a name that iconv knows (iconv -l), such as "
                      "cp1252, latin1, GBK, Shift-JIS or UTF-16",
                      units::printable(encoding, 40))};
  }
  ~Decoded() override { ::iconv_close(converter_); }
  Decoded(const Decoded&) = delete;
  Decoded& operator=(const Decoded&) = delete;

  std::size_t read(char* to, std::size_t size) override {
    while (at_ == text_.size()) {
      if (!more()) return 0;
    }
    const std::size_t n = text_.copy(to, size, at_);
    at_ += n;
    return n;
  }

  double share() const override { return source_->share(); }

 private:
  static iconv_t none() { return reinterpret_cast<iconv_t>(-1); }  // iconv's own mark of failure

  // Decodes a block of what there is; false at the end.
  bool more() {
    if (!ended_ && raw_.size() < block) {
      const std::size_t before = raw_.size();
      raw_.resize(before + block);
      const std::size_t got = source_->read(raw_.data() + before, block);
      raw_.resize(before + got);
      ended_ = got == 0;
    }
    if (raw_.empty()) return false;
    text_.resize(4 * raw_.size() + 16);  // no character of one byte is longer in UTF-8
    char *in = raw_.data(), *out = text_.data();
    std::size_t in_left = raw_.size(), out_left = text_.size();
    const bool failed =
        ::iconv(converter_, &in, &in_left, &out, &out_left) == static_cast<std::size_t>(-1);
    const int error = errno;
    text_.resize(text_.size() - out_left);
    at_ = 0;
    raw_.erase(0, raw_.size() - in_left);
    if (failed && (error == EILSEQ || ended_) && text_.empty())
      throw InputError{fmt::format("it is no text in the encoding {} (--encoding)", encoding_)};
    return true;
  }

  std::unique_ptr<ByteSource> source_;
  std::string encoding_, raw_, text_;
  std::size_t at_ = 0;  // of text_
  bool ended_ = false;
  iconv_t converter_;
};

}  // namespace

std::unique_ptr<ByteSource> decoded(std::unique_ptr<ByteSource> source, const std::string& encoding,
                                    std::string_view first) {
  return std::make_unique<Decoded>(std::move(source), encoding, first);
}

}  // namespace railbook::table
