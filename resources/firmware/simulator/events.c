#include "events.h"

#include <poll.h>
#include <simavr/avr_adc.h>
#include <simavr/avr_ioport.h>
#include <simavr/sim_cycle_timers.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define WEAK 0.2
#define DIVIDER 4 /* 300 kΩ over 100 kΩ */

typedef void (*action_t)(spi_bus_t *bus, imu_model_t *imu, int number);

static void unplug(spi_bus_t *bus, imu_model_t *imu, int number)
{
    (void)bus, (void)number;
    imu->present = false;
}

static void plug(spi_bus_t *bus, imu_model_t *imu, int number)
{
    (void)number;
    imu->present = true;
    imu_power_on(imu, bus_time(bus->avr));
}

static void brownout(spi_bus_t *bus, imu_model_t *imu, int number)
{
    (void)bus, (void)number;
    imu_power_on(imu, 0);
}

static void weak_accel(spi_bus_t *bus, imu_model_t *imu, int number)
{
    (void)bus, (void)number;
    imu->weak_accel = WEAK;
}

static void weak_gyro(spi_bus_t *bus, imu_model_t *imu, int number)
{
    (void)bus, (void)number;
    imu->weak_gyro = WEAK;
}

/* `number` is 256 times the IMU's number plus what WHO_AM_I reads. */
static void chip(spi_bus_t *bus, imu_model_t *imu, int number)
{
    imu = &bus->imu[number / 256];
    imu->chip = number % 256;
    imu_power_on(imu, bus_time(bus->avr));
}

/* `number` is 256 times the IMU's number plus how much warmer than 31 °C it is. */
static void warm(spi_bus_t *bus, imu_model_t *imu, int number)
{
    imu = &bus->imu[number / 256];
    imu->warmer = number % 256;
}

static void battery(spi_bus_t *bus, imu_model_t *imu, int number)
{
    (void)imu;
    avr_raise_irq(avr_io_getirq(bus->avr, AVR_IOCTL_ADC_GETIRQ, ADC_IRQ_ADC7), number / DIVIDER);
}

static avr_cycle_count_t rise(avr_t *avr, avr_cycle_count_t when, void *pin)
{
    (void)when;
    printf("pulse %.6f\n", bus_time(avr));
    fflush(stdout);
    avr_raise_irq(pin, 1);
    return 0;
}

/* The synchrony pin, PD2, which is pulled up, is low for `number` microseconds: its end is reported. */
static void pulse(spi_bus_t *bus, imu_model_t *imu, int number)
{
    (void)imu;
    avr_irq_t *pin = avr_io_getirq(bus->avr, AVR_IOCTL_IOPORT_GETIRQ('D'), 2);
    avr_raise_irq(pin, 0);
    avr_cycle_timer_register_usec(bus->avr, number, rise, pin);
}

static void reset(spi_bus_t *bus, imu_model_t *imu, int number)
{
    (void)imu, (void)number;
    avr_reset(bus->avr);
}

static const struct {
    const char *name;
    action_t action;
    int most; /* the largest number it takes */
} commands[] = {
    {"unplug", unplug, BUS_IMUS - 1},
    {"plug", plug, BUS_IMUS - 1},
    {"brownout", brownout, BUS_IMUS - 1},
    {"weak-accel", weak_accel, BUS_IMUS - 1},
    {"weak-gyro", weak_gyro, BUS_IMUS - 1},
    {"chip", chip, 256 * BUS_IMUS - 1},
    {"warm", warm, 256 * BUS_IMUS - 1},
    {"battery", battery, 20000},
    {"pulse", pulse, 1000000},
    {"reset", reset, 0},
};

/* Index of the command in `text` and its number, or -1. */
static int parse(const char *text, int *number)
{
    char name[16] = "";
    *number = 0;
    sscanf(text, "%15s %d", name, number);
    for (unsigned i = 0; i < sizeof commands / sizeof *commands; i++)
        if (!strcmp(name, commands[i].name) && *number >= 0 && *number <= commands[i].most)
            return i;
    return -1;
}

bool events_add(events_t *events, const char *text)
{
    char *rest;
    int number;
    double t = strtod(text, &rest);
    if (rest == text || *rest != ':' || parse(rest + 1, &number) < 0 ||
        events->count == EVENTS_MAX) {
        fprintf(stderr, "%s is not T:COMMAND, or one event too many.\n", text);
        return false;
    }
    events->list[events->count++] = (event_t){t, rest + 1};
    return true;
}

/* False, and nothing done, where the text is no command. */
static bool carry_out(const char *command, spi_bus_t *bus)
{
    int number;
    int which = parse(command, &number);
    if (which < 0)
        return false;
    commands[which].action(bus, &bus->imu[number % BUS_IMUS], number);
    return true;
}

/* Takes what stands on standard input without waiting for more. */
static void obey_input(spi_bus_t *bus)
{
    static char line[64];
    static unsigned length;
    struct pollfd input = {.fd = STDIN_FILENO, .events = POLLIN};
    char c;
    while (poll(&input, 1, 0) == 1 && input.revents & POLLIN && read(STDIN_FILENO, &c, 1) == 1) {
        if (c != '\n') {
            if (length < sizeof line - 1)
                line[length++] = c;
            continue;
        }
        line[length] = 0;
        length = 0;
        if (!carry_out(line, bus))
            fprintf(stderr, "%s is no command.\n", line);
    }
}

void events_poll(events_t *events, spi_bus_t *bus)
{
    for (int i = 0; i < events->count; i++) {
        event_t *event = &events->list[i];
        if (!event->command || bus_time(bus->avr) < event->t)
            continue;
        carry_out(event->command, bus);
        event->command = NULL;
    }
    obey_input(bus);
}
