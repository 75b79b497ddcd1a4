#include <railbook/records/record.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include <railbook/num/pairs.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/units/number_text.hpp>

namespace railbook::records {
namespace {

constexpr std::size_t settling = 1000;                   // positions that decide on the spacing
constexpr std::size_t piece = 4096;                      // samples handed on at once
constexpr double free_slots = 1e6, slots_a_sample = 20;  // longest record for its samples
constexpr double off_grid = 0.25;                        // of a spacing
constexpr double spacing_mismatch = 0.005, spacing_refused = 0.02;
constexpr double highest_height = 1e6;  // m: its square still has all digits to spare
constexpr double lag = 10;              // m

// How many positions are about a spacing behind the one before, which that before the first is, up
// to the first eight one of which is not.
std::size_t even_steps(std::span<const double> positions, double direction, double spacing,
                       double slack) {
  std::size_t i = 0;
  for (; i + 8 <= positions.size(); i += 8) {
    num::PairMask even = ~num::PairMask{};
    for (std::size_t j = i; j < i + 8; j += 2) {
      const double* const at = positions.data() + j;
      const num::Pair here = direction * num::pair_at(at),
                      before = direction * num::pair_at(at - 1);
      const num::Pair off = num::absolute(here - before - spacing);
      even &= num::is_number(off) & (num::only(num::is_number(off), off) <= slack);
    }
    if (num::any(~even)) break;
  }
  return i;
}

bool all_within(std::span<const double> values, double most) {
  num::PairMask known = ~num::PairMask{};
  num::Pair largest{};
  for (std::size_t i = 0; i + 2 <= values.size(); i += 2) {
    const num::Pair size = num::absolute(num::pair_at(&values[i]));
    known &= num::is_number(size);
    largest = num::larger(num::only(num::is_number(size), size), largest);
  }
  return !num::any(~known) && !num::any(largest > most) &&
         std::islessequal(std::abs(values.back()), most);
}

}  // namespace

RecordStream::RecordStream(const RecordOptions& options,
                           std::function<void(std::span<const double>)> sink)
    : options_(options),
      sink_(std::move(sink)),
      screen_([this](std::span<const double> values) { join(values); }, options_.screening) {
  if (options_.spacing) {
    spacing_ = units::require_positive("spacing", *options_.spacing, "m");
    places_ = PlaceMap{spacing_};
    screen_.set_scale(spacing_, options_.unit);
  }
  ready_.reserve(piece);
}

void RecordStream::add(std::span<const double> values) {
  taken_ += values.size();
  take(values);
}

void RecordStream::add(std::span<const double> positions, std::span<const double> values) {
  positions_ = true;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const std::size_t even = go_on(positions.subspan(i));
    taken_ += even;
    take(values.subspan(i, even));
    i += even;
    if (i == positions.size()) return;
    ++taken_;
    if (std::isnan(positions[i])) {
      unplaced_ += std::isnan(values[i]) ? 0 : 1;
      continue;
    }
    units::require_finite("position of sample " + std::to_string(taken_), positions[i], "m");
    if (settled_) {
      place({direction_ * positions[i], values[i]});
    } else {
      first_.push_back({positions[i], values[i]});
      if (first_.size() == settling) settle_spacing();
    }
  }
}

// Places samples as long as each is about a spacing behind the one before; how many.
std::size_t RecordStream::go_on(std::span<const double> positions) {
  if (!settled_ || rounding_ > 0) return 0;
  const double slack = off_grid * spacing_;
  double last = last_position_;
  std::size_t n = 0;
  const auto even = [&](double before) {
    return n < positions.size() &&
           std::islessequal(std::abs(direction_ * positions[n] - before - spacing_), slack);
  };
  if (even(last)) {
    ++n;
    n += even_steps(positions.subspan(n), direction_, spacing_, slack);
    while (even(direction_ * positions[n - 1])) ++n;
    last = direction_ * positions[n - 1];
  }
  if (n > 0) places_.add(steps_ + 1, positions.first(n));
  fresh_ = fresh_ && n == 0;
  steps_ += n;
  last_position_ = last;
  return n;
}

