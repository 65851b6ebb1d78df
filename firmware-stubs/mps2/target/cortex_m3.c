#include "cortex_m3.h"

/* SysTick and NVIC as in Arm's DDI 0403 (ARMv7-M), the timer as in DDI 0479 (CMSDK APB timer). */
#define SYSTICK_CONTROL (*(volatile uint32_t*)0xE000E010U)
#define SYSTICK_RELOAD (*(volatile uint32_t*)0xE000E014U)
#define SYSTICK_VALUE (*(volatile uint32_t*)0xE000E018U)
#define SYSTICK_ON 7U /* processor clock, interrupt, enable */
#define NVIC_ENABLE (*(volatile uint32_t*)0xE000E100U)
#define TIMER_CONTROL (*(volatile uint32_t*)0x40000000U)
#define TIMER_VALUE (*(volatile uint32_t*)0x40000004U)
#define TIMER_RELOAD (*(volatile uint32_t*)0x40000008U)
#define TIMER_ON 1U
#define WAKE_HZ 1000U

static volatile bool ticked;
static uint32_t last, cycles;

void eb_enable_interrupts(uint32_t mask) { NVIC_ENABLE = mask; }

void eb_systick(void) { ticked = true; }

void eb_clock_start(void) {
  TIMER_RELOAD = 0xFFFFFFFFU;
  TIMER_VALUE = 0xFFFFFFFFU;
  TIMER_CONTROL = TIMER_ON;
  last = TIMER_VALUE;
  SYSTICK_RELOAD = EB_CLOCK_HZ / WAKE_HZ - 1U;
  SYSTICK_VALUE = 0;
  SYSTICK_CONTROL = SYSTICK_ON;
}

uint32_t eb_clock_elapsed_us(void) {
  const uint32_t now = TIMER_VALUE; /* it counts down, and around in 171 s */
  uint32_t elapsed;
  cycles += last - now;
  last = now;
  elapsed = cycles / EB_CLOCK_MHZ;
  cycles -= elapsed * EB_CLOCK_MHZ;
  return elapsed;
}

bool eb_clock_ticked(void) {
  const bool was = ticked;
  ticked = false;
  return was;
}
