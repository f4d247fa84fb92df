#include "motors.h"

#include <stdio.h>

#include "spi_bus.h"

/* Data addresses: pin direction, timer control with the connecting bit, compare value, clock. */
static const struct {
    uint16_t control, compare, clock;
    uint8_t connected, output;
} pins[MOTORS] = {
    {0x44, 0x47, 0x45, 0x80, 0x40}, /* OC0A, PD6 */
    {0x44, 0x48, 0x45, 0x20, 0x20}, /* OC0B, PD5 */
    {0xB0, 0xB4, 0xB1, 0x20, 0x08}, /* OC2B, PD3 */
};

enum { DDRD = 0x2A };

#define FAST_PWM 0x03
#define CLOCK_SELECT 0x07

static uint8_t amplitude_of(const avr_t *avr, int i)
{
    uint8_t control = avr->data[pins[i].control];
    int driven = avr->data[DDRD] & pins[i].output && control & pins[i].connected &&
                 (control & FAST_PWM) == FAST_PWM && avr->data[pins[i].clock] & CLOCK_SELECT;
    return driven ? avr->data[pins[i].compare] : 0;
}

void motors_poll(motors_t *motors, avr_t *avr)
{
    for (int i = 0; i < MOTORS; i++) {
        uint8_t now = amplitude_of(avr, i);
        if (now == motors->amplitude[i])
            continue;
        motors->amplitude[i] = now;
        printf("haptic %d %d %.4f\n", i, now, bus_time(avr));
        fflush(stdout);
    }
}
