// The limits of an FRA class, watched over a column of profile or alinement where its chords are whole: not where they reach over an
// end of the record or a gap.
#pragma once

#include <deque>
#include <span>
#include <string>
#include <vector>

#include "measures/exceptions.hpp"
#include "measures/inner_filter.hpp"
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
  std::string column_;
  std::vector<std::string> chords_;  // each with its exceptions, and the filter that finds them
  std::deque<measures::Exceptions> exceptions_;
  std::deque<measures::InnerFilter> filters_;
};

}  // namespace railbook::quality_tool
