#include "items.hpp"

void railbook::contact_chapter::add_method(report::Chapter&) {}
