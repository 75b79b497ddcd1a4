#include <railbook/tool/session.hpp>

namespace railbook::tool {

Session& session() {
  static Session one;
  return one;
}

}  // namespace railbook::tool
