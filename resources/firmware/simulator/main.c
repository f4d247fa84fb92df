/* Runs the glove's firmware on a simulated ATmega328P with seven simulated IMUs. */
#include <getopt.h>
#include <signal.h>
#include <simavr/sim_elf.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include <unistd.h>

#include "events.h"
#include "motors.h"
#include "port.h"
#include "spi_bus.h"

#define STEP_S 0.0005 /* of simulated time between looks at the world outside */

static const char usage[] =
    "Usage: simulate_glove FIRMWARE.elf [options]\n"
    "  --motion FILE   what the IMUs feel: rows of t and 7 times ax ay az gx gy gz (SI)\n"
    "  --at T:COMMAND  unplug, plug, brownout, weak-accel, weak-gyro IMU, chip or warm\n"
    "                  256*IMU+VALUE, battery MV, pulse US,\n"
    "                  reset;\n"
    "                  the same commands are taken, one a line, from standard input\n"
    "  --for SECONDS   of simulated time; otherwise until it is stopped\n"
    "  --fast          as fast as the machine can, waiting for the host; otherwise in real time\n"
    "Prints the port to open, then what the motors do, then one line of JSON.\n";

typedef struct {
    const char *firmware, *motion;
    double seconds;
    bool fast;
    events_t events;
} options_t;

static volatile sig_atomic_t stop;
static avr_cycle_count_t asleep;

static void on_signal(int number)
{
    (void)number;
    stop = 1;
}

static bool parse_options(options_t *options, int argc, char **argv)
{
    static const struct option names[] = {{"motion", 1, 0, 'm'}, {"at", 1, 0, 'a'},
                                          {"for", 1, 0, 'f'},    {"fast", 0, 0, 'x'},
                                          {0, 0, 0, 0}};
    *options = (options_t){.seconds = -1};
    for (int c; (c = getopt_long(argc, argv, "", names, NULL)) >= 0;) {
        if (c == 'm')
            options->motion = optarg;
        else if (c == 'f')
            options->seconds = atof(optarg);
        else if (c == 'x')
            options->fast = true;
        else if (c != 'a' || !events_add(&options->events, optarg))
            return false;
    }
    options->firmware = argv[optind];
    return optind == argc - 1;
}

/* simavr calls it instead of sleeping: time is paced elsewhere. */
static void on_sleep(avr_t *avr, avr_cycle_count_t cycles)
{
    (void)avr, (void)cycles;
}

/* simavr's own chatter would go to standard output, among the lines meant for the caller. */
static void log_errors(avr_t *avr, const int level, const char *format, va_list arguments)
{
    (void)avr;
    if (level <= LOG_ERROR)
        vfprintf(stderr, format, arguments);
}

static avr_t *load(const char *path)
{
    elf_firmware_t firmware = {0};
    avr_global_logger_set(log_errors);
    if (elf_read_firmware(path, &firmware)) {
        fprintf(stderr, "%s cannot be read.\n", path);
        return NULL;
    }
    avr_t *avr = avr_make_mcu_by_name("atmega328p");
    avr_init(avr);
    avr->frequency = 16000000;
    avr_load_firmware(avr, &firmware);
    avr->sleep = on_sleep;
    avr->avcc = avr->vcc = avr->aref = 5000; /* mV */
    return avr;
}

static double wall_s(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return now.tv_sec + now.tv_nsec * 1e-9;
}

/* Sleeps until the wall clock has caught up with the simulated one. */
static void pace(const avr_t *avr, double started)
{
    double ahead = bus_time(avr) - (wall_s() - started);
    if (ahead > 0.001)
        usleep(ahead * 1e6);
}

static bool run_step(avr_t *avr)
{
    avr_cycle_count_t end = avr->cycle + avr->frequency * STEP_S;
    while (avr->cycle < end) {
        avr_cycle_count_t before = avr->cycle;
        int slept = avr->state == cpu_Sleeping;
        int state = avr_run(avr);
        if (slept)
            asleep += avr->cycle - before;
        if (state == cpu_Done || state == cpu_Crashed)
            return false;
    }
    return true;
}

static void report(const avr_t *avr, const spi_bus_t *bus, const port_t *port, bool alive)
{
    unsigned violations = bus->conflicts;
    for (int i = 0; i < BUS_IMUS; i++)
        violations += bus->imu[i].violations;
    printf("{\"alive\": %s, \"simulated_s\": %.4f, \"awake\": %.4f, \"round_us\": %.1f, "
           "\"violations\": %u, \"bytes_sent\": %lu, \"bytes_lost\": %lu}\n",
           alive ? "true" : "false", bus_time(avr), 1 - (double)asleep / avr->cycle,
           bus->round_max * 1e6 / avr->frequency, violations, port->sent, port->lost);
}

static bool run(options_t *options, avr_t *avr, spi_bus_t *bus, port_t *port)
{
    motors_t motors = {0};
    double started = wall_s();
    bool alive = true;
    while (alive && !stop && (options->seconds < 0 || bus_time(avr) < options->seconds)) {
        events_poll(&options->events, bus);
        port_poll(port);
        alive = run_step(avr);
        motors_poll(&motors, avr);
        if (!options->fast)
            pace(avr, started);
    }
    return alive;
}

int main(int argc, char **argv)
{
    options_t options;
    if (!parse_options(&options, argc, argv)) {
        fputs(usage, stderr);
        return 2;
    }
    motion_t *motion = options.motion ? motion_read(options.motion, BUS_IMUS) : NULL;
    avr_t *avr = load(options.firmware);
    spi_bus_t bus;
    port_t port;
    if (!avr || (options.motion && !motion) || !port_attach(&port, avr, options.fast))
        return 1;
    bus_attach(&bus, avr, motion);
    signal(SIGTERM, on_signal);
    signal(SIGINT, on_signal);
    printf("port %s\n", port.name);
    fflush(stdout);
    bool alive = run(&options, avr, &bus, &port);
    report(avr, &bus, &port, alive);
    return alive ? 0 : 1;
}
