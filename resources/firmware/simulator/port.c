#include "port.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <simavr/avr_uart.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <termios.h>
#include <unistd.h>

#define PATIENCE_MS 5000

static bool open_terminal(port_t *port)
{
    port->master = posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK);
    if (port->master < 0 || grantpt(port->master) || unlockpt(port->master))
        return false;
    port->name = ptsname(port->master);
    /* Held open, so that the host may close and open it as it likes. */
    port->slave = open(port->name, O_RDWR | O_NOCTTY);
    struct termios raw;
    if (port->slave < 0 || tcgetattr(port->slave, &raw))
        return false;
    cfmakeraw(&raw);
    return tcsetattr(port->slave, TCSANOW, &raw) == 0;
}

static void on_output(avr_irq_t *irq, uint32_t value, void *param)
{
    port_t *port = param;
    uint8_t byte = value;
    struct pollfd room = {.fd = port->master, .events = POLLOUT};
    (void)irq;
    if (port->waits)
        poll(&room, 1, PATIENCE_MS);
    if (write(port->master, &byte, 1) == 1)
        port->sent++;
    else
        port->lost++;
}

static void on_ready(avr_irq_t *irq, uint32_t value, void *param)
{
    (void)irq, (void)value;
    ((port_t *)param)->ready = true;
}

static void on_full(avr_irq_t *irq, uint32_t value, void *param)
{
    (void)irq, (void)value;
    ((port_t *)param)->ready = false;
}

static avr_irq_t *uart_irq(avr_t *avr, int which)
{
    return avr_io_getirq(avr, AVR_IOCTL_UART_GETIRQ('0'), which);
}

bool port_attach(port_t *port, avr_t *avr, bool waits)
{
    *port = (port_t){.avr = avr, .waits = waits};
    if (!open_terminal(port)) {
        fprintf(stderr, "No pseudo-terminal: %s.\n", strerror(errno));
        return false;
    }
    uint32_t flags = 0; /* neither prints on the console nor naps while the chip polls */
    avr_ioctl(avr, AVR_IOCTL_UART_SET_FLAGS('0'), &flags);
    port->input = uart_irq(avr, UART_IRQ_INPUT);
    avr_irq_register_notify(uart_irq(avr, UART_IRQ_OUTPUT), on_output, port);
    avr_irq_register_notify(uart_irq(avr, UART_IRQ_OUT_XON), on_ready, port);
    avr_irq_register_notify(uart_irq(avr, UART_IRQ_OUT_XOFF), on_full, port);
    return true;
}

void port_poll(port_t *port)
{
    uint8_t byte;
    while (port->ready && read(port->master, &byte, 1) == 1)
        avr_raise_irq(port->input, byte);
}
