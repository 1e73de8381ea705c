// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/check_output.hpp"

#include <array>

#include "drivers/output/terminal.hpp"
#include "drivers/output/whole_file.hpp"

namespace assay::drivers {

void tell(const CheckOptions& options, const std::string& text, const std::string& json, const std::string& junit,
          const std::string& markdown) {
  struct Page {
    const std::string &file, &text;
  };
  const std::array<Page, 3> pages{{{options.json, json}, {options.junit, junit}, {options.markdown, markdown}}};
  const std::string* shown = &text;
  for (const Page& page : pages) {
    if (page.file == "-") shown = &page.text;
  }
  shown == &json ? print_json(*shown) : print(*shown);
  for (const Page& page : pages) {
    if (!page.file.empty() && page.file != "-") write_file(page.file, page.text);
  }
}

}  // namespace assay::drivers