// A rounded position is met by the grid of those before it, not by the last of them.
void RecordStream::place(const Sample& given) {
  Sample sample = given;
  if (std::exchange(fresh_, false) && sample.position < last_position_) {
    direction_ = -direction_;
    first_position_ = last_position_ = -last_position_;
    grid_ = -grid_;
    sample.position = -sample.position;
  }
  const double last = rounding_ > 0 ? grid_ : last_position_;
  const double step = (sample.position - last) / spacing_;
  const double slack = off_grid + 0.5 * rounding_ / spacing_;
  const double whole = std::abs(step - 1) <= slack ? 1 : std::round(step);
  if (rounding_ == 0 ? !(step > 0) : sample.position < last_position_)
    return resync(sample, direction_ > 0 ? "positions do not ascend" : "positions do not descend");
  if (whole < 1 || std::abs(step - whole) > slack)
    return resync(sample, "positions are not evenly spaced");
  if (static_cast<double>(steps_) + whole >
      free_slots + slots_a_sample * static_cast<double>(taken_))
    return resync(sample,
                  "positions jump too far for a record of " + std::to_string(taken_) + " samples");
  const double thousands = sample.position / units::kilometre;
  if (whole > 1 && std::abs(thousands - std::round(thousands)) < 1e-7) {
    if (options_.resync == Resync::count) return resync(sample, "");
    whole_kilometre_ = whole_kilometre_.value_or(direction_ * sample.position);
  }
  for (double missing = 1; missing < whole; ++missing) screen_.push({&lost, 1});
  steps_ += static_cast<std::size_t>(whole);
  last_position_ = sample.position;
  grid_ = last + spacing_ * (whole + (rounding_ > 0.5 * spacing_ ? 0.0625 : 0.25) * (step - whole));
  const double here = direction_ * (rounding_ > 0 ? grid_ : sample.position);
  places_.add(steps_, {&here, 1});
  take({&sample.value, 1});
}

// The sample is not where the one before says.
void RecordStream::resync(const Sample& sample, const std::string& why) {
  const double jump = direction_ * (sample.position - last_position_);
  if (options_.resync == Resync::refuse)
    throw InputError{
        why + ": " + units::number_text(direction_ * last_position_) + " m is followed by " +
        units::number_text(direction_ * sample.position) + " m (sample " +
        std::to_string(placed_ + 1) + "); the spacing is " + units::number_text(spacing_) +
        " m; allowed: --resync cut, which parts the record there, --resync count, "
        "which counts on in steps of the spacing, --resample SPACING, which interpolates, or "
        "--distance none --spacing" +
        (jump < 0 ? "; --where COLUMN=VALUE reads one rail or run of several" : "")};
  length_ += last_position_ - first_position_;
  lengths_ += steps_ - first_step_;
  const bool cut = options_.resync == Resync::cut;
  if (cut) {
    screen_.cut(jump);
    const double here = direction_ * (last_position_ + spacing_);
    places_.add(++steps_, {&here, 1});
    ++cuts_;
    fresh_ = true;
  } else {
    counts_.push_back({"counted", direction_ * last_position_, direction_ * sample.position, 1,
                       jump, false, "--resync"});
    ++counted_;
  }
  first_step_ = ++steps_;
  first_position_ = last_position_ = grid_ = sample.position;
  places_.jump(steps_, direction_ * sample.position);
  take({&sample.value, 1});
}

void RecordStream::take(std::span<const double> values) {
  const bool usual = varies_ && !values.empty() && all_within(values, highest_height);
  if (usual) placed_ += values.size();
  for (const double value : usual ? std::span<const double>{} : values) {
    ++placed_;
    if (!std::islessequal(std::abs(value), highest_height) && !std::isnan(value))
      units::require_between("sample " + std::to_string(placed_), value, -highest_height,
                             highest_height, "m");
    if (varies_ || std::isnan(value)) continue;
    varies_ = any_ && value != first_value_;
    first_value_ = value;
    any_ = true;
  }
  screen_.push(values);
}

// The samples come back from the screen; gaps are closed with the first good sample after them.
void RecordStream::join(std::span<const double> values) {
  const auto is_lost = [](double value) { return std::isnan(value); };
  for (auto at = values.begin(); at != values.end();) {
    const auto good = std::find_if_not(at, values.end(), is_lost);
    for (; at != good; ++at, ++joined_, ++gap_) {
      while (fault_ < faults().size() && faults()[fault_].first < joined_) ++fault_;
      cut_ = cut_ || (fault_ < faults().size() && faults()[fault_].first == joined_ &&
                      faults()[fault_].fault >= Fault::step);
    }
    at = std::find_if(good, values.end(), is_lost);
    if (at == good) return;
    close_gap(*good);
    put({good, at});
    joined_ += static_cast<std::size_t>(at - good);
    last_value_ = *(at - 1);
  }
}

void RecordStream::close_gap(double value) {
  const std::size_t most =
      spacing_ > 0
          ? std::max(options_.bridge,
                     static_cast<std::size_t>(std::min(1e6, options_.bridge_length / spacing_)))
          : options_.bridge;
  const bool bridge = begun_ && gap_ <= most && !cut_;
  if (gap_ > 0) unread_.push_back({samples_, gap_});
  for (std::size_t i = 1; i <= gap_; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(gap_ + 1);
    put(bridge ? last_value_ + share * (value - last_value_) : lost);
  }
  (bridge ? bridged_ : missing_) += gap_;
  gap_ = 0;
  cut_ = false;
  begun_ = true;
}

