# SPDX-License-Identifier: BSD-3-Clause
# cmake -D PAGE=docs/causes.md -D OUTPUT=... -P embed_page.cmake
file(READ ${PAGE} text)
file(WRITE ${OUTPUT} "// Generated.
#include \"drivers/causes_page.hpp\"

namespace assay::drivers {

std::string_view causes_page() { return R\"page(${text})page\"; }

}  // namespace assay::drivers
")
