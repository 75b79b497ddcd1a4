#include "items.hpp"

void railbook::contact_chapter::add_example_4(report::Chapter&) {}
