/* Prints how many bytes this processor saves of a program's floating-point and vector registers,
 * with every feature that the kernel has enabled: what ptrace() transfers whole or refuses
 * (EFAULT). `build` gives the guest kernel that much room, `run` compares at each start. */
#include <cpuid.h>
#include <stdio.h>

int main(void) {
  unsigned eax = 0, ebx = 0, ecx = 0, edx = 0;
  unsigned size = 512; /* FXSAVE: what there is without XSAVE */
  if (__get_cpuid(1, &eax, &ebx, &ecx, &edx) && (ecx & bit_OSXSAVE) != 0 &&
      __get_cpuid_count(0xD, 0, &eax, &ebx, &ecx, &edx)) {
    size = ebx; /* of the features in XCR0; ecx counts those that the kernel left off, too */
  }
  return printf("%u\n", size) < 0;
}
