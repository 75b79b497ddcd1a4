#include <railbook/records/screen.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

#include <railbook/num/median.hpp>
#include <railbook/num/pairs.hpp>

namespace railbook::records {
namespace {

constexpr double far_off = 12, per_missing = 3, above_recent = 4;  // median steps; recent steps
constexpr std::size_t longest_excursion = 256;
constexpr std::size_t fewest_steps = 50;  // that a median step means something
constexpr std::size_t stuck_at_least = 20, stuck_lags = 8;
constexpr double moved = 5;  // quanta
constexpr double largest_jump = 0.1,
                 steepest = 0.3;       // m, m/m: from one sample to the next, on any track
constexpr double returns_within = 20;  // m: a level that does is a defect

// The moves |v[i + lag] - v[i]| from low to high, of every so many samples, and how many are there
// from `least` and from low on.
struct Kept {
  std::vector<double> moves;
  std::size_t all = 0, from_low = 0;
};
Kept keep_moves(const std::vector<double>& v, std::size_t lag, std::size_t stride, double least,
                double low, double high) {
  std::vector<double> moves(v.size() / stride + 2);
  num::PairMask all{}, from_low{};
  std::size_t size = 0;
  for (std::size_t i = 0; i + lag < v.size(); i += 2 * stride) {
    const std::size_t next = i + stride;
    const num::Pair move = num::absolute(
        num::Pair{v[i + lag] - v[i], next + lag < v.size() ? v[next + lag] - v[next] : lost});
    const num::PairMask there = num::is_number(move);
    const num::Pair known = num::only(there, move) + num::only(~there, num::both(-1));
    all -= known >= least;
    from_low -= known >= low;
    const num::PairMask here = (known >= low) & (known <= high);
    moves[size] = move[0];
    size -= static_cast<std::size_t>(here[0]);
    moves[size] = move[1];
    size -= static_cast<std::size_t>(here[1]);
  }
  moves.resize(size);
  return {std::move(moves), static_cast<std::size_t>(all[0] + all[1]),
          static_cast<std::size_t>(from_low[0] + from_low[1])};
}

// The number of about so many such moves that are not below `least`, and their upper median, which
// was about `before`: what is near to that holds the new one as a rule.
struct Moves {
  std::size_t count = 0;
  double median = 0;
};
Moves moves(const std::vector<double>& v, std::size_t lag, std::size_t about, double least,
            double before) {
  const std::size_t stride = std::max<std::size_t>(1, v.size() / about);
  const double low = std::max(least, 0.85 * before);
  Kept kept = keep_moves(v, lag, stride, least, low, 1.15 * before);
  std::size_t below = kept.all - kept.from_low;
  const std::size_t middle = kept.all / 2;
  if (middle < below || middle >= below + kept.moves.size()) {
    kept = keep_moves(v, lag, stride, least, least, std::numeric_limits<double>::infinity());
    below = 0;
  }
  return {kept.all, kept.all > 0 ? num::nth_smallest(kept.moves, middle - below) : 0};
}

// The smallest step of v[0] to v[n] that is not zero, if it is less than `least`.
double least_step(const double* v, std::size_t n, double least) {
  const num::Pair infinite = num::both(std::numeric_limits<double>::infinity());
  num::Pair smallest = num::both(least);
  std::size_t i = 0;
  for (; i + 2 <= n; i += 2) {
    const num::Pair move = num::absolute(num::pair_at(v + i + 1) - num::pair_at(v + i));
    const num::Pair step = num::only(num::is_number(move), move);
    smallest = num::smaller(step + num::only(step == 0, infinite), smallest);
  }
  least = std::min(smallest[0], smallest[1]);
  const double last = i < n ? std::abs(v[i + 1] - v[i]) : least;
  return std::isless(last, least) && last > 0 ? last : least;
}

// How many of n steps before v[0], v[1] and so on are neither zero nor over `most`, up to the first
// eight one of which is.
std::size_t usual_steps(const double* v, std::size_t n, double most) {
  std::size_t i = 0;
  for (; i + 8 <= n; i += 8) {
    num::PairMask usual = ~num::PairMask{};
    for (std::size_t j = i; j < i + 8; j += 2) {
      const num::Pair move = num::absolute(num::pair_at(v + j) - num::pair_at(v + j - 1));
      const num::Pair step = num::only(num::is_number(move), move);
      usual &= (step > 0) & (step <= most);
    }
    if (num::any(~usual)) break;
  }
  return i;
}

}  // namespace

void Screen::push(std::span<const double> values) {
  while (!values.empty()) {
    const auto next = values.first(std::min(values.size(), 2 * block - v_.size()));
    values = values.subspan(next.size());
    v_.insert(v_.end(), next.begin(), next.end());
    if (v_.size() == 2 * block) judge(block);
  }
}

void Screen::cut(double jump) {
  cuts_.emplace_back(base_ + v_.size(), jump);
  push({&lost, 1});
}

void Screen::finish() {
  last_ = true;
  judge(v_.size());
}

void Screen::judge(std::size_t upto) {
  measure();
  while ((next_ = pass(next_, upto)) < upto) next_ = judge_at(next_);
  sink_({v_.data(), upto});
  v_.erase(v_.begin(), v_.begin() + static_cast<std::ptrdiff_t>(upto));
  base_ += upto;
  next_ -= upto;
  seen_ -= std::min(seen_, upto);
  good_at_ -= static_cast<std::ptrdiff_t>(upto);
}

std::optional<FaultyStretch> Screen::still() const {
  for (std::size_t i = 0; i < lags; ++i)
    if (!std::isinf(quantum_) && mean_move_[i] >= moved * quantum_ &&
        still_.count >= std::max(stuck_at_least, stuck_lags << i))
      return still_;
  return std::nullopt;
}

void Screen::measure() {
  if (seen_ + 1 < v_.size()) {
    quantum_ = least_step(&v_[seen_], v_.size() - 1 - seen_, quantum_);
    seen_ = v_.size() - 1;
  }
  constexpr double least = std::numeric_limits<double>::min();  // not of rounded or stuck values
  const Moves steps =
      moves(v_, 1, 2 * block / 3, least, median_step_);  // for a median to a per cent
  judged_ = judged_ || steps.count >= fewest_steps;
  median_step_ = steps.median;
  const auto so_far = static_cast<double>(++blocks_);
  mean_step_ += (median_step_ - mean_step_) / so_far;
  stuck_from_ = std::isinf(quantum_) ? block : v_.size() + 1;
  for (std::size_t i = lags; i-- > 0;) {
    const double here = moves(v_, std::size_t{1} << i, 512, 0, mean_move_[i]).median;
    mean_move_[i] += (here - mean_move_[i]) / so_far;
    if (!std::isinf(quantum_) && std::max(here, mean_move_[i]) >= moved * quantum_)
      stuck_from_ = std::max(stuck_at_least, stuck_lags << i);
  }
}

double Screen::limit(std::size_t i) const {
  const auto missing = static_cast<double>(static_cast<std::ptrdiff_t>(i) - good_at_ - 1);
  if (!judged_) return std::numeric_limits<double>::infinity();
  const double step = std::max(median_step_, mean_step_);
  return step * (far_off + per_missing * missing);
}

// The end of the run of values equal to that at i.
std::size_t Screen::equal_until(std::size_t i, bool over_gaps) const {
  std::size_t j = i + 1;
  while (j < v_.size() && (std::isnan(v_[j]) ? over_gaps : v_[j] == v_[i])) ++j;
  return j;
}

// Notes the samples that are there, and takes them out where that is wanted.
std::size_t Screen::report(std::size_t from, std::size_t to, Fault fault, double value,
                           bool taken_out, double off) {
  for (std::size_t i = from; i < to; ++i) {
    if (std::isnan(v_[i])) continue;
    const std::size_t at = base_ + i;
    const bool on = !faults_.empty() && fault != Fault::step && faults_.back().fault == fault &&
                    faults_.back().taken_out == taken_out &&
                    faults_.back().first + faults_.back().count == at;
    if (on)
      ++faults_.back().count;
    else
      faults_.push_back({fault, at, 1, value, taken_out, off});
    if (taken_out) v_[i] = lost;
  }
  return to;
}

// A step from one sample to another, `slots` samples on, that no track makes.
bool Screen::impossible(double jump, std::size_t slots) const {
  return jump > largest_jump &&
         jump > steepest * spacing_ * static_cast<double>(std::max<std::size_t>(1, slots));
}

// Written as three nines and more, or the largest of two bytes: what a recorder writes for nothing.
bool Screen::is_code(double value) const {
  char text[32];
  const double written = std::abs(value) / unit_;
  std::snprintf(text, sizeof text, "%.6g", written);
  std::string digits{text};
  std::erase(digits, '.');
  const bool nines = digits.size() >= 3 && digits.find_first_not_of('9') == std::string::npos;
  const double whole = std::round(written);
  return nines || (std::abs(written - whole) < 1e-6 * written &&
                   (whole == 32767 || whole == 32768 || whole == 65535));
}

std::size_t Screen::accept(std::size_t i) {
  if (good_)
    step(std::abs(v_[i] - *good_) / static_cast<double>(static_cast<std::ptrdiff_t>(i) - good_at_));
  const bool run_begins =
      !good_ || *good_ != v_[i] || good_at_ + 1 != static_cast<std::ptrdiff_t>(i);
  run_ = run_begins ? 1 : run_ + 1;
  if (run_ > still_.count) still_ = {Fault::stuck, base_ + i + 1 - run_, run_, v_[i]};
  good_ = v_[i];
  good_at_ = static_cast<std::ptrdiff_t>(i);
  if (!run_begins || i + 1 >= v_.size()) return i + 1;
  const std::size_t end = equal_until(i, false);
  if (end - i < stuck_from_) return i + 1;
  if (end == v_.size() && !last_) constant_ = v_[i];
  return report(i + 1, end, Fault::stuck, v_[i], screening_.stuck);
}

void Screen::step(double size) {
  recent_ = {recent_[1], recent_[2], size};
}

// Accepts the samples from i on that follow each other in usual steps, none of them zero: nothing
// need be looked at twice. The first that is left, at most upto.
std::size_t Screen::pass(std::size_t i, std::size_t upto) {
  if (constant_ || !good_ || good_at_ + 1 != static_cast<std::ptrdiff_t>(i)) return i;
  const double most = limit(i);
  std::size_t end = i;
  const auto usual = [&](double before) {
    const double size = end < upto ? std::abs(v_[end] - before) : 0;
    return std::isgreater(size, 0) && std::islessequal(size, most);
  };
  if (usual(*good_)) {
    ++end;
    end += usual_steps(v_.data() + end, upto - end, most);
    while (usual(v_[end - 1])) ++end;
  }
  // One from which the next does not differ may begin a run of equal ones.
  if (end > i && end < v_.size() && v_[end] == v_[end - 1]) --end;
  if (end == i) return i;
  for (std::size_t j = end - std::min<std::size_t>(end - i, 3); j < end; ++j)
    step(std::abs(v_[j] - (j == i ? *good_ : v_[j - 1])));
  run_ = 1;
  good_ = v_[end - 1];
  good_at_ = static_cast<std::ptrdiff_t>(end) - 1;
  return end;
}

std::size_t Screen::judge_at(std::size_t i) {
  if (std::isnan(v_[i])) {
    if (cuts_.empty() || cuts_.front().first != base_ + i) return i + 1;
    faults_.push_back({Fault::cut, base_ + i, 1, cuts_.front().second, false});
    cuts_.erase(cuts_.begin());
    good_.reset();
    constant_.reset();
    return i + 1;
  }
  if (constant_) {
    const double value = v_[i];
    if (value == *constant_)
      return report(i, i + 1, faults_.back().fault, value, faults_.back().taken_out);
    constant_.reset();
  }
  if (!good_) return judge_first(i);
  const double jump = std::abs(v_[i] - *good_);
  const double slots = static_cast<double>(static_cast<std::ptrdiff_t>(i) - good_at_);
  const double steps = above_recent * *std::max_element(recent_.begin(), recent_.end()) * slots;
  return jump <= std::max(limit(i), steps) ? accept(i) : judge_far(i);
}

// The record may begin with a code or an outlier: far from the next value, and from most of those
// that follow.
std::size_t Screen::judge_first(std::size_t i) {
  const std::size_t end = equal_until(i, true);
  good_at_ = static_cast<std::ptrdiff_t>(end) - 1;
  std::size_t seen = 0, far = 0;
  for (std::size_t j = end; j < v_.size() && seen < 9; ++j) {
    if (std::isnan(v_[j])) continue;
    ++seen;
    far += std::abs(v_[j] - v_[i]) > limit(j) ? 1 : 0;
  }
  if (seen < 2 || 2 * far <= seen || std::abs(v_[end] - v_[i]) <= limit(end)) return accept(i);
  const bool never = screening_.codes && impossible(std::abs(v_[end] - v_[i]), end - i);
  return report(i, end, end - i > 1 ? Fault::code : Fault::outlier, v_[i],
                never || screening_.outliers, v_[i] - v_[end]);
}

std::size_t Screen::judge_far(std::size_t i) {
  const std::size_t end = equal_until(i, true);
  const auto equal =
      end - i -
      static_cast<std::size_t>(std::count_if(v_.begin() + static_cast<std::ptrdiff_t>(i),
                                             v_.begin() + static_cast<std::ptrdiff_t>(end),
                                             [](double v) { return std::isnan(v); }));
  const bool open = end == v_.size();
  if (equal >= 2 && (open || equal >= stuck_at_least || std::abs(v_[end] - *good_) <= limit(end))) {
    if (open && !last_) constant_ = v_[i];
    const auto slots = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(i) - good_at_);
    const bool code = is_code(v_[i]) || impossible(std::abs(v_[i] - *good_), slots);
    return report(i, end, Fault::code, v_[i], screening_.outliers || (screening_.codes && code));
  }
  return judge_excursion(i);
}

