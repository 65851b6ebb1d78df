/* Process 1 of the lab's guest: lays a tmpfs over the host's files, sets up what `run` asked for in
 * the control folder, runs the command there, and ends the guest with its status.
 *
 * The control folder is a folder of the host: argv, env (NUL-separated), cwd, seed, shares (a
 * folder a line), links (commands for `ip -batch`), modules (a line each: arguments of modprobe).
 * What comes back is in `status`: what a shell would say of the command. */
#define _GNU_SOURCE
#include <errno.h>
#include <fcntl.h>
#include <linux/random.h>
#include <poll.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/mount.h>
#include <sys/reboot.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#define CONTROL "/run/lab"
enum { kLongest = 1 << 20, kMostWords = 4096 };

static void end(void) {
  sync();
  reboot(RB_POWER_OFF);
  _exit(1);
}

/* The console is a file that `run` shows when there is no status. */
static void die(const char* format, ...) {
  va_list arguments;
  va_start(arguments, format);
  const int number = errno;
  fprintf(stderr, "lab: ");
  vfprintf(stderr, format, arguments);
  fprintf(stderr, "%s%s\n", number ? ": " : "", number ? strerror(number) : "");
  va_end(arguments);
  end();
}

static void attach(const char* source, const char* target, const char* type, const char* options) {
  if (mount(source, target, type, 0, options)) die("mounting %s on %s", type, target);
}

static void make_folders(const char* path) {
  char copy[4096];
  snprintf(copy, sizeof copy, "%s", path);
  for (char* at = copy + 1; *at; ++at) {
    if (*at != '/') continue;
    *at = '\0';
    mkdir(copy, 0755);
    *at = '/';
  }
  mkdir(copy, 0755);
}

/* A file of the control folder; NULL when it is not there. */
static char* contents(const char* name, size_t* size) {
  char path[256];
  snprintf(path, sizeof path, CONTROL "/%s", name);
  const int file = open(path, O_RDONLY | O_CLOEXEC);
  if (file < 0) return NULL;
  char* text = malloc(kLongest + 1);
  if (!text) die("memory for %s", name);
  *size = 0;
  ssize_t got;
  while (*size < kLongest && (got = read(file, text + *size, kLongest - *size)) > 0) {
    *size += (size_t)got;
  }
  if (*size == kLongest) errno = E2BIG, die("%s", name);
  close(file);
  text[*size] = '\0';
  return text;
}

/* The words of a NUL-separated file, as execve() wants them. */
static char** words(const char* name) {
  size_t size = 0;
  char* text = contents(name, &size);
  char** out = calloc(kMostWords + 1, sizeof *out);
  if (!text || !out) die("%s", name);
  int count = 0;
  for (size_t at = 0; at < size && count < kMostWords; at += strlen(text + at) + 1) {
    out[count++] = text + at;
  }
  return out;
}

static void build_root(const char* control) {
  attach("lab", "/mnt", "tmpfs", "size=90%");
  mkdir("/mnt/upper", 0755);
  mkdir("/mnt/work", 0755);
  mkdir("/mnt/root", 0755);
  attach("lab", "/mnt/root", "overlay", "lowerdir=/,upperdir=/mnt/upper,workdir=/mnt/work");
  if (chroot("/mnt/root") || chdir("/")) die("changing to the new root");
  attach("proc", "/proc", "proc", NULL);
  attach("sysfs", "/sys", "sysfs", NULL);
  attach("devtmpfs", "/dev", "devtmpfs", NULL);
  make_folders("/dev/pts");
  make_folders("/dev/shm");
  attach("devpts", "/dev/pts", "devpts", "mode=620,ptmxmode=666");
  attach("shm", "/dev/shm", "tmpfs", "mode=1777");
  attach("run", "/run", "tmpfs", "mode=755");
  make_folders(CONTROL);
  attach("control", CONTROL, "hostfs", control);
  symlink("/proc/self/fd", "/dev/fd");
}

static void attach_shares(void) {
  size_t size = 0;
  char* list = contents("shares", &size);
  for (char* folder = list ? strtok(list, "\n") : NULL; folder; folder = strtok(NULL, "\n")) {
    make_folders(folder);
    attach("share", folder, "hostfs", folder);
  }
}

/* Without it the first read of /dev/urandom gathers entropy for seconds. */
static void seed_random(void) {
  struct {
    struct rand_pool_info info;
    char bytes[64];
  } seed = {{512, 64}, {0}};
  size_t size = 0;
  const char* given = contents("seed", &size);
  if (!given || size < sizeof seed.bytes) return;
  memcpy(seed.bytes, given, sizeof seed.bytes);
  const int pool = open("/dev/random", O_RDWR | O_CLOEXEC);
  if (pool < 0 || ioctl(pool, RNDADDENTROPY, &seed)) die("seeding /dev/random");
  close(pool);
}

