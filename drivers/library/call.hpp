// SPDX-License-Identifier: BSD-3-Clause
// What surrounds every call of the library: the arithmetic of the host is put aside and given back, and whatever is
// thrown becomes a code and an assay_error.
#pragma once

#include <cfenv>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <exception>
#include <stdexcept>
#include <string>

#include "drivers/library/assay.h"
#include "harness/numeric/arithmetic.hpp"

namespace assay::drivers {

/// While one lives, this thread computes by default rules: to nearest, no traps, gradual underflow. Then it has its own
/// again, with the flags that it had.
class OwnArithmetic {
 public:
  OwnArithmetic() {
    std::feholdexcept(&of_host_);
    reset_arithmetic();
  }
  ~OwnArithmetic() { std::fesetenv(&of_host_); }
  OwnArithmetic(const OwnArithmetic&) = delete;
  OwnArithmetic& operator=(const OwnArithmetic&) = delete;

 private:
  std::fenv_t of_host_;
};

/// An argument that cannot be, ASSAY_BAD_INPUT, or a code of the call's own.
class RefusedCall : public std::runtime_error {
 public:
  RefusedCall(std::string at, const std::string& what, int code = ASSAY_BAD_INPUT, std::int64_t at_point = -1)
      : std::runtime_error(what), key(std::move(at)), status(code), point(at_point) {}
  std::string key;  ///< "points.X"
  int status;
  std::int64_t point;
};

inline void refuse_call_if(bool fault, const char* key, const std::string& what) {
  if (fault) throw RefusedCall(key, what);
}

/// Of the exception that is being handled: its code, and what is said of it.
int code_of_exception(assay_error* error);

/// Whether the caller's struct can take what is said.
bool takes_words(const assay_error* error);

/// Of a call that has come to its end: its code.
int tell_code(assay_error* error, int code);

/// Calls `body`, which returns a code or throws. A thread that is cancelled in it goes its way.
template <class Body>
int call_of_library(assay_error* error, const Body& body) {
  if (error && !takes_words(error)) return ASSAY_BAD_INPUT;
  const OwnArithmetic arithmetic;
  try {
    return tell_code(error, body());
  } catch (const std::exception&) {
    return code_of_exception(error);
  }
}

/// A struct of the caller's as this library knows it: of an older header what is missing is zero; of a later one what
/// is unknown must be. first: size of the struct in API 1.0.
template <class Struct>
Struct known_part(const Struct* given, std::size_t first, const char* name) {
  refuse_call_if(!given, name, "must not be null");
  const std::size_t size = given->struct_size;
  constexpr std::size_t most = 1 << 16;
  refuse_call_if(size < first || size > most, name,
                 "struct_size is " + std::to_string(size) + ": initialize it by the macro of the header");
  for (std::size_t at = sizeof(Struct); at < size; ++at) {
    const char byte = reinterpret_cast<const char*>(given)[at];
    refuse_call_if(byte != 0, name, "is of a later header, and has a member set that this library does not know");
  }
  Struct known{};
  std::memcpy(&known, given, std::min(size, sizeof known));
  return known;
}

/// Handles begin with what tells them apart.
enum class HandleMark : std::uint64_t {
  problem = 0x61737361792d7072,
  points = 0x61737361792d7074,
  cells = 0x61737361792d636c,
  mesh = 0x61737361792d6d73
};

template <class Handle>
Handle& known_handle(Handle* handle, HandleMark mark, const char* name) {
  refuse_call_if(!handle, name, "must not be null");
  refuse_call_if(handle->mark != mark, name, "is no such handle, or was closed");
  return *handle;
}

/// Deletes the handle, which null may be; one of another kind stays.
template <class Handle>
void close_handle(Handle* handle, HandleMark mark) {
  if (!handle || handle->mark != mark) return;
  const OwnArithmetic arithmetic;
  handle->mark = HandleMark{};
  delete handle;
}

}  // namespace assay::drivers
