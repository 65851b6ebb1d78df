#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include "cortex_m3.h"

/* From mps2.ld. */
extern uint8_t eb_stack_top[], eb_data_source[], eb_data_start[], eb_data_end[], eb_bss_start[],
    eb_bss_end[];

int main(void);
void eb_reset(void);
void eb_halt(void);

/* Stands still for good, and the plant notices the silence. */
void eb_halt(void) {
  eb_interrupts_off();
  for (;;) eb_sleep();
}

void eb_reset(void) {
  memcpy(eb_data_start, eb_data_source, (size_t)(eb_data_end - eb_data_start));
  memset(eb_bss_start, 0, (size_t)(eb_bss_end - eb_bss_start));
  main();
  eb_halt();
}

#define EXCEPTIONS 16
typedef void (*handler)(void);
struct vectors {
  uint8_t* stack_top;
  handler exceptions[EXCEPTIONS - 1];
  handler interrupts[32];
};

/* Reset, NMI, four faults, four reserved, SVCall, debug, reserved, PendSV, SysTick; then the
 * board's interrupts, of which only the first four are ever enabled. */
__attribute__((section(".vectors"), used)) static const struct vectors vectors = {
    eb_stack_top,
    {eb_reset, eb_halt, eb_halt, eb_halt, eb_halt, eb_halt, 0, 0, 0, 0, eb_halt, eb_halt, 0,
     eb_halt, eb_systick},
    {eb_uart0_received, eb_uart0_sent, eb_uart1_received, eb_uart1_sent}};
