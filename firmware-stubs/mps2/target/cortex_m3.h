#ifndef EB_CORTEX_M3_H
#define EB_CORTEX_M3_H

#include <stdbool.h>
#include <stdint.h>

#define EB_CLOCK_HZ 25000000U
#define EB_CLOCK_MHZ (EB_CLOCK_HZ / 1000000U)

/* Peripheral interrupts 0 ... 31, one bit each. */
void eb_enable_interrupts(uint32_t mask);

static inline void eb_interrupts_off(void) { __asm__ volatile("cpsid i" ::: "memory"); }
static inline void eb_interrupts_on(void) { __asm__ volatile("cpsie i" ::: "memory"); }
/* Until an interrupt is pending, also one that is held back. */
static inline void eb_sleep(void) { __asm__ volatile("wfi" ::: "memory"); }

/* SysTick wakes the processor every millisecond; a free-running counter measures: interrupts that
 * an emulator served late and as one are no lost time. */
void eb_clock_start(void);
/* Microseconds since the last call. */
uint32_t eb_clock_elapsed_us(void);
/* True once after each SysTick. To be asked with interrupts off before sleeping. */
bool eb_clock_ticked(void);

/* Interrupt handlers. */
void eb_systick(void);
void eb_uart0_received(void);
void eb_uart0_sent(void);
void eb_uart1_received(void);
void eb_uart1_sent(void);

#endif
