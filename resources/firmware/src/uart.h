/* The serial port, 8N1 at BAUD, through two ring buffers and interrupts. */
#ifndef UART_H
#define UART_H

#include <stdbool.h>
#include <stdint.h>

#ifndef BAUD
#define BAUD 250000UL
#endif

void uart_init(void);

/* Bytes that uart_put takes at once. */
uint8_t uart_room(void);

/* Queues a byte; the caller has made sure of the room. */
void uart_put(uint8_t byte);

/* Takes the oldest byte received, or returns false. Bytes that found the ring full are lost: the
 * checksum of their frame tells. */
bool uart_get(uint8_t *byte);
bool uart_has_input(void);

#endif
