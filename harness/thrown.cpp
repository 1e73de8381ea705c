// SPDX-License-Identifier: BSD-3-Clause
#include "harness/thrown.hpp"

#include <dlfcn.h>

#include "harness/foreign_message.hpp"

namespace assay {

bool is_own_code(const void* function) {
  Dl_info of_function = {}, own = {};
  return ::dladdr(function, &of_function) != 0 && ::dladdr(reinterpret_cast<const void*>(is_own_code), &own) != 0 &&
         of_function.dli_fbase == own.dli_fbase;
}

std::string words_of_exception(const char* what) {
  constexpr std::size_t longest = 300;
  const std::string said = one_line_of(what).substr(0, longest);
  return "threw an exception, which must not pass the C ABI" + (said.empty() ? "" : ": " + said);
}

}  // namespace assay
