/* SPDX-License-Identifier: BSD-3-Clause */
/* Loaded before a program (LD_PRELOAD), it leaves the byte $FILL_STACK, a decimal number, in the stack of its main
   thread: what another machine may have left there. */
#include <stddef.h>
#include <stdlib.h>

__attribute__((constructor)) static void fill_stack(void) {
  const char* word = getenv("FILL_STACK");
  if (!word) return;
  volatile unsigned char room[256 << 10];
  const unsigned char byte = (unsigned char)atoi(word);
  for (size_t k = 0; k < sizeof room; ++k) room[k] = byte;
}
