// The same in a process of its own.
_Thread_local int apart;

#include "gathers.c"
