// SPDX-License-Identifier: BSD-3-Clause
// Table collections of the input file: there are none, and every routine says so by JERROR, its last argument before
// the lengths of texts.

extern "C" {

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
