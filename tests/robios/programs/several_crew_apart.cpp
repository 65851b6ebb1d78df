// The same in a process of its own.
[[maybe_unused]] thread_local int apart = 0;

#include "several_crew.cpp"
