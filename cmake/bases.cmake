# SPDX-License-Identifier: BSD-3-Clause
# The bases of mpm/basis/bases.inc: the kernels of each, and the headers of all. Sets basis_kernels.
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/mpm/basis/bases.inc)
file(STRINGS mpm/basis/bases.inc lines REGEX "^ASSAY_BASIS")
set(basis_kernels "")
set(ASSAY_HEADERS "")
foreach(line IN LISTS lines)
  string(REGEX REPLACE "^ASSAY_BASIS\\(([a-z0-9_]+), ([A-Za-z0-9]+), ([a-z0-9_]+)\\)" "\\1;\\2;\\3" words "${line}")
  list(GET words 0 name)
  list(GET words 1 basis)
  list(GET words 2 header)
  set(kernels ${PROJECT_BINARY_DIR}/generated/mpm/kernels/variants/${name}.cpp)
  file(CONFIGURE OUTPUT ${kernels} @ONLY CONTENT
"#include \"mpm/basis/@header@.hpp\"
#include \"mpm/kernels/variants/table.hpp\"

namespace assay::mpm::ASSAY_INSTRUCTIONS {

template Kernels<ASSAY_DIMENSION> table<@basis@<ASSAY_DIMENSION>, ASSAY_DIMENSION>();

}  // namespace assay::mpm::ASSAY_INSTRUCTIONS
")
  list(APPEND basis_kernels ${kernels})
  string(APPEND ASSAY_HEADERS "#include \"mpm/basis/${header}.hpp\"\n")
endforeach()
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/generated/bases/all_bases.inc @ONLY CONTENT "@ASSAY_HEADERS@")
target_include_directories(assay_mpm PUBLIC ${PROJECT_BINARY_DIR}/generated/bases)
