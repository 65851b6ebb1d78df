#include "uart.h"

#include "cortex_m3.h"

/* CMSDK APB UART; registers as in Arm's DDI 0479 (Cortex-M System Design Kit), addresses and
 * interrupts as in DAI 0385 (AN385, Cortex-M3 on V2M-MPS2). */
struct registers {
  volatile uint32_t data, state, control, interrupt, divider;
};
#define STATE_SEND_FULL 1U
#define STATE_RECEIVED 2U
#define CONTROL_SEND 1U
#define CONTROL_RECEIVE 2U
#define CONTROL_SEND_INTERRUPT 4U
#define CONTROL_RECEIVE_INTERRUPT 8U
#define INTERRUPT_SENT 1U
#define INTERRUPT_RECEIVED 2U
#define DIVIDER (EB_CLOCK_HZ / 115200U)

#define RING 1024U /* a power of two */

struct ring {
  uint8_t bytes[RING];
  volatile uint32_t in, out;
};

static struct registers* const uarts[EB_LINE_COUNT] = {(struct registers*)0x40004000U,
                                                       (struct registers*)0x40005000U};

static struct { struct ring received, to_send; } lines[EB_LINE_COUNT];

static void receive(enum eb_line which) {
  struct registers* uart = uarts[which];
  struct ring* ring = &lines[which].received;
  /* Cleared first: a byte that comes in between raises it again. The other way round its interrupt
   * would be lost, and with it every byte after it. */
  uart->interrupt = INTERRUPT_RECEIVED;
  while ((uart->state & STATE_RECEIVED) != 0) {
    const uint8_t byte = (uint8_t)uart->data;
    if (ring->in - ring->out == RING) continue; /* lost, as it would be in the UART */
    ring->bytes[ring->in % RING] = byte;
    ring->in = ring->in + 1;
  }
}

/* From the interrupt, or with interrupts off. */
static void feed(enum eb_line which) {
  struct registers* uart = uarts[which];
  struct ring* ring = &lines[which].to_send;
  uart->interrupt = INTERRUPT_SENT;
  while (ring->out != ring->in && (uart->state & STATE_SEND_FULL) == 0) {
    uart->data = ring->bytes[ring->out % RING];
    ring->out = ring->out + 1;
  }
}

void eb_uart0_received(void) { receive(EB_LINE_HOST); }
void eb_uart0_sent(void) { feed(EB_LINE_HOST); }
void eb_uart1_received(void) { receive(EB_LINE_PLANT); }
void eb_uart1_sent(void) { feed(EB_LINE_PLANT); }

void eb_uart_start(void) {
  int i;
  for (i = 0; i < EB_LINE_COUNT; ++i) {
    uarts[i]->divider = DIVIDER;
    uarts[i]->control =
        CONTROL_SEND | CONTROL_RECEIVE | CONTROL_SEND_INTERRUPT | CONTROL_RECEIVE_INTERRUPT;
  }
  eb_enable_interrupts(0xFU); /* UART0 received, sent, UART1 received, sent */
}

int eb_uart_get(enum eb_line line) {
  struct ring* ring = &lines[line].received;
  uint8_t byte;
  if (ring->in == ring->out) return -1;
  byte = ring->bytes[ring->out % RING];
  ring->out = ring->out + 1;
  return byte;
}

size_t eb_uart_room(enum eb_line line) {
  const struct ring* ring = &lines[line].to_send;
  return RING - (ring->in - ring->out);
}

void eb_uart_put(enum eb_line line, const uint8_t* bytes, size_t count) {
  struct ring* ring = &lines[line].to_send;
  size_t i;
  for (i = 0; i < count; ++i) {
    ring->bytes[ring->in % RING] = bytes[i];
    ring->in = ring->in + 1;
  }
  eb_interrupts_off();
  feed(line);
  eb_interrupts_on();
}

void eb_uart_drop_sent(enum eb_line line) {
  eb_interrupts_off();
  lines[line].to_send.out = lines[line].to_send.in;
  eb_interrupts_on();
}

bool eb_uart_waiting(void) {
  int i;
  for (i = 0; i < EB_LINE_COUNT; ++i) {
    if (lines[i].received.in != lines[i].received.out) return true;
  }
  return false;
}
