// Messages of bytes over MPI: none blocks, so that a rank may sleep between looks instead of spinning. For one thread.
#pragma once
#include <mpi.h>

#include <algorithm>
#include <list>
#include <optional>
#include <vector>

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
    if (bytes.size() > most_bytes) throw DeviceError("a message between ranks is larger than MPI can count: take fewer pixels at once");
    sent_.push_back({std::move(bytes), MPI_REQUEST_NULL});
    Outgoing& out = sent_.back();
    MPI_Isend(out.bytes.data(), static_cast<int>(out.bytes.size()), MPI_BYTE, to, static_cast<int>(what), MPI_COMM_WORLD, &out.request);
  }

  // The next one that is there whole, if there is one; those of one rank in their order. A rank that dies in the middle of a letter
  // holds up nothing but its own.
  std::optional<Letter> receive() {
    sent_.remove_if([](Outgoing& out) { return is_done(out.request); });
    begin_to_receive();
    std::vector<int> behind;   // an unfinished one of theirs
    for (auto at = incoming_.begin(); at != incoming_.end(); ++at) {
      const int from = at->letter.from;
      if (std::find(behind.begin(), behind.end(), from) != behind.end()) continue;
      if (!is_done(at->request)) {
        behind.push_back(from);
        continue;
      }
      Letter letter = std::move(at->letter);
      incoming_.erase(at);
      return letter;
    }
    return std::nullopt;
  }

  bool all_sent() const { return sent_.empty(); }

 private:
  static constexpr std::size_t most_bytes = 0x7fffffff;
  struct Outgoing {
    Parcel bytes;
    MPI_Request request;
  };
  struct Incoming {
    Letter letter;
    MPI_Request request;
  };

  static bool is_done(MPI_Request& request) {
    int done = 0;
    MPI_Test(&request, &done, MPI_STATUS_IGNORE);
    return done != 0;
  }

  void begin_to_receive() {
    for (;;) {
      MPI_Status status;
      MPI_Message message;
      int there = 0, size = 0;
      MPI_Improbe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &there, &message, &status);
      if (!there) return;
      MPI_Get_count(&status, MPI_BYTE, &size);
      incoming_.push_back({{status.MPI_SOURCE, static_cast<Message>(status.MPI_TAG), Parcel(static_cast<std::size_t>(size))}, {}});
      Incoming& in = incoming_.back();
      MPI_Imrecv(in.letter.bytes.data(), size, MPI_BYTE, &message, &in.request);
    }
  }

  std::list<Outgoing> sent_;
  std::list<Incoming> incoming_;   // in the order in which they were sent
};

}  // namespace nicol
