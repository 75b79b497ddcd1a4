#include "items.hpp"

namespace psd {

void add_stability(railbook::report::Chapter&) {}

}  // namespace psd
