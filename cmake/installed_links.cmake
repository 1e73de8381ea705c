# SPDX-License-Identifier: BSD-3-Clause
# cmake -D FOLDER=... -P installed_links.cmake: in the installed pages, links out of docs/ to what lies beside them there.
file(GLOB_RECURSE pages ${FOLDER}/*.md)
foreach(page IN LISTS pages)
  file(READ ${page} text)
  string(REGEX REPLACE "\\]\\(((\\.\\./)*)\\.\\./(README|CONTRIBUTING|SECURITY|CITATION|CHANGELOG|bench/)" "](\\1\\3" text "${text}")
  string(REGEX REPLACE "\\]\\(((\\.\\./)*)bench/results" "](\\1results" text "${text}")
  file(WRITE ${page} "${text}")
endforeach()
