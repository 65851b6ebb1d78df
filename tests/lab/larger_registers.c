/* Preloaded into the guest kernel, makes the host's ptrace() behave as on a processor that saves
 * EYEBRIDGE_TEST_REGISTERS bytes of registers: setting them from a smaller area fails with EFAULT,
 * reading them fills the area. What lies behind the registers of this processor gets a different
 * content each time it is read; when it comes back changed or mixed, setting fails with EBADMSG. */
#define _GNU_SOURCE
#include <elf.h>
#include <errno.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdlib.h>
#include <sys/ptrace.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

enum { kTiles = 2752 }; /* where the tiles of AMX begin */

static size_t size;

__attribute__((constructor)) static void read_size(void) {
  const char* const text = getenv("EYEBRIDGE_TEST_REGISTERS");
  if (text) size = strtoul(text, NULL, 10);
}

static uint64_t word(uint64_t reading, size_t at) { return reading * 0x9E3779B97F4A7C15u + at; }

static void fill(uint64_t* area, size_t bytes) {
  static uint64_t reading;
  ++reading;
  for (size_t i = kTiles / 8; i < bytes / 8; ++i) area[i] = word(reading, i);
}

static int unchanged(const uint64_t* area, size_t bytes) {
  const uint64_t first = area[kTiles / 8] - kTiles / 8;
  for (size_t i = kTiles / 8; i < bytes / 8; ++i) {
    if (area[i] != first + i) return 0;
  }
  return first != 0;
}

static long fail(int number) {
  errno = number;
  return -1;
}

long ptrace(enum __ptrace_request request, ...) {
  va_list arguments;
  va_start(arguments, request);
  const pid_t process = va_arg(arguments, pid_t);
  void* const address = va_arg(arguments, void*);
  void* data = va_arg(arguments, void*);
  va_end(arguments);

  struct iovec* const area = data;
  const int whole = size > 0 && (uintptr_t)address == NT_X86_XSTATE;
  const size_t room =
      whole && (request == PTRACE_GETREGSET || request == PTRACE_SETREGSET) ? area->iov_len : 0;
  if (whole && request == PTRACE_SETREGSET) {
    if (room < size) return fail(EFAULT);
    if (!unchanged(area->iov_base, size)) return fail(EBADMSG);
  }
  long word_read = 0; /* the system call stores what glibc's function returns */
  const int peeks =
      request == PTRACE_PEEKTEXT || request == PTRACE_PEEKDATA || request == PTRACE_PEEKUSER;
  if (peeks) data = &word_read;
  const long result = syscall(SYS_ptrace, request, process, address, data);
  if (result < 0) return result;
  if (whole && request == PTRACE_GETREGSET) {
    area->iov_len = room < size ? room : size;
    fill(area->iov_base, area->iov_len);
  }
  if (peeks) {
    errno = 0;
    return word_read;
  }
  return result;
}
