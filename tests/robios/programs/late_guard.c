/* Preloaded: the first child of a program, which is the guard of its terminal, goes on no sooner
   than a SIGTSTP has come to it. On a busy computer Ctrl-Z may be that early. */
#define _GNU_SOURCE
#include <signal.h>
#include <sys/syscall.h>
#include <unistd.h>

static long program;

__attribute__((constructor)) static void begin(void) { program = syscall(SYS_getpid); }

pid_t setsid(void) {
  sigset_t pending;
  while (syscall(SYS_getpid) != program) {
    if (sigpending(&pending) != 0 || sigismember(&pending, SIGTSTP)) break;
    syscall(SYS_sched_yield);
  }
  return (pid_t)syscall(SYS_setsid);
}
