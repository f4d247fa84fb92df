/* The chip's UART on a pseudo-terminal, which a host opens as it would a USB serial port. */
#ifndef PORT_H
#define PORT_H

#include <simavr/sim_avr.h>
#include <stdbool.h>

typedef struct {
    avr_t *avr;
    int master, slave;
    const char *name; /* of the slave */
    bool waits;       /* for a slow host instead of losing bytes, as no real port does */
    bool ready;       /* the chip takes input */
    unsigned long sent, lost;
    avr_irq_t *input;
} port_t;

/* False, with a sentence on standard error, where no pseudo-terminal can be had. */
bool port_attach(port_t *port, avr_t *avr, bool waits);

/* Hands the chip what the host has written, as fast as its line allows. */
void port_poll(port_t *port);

#endif
