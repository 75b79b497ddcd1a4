// Numbers set aside on disk, to be read again in any order: for work that needs a record twice and
// must not hold it.
#pragma once

#include <cstddef>
#include <span>

namespace railbook::files {

// A file without a name in TMPDIR (else /tmp); it goes with the object, or with the program.
class Spool {
 public:
  Spool();
  ~Spool();
  Spool(Spool&& other) noexcept;
  Spool& operator=(Spool&&) = delete;

  // Both throw OutsideError with the system's reason.
  void append(std::span<const double> values);
  void read(std::size_t from, std::span<double> values) const;  // all of them are there

  std::size_t size() const { return size_; }

 private:
  int descriptor_;
  std::size_t size_ = 0;
};

}  // namespace railbook::files