/* Runs a tool of the host; its messages go to the console. */
static void tool(char* const arguments[]) {
  const pid_t child = fork();
  if (child == 0) {
    setenv("PATH", "/usr/sbin:/usr/bin:/sbin:/bin", 1);
    execvp(arguments[0], arguments);
    fprintf(stderr, "lab: %s: %s\n", arguments[0], strerror(errno));
    _exit(127);
  }
  int status = 0;
  if (child < 0 || waitpid(child, &status, 0) != child || status != 0) {
    errno = 0;
    die("%s %s did not work", arguments[0], arguments[1]);
  }
}

static void load_modules(const char* folder) {
  size_t size = 0;
  char* list = contents("modules", &size);
  char* rest = NULL;
  for (char* line = list ? strtok_r(list, "\n", &rest) : NULL; line;
       line = strtok_r(NULL, "\n", &rest)) {
    char* arguments[32] = {"modprobe", "-d", (char*)folder};
    int count = 3;
    for (char* word = strtok(line, " "); word && count < 31; word = strtok(NULL, " ")) {
      arguments[count++] = word;
    }
    tool(arguments);
  }
}

static int open_line(const char* name) {
  const int line = open(name, O_WRONLY | O_NOCTTY | O_CLOEXEC);
  struct termios settings;
  if (line < 0 || tcgetattr(line, &settings)) die("%s", name);
  cfmakeraw(&settings);
  if (tcsetattr(line, TCSANOW, &settings)) die("%s", name);
  return line;
}

static pid_t start_command(const int out[2], const int err[2]) {
  char** const arguments = words("argv");
  char** const environment = words("env");
  size_t size = 0;
  const char* folder = contents("cwd", &size);
  const pid_t child = fork();
  if (child != 0) return child;
  setsid();
  const int nothing = open("/dev/null", O_RDONLY);
  dup2(nothing, 0);
  dup2(out[1], 1);
  dup2(err[1], 2);
  if (nothing > 2) close(nothing);
  if (!folder || chdir(folder)) {
    fprintf(stderr, "lab: cannot go to %s: %s\n", folder ? folder : "(nowhere)", strerror(errno));
    _exit(126);
  }
  environ = environment; /* execvp() looks along its PATH */
  execvp(arguments[0], arguments);
  fprintf(stderr, "lab: cannot run %s: %s\n", arguments[0], strerror(errno));
  _exit(errno == ENOENT ? 127 : 126);
}

/* Moves what there is; false at the end of the pipe, or where nothing is left and none is waited
 * for. */
static int move(int from, int to) {
  static char buffer[65536];
  const ssize_t got = read(from, buffer, sizeof buffer);
  if (got < 0 && errno == EINTR) return 1;
  if (got <= 0) return 0;
  for (ssize_t at = 0; at < got;) {
    const ssize_t wrote = write(to, buffer + at, (size_t)(got - at));
    if (wrote < 0 && errno != EINTR) return 0;
    if (wrote > 0) at += wrote;
  }
  return 1;
}

static int child_pipe[2];
static void child_ended(int number) {
  (void)number;
  const ssize_t ignored = write(child_pipe[1], "", 1);
  (void)ignored;
}

static int run_command(void) {
  const int lines[2] = {open_line("/dev/ttyS0"), open_line("/dev/ttyS1")};
  int out[2], err[2];
  if (pipe2(out, O_CLOEXEC) || pipe2(err, O_CLOEXEC) || pipe2(child_pipe, O_CLOEXEC | O_NONBLOCK)) {
    die("pipes");
  }
  signal(SIGCHLD, child_ended);
  const pid_t command = start_command(out, err);
  if (command < 0) die("fork");
  close(out[1]);
  close(err[1]);
  struct pollfd watched[3] = {{out[0], POLLIN, 0}, {err[0], POLLIN, 0}, {child_pipe[0], POLLIN, 0}};
  int status = 0;
  for (int running = 1; running;) {
    if (poll(watched, 3, -1) < 0 && errno != EINTR) die("poll");
    for (int i = 0; i < 2; ++i) {
      if (watched[i].revents && !move(watched[i].fd, lines[i])) watched[i].fd = -1;
    }
    char byte;
    while (read(child_pipe[0], &byte, 1) > 0) continue;
    pid_t ended;
    int how;
    while ((ended = waitpid(-1, &how, WNOHANG)) > 0) {
      if (ended == command) {
        status = how;
        running = 0;
      }
    }
  }
  /* What the command wrote before it ended is in the pipes; what it left running is cut off. */
  const int ends[2] = {out[0], err[0]};
  for (int i = 0; i < 2; ++i) {
    fcntl(ends[i], F_SETFL, O_NONBLOCK);
    while (move(ends[i], lines[i])) continue;
    tcdrain(lines[i]);
  }
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

int main(void) {
  const char* const control = getenv("LAB_CONTROL");
  const char* const modules = getenv("LAB_MODULES");
  if (!control || !modules) errno = EINVAL, die("LAB_CONTROL and LAB_MODULES");
  build_root(control);
  attach_shares();
  seed_random();
  sethostname("lab", 3);
  tool((char*[]){"ip", "-batch", CONTROL "/links", NULL});
  load_modules(modules);
  const int status = run_command();
  FILE* const file = fopen(CONTROL "/status", "w");
  if (!file || fprintf(file, "%d\n", status) < 0 || fclose(file)) die("writing the status");
  end();
}
