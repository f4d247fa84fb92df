// SPDX-License-Identifier: Apache-2.0
#include "memory.h"

#include <cstdlib>
#include <cstring>

#ifdef _WIN32
#define WIN32_LEAN_AND_MEAN
#include <windows.h>
#else
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>
#endif

namespace glovetrack {
namespace {

constexpr char MAGIC[8] = {'G', 'L', 'V', 'T', 'R', 'K', 'X', 'R'};
constexpr int64_t LOOK_AGAIN = 50'000'000;         // ns
constexpr int64_t ABANDONED = 10'000'000'000;      // ns without a sign
constexpr const char* ELSEWHERE = "GLOVETRACK_OPENXR_MEMORY";

#ifdef _WIN32

uint32_t this_process() { return GetCurrentProcessId(); }

std::string memory_name() {
    const char* given = std::getenv(ELSEWHERE);
    return given && *given ? given : "Local\\glovetrack-openxr-" + std::to_string(VERSION);
}

Layout* map(uint64_t& identity, void*& handle) {
    HANDLE mapping = OpenFileMappingA(FILE_MAP_ALL_ACCESS, FALSE, memory_name().c_str());
    if (!mapping) return nullptr;
    void* found = MapViewOfFile(mapping, FILE_MAP_ALL_ACCESS, 0, 0, sizeof(Layout));
    if (!found) {
        CloseHandle(mapping);
        return nullptr;
    }
    handle = mapping;
    identity = 1;
    return static_cast<Layout*>(found);
}

void unmap(Layout* layout, void* handle) {
    UnmapViewOfFile(layout);
    CloseHandle(handle);
}

#else

uint32_t this_process() { return static_cast<uint32_t>(getpid()); }

std::string memory_name() {
    const char* given = std::getenv(ELSEWHERE);
    if (given && *given) return given;
    return "/dev/shm/glovetrack-openxr-" + std::to_string(VERSION) + "-" + std::to_string(getuid());
}

// A memory of this user that is not the one of `identity`, which is set to the new one.
Layout* map(uint64_t& identity, void*&) {
    int file = open(memory_name().c_str(), O_RDWR | O_NOFOLLOW | O_CLOEXEC);
    if (file < 0) return nullptr;
    struct stat found;
    void* mapped = MAP_FAILED;
    if (fstat(file, &found) == 0 && found.st_uid == getuid() && found.st_ino != identity &&
        found.st_size == static_cast<off_t>(sizeof(Layout))) {
        mapped = mmap(nullptr, sizeof(Layout), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
        if (mapped != MAP_FAILED) identity = found.st_ino;
    }
    ::close(file);
    return mapped == MAP_FAILED ? nullptr : static_cast<Layout*>(mapped);
}

void unmap(Layout* layout, void*) { munmap(layout, sizeof(Layout)); }

#endif

}  // namespace

bool Placement::operator==(const Placement& other) const {
    return space == other.space && !std::memcmp(position, other.position, sizeof position) &&
           !std::memcmp(orientation, other.orientation, sizeof orientation);
}

Memory& Memory::get() {
    static Memory* memory = new Memory;  // stays until the process ends: threads may still read it
    return *memory;
}

int64_t Memory::now() {
#ifdef _WIN32
    LARGE_INTEGER count, frequency;
    QueryPerformanceCounter(&count);
    QueryPerformanceFrequency(&frequency);
    const int64_t s = count.QuadPart / frequency.QuadPart;
    return s * 1'000'000'000 +
           (count.QuadPart % frequency.QuadPart) * 1'000'000'000 / frequency.QuadPart;
#else
    timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return int64_t{t.tv_sec} * 1'000'000'000 + t.tv_nsec;
#endif
}

std::optional<Moment> Memory::hand(uint32_t hand, std::optional<int64_t> t) {
    std::lock_guard<std::mutex> lock(mutex_);
    const int64_t at = now();
    if (!look(at) || !is_fresh(hand, at)) return std::nullopt;
    const Header& header = layout_->header;
    Moment out;
    out.placement.space = header.space;
    std::memcpy(out.placement.position, header.position, sizeof header.position);
    std::memcpy(out.placement.orientation, header.orientation, sizeof header.orientation);
    out.ahead = header.ahead;
    for (int again = 0; again < 3; ++again) {  // the newest is overwritten after 0.3 s at the soonest
        const uint64_t newest = header.hands[hand].count.load(std::memory_order_acquire);
        if (!copy(hand, newest, out.before)) continue;
        out.after.reset();
        for (uint64_t n = newest; t && out.before.t > *t && --n && n + RING > newest + 2;) {
            out.after = out.before;
            if (!copy(hand, n, out.before)) return std::nullopt;
        }
        return out;
    }
    return std::nullopt;
}

void Memory::sign(bool active) {
    std::lock_guard<std::mutex> lock(mutex_);
    const int64_t at = now();
    Reader* mine = layout_ ? entry(at) : nullptr;
    if (!mine) return;
    mine->last.store(at, std::memory_order_relaxed);
    mine->readings.fetch_add(1, std::memory_order_relaxed);
    if (active) mine->active.fetch_add(1, std::memory_order_relaxed);
}

void Memory::set_name(const char* name) {
    std::lock_guard<std::mutex> lock(mutex_);
    name_ = name;
    name_.resize(std::min(name_.size(), sizeof(Reader::name) - 1));
}

// Whether there is a memory whose program is running; looks for another one where there is none.
bool Memory::look(int64_t now) {
    const bool runs = layout_ && layout_->header.running.load(std::memory_order_acquire) &&
                      (is_fresh(0, now) || is_fresh(1, now));
    if (!runs && now - looked_ >= LOOK_AGAIN) {
        looked_ = now;
        reopen();
    }
    return layout_ && !std::memcmp(layout_->header.magic, MAGIC, sizeof MAGIC) &&
           layout_->header.version == VERSION && layout_->header.size == sizeof(Layout) &&
           layout_->header.running.load(std::memory_order_acquire);
}

bool Memory::is_fresh(uint32_t hand, int64_t now) const {
    const Hand& counted = layout_->header.hands[hand];
    const uint64_t n = counted.count.load(std::memory_order_acquire);
    if (!counted.present || !n) return false;
    return now - layout_->rings[hand][(n - 1) % RING].written < layout_->header.stale;
}

void Memory::reopen() {
    uint64_t identity = layout_ ? identity_ : 0;
    void* handle = nullptr;
#ifdef _WIN32
    close();  // the name lasts while somebody has it open
#endif
    Layout* found = map(identity, handle);
    if (!found) return;
    close();
    layout_ = found;
    identity_ = identity;
    handle_ = handle;
}

void Memory::close() {
    if (layout_) unmap(layout_, handle_);
    layout_ = nullptr;
    entry_ = nullptr;
}

// This process's entry among the readers; null if all are taken.
Reader* Memory::entry(int64_t now) {
    const uint32_t own = this_process();
    if (entry_ && entry_->process.load(std::memory_order_relaxed) == own) return entry_;
    for (Reader& reader : layout_->readers) {
        uint32_t owner = reader.process.load(std::memory_order_acquire);
        const bool abandoned = now - reader.last.load(std::memory_order_relaxed) > ABANDONED;
        if (owner && owner != own && !abandoned) continue;
        if (!reader.process.compare_exchange_strong(owner, own)) continue;
        reader.layer = LAYER_VERSION;
        reader.readings.store(0, std::memory_order_relaxed);
        reader.active.store(0, std::memory_order_relaxed);
        std::memset(reader.name, 0, sizeof reader.name);
        std::memcpy(reader.name, name_.data(), name_.size());
        return entry_ = &reader;
    }
    return entry_ = nullptr;
}

// False if the sample is not there or was written meanwhile.
bool Memory::copy(uint32_t hand, uint64_t number, Pose& pose) const {
    if (!number) return false;
    const Sample& sample = layout_->rings[hand][(number - 1) % RING];
    if (sample.sequence.load(std::memory_order_acquire) != number) return false;
    pose.t = sample.t;
    pose.active = sample.active != 0;
    std::memcpy(pose.joints, sample.joints, sizeof pose.joints);
    std::atomic_thread_fence(std::memory_order_acquire);
    return sample.sequence.load(std::memory_order_relaxed) == number;
}

}  // namespace glovetrack
