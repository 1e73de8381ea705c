// SPDX-License-Identifier: BSD-3-Clause
// `assay compare`: what has changed from one study's results to another's.
#include "drivers/input_error.hpp"
#include "drivers/input_file.hpp"
#include "drivers/output/terminal.hpp"
#include "drivers/output/whole_file.hpp"
#include "drivers/study/comparison_text.hpp"
#include "drivers/verbs.hpp"

namespace assay::drivers {

int compare(const CompareOptions& options) {
  forget_inputs();
  if (is_same_stream(options.before, options.after))
    throw InputError({}, "assay compare", "A and B are one stream, which can be read once");
  const StoredStudy A = stored_study(options.before), B = stored_study(options.after);
  refuse_input_as_output(options.markdown, "--markdown");
  const Comparison found = compared(A.findings, B.findings);
  const std::string markdown = options.markdown.empty() ? "" : comparison_markdown(A, B, found);
  const bool whole = options.verbosity == Verbosity::verbose;
  if (options.json && options.markdown != "-") {
    print_json(comparison_json(A, B, found));
  } else {
    print(options.markdown == "-"                 ? markdown
          : options.verbosity == Verbosity::quiet ? comparison_verdict(found) + "\n"
                                                  : comparison_text(A, B, found, whole));
  }
  if (!options.markdown.empty() && options.markdown != "-") write_file(options.markdown, markdown);
  return found.is_worse() ? 1 : 0;
}

}  // namespace assay::drivers
