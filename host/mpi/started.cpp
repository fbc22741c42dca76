#include <cstdlib>

#include "host/mpi/ranks.hpp"

namespace nicol {

int ranks_started() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"})
    if (const char* size = std::getenv(name)) return std::atoi(size);
  return 1;
}

std::string device_of_rank(const std::string& wanted, int on_node) {
  const std::vector<DeviceInfo> devices = choose_devices(wanted);
  return std::to_string(devices[static_cast<std::size_t>(on_node) % devices.size()].index);
}

}  // namespace nicol
