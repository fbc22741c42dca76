// Ranks over MPI.
#include <fmt/format.h>
#include <mpi.h>
#include <sched.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <thread>

#include "host/mpi/ranks.hpp"
#include "host/mpi/remote_executor.hpp"
#include "host/mpi/server.hpp"

namespace nicol {
namespace {

constexpr double default_patience_s = 30;

double patience_s() {
  const char* set = std::getenv("NICOL_RANK_PATIENCE_S");
  const double wanted = set ? std::atof(set) : 0;
  return wanted > 0 ? wanted : default_patience_s;
}

std::string node_name() {
  char name[MPI_MAX_PROCESSOR_NAME];
  int size = 0;
  MPI_Get_processor_name(name, &size);
  return std::string(name, static_cast<std::size_t>(size));
}

class MpiRanks : public Ranks, public ExecutorSource, private Post {
 public:
  explicit MpiRanks(std::string build) : build_(std::move(build)) {
    int provided = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &count_);
    MPI_Comm node;
    MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &node);
    MPI_Comm_rank(node, &on_node_);
    MPI_Comm_size(node, &node_ranks_);
    MPI_Comm_free(&node);
    place_ = fmt::format("rank {} on {}", rank_, node_name());
    if (rank_ > 0) return;
    peers_.resize(static_cast<std::size_t>(count_));
    for (int r = 1; r < count_; ++r) peers_[static_cast<std::size_t>(r)].rank = r;
    for (Peer& peer : peers_) peer.place = fmt::format("rank {}", peer.rank);
  }

  int rank() const override { return rank_; }
  int count() const override { return count_; }
  int on_node() const override { return on_node_; }

  // Open MPI binds up to two ranks to a core each, whatever else there is.
  std::string advice() const override {
    cpu_set_t allowed;
    const long cores = sysconf(_SC_NPROCESSORS_ONLN);
    if (sched_getaffinity(0, sizeof allowed, &allowed) != 0 || CPU_COUNT(&allowed) * static_cast<long>(node_ranks_) >= cores) return "";
    return fmt::format("mpirun binds each of the {} ranks of this machine to {} of its {} cores: mpirun --bind-to none lets them use all",
                       node_ranks_, CPU_COUNT(&allowed), cores);
  }

  ExecutorSource& others(const std::string& device) override {
    device_ = device;
    return *this;
  }

  std::vector<std::unique_ptr<TileExecutor>> executors(const PackedScene& scene, const RenderOptions& options, int lanes) override {
    std::vector<std::unique_ptr<TileExecutor>> made;
    for (Peer& peer : peers_) {
      if (peer.rank == 0 || peer.lost) continue;
      made.push_back(std::make_unique<RemoteExecutor>(static_cast<Post&>(*this), peer, patience_s(),
                                                      job_parcel(peer.epoch + 1, build_, device_, scene, options, lanes)));
    }
    return made;
  }

  // What mpirun sends to all is for rank 0 to heed; the others end when it does.
  int serve() override {
    ::signal(SIGINT, SIG_IGN);
    ::signal(SIGTERM, SIG_IGN);
    const int code = Server(rank_, on_node_, place_, build_).run();
    MPI_Finalize();
    return code;
  }

  // Finalizing waits for all; a rank that does not answer would never come.
  void end(int code) override {
    for (const Peer& peer : peers_)
      if (peer.rank > 0 && !peer.lost) mail_.send(peer.rank, Message::end, {});
    const auto waiting_since = Peer::Clock::now();
    const auto all_gone = [&] {
      return std::all_of(peers_.begin(), peers_.end(), [](const Peer& peer) { return peer.rank == 0 || peer.gone || peer.lost; });
    };
    for (; !all_gone() && Peer::Clock::now() - waiting_since < std::chrono::duration<double>(patience_s()); look())
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    if (std::any_of(peers_.begin(), peers_.end(), [](const Peer& peer) { return peer.rank > 0 && !peer.gone; }))
      MPI_Abort(MPI_COMM_WORLD, code);
    MPI_Finalize();
  }

 private:
  Mail& mail() override { return mail_; }

  void look() override {
    for (auto letter = mail_.receive(); letter; letter = mail_.receive()) take(std::move(*letter));
  }

  void take(Letter letter) {
    Peer& peer = peers_[static_cast<std::size_t>(letter.from)];
    peer.heard = Peer::Clock::now();
    BytesIn in(letter.bytes);
    switch (letter.what) {
      case Message::ready:
        if (in.get<std::int64_t>() != peer.epoch) return;
        in.get_all(peer.place);
        in.get_all(peer.device);
        peer.units_that_fit = in.get<std::int64_t>();
        peer.ready = true;
        return;
      case Message::traced:
        if (in.get<TracedHead>().epoch == peer.epoch) peer.traced.push_back(std::move(letter.bytes));
        return;
      case Message::failed:
        if (in.get<std::int64_t>() != peer.epoch) return;
        peer.shortage = in.get<bool>();
        in.get_all(peer.failure);
        return;
      case Message::bye: peer.gone = true; return;
      default: return;
    }
  }

  const std::string build_;
  std::string place_, device_;
  int rank_ = 0, count_ = 1, on_node_ = 0, node_ranks_ = 1;
  Mail mail_;
  std::vector<Peer> peers_;   // by rank; that of rank 0 stands idle
};

}  // namespace

std::unique_ptr<Ranks> join_ranks(const std::string& build) {
  if (ranks_started() < 2) return nullptr;
  auto ranks = std::make_unique<MpiRanks>(build);
  if (ranks->count() == ranks_started()) return ranks;
  MPI_Finalize();
  throw RanksError(fmt::format("mpirun has started {} ranks, but they are {} to the MPI that nicol is built with, so that each would render the "
                               "whole picture: use the mpirun of that MPI", ranks_started(), ranks->count()));
}

}  // namespace nicol
