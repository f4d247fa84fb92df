/* Vibration motors on hardware PWM, each for a set time. */
#ifndef HAPTIC_H
#define HAPTIC_H

#include <stdint.h>

void haptic_init(void);

/* Runs a motor at amplitude/255 for duration_ms from now; either of them 0 stops it. An unknown
 * channel is ignored. */
void haptic_start(uint8_t channel, uint8_t amplitude, uint16_t duration_ms, uint32_t now_us);

/* Stops the motors whose time is over. */
void haptic_poll(uint32_t now_us);

#endif