void RecordStream::put(std::span<const double> values) {
  while (!values.empty()) {
    const auto next = values.first(std::min(values.size(), piece - ready_.size()));
    values = values.subspan(next.size());
    samples_ += next.size();
    if (spacing_ > 0) compare(next);
    ready_.insert(ready_.end(), next.begin(), next.end());
    if (ready_.size() < piece) continue;
    sink_(ready_);
    ready_.clear();
  }
}

// The height against the mean of those 10 m before and behind: a grade does not show.
void RecordStream::compare(std::span<const double> values) {
  if (reach_ == 0) {
    reach_ = 2 * static_cast<std::size_t>(std::clamp(lag / spacing_, 1.0, 1e5));
    past_.assign(reach_, lost);
  }
  const std::size_t middle = reach_ / 2, count = values.size();
  const std::size_t inner =
      std::max<std::size_t>(1, static_cast<std::size_t>(0.29 * static_cast<double>(reach_)));
  const std::size_t behind = middle - inner, ahead = (middle + inner) % reach_;
  past_.insert(past_.end(), values.begin(), values.end());
  past_.push_back(lost);  // behind an odd number
  const double* oldest = &past_[past_.size() - 1 - count - reach_];
  num::Pair moved{}, moved_inner{};
  num::PairMask known{};
  for (std::size_t i = 0; i < count; i += 2, oldest += 2) {
    const num::Pair here = num::pair_at(oldest + middle);
    const num::Pair offset = here - 0.5 * (num::pair_at(oldest + reach_) + num::pair_at(oldest));
    const num::Pair inner_offset =
        here - 0.5 * (num::pair_at(oldest + behind) + num::pair_at(oldest + ahead));
    const num::Pair within = inner_offset + (offset - offset);  // known where both are
    moved += num::only(num::is_number(offset), offset * offset);
    moved_inner += num::only(num::is_number(within), within * within);
    known -= num::is_number(offset);
  }
  moved_ += moved[0] + moved[1];
  moved_inner_ += moved_inner[0] + moved_inner[1];
  moves_ += static_cast<std::size_t>(known[0] + known[1]);
  past_.pop_back();
  if (past_.size() > 2 * reach_ + piece)
    past_.erase(past_.begin(), past_.end() - static_cast<std::ptrdiff_t>(reach_));
}

std::size_t RecordStream::unread(std::size_t first, std::size_t count, std::size_t reach) const {
  auto at = std::partition_point(unread_.begin(), unread_.end(), [&](const Stretch& s) {
    return s.first + s.count + reach <= first;
  });
  std::size_t n = 0, done = first;
  for (; at != unread_.end() && at->first < first + count + reach; ++at) {
    const std::size_t from = std::max(done, at->first - std::min(at->first, reach));
    const std::size_t to = std::min(first + count, at->first + at->count + reach);
    n += to > from ? to - from : 0;
    done = std::max(done, to);
  }
  return n;
}

void RecordStream::finish() {
  if (taken_ == 0) throw InputError{"the record holds no finite sample"};
  if (positions_ && !settled_) settle_spacing();
  units::require_positive("spacing (give one, or a column of positions)", spacing_, "m");
  if (any_ && !varies_)
    throw InputError{"constant signal: all samples are " + units::number_text(first_value_) +
                     " in SI units"};
  screen_.finish();
  missing_ += gap_;
  if (gap_ > 0) unread_.push_back({samples_, gap_});
  for (; gap_ > 0; --gap_) put(lost);
  if (!ready_.empty()) sink_(ready_);
  ready_.clear();
  for (const FaultyStretch& f : faults()) faulty_ += f.taken_out ? f.count : 0;
  length_ += last_position_ - first_position_;
  lengths_ += steps_ - first_step_;
  if (positions_ && lengths_ > 0) spacing_ = length_ / static_cast<double>(lengths_);
  if (options_.spacing && std::abs(spacing_ / *options_.spacing - 1) > spacing_mismatch)
    throw InputError{"spacing is given as " + units::number_text(*options_.spacing) +
                     " m, but the positions are " + units::number_text(spacing_) + " m apart"};
  if (!begun_) throw InputError{"the record holds no finite sample"};
  const PlaceMap::Unevenness uneven = places_.unevenness();
  if (uneven.share > spacing_refused)
    throw InputError{"positions are not evenly spaced: from " + units::number_text(uneven.from) +
                     " m to " + units::number_text(uneven.to) + " m they are " +
                     units::number_text(uneven.spacing) + " m apart, in the whole record " +
                     units::number_text(uneven.overall) + " m; allowed: changes of up to 2 %"};
}

}  // namespace railbook::records