// Off and back again: outliers, unless the way there is as smooth as a wave's.
std::size_t Screen::judge_excursion(std::size_t i) {
  const double entry = std::abs(v_[i] - *good_);
  double farthest = 0, signed_off = 0, path = entry, before = v_[i];
  std::size_t away = 0, j = i;
  bool back = false;
  for (; j < v_.size() && away < longest_excursion; ++j) {
    if (std::isnan(v_[j])) continue;
    path += j > i ? std::abs(v_[j] - before) : 0;
    const double off = std::abs(v_[j] - *good_);
    back = off <= limit(j);
    if (back) break;
    farthest = std::max(farthest, off);
    if (off == farthest) signed_off = v_[j] - *good_;
    before = v_[j];
    ++away;
  }
  const auto slots = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(i) - good_at_);
  const bool never = screening_.codes && impossible(entry, slots);
  if (!back)
    return j == v_.size() && away == 1
               ? report(i, j, Fault::outlier, v_[i], never || screening_.outliers, v_[i] - *good_)
               : judge_level(i);
  const double exit = std::abs(v_[j] - before);
  const bool abrupt = entry >= 0.5 * farthest && exit >= 0.5 * farthest;
  const bool rough = path >= 0.3 * farthest * static_cast<double>(away + 1);
  if (!abrupt && !rough) return judge_level(i);
  const std::size_t same = equal_until(i, true);
  return report(i, j, same >= j && away > 1 ? Fault::code : Fault::outlier, v_[i],
                screening_.outliers || (never && impossible(exit, 1)), signed_off);
}

