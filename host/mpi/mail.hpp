// Messages of bytes over MPI: none blocks, so that a rank may sleep between looks instead of spinning. For one thread.
#pragma once
#include <mpi.h>

#include <deque>
#include <list>
#include <optional>

#include "host/mpi/messages.hpp"

namespace nicol {

struct Letter {
  int from = 0;
  Message what = Message::end;
  Parcel bytes;
};

class Mail {
 public:
  // Kept until it is on its way.
  void send(int to, Message what, Parcel bytes) {
    sent_.push_back({std::move(bytes), {}});
    Outgoing& out = sent_.back();
    if (out.bytes.size() > most_bytes) throw DeviceError("a message between ranks is larger than MPI can count: take fewer pixels at once");
    MPI_Isend(out.bytes.data(), static_cast<int>(out.bytes.size()), MPI_BYTE, to, static_cast<int>(what), MPI_COMM_WORLD, &out.request);
  }

  // The next one, if there is one.
  std::optional<Letter> receive() {
    sent_.remove_if([](Outgoing& out) {
      int done = 0;
      MPI_Test(&out.request, &done, MPI_STATUS_IGNORE);
      return done != 0;
    });
    MPI_Status status;
    int there = 0, size = 0;
    MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &there, &status);
    if (!there) return std::nullopt;
    MPI_Get_count(&status, MPI_BYTE, &size);
    Letter letter{status.MPI_SOURCE, static_cast<Message>(status.MPI_TAG), Parcel(static_cast<std::size_t>(size))};
    MPI_Recv(letter.bytes.data(), size, MPI_BYTE, status.MPI_SOURCE, status.MPI_TAG, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    return letter;
  }

  bool all_sent() const { return sent_.empty(); }

 private:
  static constexpr std::size_t most_bytes = 0x7fffffff;
  struct Outgoing {
    Parcel bytes;
    MPI_Request request;
  };
  std::list<Outgoing> sent_;
};

}  // namespace nicol
