// SPDX-License-Identifier: BSD-3-Clause
// `assay compare`: what has changed from one study's results to another's.
#include <iostream>

#include "drivers/output/whole_file.hpp"
#include "drivers/study/comparison_text.hpp"
#include "drivers/verbs.hpp"

namespace assay::drivers {

int compare(const CompareOptions& options) {
  const StoredStudy A = stored_study(options.before), B = stored_study(options.after);
  const Comparison found = compared(A.findings, B.findings);
  const std::string markdown = options.markdown.empty() ? "" : comparison_markdown(A, B, found);
  std::cout << (options.markdown == "-" ? markdown
                : options.json          ? comparison_json(A, B, found)
                : options.verbosity == Verbosity::quiet
                    ? comparison_verdict(found) + "\n"
                    : comparison_text(A, B, found, options.verbosity == Verbosity::verbose))
            << std::flush;
  if (!options.markdown.empty() && options.markdown != "-") write_file(options.markdown, markdown);
  return found.is_worse() ? 1 : 0;
}

}  // namespace assay::drivers
