// Solves face problems on the device and tells the answers in the oracle's words.
#include "host/opencl/probe.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "host/opencl/device_impl.hpp"
#include "host/opencl/errors.hpp"
#include "host/opencl/probe_problem.hpp"
#include "host/opencl/program.hpp"
#include "host/opencl/scalar_buffer.hpp"
#include "kernels/probe_abi.h"

namespace nicol {
namespace {

using nlohmann::json;

constexpr std::size_t problems_per_launch = 16384;

void launch(cl::CommandQueue& queue, cl::Kernel& kernel, int local_size, const cl::Buffer& problems,
            const cl::Buffer& answers, std::size_t count) {
  kernel.setArg(0, problems);
  kernel.setArg(1, answers);
  kernel.setArg(2, static_cast<cl_int>(count));
  const std::size_t local = static_cast<std::size_t>(local_size);
  const std::size_t groups = std::max<std::size_t>(1, (count + local - 1) / local);
  queue.enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(groups * local), cl::NDRange(local));
  queue.finish();
}

std::shared_ptr<const Kernel> probe_kernel(Device& device, bool real_double) {
  KernelRequest request;
  request.file = "probe.cl";
  request.name = "probe";
  request.real_double = real_double;
  request.warm_up = [&device](cl::CommandQueue& queue, cl::Kernel& kernel, int local_size) {
    const cl::Buffer empty(device.context, CL_MEM_READ_WRITE, 4096);
    launch(queue, kernel, local_size, empty, empty, 0);
  };
  return get_kernel(device, request);
}

template <class Real>
std::vector<double> read_back(cl::CommandQueue& queue, const cl::Buffer& buffer, std::size_t count) {
  std::vector<Real> values(count);
  queue.enqueueReadBuffer(buffer, CL_TRUE, 0, count * sizeof(Real), values.data());
  return {values.begin(), values.end()};
}

// ANSWER_SCALARS per problem.
std::vector<double> solve(Device& device, const Kernel& built, const std::vector<double>& problems, bool real_double) {
  const std::lock_guard<std::mutex> one_at_a_time(device.launches);
  const std::size_t values = problems.size() / PROBE_SCALARS * ANSWER_SCALARS;
  const cl::Buffer in = scalar_buffer(device.context, problems, real_double);
  const cl::Buffer out(device.context, CL_MEM_WRITE_ONLY, values * (real_double ? sizeof(double) : sizeof(float)));
  launch(device.queues[0], built.kernel, built.local_size, in, out, problems.size() / PROBE_SCALARS);
  return real_double ? read_back<double>(device.queues[0], out, values)
                     : read_back<float>(device.queues[0], out, values);
}

json complex_vector(const double* v) { return {{v[0], v[1]}, {v[2], v[3]}, {v[4], v[5]}}; }

// Direction of Re(E x H*); that of the wave normal where the wave carries nothing. Null for evanescent waves.
json ray_of(const double* wave, const json& normal) {
  const double* e = wave + ANSWER_WAVE_E;
  const double* h = wave + ANSWER_WAVE_H;
  const auto term = [&](int i, int j) { return e[2 * i] * h[2 * j] + e[2 * i + 1] * h[2 * j + 1]; };
  const double x = term(1, 2) - term(2, 1), y = term(2, 0) - term(0, 2), z = term(0, 1) - term(1, 0);
  const double length = std::hypot(x, y, z);
  return length > 1e-30 ? json{x / length, y / length, z / length} : normal;
}

json wave_answer(const double* wave, int index, const ProbeProblem& problem) {
  const double* k = wave + ANSWER_WAVE_K;
  const double n_phase = std::hypot(k[0], k[2], k[4]);
  const bool complex_q = problem.absorbs[0], absorbs = problem.absorbs[index / 2];
  const char* type = complex_q || absorbs                 ? "attenuated"
                     : wave[ANSWER_WAVE_P + 1] != 0 ? "evanescent"
                                                          : "propagating";
  const bool runs = type[0] != 'e';
  const json normal = {k[0] / n_phase, k[2] / n_phase, k[4] / n_phase};
  return {{"side", index < 2 ? "r" : "t"},
          {"type", type},
          {"p", {wave[ANSWER_WAVE_P], wave[ANSWER_WAVE_P + 1]}},
          {"k", complex_vector(k)},
          {"n_phase", n_phase},
          {"s", runs ? normal : json()},
          {"ray", runs ? ray_of(wave, normal) : json()},
          {"E", complex_vector(wave + ANSWER_WAVE_E)},
          {"H", complex_vector(wave + ANSWER_WAVE_H)},
          {"power", wave[ANSWER_WAVE_POWER]}};
}

json answer_of(const ProbeProblem& problem, const double* answer) {
  json waves = json::array();
  double sum_powers = 0;
  for (int i = 0; i < 4; ++i) {
    waves.push_back(wave_answer(answer + i * ANSWER_WAVE_SCALARS, i, problem));
    sum_powers += answer[i * ANSWER_WAVE_SCALARS + ANSWER_WAVE_POWER];
  }
  return {{"id", problem.id},
          {"waves", waves},
          {"totals",
           {{"R", answer[ANSWER_R]},
            {"T", answer[ANSWER_T]},
            {"sum_powers", sum_powers},
            {"E_r", complex_vector(answer + ANSWER_E_R)},
            {"E_t", complex_vector(answer + ANSWER_E_T)}}}};
}

json parse(const std::string& text) {
  json input;
  try {
    input = json::parse(text);
  } catch (const json::exception& error) {
    throw std::runtime_error(std::string("the input is not JSON: ") + error.what());
  }
  if (!input.is_object() || !input.contains("interface") || !input["interface"].is_array())
    throw std::runtime_error("member 'interface' is missing: expected an object with an array of face problems");
  return input;
}

// What is no face problem is named, not passed over.
json not_faces(const json& cases, const char* kind) {
  json answers = json::array();
  if (!cases.is_array()) return answers;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const auto id = cases[i].is_object() ? cases[i].find("id") : cases[i].end();
    if (!cases[i].is_object() || id == cases[i].end() || !id->is_string())
      throw std::runtime_error(fmt::format("{}[{}]: member 'id' is missing", kind, i));
    answers.push_back({{"id", *id}, {"unsupported", "probe answers faces (interface) only"}});
  }
  return answers;
}

