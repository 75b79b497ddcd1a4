// The figures of the car of chapter 04, from sources in which both corners are a tenth of the
// book's.
#include "sections.hpp"

using namespace railbook;

int main(int argc, char** argv) {
  report::Section items = filters_chapter::speeds;
  for (report::Entry& item : items) item.title = item.id;
  return report::run(argc, argv,
                     {.id = "04-filters",
                      .name = "corners_at_a_tenth",
                      .title = "The car with corners at a tenth",
                      .paper = "",
                      .sources = RAILBOOK_CHAPTER_DIR},
                     {items}, {});
}
