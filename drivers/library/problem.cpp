// SPDX-License-Identifier: BSD-3-Clause
// Of assay.h: problems, and what they say of themselves.
#include <cstring>
#include <utility>

#include "drivers/library/exact_problem.hpp"
#include "drivers/result/result.hpp"

namespace assay::drivers {

namespace {

/// Into a buffer of so many bytes, cut where it does not fit.
int put_text(const std::string& text, char* buffer, std::size_t size, std::size_t* needed) {
  if (needed) *needed = text.size() + 1;
  if (!buffer || size == 0) return ASSAY_DONE;
  const std::size_t length = text.copy(buffer, size - 1);
  buffer[length] = '\0';
  return ASSAY_DONE;
}

}  // namespace

extern "C" {

ASSAY_API int assay_open(const assay_options* options, assay_problem** problem, assay_error* error) {
  if (problem) *problem = nullptr;
  return call_of_library(error, [&] {
    refuse_call_if(!problem, "problem", "must not be null");
    const assay_options known = known_part(options, sizeof(assay_options), "options");
    auto made = std::make_unique<assay_problem>();
    made->shared = std::make_shared<const ExactProblem>(known);
    *problem = made.release();
    return ASSAY_DONE;
  });
}

ASSAY_API void assay_close(assay_problem* problem) { close_handle(problem, HandleMark::problem); }

ASSAY_API int assay_get_facts(const assay_problem* problem, assay_facts* facts, assay_error* error) {
  return call_of_library(error, [&] {
    const auto& shared = known_handle(problem, HandleMark::problem, "problem").shared;
    const auto size = known_part(facts, sizeof(assay_facts), "facts").struct_size;
    *facts = shared->facts();
    facts->struct_size = size;
    return ASSAY_DONE;
  });
}

ASSAY_API int assay_describe(const assay_problem* problem, char* buffer, size_t size, size_t* needed) {
  return call_of_library(nullptr, [&] {
    return put_text(known_handle(problem, HandleMark::problem, "problem").shared->description(), buffer, size, needed);
  });
}

ASSAY_API int assay_warnings(const assay_problem* problem, char* buffer, size_t size, size_t* needed) {
  return call_of_library(nullptr, [&] {
    return put_text(known_handle(problem, HandleMark::problem, "problem").shared->warnings(), buffer, size, needed);
  });
}

ASSAY_API const char* assay_version(void) { return ASSAY_VERSION_TEXT; }

}  // extern "C"

}  // namespace assay::drivers
