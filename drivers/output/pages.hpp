// SPDX-License-Identifier: BSD-3-Clause
// What a verb tells: one text on standard output, and files beside it.
#pragma once

#include <string>
#include <vector>

namespace assay::drivers {

struct Page {
  std::string file;  ///< "-": standard output; empty: none
  std::string text;
  bool is_json = false;
};

/// What was found first, on standard output: `text`, or the last page that is asked for there. Then the files, whatever
/// becomes of them. Throws SystemError.
void tell(const std::string& text, const std::vector<Page>& pages);

}  // namespace assay::drivers
