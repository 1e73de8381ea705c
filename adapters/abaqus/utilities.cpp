// SPDX-License-Identifier: BSD-3-Clause
// Abaqus' utility routines for user materials, as Fortran calls them on Linux: everything by reference, the lengths of
// character arguments by value at the end. A library of its own that is loaded before foreign models; what a routine
// does is what Abaqus' manual says of it.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <string>

#include <Eigen/Eigenvalues>

extern "C" {

/// What happens where a model ends the analysis: set by the host; must not return. Null: a line on standard error, and
/// the process ends with status 1.
void (*assay_abaqus_on_end)(const char* what) = nullptr;

/// GETOUTDIR: where the model may look for its files; set by the host.
char assay_abaqus_folder[4096] = ".";

}  // extern "C"

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

[[noreturn]] void end_analysis(const char* what) {
  unlock_all();
  if (assay_abaqus_on_end) assay_abaqus_on_end(what);
  std::fprintf(stderr, "the model %s\n", what);
  std::exit(1);
}

/// A Fortran character variable of `size`, blank-padded, and the length of the text in it.
void write_text(const char* text, char* out, int* length, std::size_t size) {
  const std::size_t n = std::min(std::strlen(text), size);
  std::fill_n(out, size, ' ');
  std::copy_n(text, n, out);
  *length = static_cast<int>(n);
}

using Tensor = Eigen::Matrix3d;

constexpr int strains = 2;  ///< LSTR: 1 stresses, 2 strains with engineering shears

/// Places of the shear components: 12, 13, 23 of Abaqus/Standard, 12, 23, 31 of Abaqus/Explicit.
struct Shears {
  int row[3], column[3];
};
constexpr Shears of_standard{{0, 0, 1}, {1, 2, 2}}, of_explicit{{0, 1, 2}, {1, 2, 0}};

/// Components 11, 22, 33 and the shears, as many as there are, `stride` apart.
Tensor tensor_of(const double* s, double shear, int ndi, int nshr, const Shears& shears = of_standard,
                 std::size_t stride = 1) {
  const auto at = [&](int k) { return s[static_cast<std::size_t>(k) * stride]; };
  const auto& [row, column] = shears;
  Tensor A = Tensor::Zero();
  for (int k = 0; k < ndi && k < 3; ++k) A(k, k) = at(k);
  for (int k = 0; k < nshr && k < 3; ++k) A(row[k], column[k]) = A(column[k], row[k]) = shear * at(ndi + k);
  return A;
}

Tensor tensor_of(const double* s, const int* lstr, const int* ndi, const int* nshr) {
  return tensor_of(s, *lstr == strains ? 0.5 : 1, *ndi, *nshr);
}

void write_components(const Tensor& A, int lstr, int ndi, int nshr, double* s) {
  const auto& [row, column] = of_standard;
  const double shear = lstr == strains ? 2 : 1;
  for (int k = 0; k < ndi && k < 3; ++k) s[k] = A(k, k);
  for (int k = 0; k < nshr && k < 3; ++k) s[ndi + k] = shear * A(row[k], column[k]);
}

/// In ascending order, with directions; of what is not finite all are NaN, which the iteration would hide.
struct Principal {
  explicit Principal(const Tensor& A) {
    if (!A.allFinite()) return;
    const Eigen::SelfAdjointEigenSolver<Tensor> solver(A);
    values = solver.eigenvalues();
    directions = solver.eigenvectors();
  }
  Eigen::Vector3d values = Eigen::Vector3d::Constant(NAN);
  Tensor directions = Tensor::Constant(NAN);  ///< column k: of value k
};

struct Message {
  const char* text;
  std::size_t length;
  const int* integers;
  const double* reals;
  const char* strings;
  std::size_t string_length;
};

/// With its values in place of %I, %R and %S; what exceeds `size` is cut.
void write_message(Message m, char* out, std::size_t size) {
  constexpr std::size_t word = 8;  // CHARACTER*8 CHARV(*)
  const std::size_t stride = std::max(m.string_length, word);
  std::string line;
  for (std::size_t k = 0; k < m.length; ++k) {
    const char next = k + 1 < m.length ? m.text[k + 1] : ' ';
    if (m.text[k] != '%' || (next != 'I' && next != 'R' && next != 'S')) {
      line += m.text[k];
      continue;
    }
    ++k;
    if (next == 'I') line += std::to_string(*m.integers++);
    if (next == 'R') {
      char number[32];
      std::snprintf(number, sizeof number, "%.6g", *m.reals++);
      line += number;
    }
    if (next == 'S') line.append(m.strings, strnlen(m.strings, stride)), m.strings += stride;
  }
  line.erase(line.find_last_not_of(' ') + 1);
  out[line.copy(out, size - 1)] = '\0';
}

}  // namespace

