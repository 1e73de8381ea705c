# SPDX-License-Identifier: BSD-3-Clause
# cmake -D SOURCE_DIR=... -D OUTPUT=... -P embed_standard.cmake: the editions of the standard set and their scenes as
# texts: "1/vortex_mild.yaml".
set(entries "")
file(GLOB editions RELATIVE ${SOURCE_DIR}/drivers/standard ${SOURCE_DIR}/drivers/standard/edition_*.yaml)
file(GLOB_RECURSE scenes RELATIVE ${SOURCE_DIR}/configs/standard ${SOURCE_DIR}/configs/standard/*.yaml)
foreach(name IN LISTS editions)
  file(READ ${SOURCE_DIR}/drivers/standard/${name} text)
  string(APPEND entries "      {\"${name}\", R\"yaml(${text})yaml\"},\n")
endforeach()
foreach(name IN LISTS scenes)
  file(READ ${SOURCE_DIR}/configs/standard/${name} text)
  string(APPEND entries "      {\"${name}\", R\"yaml(${text})yaml\"},\n")
endforeach()
file(WRITE ${OUTPUT} "// Generated.
#include \"drivers/standard/standard_set.hpp\"

namespace assay::drivers {

const std::map<std::string, std::string>& standard_texts() {
  static const std::map<std::string, std::string> texts{
${entries}  };
  return texts;
}

}  // namespace assay::drivers
")
