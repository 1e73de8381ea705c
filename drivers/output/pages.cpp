// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/output/pages.hpp"

#include "drivers/system/input_file.hpp"
#include "drivers/system/terminal.hpp"
#include "drivers/system/whole_file.hpp"

namespace assay::drivers {

void tell(const std::string& text, const std::vector<Page>& pages) {
  Page shown{{}, text};
  for (const Page& page : pages) {
    if (page.file == standard_stream) shown = page;
  }
  shown.is_json ? print_json(shown.text) : print(shown.text);
  for (const Page& page : pages) {
    if (!page.file.empty() && page.file != standard_stream) write_file(page.file, page.text);
  }
}

}  // namespace assay::drivers