extern "C" {

/// SINV1 = tr(s) / 3, SINV2 = sqrt(3/2 dev s : dev s).
void sinv_(const double* stress, double* sinv1, double* sinv2, const int* ndi, const int* nshr) {
  const Tensor A = tensor_of(stress, 1.0, *ndi, *nshr);
  *sinv1 = A.trace() / 3;
  const Tensor deviator = A - *sinv1 * Tensor::Identity();
  *sinv2 = std::sqrt(1.5) * deviator.norm();
}

/// Principal values, in ascending order.
void sprinc_(const double* s, double* ps, const int* lstr, const int* ndi, const int* nshr) {
  const Principal found(tensor_of(s, lstr, ndi, nshr));
  for (int k = 0; k < 3; ++k) ps[k] = found.values(k);
}

/// And directions: AN(K, I), I = 1, 2, 3 are the cosines of PS(K).
void sprind_(const double* s, double* ps, double* an, const int* lstr, const int* ndi, const int* nshr) {
  const Principal found(tensor_of(s, lstr, ndi, nshr));
  for (int k = 0; k < 3; ++k) {
    ps[k] = found.values(k);
    for (int i = 0; i < 3; ++i) an[3 * i + k] = found.directions(i, k);
  }
}

/// SPRIME = R S R^T, R column by column.
void rotsig_(const double* s, const double* r, double* sprime, const int* lstr, const int* ndi, const int* nshr) {
  const Tensor R = Eigen::Map<const Tensor>(r), A = tensor_of(s, lstr, ndi, nshr);
  write_components(R * A * R.transpose(), *lstr, *ndi, *nshr, sprime);
}

/// The analysis ends.
void xit_() { end_analysis("called XIT"); }
void xplb_exit_() { end_analysis("called XPLB_EXIT"); }

/// LOP 1: information, -1: warning, -2: error, -3: error that ends the analysis. %I, %R and %S of the text stand for
/// the next integer, real and string.
void stdb_abqerr_(const int* lop, const char* text, const int* intv, const double* realv, const char* charv,
                  std::size_t text_length, std::size_t charv_length) {
  char line[600];  // no object with a destructor: the end of the analysis leaves this frame without one
  write_message({text, text_length, intv, realv, charv, charv_length}, line, sizeof line);
  const char* kind = *lop > 0 ? "information" : *lop == -1 ? "warning" : "error";
  std::fprintf(stderr, "%s: %s\n", kind, line);
  constexpr int fatal = -3;
  if (*lop != fatal) return;
  char what[sizeof line + 60];
  std::snprintf(what, sizeof what, "reported an error that ends the analysis: %s", line);
  end_analysis(what);
}

void xplb_abqerr_(const int* lop, const char* text, const int* intv, const double* realv, const char* charv,
                  std::size_t text_length, std::size_t charv_length) {
  stdb_abqerr_(lop, text, intv, realv, charv, text_length, charv_length);
}

/// Variables of a finite element's point: there is none. JRCD = 1 says so.
void getvrm_(const char*, double*, int*, char*, int* jrcd, ...) { *jrcd = 1; }
void vgetvrm_(const char*, double*, int*, char*, int* jrcd, ...) { *jrcd = 1; }

void getoutdir_(char* folder, int* length, std::size_t size) { write_text(assay_abaqus_folder, folder, length, size); }
void vgetoutdir_(char* folder, int* length, std::size_t size) { write_text(assay_abaqus_folder, folder, length, size); }
void getjobname_(char* name, int* length, std::size_t size) { write_text("assay", name, length, size); }
void vgetjobname_(char* name, int* length, std::size_t size) { write_text("assay", name, length, size); }

void getrank_(int* rank) { *rank = 0; }
void vgetrank_(int* rank) { *rank = 0; }
void getnumcpus_(int* count) { *count = 1; }
void vgetnumcpus_(int* count) { *count = 1; }
int getnumthreads_() { return 1; }
int get_thread_id_() { return 0; }
int getnumthreads() { return 1; }
int get_thread_id() { return 0; }

/// Principal values and directions of n tensors 11, 22, 33, 12, 23, 31, [component][point].
void vsprind_(const int* nblock, const double* tensor, double* values, double* vectors, const int* ndir,
              const int* nshr) {
  const auto n = static_cast<std::size_t>(*nblock);
  for (std::size_t p = 0; p < n; ++p) {
    const Principal found(tensor_of(tensor + p, 1.0, *ndir, *nshr, of_explicit, n));
    for (std::size_t k = 0; k < 3; ++k) {
      const auto i = static_cast<Eigen::Index>(k);
      values[k * n + p] = found.values(i);
      for (std::size_t c = 0; vectors && c < 3; ++c) {
        vectors[(3 * k + c) * n + p] = found.directions(static_cast<Eigen::Index>(c), i);
      }
    }
  }
}

void vsprinc_(const int* nblock, const double* tensor, double* values, const int* ndir, const int* nshr) {
  vsprind_(nblock, tensor, values, nullptr, ndir, nshr);
}

// From Fortran and from C.
void mutexinit_(const int*) {}
void mutexlock_(const int* id) { lock(*id); }
void mutexunlock_(const int* id) { unlock(place_of(*id)); }
void MutexInit(int) {}
void MutexLock(int id) { lock(id); }
void MutexUnlock(int id) { unlock(place_of(id)); }

// Table collections of the input file: there are none, and every routine says so by JERROR, its last argument before
// the lengths of texts.
void settablecollection_(const char*, int* jerror, ...) { *jerror = 1; }

void getparametertable_(const char*, const int*, int*, int*, double*, char*, int* jerror, ...) { *jerror = 1; }
void getparametertablerow_(const char*, const int*, const int*, int*, int*, double*, char*, int* jerror, ...) {
  *jerror = 1;
}

void getpropertytable_(const char*, const double*, const double*, const double*, const int*, double*, double*,
                       const int*, int* jerror, ...) {
  *jerror = 1;
}
void vgetpropertytable_(const char*, const int*, const double*, const double*, const double*, const int*, double*,
                        double*, double*, const int*, int* jerror, ...) {
  *jerror = 1;
}

void queryparametertable_(const char*, int*, int*, int* jerror, ...) { *jerror = 1; }
void querypropertytable_(const char*, int*, double*, char*, int* jerror, ...) { *jerror = 1; }
void querytablecollection_(int*, char*, int* jerror, ...) { *jerror = 1; }
void querytablecollectionsize_(int*, int* jerror, ...) { *jerror = 1; }
void querytablecollectionnames_(char*, const int*, ...) {}

}  // extern "C"
