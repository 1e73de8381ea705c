// SPDX-License-Identifier: BSD-3-Clause
// The end of the analysis, texts and mutexes.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <mutex>

#include "adapters/abaqus/utilities.hpp"

namespace {

constexpr int mutex_count = 100;  ///< Abaqus has as many
std::mutex mutexes[mutex_count];

std::mutex& mutex_of(int id) { return mutexes[static_cast<unsigned>(id - 1) % mutex_count]; }

}  // namespace

extern "C" {

void (*assay_abaqus_on_end)(const char* what) = nullptr;
char assay_abaqus_folder[4096] = ".";

void assay_abaqus_end(const char* what) {
  if (assay_abaqus_on_end) assay_abaqus_on_end(what);
  std::fprintf(stderr, "the model %s\n", what);
  std::exit(1);
}

void assay_abaqus_text(const char* text, char* out, int* length, std::size_t size) {
  const std::size_t n = std::min(std::strlen(text), size);
  std::fill_n(out, size, ' ');
  std::copy_n(text, n, out);
  *length = static_cast<int>(n);
}

// From Fortran and from C.
void mutexinit_(const int*) {}
void mutexlock_(const int* id) { mutex_of(*id).lock(); }
void mutexunlock_(const int* id) { mutex_of(*id).unlock(); }
void MutexInit(int) {}
void MutexLock(int id) { mutex_of(id).lock(); }
void MutexUnlock(int id) { mutex_of(id).unlock(); }

}  // extern "C"
