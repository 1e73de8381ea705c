// SPDX-License-Identifier: BSD-3-Clause
// The end of the analysis, texts and mutexes.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <mutex>

#include "adapters/abaqus/utilities.hpp"

namespace {

constexpr unsigned mutex_count = 100;  ///< Abaqus has as many
std::mutex mutexes[mutex_count];
thread_local bool held[mutex_count];  ///< by this thread

unsigned place_of(int id) { return (static_cast<unsigned>(id) - 1) % mutex_count; }

void lock(int id) {
  mutexes[place_of(id)].lock();
  held[place_of(id)] = true;
}

void unlock(unsigned place) {
  if (!held[place]) return;
  held[place] = false;
  mutexes[place].unlock();
}

/// A call that the model has ended comes back to nothing: the next one would wait for ever.
void unlock_all() {
  for (unsigned place = 0; place < mutex_count; ++place) unlock(place);
}

}  // namespace

extern "C" {

void (*assay_abaqus_on_end)(const char* what) = nullptr;
char assay_abaqus_folder[4096] = ".";

void assay_abaqus_end(const char* what) {
  unlock_all();
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
void mutexlock_(const int* id) { lock(*id); }
void mutexunlock_(const int* id) { unlock(place_of(*id)); }
void MutexInit(int) {}
void MutexLock(int id) { lock(id); }
void MutexUnlock(int id) { unlock(place_of(id)); }

}  // extern "C"
