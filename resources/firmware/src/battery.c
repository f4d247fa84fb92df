#include "battery.h"

#include <avr/io.h>

#include "board.h"

#define LEAST_MV 2500 /* no lithium cell is lower; the divider alone reads about 0 */

void battery_init(void)
{
    ADMUX = _BV(REFS1) | _BV(REFS0) | BATTERY_MUX; /* against 1.1 V */
    ADCSRA = _BV(ADEN) | _BV(ADPS2) | _BV(ADPS1) | _BV(ADPS0) | _BV(ADSC); /* clk/128 */
}

uint16_t battery_mV(void)
{
    uint16_t mV = ADC * BATTERY_FULL_SCALE_MV / 1024;
    ADCSRA |= _BV(ADSC);
    return mV < LEAST_MV ? BATTERY_NONE : mV;
}
