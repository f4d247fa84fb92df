"""What is kept between runs: settings, colours, wearers, images."""
