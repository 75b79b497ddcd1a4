#include <railbook/quality/exceptions.hpp>

#include <cmath>
#include <utility>

#include <railbook/units/input_error.hpp>

namespace railbook::quality {

Exceptions::Exceptions(double limit, std::function<double(std::size_t)> place)
    : Exceptions(-units::require_positive("limit", limit, "m"), limit, std::move(place)) {}

void Exceptions::push(std::span<const double> piece) {
  for (const double value : piece) {
    const std::size_t sample = at_++;
    const int side = std::isgreater(value, high_) ? 1 : std::isless(value, low_) ? -1 : 0;
    if (side != 0) {
      const double place = place_(sample);
      if (side != side_) all_.push_back({place, place, value, place});
      Exception& now = all_.back();
      now.to = place;
      if (side * value > side * now.largest) now.largest = value, now.at = place;
    }
    side_ = side;
  }
}

}  // namespace railbook::quality
