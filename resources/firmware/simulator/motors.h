/* Watches the pins of the vibration motors and prints what changes. */
#ifndef MOTORS_H
#define MOTORS_H

#include <simavr/sim_avr.h>

#define MOTORS 3

typedef struct {
    uint8_t amplitude[MOTORS];
} motors_t;

/* Prints "haptic CHANNEL AMPLITUDE T" for each motor whose duty, of 255, is another one. */
void motors_poll(motors_t *motors, avr_t *avr);

#endif
