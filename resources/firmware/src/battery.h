/* The battery's voltage, measured in the background. */
#ifndef BATTERY_H
#define BATTERY_H

#include <stdint.h>

#define BATTERY_NONE 0xFFFF

/* Starts the first measurement. */
void battery_init(void);

/* mV of the last measurement, BATTERY_NONE without a battery; starts the next one. Calls lie at
 * least 1 ms apart. */
uint16_t battery_mV(void);

#endif
