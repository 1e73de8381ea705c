// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/check/check_output.hpp"

#include <array>

#include "drivers/system/input_file.hpp"
#include "drivers/system/terminal.hpp"
#include "drivers/system/whole_file.hpp"

namespace assay::drivers {

void refuse_inputs_as_outputs(const CheckOptions& options) {
  refuse_input_as_output(options.json, "--json");
  refuse_input_as_output(options.junit, "--junit");
  refuse_input_as_output(options.markdown, "--markdown");
}

void tell(const CheckOptions& options, const std::string& text, const std::string& json, const std::string& junit,
          const std::string& markdown) {
  struct Page {
    const std::string &file, &text;
  };
  const std::array<Page, 3> pages{{{options.json, json}, {options.junit, junit}, {options.markdown, markdown}}};
  refuse_inputs_as_outputs(options);
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
