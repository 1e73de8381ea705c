# SPDX-License-Identifier: BSD-3-Clause
# cmake -D PAGE=docs/causes.md -D OUTPUT=... -P embed_page.cmake
# A compiler promises 65,536 bytes of a literal: each section is one of its own.
file(READ ${PAGE} text)
string(REPLACE "\n## " "\n)page\",\n      R\"page(## " text "${text}")
file(WRITE ${OUTPUT} "// Generated.
#include \"drivers/check/check.hpp\"

#include <string>

namespace assay::drivers {

std::string_view causes_page() {
  static const std::string page = [] {
    std::string all;
    for (const char* section : {R\"page(${text})page\"}) all += section;
    return all;
  }();
  return page;
}

}  // namespace assay::drivers
")
