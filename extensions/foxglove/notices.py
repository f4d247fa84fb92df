"""Texts of the Foxglove server's notices."""

TEXTS = {
    "foxglove.no_channel": "There is no channel {channel}.",
    "foxglove.second": "Subscription {subscription} to channel {channel} is a second one.",
    "foxglove.not_understood": "The message is invalid: {why}.",
    "foxglove.no_operation": 'Glovetrack has no operation "{operation}".',
}