json solve_faces(Device& device, const json& faces, bool real_double) {
  std::vector<ProbeProblem> problems;
  for (std::size_t i = 0; i < faces.size(); ++i) problems.push_back(read_problem(faces[i], i));
  const auto kernel = probe_kernel(device, real_double);
  keep(*kernel);
  json answers = json::array();
  for (std::size_t begin = 0; begin < problems.size(); begin += problems_per_launch) {
    const std::size_t end = std::min(problems.size(), begin + problems_per_launch);
    std::vector<double> scalars;
    for (std::size_t i = begin; i < end; ++i)
      scalars.insert(scalars.end(), problems[i].scalars.begin(), problems[i].scalars.end());
    const std::vector<double> solved =
        scalars.empty() ? scalars : solve(device, *kernel, scalars, real_double);
    const double* next = solved.data();
    for (std::size_t i = begin; i < end; ++i) {
      if (!problems[i].unsupported.empty()) {
        answers.push_back({{"id", problems[i].id}, {"unsupported", problems[i].unsupported}});
        continue;
      }
      answers.push_back(answer_of(problems[i], next));
      next += ANSWER_SCALARS;
    }
  }
  return answers;
}

}  // namespace

std::string probe(Device& device, const std::string& text, bool real_double) {
  const json input = parse(text);
  json output;
  output["device"] = device.about.name;
  output["real"] = real_double ? "double" : "float";
  try {
    output["interface"] = solve_faces(device, input["interface"], real_double);
  } catch (const cl::Error& error) {
    throw DeviceError(error_message(error, device.about.name));
  }
  for (const char* kind : {"bulk", "propagation"})
    if (input.contains(kind)) output[kind] = not_faces(input[kind], kind);
  return output.dump(1, ' ');   // doubles as the shortest text that reads back to the same bits
}

}  // namespace nicol
