/* What happens to the glove while it runs, at times given beforehand or on standard input. */
#ifndef EVENTS_H
#define EVENTS_H

#include <stdbool.h>

#include "spi_bus.h"

#define EVENTS_MAX 64

typedef struct {
    double t; /* s */
    const char *command;
} event_t;

typedef struct {
    event_t list[EVENTS_MAX];
    int count;
} events_t;

/* Adds "T:COMMAND"; false, with a sentence on standard error, where it is not one. Commands:
 *   unplug IMU, plug IMU   its wires off and on again (it comes back with power-on settings)
 *   brownout IMU           it loses its settings and goes on
 *   weak-accel IMU, weak-gyro IMU   it answers the self-test with a fifth of what it should
 *   battery MV             the battery's voltage
 *   pulse US               the synchrony pin is low that long; when it rises is printed
 *   reset                  the reset button */
bool events_add(events_t *events, const char *text);

/* Carries out what is due, and the commands that stand, one a line, on standard input. */
void events_poll(events_t *events, spi_bus_t *bus);

#endif
