#include "spi.h"

#include <avr/io.h>

#include "board.h"

#define MODE (_BV(SPE) | _BV(MSTR) | _BV(CPOL) | _BV(CPHA))

void spi_init(void)
{
    spi_release(); /* high before they become outputs, so that no chip sees a false start */
    DDRC |= SELECT_C_MASK;
    DDRB |= SELECT_B_MASK | SPI_OUTPUTS;
    PORTB |= _BV(PB4); /* without a chip MISO reads ones */
    spi_slow();
}

void spi_slow(void)
{
    SPCR = MODE | _BV(SPR0); /* clk/16 */
}

void spi_fast(void)
{
    SPCR = MODE; /* clk/4 */
}

void spi_select(uint8_t imu)
{
    if (imu < 6)
        PORTC &= ~_BV(imu);
    else
        PORTB &= ~SELECT_B_MASK;
}

void spi_release(void)
{
    PORTC |= SELECT_C_MASK;
    PORTB |= SELECT_B_MASK;
}

uint8_t spi_transfer(uint8_t byte)
{
    SPDR = byte;
    loop_until_bit_is_set(SPSR, SPIF);
    return SPDR;
}
