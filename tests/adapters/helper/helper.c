/* SPDX-License-Identifier: BSD-3-Clause */
/* What the plug-in asks_a_helper needs from another library. */
__attribute__((visibility("default"))) double helper_share(void);

double helper_share(void) { return 0.5; }
