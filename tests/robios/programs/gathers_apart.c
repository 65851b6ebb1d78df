// The same in a process of its own, as it has threads.
#define APART
#include <pthread.h>

#include "gathers.c"
