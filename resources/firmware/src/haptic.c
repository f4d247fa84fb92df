#include "haptic.h"

#include <avr/interrupt.h>
#include <avr/io.h>
#include <stdbool.h>

#include "board.h"

static bool running[HAPTIC_CHANNELS];
static uint32_t end_us[HAPTIC_CHANNELS];

/* Does nothing but wake the main loop each 1.024 ms while a motor runs. */
EMPTY_INTERRUPT(TIMER2_OVF_vect)

void haptic_init(void)
{
    DDRD |= HAPTIC_OUTPUTS;
    TCCR0A = _BV(WGM01) | _BV(WGM00); /* fast PWM, outputs not yet connected */
    TCCR2A = _BV(WGM21) | _BV(WGM20);
    TCCR0B = _BV(CS01) | _BV(CS00); /* clk/64: 977 Hz, above what a motor follows */
    TCCR2B = _BV(CS22);             /* clk/64 as well; Timer2 counts its prescalers otherwise */
}

/* Amplitude 0 takes the pin off the timer: fast PWM at 0 still gives a short pulse per turn. */
static void drive(uint8_t channel, uint8_t amplitude)
{
    volatile uint8_t *control = channel == 2 ? &TCCR2A : &TCCR0A;
    uint8_t connect = channel == 0 ? _BV(COM0A1) : channel == 1 ? _BV(COM0B1) : _BV(COM2B1);
    volatile uint8_t *duty = channel == 0 ? &OCR0A : channel == 1 ? &OCR0B : &OCR2B;
    *duty = amplitude;
    if (amplitude)
        *control |= connect;
    else
        *control &= ~connect;
}

static void wake_while_running(void)
{
    bool any = false;
    for (uint8_t i = 0; i < HAPTIC_CHANNELS; i++)
        any |= running[i];
    TIMSK2 = any ? _BV(TOIE2) : 0;
}

void haptic_start(uint8_t channel, uint8_t amplitude, uint16_t duration_ms, uint32_t now_us)
{
    if (channel >= HAPTIC_CHANNELS)
        return;
    if (duration_ms == 0)
        amplitude = 0;
    running[channel] = amplitude != 0;
    end_us[channel] = now_us + duration_ms * 1000UL;
    drive(channel, amplitude);
    wake_while_running();
}

void haptic_poll(uint32_t now_us)
{
    for (uint8_t i = 0; i < HAPTIC_CHANNELS; i++)
        if (running[i] && (int32_t)(now_us - end_us[i]) >= 0)
            haptic_start(i, 0, 0, now_us);
}
