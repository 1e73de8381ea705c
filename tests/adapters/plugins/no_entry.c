/* SPDX-License-Identifier: BSD-3-Clause */
/* A shared library that is no material. */
int no_material(void);
int no_material(void) { return 1; }
