#include "spi_bus.h"

#include <simavr/avr_ioport.h>

/* Registers of the ATmega328P, as data addresses. */
enum { DDRB = 0x24, DDRC = 0x27, SPCR = 0x4C, SPSR = 0x4D, SPDR = 0x4E };

#define SPIF 0x80
#define SPI2X 0x01
#define LAST (BUS_IMUS - 1)

double bus_time(const avr_t *avr)
{
    return (double)avr->cycle / avr->frequency;
}

static unsigned cycles_per_bit(const avr_t *avr)
{
    static const unsigned divider[] = {4, 16, 64, 128};
    unsigned full = divider[avr->data[SPCR] & 3];
    return avr->data[SPSR] & SPI2X ? full / 2 : full;
}

static uint8_t exchange(spi_bus_t *bus)
{
    uint8_t miso = 0xFF;
    double hz = (double)bus->avr->frequency / cycles_per_bit(bus->avr);
    if (bus->selected & (bus->selected - 1))
        bus->conflicts++;
    for (int i = 0; i < BUS_IMUS; i++)
        if (bus->selected & (1u << i))
            miso &= imu_transfer(&bus->imu[i], bus->sent, hz);
    return miso;
}

static avr_cycle_count_t finish(avr_t *avr, avr_cycle_count_t when, void *param)
{
    spi_bus_t *bus = param;
    (void)when;
    bus->received = exchange(bus);
    avr->data[SPSR] |= SPIF;
    return 0;
}

/* simavr 1.6 gives every byte 100 µs whatever the clock, so these two stand in for its own. */
static void on_write(avr_t *avr, avr_io_addr_t address, uint8_t value, void *param)
{
    spi_bus_t *bus = param;
    avr->data[address] = bus->sent = value;
    avr->data[SPSR] &= ~SPIF;
    avr_cycle_timer_register(avr, 8 * cycles_per_bit(avr), finish, bus);
}

static uint8_t on_read(avr_t *avr, avr_io_addr_t address, void *param)
{
    spi_bus_t *bus = param;
    (void)address;
    avr->data[SPSR] &= ~SPIF;
    return bus->received;
}

/* Called when chip i is released: how long a reading of all IMUs takes. */
static void note_round(spi_bus_t *bus, int i)
{
    if (!bus->imu[i].gave_data)
        return;
    if (i == 0)
        bus->first = (avr_cycle_count_t)(bus->imu[0].now * bus->avr->frequency);
    if (i != LAST || !bus->first)
        return;
    if (bus->avr->cycle - bus->first > bus->round_max)
        bus->round_max = bus->avr->cycle - bus->first;
    bus->first = 0;
}

static void on_chip_select(spi_bus_t *bus, int i, uint16_t ddr, int bit, uint32_t level)
{
    int selecting = !level && bus->avr->data[ddr] & (1 << bit);
    int was = (bus->selected >> i) & 1;
    if (selecting == was)
        return;
    bus->selected ^= 1u << i;
    if (selecting)
        imu_select(&bus->imu[i], bus_time(bus->avr));
    else
        note_round(bus, i);
}

static void on_port_c(avr_irq_t *irq, uint32_t level, void *param)
{
    on_chip_select(param, irq->irq, DDRC, irq->irq, level);
}

static void on_port_b(avr_irq_t *irq, uint32_t level, void *param)
{
    on_chip_select(param, LAST, DDRB, irq->irq, level);
}

void bus_attach(spi_bus_t *bus, avr_t *avr, const motion_t *motion)
{
    *bus = (spi_bus_t){.avr = avr, .received = 0xFF};
    for (int i = 0; i < BUS_IMUS; i++)
        imu_init(&bus->imu[i], i, motion);
    for (int bit = 0; bit < LAST; bit++)
        avr_irq_register_notify(avr_io_getirq(avr, AVR_IOCTL_IOPORT_GETIRQ('C'), bit), on_port_c,
                                bus);
    avr_irq_register_notify(avr_io_getirq(avr, AVR_IOCTL_IOPORT_GETIRQ('B'), 2), on_port_b, bus);
    avr->io[AVR_DATA_TO_IO(SPDR)].w.c = on_write;
    avr->io[AVR_DATA_TO_IO(SPDR)].w.param = bus;
    avr->io[AVR_DATA_TO_IO(SPDR)].r.c = on_read;
    avr->io[AVR_DATA_TO_IO(SPDR)].r.param = bus;
}
