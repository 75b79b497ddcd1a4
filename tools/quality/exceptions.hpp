// The limits of an FRA class, watched over a column of profile or alinement where its chords are whole: not where they reach over an
// end of the record or a gap.
#pragma once

#include <deque>
#include <span>
#include <string>
#include <vector>

#include "measures/exceptions.hpp"
#include "quality/descriptor_filter.hpp"
#include "spectra/record.hpp"

namespace railbook::quality_tool {

class FraWatch {
 public:
  // Class 1 to 9; of classes 6 to 9 only alinement is watched.
  FraWatch(std::string column, bool alinement, int track_class,
           const spectra::RecordStream& record);
  void push(std::span<const double> piece);
  void finish();

  std::size_t count() const;
  static std::string header();
  std::string rows() const;  // of a table

 private:
  struct Gap {
    std::size_t begin = 0, end = 0;  // samples
  };
  struct Watched {
    std::string chord;
    measures::Exceptions exceptions;
    quality::FilterStream filter;
    std::size_t reach = 0, at = 0, gap = 0;  // at: samples judged; gap: the next that matters
  };
  void judge(Watched& w, std::span<const double> offsets);

  std::string column_;
  std::vector<Gap> gaps_;  // the record's end too, once known
  std::size_t samples_ = 0;
  std::vector<double> judged_;
  std::deque<Watched> watched_;
};

}  // namespace railbook::quality_tool
