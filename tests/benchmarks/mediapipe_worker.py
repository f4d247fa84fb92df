"""MediaPipe Hands on stereo images, run by `bench_mediapipe` with an interpreter of its own.

Not a module of the engine: mediapipe 0.10.21 wants numpy 1, so nothing of ours is imported here.
The argument is a file of images (n, 2, h, w, 3) uint8 BGR. For each line on standard input all
pairs are searched, each camera by its own Hands, and one line of JSON is written: processor seconds
a pair and in how many images a hand was found.
"""

import json
import sys
import time

import mediapipe
import numpy as np


def main() -> None:
    pairs = np.load(sys.argv[1])[..., ::-1].copy()  # RGB
    hands = [mediapipe.solutions.hands.Hands(max_num_hands=1, model_complexity=0) for _ in range(2)]
    print("ready", flush=True)
    for _ in sys.stdin:
        start, found = time.process_time(), 0
        for pair in pairs:
            for search, image in zip(hands, pair, strict=True):
                found += search.process(image).multi_hand_landmarks is not None
        seconds = (time.process_time() - start) / len(pairs)
        print(json.dumps({"pair_s": seconds, "found": found, "of": 2 * len(pairs)}), flush=True)


if __name__ == "__main__":
    main()
