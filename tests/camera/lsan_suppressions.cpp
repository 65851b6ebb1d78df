// OSMesa keeps the framebuffer of each context, and fontconfig (behind cairo's text) its patterns
// until the process ends; neither offers a way to free them. Our own leaks are still reported.
extern "C" __attribute__((visibility("default"))) const char* __lsan_default_suppressions() {
  return "leak:libOSMesa.so\nleak:libfontconfig.so\n";
}
