// SPDX-License-Identifier: BSD-3-Clause
// The files of drivers/templates, which the build puts into the program.
#pragma once

#include <string_view>
#include <vector>

namespace assay::drivers {

/// A file of a project that `assay new-material` writes; @WORD@ in the text and NAME in the file's name are replaced.
struct ProjectTemplate {
  std::string_view flavour;  ///< the folder: c, c++, fortran, umat; common: of all of them
  std::string_view file;     ///< "NAME.c"
  std::string_view text;     ///< without its line of the licence: what is written is its author's
};

const std::vector<ProjectTemplate>& project_templates();

}  // namespace assay::drivers
