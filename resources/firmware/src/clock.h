/* Timer1: the sampling instants, a microsecond clock and the instants of pulses on the synchrony pin,
 * all from one counter. */
#ifndef CLOCK_H
#define CLOCK_H

#include <stdbool.h>
#include <stdint.h>

void clock_init(uint16_t rate_hz);

/* Changes the rate at once; the clock goes on without a step. */
void clock_set_rate(uint16_t rate_hz);
uint16_t clock_rate(void);

/* Microseconds since the start, modulo 2^32 (71.6 min). */
uint32_t clock_us(void);

/* True once per sampling instant, whose time is put into t_us; `skipped` is the number of instants
 * since the last call that nobody took. */
bool clock_take_tick(uint32_t *t_us, uint8_t *skipped);

/* Whether clock_take_tick would return true; for the sleep of the main loop. */
bool clock_tick_waits(void);

/* The oldest pulse (rising edge) that nobody took yet: its number, from 1, and the instant of its
 * interrupt. Of more than PULSES_KEPT that wait the newest are lost;
 * their numbers are missing. */
#define PULSES_KEPT 8
bool clock_take_pulse(uint16_t *number, uint32_t *t_us);
bool clock_pulse_waits(void);

#endif
