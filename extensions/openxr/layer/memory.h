// The shared memory of the running program; the layout is that of ../layout.py, which explains it.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>

namespace glovetrack {

constexpr uint32_t VERSION = 1;
constexpr uint32_t JOINTS = 26;
constexpr uint32_t RING = 32;
constexpr uint32_t READERS = 8;
constexpr uint32_t LAYER_VERSION = 1;

enum class State : uint32_t { Lost = 0, Inferred = 1, Measured = 2 };

struct Joint {
    float position[3];
    float orientation[4];
    float linear[3];
    float angular[3];
    float radius;
    float sd;
    float linear_sd;
    float angular_sd;
    State state;
};

struct Sample {
    std::atomic<uint64_t> sequence;
    int64_t t;
    int64_t written;
    uint32_t active;
    uint32_t tracking;
    uint32_t velocity;
    uint8_t reserved[20];
    Joint joints[JOINTS];
};

struct Hand {
    uint32_t present;
    uint32_t reserved;
    std::atomic<uint64_t> count;
};

struct Header {
    char magic[8];
    uint32_t version;
    uint32_t size;
    uint32_t clock;
    uint32_t process;
    std::atomic<uint32_t> running;
    uint32_t ring;
    int64_t ahead;
    int64_t stale;
    uint32_t space;
    float position[3];
    float orientation[4];
    char program[48];
    Hand hands[2];
};

struct Reader {
    std::atomic<uint32_t> process;
    uint32_t layer;
    std::atomic<int64_t> last;
    std::atomic<uint64_t> readings;
    std::atomic<uint64_t> active;
    char name[64];
    uint8_t reserved[32];
};

struct Layout {
    Header header;
    uint8_t padding[512 - sizeof(Header)];
    Reader readers[READERS];
    uint8_t more[4096 - 512 - READERS * sizeof(Reader)];
    Sample rings[2][RING];
};

static_assert(sizeof(Joint) == 72 && sizeof(Sample) == 1928 && sizeof(Header) == 160);
static_assert(sizeof(Reader) == 128 && sizeof(Layout) == 4096 + 2 * RING * sizeof(Sample));
static_assert(std::atomic<uint64_t>::is_always_lock_free);

struct Placement {
    uint32_t space;
    float position[3];
    float orientation[4];
    bool operator==(const Placement& other) const;
};

// A sample without its sequence number, and whether it is the newest one.
struct Pose {
    int64_t t;
    bool active;
    Joint joints[JOINTS];
};

// What a hand is at an instant: the sample at or before it, and the one after it if there is one.
struct Moment {
    Placement placement;
    int64_t ahead;
    Pose before;
    std::optional<Pose> after;
};

// The memory of this user's program. It is opened when there is one, and again when another program
// has been started. One for each process; calls may come from several threads.
class Memory {
  public:
    static Memory& get();

    // The hand (0 left, 1 right) at the instant `t` of `now()`'s clock, or the newest without `t`.
    // Nothing if no program sends this hand now.
    std::optional<Moment> hand(uint32_t hand, std::optional<int64_t> t);

    // Leave a sign that this process has read a hand, which was active or not.
    void sign(bool active);

    // Name of the application for its sign.
    void set_name(const char* name);

    static int64_t now();  // ns of the clock whose stamps the memory has

  private:
    bool look(int64_t now);
    bool is_fresh(uint32_t hand, int64_t now) const;
    void reopen();
    void close();
    Reader* entry(int64_t now);
    bool copy(uint32_t hand, uint64_t number, Pose& pose) const;

    std::mutex mutex_;
    std::string name_;
    Layout* layout_ = nullptr;
    uint64_t identity_ = 0;
    int64_t looked_ = 0;
    Reader* entry_ = nullptr;
    void* handle_ = nullptr;
};

}  // namespace glovetrack
