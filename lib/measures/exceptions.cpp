#include "measures/exceptions.hpp"

#include <cmath>
#include <utility>

#include "units/input_error.hpp"

namespace railbook::measures {

Exceptions::Exceptions(double limit, std::function<double(std::size_t)> place)
    : limit_(units::require_positive("limit", limit, "m")), place_(std::move(place)) {}

void Exceptions::push(std::span<const double> piece) {
  for (const double value : piece) {
    const std::size_t sample = at_++;
    const bool beyond = !std::isnan(value) && std::abs(value) > limit_;
    const int side = !beyond ? 0 : value > 0 ? 1 : -1;
    if (side != 0) {
      const double place = place_(sample);
      if (side != side_) all_.push_back({place, place, value, place});
      Exception& now = all_.back();
      now.to = place;
      if (std::abs(value) > std::abs(now.largest)) now.largest = value, now.at = place;
    }
    side_ = side;
  }
}

}  // namespace railbook::measures
