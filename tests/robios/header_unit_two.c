#include <eyebot.h>

int width_seen_in_unit_two(void);
int width_seen_in_unit_two(void) { return CAMWIDTH; }

/* What 56 of 137 real programs use without including it. */
int things_only_eyebot_brings(const char* text);
int things_only_eyebot_brings(const char* text) {
  bool right = strcmp(text, "42") == 0 && atoi(text) == 42 && abs(-3) == 3;
  FILE* none = fopen("/nonexistent/file", "r");
  char* copy = (char*)malloc(8);
  sem_t semaphore;
  pthread_t self = pthread_self();
  SEMA* alias = &semaphore;
  TASK task = {self, 1};
  if (none != NULL || copy == NULL || alias == NULL || sqrt(4.0) < 1.9 || RAND_MAX < 1) {
    right = false;
  }
  sprintf(copy, "%d", task.identifier);
  right = right && copy[0] == '1' && True == 1 && False == 0;
  free(copy);
  return right ? EXIT_SUCCESS : EXIT_FAILURE;
}
