// Preloaded by process_test.py: the main thread is late for each message, so that signals come before it waits.
#include <ctime>
#include <dlfcn.h>
#include <unistd.h>

extern "C" int zmq_msg_recv(void* message, void* socket, int flags) {
  using Receive = int (*)(void*, void*, int);
  static const auto receive = reinterpret_cast<Receive>(dlsym(dlopen("libzmq.so.5", RTLD_LAZY), "zmq_msg_recv"));
  const timespec delay{0, 300'000'000};
  if (flags == 0 && gettid() == getpid()) nanosleep(&delay, nullptr);
  return receive(message, socket, flags);
}
