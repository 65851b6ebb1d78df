/* OSMesa keeps the framebuffer of each context, and fontconfig, under cairo, what it has read,
 * until the process ends. Leaks of ours are still reported. */
__attribute__((visibility("default"))) const char* __lsan_default_suppressions(void);
const char* __lsan_default_suppressions(void) {
  return "leak:libOSMesa.so\nleak:libfontconfig.so\n";
}
__attribute__((visibility("default"))) const char* __lsan_default_options(void);
const char* __lsan_default_options(void) { return "print_suppressions=0"; }
