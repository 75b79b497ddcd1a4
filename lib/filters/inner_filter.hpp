// A filter of a record, where it has the track that it needs.
#pragma once

#include <cstddef>
#include <deque>
#include <span>
#include <vector>

#include <railbook/quality/descriptor_filter.hpp>

namespace railbook::filters {

// filters::FilterStream, NaN within `margin` samples of an end of the record or of a gap: track
// that was not measured is no part of a chord or of a wave. Exact in what it leaves out; memory:
// the filter's, and the gaps within its reach.
class InnerFilter {
 public:
  // Throws InputError when the margin is beyond the filter's reach.
  InnerFilter(const FilterTaps& taps, std::size_t margin, FilterStream::Sink sink);
  InnerFilter(const InnerFilter&) = delete;  // the filter's sink is this

  void push(std::span<const double> record);  // NaN: a gap
  void finish();

 private:
  struct Gap {
    std::size_t begin = 0, end = 0;  // samples
  };
  void judge(std::span<const double> filtered);

  std::size_t margin_;
  FilterStream::Sink sink_;
  FilterStream filter_;
  std::deque<Gap> gaps_;                  // that may still matter; the record's end too, once known
  std::size_t samples_ = 0, judged_ = 0;  // taken, given
  std::vector<double> inner_;
};

}  // namespace railbook::filters
