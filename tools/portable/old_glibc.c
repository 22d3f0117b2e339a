// Symbols that the libstdc++.a of Debian 12 takes from a glibc newer than 2.31.
#define _GNU_SOURCE
#include <stdint.h>
#include <stdlib.h>
#include <sys/random.h>

#define LOCAL __attribute__((visibility("hidden")))

// Counts of shared pointers are always atomic.
LOCAL char __libc_single_threaded = 0;

LOCAL uint32_t arc4random(void) {
  uint32_t number;
  if (getrandom(&number, sizeof number, 0) != sizeof number) abort();
  return number;
}
