// SPDX-License-Identifier: BSD-3-Clause
// What surrounds a call of a plug-in: exceptions, which none may let pass, for the ABI is C; what it says; the end of
// its instances.
#pragma once

#include <cxxabi.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <string>

#include "harness/material/own_process.hpp"
#include "harness/material/progress_mark.hpp"
#include "harness/material/stack_below.hpp"
#include "harness/numeric/arithmetic.hpp"

namespace assay {

/// What a material says, on one line; null: nothing.
inline std::string one_line_of(const char* message) {
  std::string line = message ? message : "";
  std::replace_if(
      line.begin(), line.end(), [](char c) { return static_cast<unsigned char>(c) < ' '; }, ' ');
  return line;
}

inline constexpr const char* exception_words = "threw an exception, which must not pass the C ABI";

/// Whether a function is of this program, whose exceptions are its own.
bool is_own_code(const void* function);

/// Of the exception that is being handled: "threw an exception, which must not pass the C ABI: bad_alloc".
std::string words_of_exception(const char* what);

/// Told where a plug-in ends the thread that calls it, by pthread_exit() or pthread_cancel(); null: nobody is.
inline void (*on_end_of_thread)() noexcept = nullptr;

/// Calls `function`, a plug-in's, by `call`. Empty, or what it threw, whose words are of the call, for they may not
/// come back either; exceptions of this program pass, and so does the end of a thread.
template <class Function, class Call>
std::string thrown_by(Function* function, const Call& call) {
  const void* code = reinterpret_cast<const void*>(function);
  const CallMark mark;
  try {
    fill_unset_memory();
    call();
    end_a_copy();
    return {};
  } catch (const abi::__forced_unwind&) {
    if (on_end_of_thread) on_end_of_thread();
    throw;
  } catch (const std::exception& error) {
    if (is_own_code(code)) throw;
    return words_of_exception(error.what());
  } catch (...) {
    if (is_own_code(code)) throw;
    return words_of_exception("");
  }
}

/// Whoever takes instances over in place of their destruction, each with the model's function that destroys it; null:
/// nobody.
inline std::atomic<void (*)(void (*destroy)(void*), void* self)> takes_instances_over{nullptr};

inline void destroy_marked(void (*destroy)(void*), void* self) {
  const CallMark call;
  const PhaseMark phase(CallPhase::destroying);
  destroy(self);
  end_a_copy();
  put_arithmetic_right();
}

}  // namespace assay
