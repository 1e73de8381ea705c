// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/library/call.hpp"

#include <algorithm>
#include <new>
#include <string_view>
#include <system_error>

#include "adapters/process/shortage.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/text/numbers.hpp"
#include "harness/material/material_failure.hpp"

namespace assay::drivers {

namespace {

/// What fits, with its end.
template <std::size_t Size>
void put_words(std::string_view text, char (&words)[Size]) {
  const std::size_t length = text.copy(words, Size - 1);
  words[length] = '\0';
}

/// The end of a path says more than its beginning.
template <std::size_t Size>
void put_end(std::string_view text, char (&words)[Size]) {
  put_words(text.size() < Size ? text : text.substr(text.size() - (Size - 1)), words);
}

int tell_error(assay_error* error, int code, std::string_view key, const std::string& message, std::int64_t point = -1,
               const Location& where = {}) {
  if (!error) return code;
  error->code = code;
  error->line = where.line, error->column = where.column;
  error->point = point;
  put_end(where.file, error->file);
  put_words(key, error->key);
  put_words(one_line(message), error->message);
  return code;
}

/// Where the system was short of something, that is why. It is told once: the next problem may have it.
int tell_unless_short(assay_error* error, int code, std::string_view key, const std::string& message,
                      std::int64_t point = -1, const Location& where = {}) {
  const std::string shortage = adapters::take_shortage();
  return shortage.empty() ? tell_error(error, code, key, message, point, where)
                          : tell_error(error, ASSAY_SYSTEM, "", shortage);
}

std::string failure_words(const MaterialFailure& failure) {
  std::string words = failure.what();
  if (!std::isnan(failure.xi))
    words +=
        ": on the baseline path at xi = " + rounded_text(failure.xi, 6) + ", t = " + rounded_text(failure.t, 6) + " s";
  return words;
}

}  // namespace

bool takes_words(const assay_error* error) { return error->struct_size >= sizeof(assay_error); }

int tell_code(assay_error* error, int code) { return tell_error(error, code, "", ""); }

int code_of_exception(assay_error* error) {
  try {
    throw;
  } catch (const RefusedCall& refused) {
    if (refused.status == ASSAY_BAD_INPUT || refused.status == ASSAY_BEYOND_END)
      return tell_error(error, refused.status, refused.key, refused.key + ": " + refused.what(), refused.point);
    return tell_unless_short(error, refused.status, refused.key, refused.key + ": " + refused.what(), refused.point);
  } catch (const InputError& bad) {
    return tell_unless_short(error, ASSAY_BAD_INPUT, bad.key(), bad.what(), -1, bad.where());
  } catch (const MaterialFailure& failure) {
    return tell_unless_short(error, ASSAY_FINDING, "", failure_words(failure));
  } catch (const std::bad_alloc&) {
    return tell_error(error, ASSAY_SYSTEM, "", "there is not enough memory");
  } catch (const std::length_error&) {
    return tell_error(error, ASSAY_SYSTEM, "", "there is not enough memory");
  } catch (const std::logic_error& bug) {
    return tell_error(error, ASSAY_SYSTEM, "", std::string("this is a bug of assay: ") + bug.what());
  } catch (const std::exception& other) {
    return tell_unless_short(error, ASSAY_SYSTEM, "", other.what());
  }
}

}  // namespace assay::drivers
