#include <railbook/wheelset/constraint_functions.hpp>

#include <string>
#include <utility>

#include <railbook/units/input_error.hpp>

namespace railbook::wheelset {

OddTable::OddTable(double step, std::vector<double> values)
    : step_(units::require_positive("step of the table", step, "m")),
      inverse_(1 / step),
      values_(std::move(values)) {
  if (values_.size() < 2 || values_[0] != 0)
    throw InputError("an odd table needs at least 2 values, the first of them 0; it has " +
                     std::to_string(values_.size()));
  for (const double value : values_) units::require_finite("value of the table", value);
  for (std::size_t i = 1; i < values_.size(); ++i)
    slopes_.push_back((values_[i] - values_[i - 1]) * inverse_);
  last_ = double(slopes_.size() - 1);
}

}  // namespace railbook::wheelset
