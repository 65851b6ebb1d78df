#include "board_app.h"
#include "cortex_m3.h"
#include "uart.h"

static struct eb_app app;

static void send(void) {
  uint8_t bytes[EB_PLANT_FRAME];
  size_t count;
  if (eb_app_host_lost(&app)) eb_uart_drop_sent(EB_LINE_HOST);
  if (eb_uart_room(EB_LINE_PLANT) >= sizeof bytes) {
    count = eb_app_to_plant(&app, bytes);
    eb_uart_put(EB_LINE_PLANT, bytes, count);
  }
  do {
    count = eb_uart_room(EB_LINE_HOST);
    if (count > sizeof bytes) count = sizeof bytes;
    count = eb_app_to_host(&app, bytes, count);
    eb_uart_put(EB_LINE_HOST, bytes, count);
  } while (count > 0);
}

static void sleep(void) {
  eb_interrupts_off();
  if (!eb_uart_waiting() && !eb_clock_ticked()) eb_sleep();
  eb_interrupts_on();
}

int main(void) {
  eb_app_init(&app);
  eb_clock_start();
  eb_uart_start();
  for (;;) {
    int byte;
    while ((byte = eb_uart_get(EB_LINE_PLANT)) >= 0) eb_app_plant(&app, (uint8_t)byte);
    while ((byte = eb_uart_get(EB_LINE_HOST)) >= 0) eb_app_host(&app, (uint8_t)byte);
    eb_app_time(&app, eb_clock_elapsed_us());
    send();
    sleep();
  }
}
