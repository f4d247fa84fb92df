#include "clock.h"

#include <avr/interrupt.h>
#include <avr/io.h>
#include <util/atomic.h>

#include "board.h"

#define COUNTS_PER_US 2 /* 16 MHz / 8 */

static volatile uint32_t tick_us; /* the last sampling instant */
static volatile uint16_t period_us;
static volatile uint8_t ticks; /* not yet taken */

static volatile struct {
    uint16_t number;
    uint32_t t_us;
} pulses[PULSES_KEPT];
static volatile uint8_t first_pulse, pulses_waiting;
static uint16_t pulse_number; /* of the last one, kept or not */

ISR(TIMER1_COMPA_vect)
{
    tick_us += period_us;
    if (ticks < UINT8_MAX)
        ticks++;
}

/* To be called with interrupts off. */
static uint32_t now_us(void)
{
    uint16_t counts = TCNT1;
    uint32_t start = tick_us;
    if (TIFR1 & _BV(OCF1A)) { /* the counter went round and its interrupt has not run yet */
        counts = TCNT1;
        start += period_us;
    }
    return start + counts / COUNTS_PER_US;
}

/* The first of all interrupts: it waits for another one's end at most, some microseconds. */
ISR(INT0_vect)
{
    uint32_t t_us = now_us();
    pulse_number++;
    if (pulses_waiting < PULSES_KEPT) {
        uint8_t place = (first_pulse + pulses_waiting++) % PULSES_KEPT;
        pulses[place].number = pulse_number;
        pulses[place].t_us = t_us;
    }
}

static void set_period(uint16_t rate_hz)
{
    period_us = 1000000UL / rate_hz;
    OCR1A = period_us * COUNTS_PER_US - 1;
}

void clock_init(uint16_t rate_hz)
{
    TCCR1A = 0;
    set_period(rate_hz);
    TIMSK1 = _BV(OCIE1A);
    TCCR1B = _BV(WGM12) | _BV(CS11); /* clear on compare match, clk/8 */
    PORTD |= SYNC_PIN;               /* pulled up: a pin that nothing is on has no edges */
    EICRA = _BV(ISC01) | _BV(ISC00); /* rising edges */
    EIFR = _BV(INTF0);
    EIMSK = _BV(INT0);
}

void clock_set_rate(uint16_t rate_hz)
{
    ATOMIC_BLOCK(ATOMIC_RESTORESTATE) {
        tick_us = now_us();
        TCNT1 = 0; /* else a counter already past the new period would run on to 65535 */
        TIFR1 = _BV(OCF1A);
        set_period(rate_hz);
    }
}

uint16_t clock_rate(void)
{
    return 1000000UL / period_us; /* only the main loop writes period_us */
}

uint32_t clock_us(void)
{
    uint32_t now;
    ATOMIC_BLOCK(ATOMIC_RESTORESTATE) {
        now = now_us();
    }
    return now;
}

bool clock_take_tick(uint32_t *t_us, uint8_t *skipped)
{
    uint8_t taken;
    ATOMIC_BLOCK(ATOMIC_RESTORESTATE) {
        taken = ticks;
        ticks = 0;
        *t_us = tick_us;
    }
    *skipped = taken ? taken - 1 : 0;
    return taken != 0;
}

bool clock_tick_waits(void)
{
    return ticks != 0;
}

bool clock_take_pulse(uint16_t *number, uint32_t *t_us)
{
    bool taken = false;
    ATOMIC_BLOCK(ATOMIC_RESTORESTATE) {
        if (pulses_waiting) {
            *number = pulses[first_pulse].number;
            *t_us = pulses[first_pulse].t_us;
            first_pulse = (first_pulse + 1) % PULSES_KEPT;
            pulses_waiting--;
            taken = true;
        }
    }
    return taken;
}

bool clock_pulse_waits(void)
{
    return pulses_waiting != 0;
}
