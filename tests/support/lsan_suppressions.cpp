// For tests that load these libraries themselves. OSMesa keeps the framebuffer of each context,
// fontconfig (behind cairo's and Qt's text) its patterns, D-Bus (behind Qt) what each of its
// threads has, until the process ends; none offers a way to free them. Our own leaks are still
// reported.
extern "C" __attribute__((visibility("default"))) const char* __lsan_default_suppressions() {
  return "leak:libOSMesa.so\nleak:libfontconfig.so\nleak:libdbus-1.so\n";
}
