// Loaded before a program (LD_PRELOAD): its operator new counts what is alive, and fails when it is
// told to.
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>

namespace {

std::atomic<long> calls{0}, alive{0}, failing{0};

void* allocated(std::size_t size, std::size_t alignment) {
  if (++calls == failing) throw std::bad_alloc();
  const std::size_t whole = (size / alignment + 1) * alignment;
  void* const room = std::aligned_alloc(alignment, whole);
  if (!room) throw std::bad_alloc();
  ++alive;
  return room;
}

void freed(void* room) {
  if (room) --alive;
  std::free(room);
}

constexpr std::size_t usual = alignof(std::max_align_t);

}  // namespace

extern "C" {
// From now on the call number `call` fails, counted from 1; none if it is 0.
void fail_at(long call) {
  calls = 0;
  failing = call;
}
// How many calls there were since.
long count_calls() { return calls; }
// How many are allocated and not freed.
long count_alive() { return alive; }
}

void* operator new(std::size_t size) { return allocated(size, usual); }
void* operator new[](std::size_t size) { return allocated(size, usual); }
void* operator new(std::size_t size, std::align_val_t a) {
  return allocated(size, static_cast<std::size_t>(a));
}
void* operator new[](std::size_t size, std::align_val_t a) {
  return allocated(size, static_cast<std::size_t>(a));
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  try {
    return allocated(size, usual);
  } catch (...) {
    return nullptr;
  }
}
void* operator new[](std::size_t size, const std::nothrow_t& nothrow) noexcept {
  return operator new(size, nothrow);
}
void operator delete(void* room) noexcept { freed(room); }
void operator delete[](void* room) noexcept { freed(room); }
void operator delete(void* room, std::size_t) noexcept { freed(room); }
void operator delete[](void* room, std::size_t) noexcept { freed(room); }
void operator delete(void* room, std::align_val_t) noexcept { freed(room); }
void operator delete[](void* room, std::align_val_t) noexcept { freed(room); }
void operator delete(void* room, std::size_t, std::align_val_t) noexcept { freed(room); }
void operator delete[](void* room, std::size_t, std::align_val_t) noexcept { freed(room); }
void operator delete(void* room, const std::nothrow_t&) noexcept { freed(room); }
void operator delete[](void* room, const std::nothrow_t&) noexcept { freed(room); }
