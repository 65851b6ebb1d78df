/* One call at a time: C leaves it to the compiler which argument of a printf comes first. */
#define TELL(what, call) printf(what " %d\n", (int)(call))