// Where the level that is left at i is met again, within 20 m; i where it is not.
std::size_t Screen::end_of_jump(std::size_t i) const {
  const double entry = v_[i] - *good_;
  const auto most = static_cast<std::size_t>(
      spacing_ > 0 ? std::clamp(returns_within / spacing_, 2.0, 1e5) : 40.0);
  for (std::size_t j = i + 1; j < std::min(v_.size(), i + most); ++j)
    if (std::islessequal((v_[j] - *good_) / entry, 0.3)) return j;
  return i;
}

// Off for good: a step, if the record goes on from there in its usual steps.
std::size_t Screen::judge_level(std::size_t i) {
  const double entry = v_[i] - *good_;
  std::vector<double> off, steps;
  double before = v_[i];
  for (std::size_t j = i + 1; j < v_.size() && off.size() < longest_excursion; ++j) {
    if (std::isnan(v_[j])) continue;
    off.push_back(std::abs(v_[j] - *good_));
    steps.push_back(std::abs(v_[j] - before));
    before = v_[j];
  }
  const bool at_once = std::abs(entry) >= 0.5 * num::upper_median(off);
  if (!at_once || num::upper_median(steps) > 0.25 * std::abs(entry)) return accept(i);
  const std::size_t end = end_of_jump(i);
  if (end > i) {
    double largest = entry;
    for (std::size_t j = i; j < end; ++j)
      if (std::abs(v_[j] - *good_) > std::abs(largest)) largest = v_[j] - *good_;
    // The way back, or a step of the same slope.
    const bool on = !faults_.empty() && faults_.back().fault == Fault::jump &&
                    faults_.back().first + faults_.back().count >= base_ + i;
    if (!on)
      faults_.push_back({Fault::jump, base_ + i, end - i, largest, false});
    else
      faults_.back().count = std::max(faults_.back().count, base_ + end - faults_.back().first);
    return accept(i);
  }
  good_ = v_[i];
  good_at_ = static_cast<std::ptrdiff_t>(i);
  return report(i, i + 1, Fault::step, entry, screening_.steps);
}

}  // namespace railbook::records
