/* Glovetrack's glove: seven MPU-9250 sampled by Timer1 and sent to the host. */
#include <avr/interrupt.h>
#include <avr/pgmspace.h>
#include <avr/sleep.h>
#include <avr/wdt.h>

#include "battery.h"
#include "board.h"
#include "clock.h"
#include "haptic.h"
#include "imus.h"
#include "link.h"
#include "selftest.h"
#include "spi.h"
#include "uart.h"

#define START_RATE_HZ 100
#define SECOND_US 1000000UL

static imu_reading_t readings[IMU_COUNT];

/* The watchdog stays armed over the reset that it causes, at its shortest time. */
void __attribute__((naked, used, section(".init3"))) disarm_watchdog(void)
{
    MCUSR = 0;
    wdt_disable();
}

static void report_selftest(const uint8_t failed[], uint16_t unknown)
{
    uint16_t accel = 0, gyro = 0;
    uint16_t absent = ~imus_ok() & ~unknown & (_BV(IMU_COUNT) - 1);
    for (uint8_t i = 0; i < IMU_COUNT; i++) {
        accel |= failed[i] & SELFTEST_ACCEL ? _BV(i) : 0;
        gyro |= failed[i] & SELFTEST_GYRO ? _BV(i) : 0;
    }
    if (absent)
        link_send_error(PSTR("no answer from IMU"), absent);
    if (unknown)
        link_send_error(PSTR("unknown chip, not used: IMU"), unknown);
    if (accel)
        link_send_error(PSTR("accelerometer self-test failed on IMU"), accel);
    if (gyro)
        link_send_error(PSTR("gyroscope self-test failed on IMU"), gyro);
}

/* The host learns that an IMU is gone before it gets a packet without it. */
static void sample(uint32_t t_us, uint8_t skipped)
{
    uint16_t lost = imus_read(readings);
    if (lost) {
        link_send_status();
        link_send_error(PSTR("no answer from IMU"), lost);
    }
    link_send_samples(t_us, skipped, readings);
}

/* Pulses that came while nobody listened are of no use later. */
static void tell_pulses(void)
{
    uint16_t number;
    uint32_t t_us;
    while (clock_take_pulse(&number, &t_us))
        if (link_is_streaming())
            link_send_pulse(number, t_us);
}

static void each_second(uint32_t now_us)
{
    static uint32_t last_us;
    if (now_us - last_us < SECOND_US)
        return;
    last_us = now_us;
    imus_revive();
    if (link_is_streaming()) {
        link_send_status();
        link_send_temperatures();
    } else
        link_send_hello();
}

static void sleep_until_interrupt(void)
{
    cli(); /* so that nothing comes between the question and the sleep */
    if (!clock_tick_waits() && !clock_pulse_waits() && !uart_has_input()) {
        sleep_enable();
        sei();
        sleep_cpu();
        sleep_disable();
    }
    sei();
}

static void start(void)
{
    uint8_t failed[IMU_COUNT];
    uint16_t unknown;
    wdt_enable(WDTO_1S);
    uart_init();
    spi_init();
    haptic_init();
    battery_init();
    clock_init(START_RATE_HZ);
    set_sleep_mode(SLEEP_MODE_IDLE);
    sei();
    imus_start();
    selftest_run(failed);
    unknown = imus_judge(failed);
    imus_read(readings); /* for the temperature in the first STATUS */
    uart_put(0); /* ends a frame that a reset has cut off, so that the HELLO is not lost with it */
    link_send_hello();
    report_selftest(failed, unknown);
}

int main(void)
{
    start();
    for (;;) {
        uint32_t t_us;
        uint8_t skipped;
        wdt_reset();
        link_obey();
        if (clock_take_tick(&t_us, &skipped)) {
            if (link_is_streaming())
                sample(t_us, skipped);
            each_second(clock_us());
        }
        tell_pulses();
        haptic_poll(clock_us());
        sleep_until_interrupt();
    }
}
