#include "items.hpp"

void railbook::contact_chapter::add_example_2(report::Chapter&) {}
