// What comes with several_library: a variable in a library.
int own_count(void);

int own_count(void) {
  static int count = 0;
  return ++count;
}
