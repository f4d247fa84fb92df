#include "uart.h"

#include <avr/interrupt.h>
#include <avr/io.h>

/* Double speed: 250000 is exact (7), 115200 is 2.1 % fast (16; without it -3.5 %). */
#define DIVIDER ((F_CPU + 4 * BAUD) / (8 * BAUD) - 1)

/* The rings' indices are bytes and wrap by themselves or by a mask. The sending ring holds two
 * frames of seven IMUs. */
#define SEND_SIZE 256
#define RECEIVE_MASK 63

static uint8_t send_ring[SEND_SIZE];
static volatile uint8_t send_head, send_tail;
static uint8_t receive_ring[RECEIVE_MASK + 1];
static volatile uint8_t receive_head, receive_tail;

ISR(USART_UDRE_vect)
{
    UDR0 = send_ring[send_tail++];
    if (send_tail == send_head)
        UCSR0B &= ~_BV(UDRIE0);
}

ISR(USART_RX_vect)
{
    uint8_t byte = UDR0;
    uint8_t next = (receive_head + 1) & RECEIVE_MASK;
    if (next != receive_tail) {
        receive_ring[receive_head] = byte;
        receive_head = next;
    }
}

void uart_init(void)
{
    UCSR0A = _BV(U2X0); /* before the divider: simavr takes the speed when that is written */
    UCSR0C = _BV(UCSZ01) | _BV(UCSZ00);
    UBRR0 = DIVIDER;
    UCSR0B = _BV(RXCIE0) | _BV(RXEN0) | _BV(TXEN0);
}

uint8_t uart_room(void)
{
    return (uint8_t)(send_tail - send_head - 1);
}

void uart_put(uint8_t byte)
{
    send_ring[send_head] = byte;
    send_head++;
    UCSR0B |= _BV(UDRIE0);
}

bool uart_get(uint8_t *byte)
{
    if (receive_head == receive_tail)
        return false;
    *byte = receive_ring[receive_tail];
    receive_tail = (receive_tail + 1) & RECEIVE_MASK;
    return true;
}

bool uart_has_input(void)
{
    return receive_head != receive_tail;
}
