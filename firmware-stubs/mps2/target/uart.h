#ifndef EB_UART_H
#define EB_UART_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* The two serial lines of the board, behind rings that the interrupts fill and empty. */
enum eb_line { EB_LINE_HOST, EB_LINE_PLANT, EB_LINE_COUNT };

void eb_uart_start(void);
/* The next byte that came in; -1 when there is none. */
int eb_uart_get(enum eb_line line);
/* How many bytes eb_uart_put() takes now. */
size_t eb_uart_room(enum eb_line line);
/* At most that many. */
void eb_uart_put(enum eb_line line, const uint8_t* bytes, size_t count);
/* Forgets what has not gone out yet. */
void eb_uart_drop_sent(enum eb_line line);
/* Something came in. To be asked with interrupts off before sleeping. */
bool eb_uart_waiting(void);

#endif
