/* SPDX-License-Identifier: BSD-3-Clause */
/* All that the Python package asks of a library before it refuses one that is too old. */
__attribute__((visibility("default"))) const char *assay_version(void);
const char *assay_version(void) { return "0.0.9"; }
