#include "clock.h"

#include <avr/interrupt.h>
#include <avr/io.h>
#include <util/atomic.h>

#define COUNTS_PER_US 2 /* 16 MHz / 8 */

static volatile uint32_t tick_us; /* the last sampling instant */
static volatile uint16_t period_us;
static volatile uint8_t ticks; /* not yet taken */

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
