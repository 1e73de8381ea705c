# SPDX-License-Identifier: BSD-3-Clause
# CPack calls this between installing into a folder of its own and packing that: what Debian wants to have otherwise.
set(share ${CPACK_TEMPORARY_DIRECTORY}/usr/share)
set(documents ${share}/doc/assay)

# A time in a compressed file would make two packages of the same sources differ.
function(compress file)
  execute_process(COMMAND gzip -9nf ${file} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# The copyright, which has the licence in it, indented as its format has it.
file(READ ${CPACK_DEBIAN_LICENCE_FILE} licence)
string(REGEX MATCH "Copyright [^\n]*" holder "${licence}")
string(FIND "${licence}" "Redistribution" begin)
string(SUBSTRING "${licence}" ${begin} -1 licence)
string(STRIP "${licence}" licence)
string(REPLACE "\n\n" "\n.\n" licence "${licence}")
string(REPLACE "\n" "\n " licence "${licence}")
string(REPLACE "Copyright (c) " "" holder "${holder}")
file(WRITE ${documents}/copyright
"Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/
Upstream-Name: assay
Comment: What the program has of others is under their licences, see THIRD_PARTY.md and third_party.

Files: *
Copyright: ${holder}
License: BSD-3-Clause
 ${licence}
")

# Terms that a binary must carry, of headers that were compiled into it; libraries come with packages of their own, and
# Boost's licence asks for nothing with a binary.
foreach(headers IN ITEMS libcli11-dev libeigen3-dev libstb-dev nlohmann-json3-dev)
  if(EXISTS /usr/share/doc/${headers}/copyright)
    configure_file(/usr/share/doc/${headers}/copyright ${documents}/third_party/${headers} COPYONLY)
  endif()
endforeach()

# The history in the form that Debian's tools read; the one for people lies beside it.
set(epoch "$ENV{SOURCE_DATE_EPOCH}")
if(epoch STREQUAL "")
  string(TIMESTAMP epoch "%s" UTC)
endif()
set(ENV{SOURCE_DATE_EPOCH} ${epoch})
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
file(WRITE ${documents}/changelog
"assay (${CPACK_PACKAGE_VERSION}) stable; urgency=medium

  * See CHANGELOG.md.

 -- ${CPACK_PACKAGE_CONTACT}  ${date}
")
compress(${documents}/changelog)
compress(${share}/man/man1/assay.1)

# Whatever the umask was when the sources were checked out.
execute_process(COMMAND chmod -R u+rwX,go=rX ${CPACK_TEMPORARY_DIRECTORY}/usr COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND find ${CPACK_TEMPORARY_DIRECTORY} -exec touch -h -d @${epoch} {} + COMMAND_ERROR_IS_FATAL ANY)
