// The program: reads the command line and hands over to the verb.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <functional>
#include <new>

#include "host/app/accuracy_command.hpp"
#include "host/app/commands.hpp"
#include "host/app/interrupt.hpp"
#include "host/app/povray_switches.hpp"
#include "host/app/preview_command.hpp"
#include "host/mpi/ranks.hpp"
#include "host/opencl/render.hpp"
#include "sdl/diagnostics.hpp"

namespace {

using namespace nicol::app;

void add_scene_options(CLI::App& verb, SceneOptions& options) {
  verb.add_option("-W,--width", options.width, "Width of the picture in pixels")
      ->check(CLI::Range(1, 65536))
      ->capture_default_str();
  verb.add_option("-H,--height", options.height, "Height of the picture in pixels")
      ->check(CLI::Range(1, 65536))
      ->capture_default_str();
  verb.add_option("-L,--library", options.library_paths,
                  "Folder to look for include files in; may be repeated")
      ->allow_extra_args(false);
  verb.add_option("-D,--declare", options.declares,
                  "name=value: a number declared before the scene is read")
      ->allow_extra_args(false);
  verb.add_option("--wavelengths", options.wavelengths,
                  "from:to:step or a list, in nm, instead of the scene's");
  verb.add_option("--max-trace-level", options.max_trace_level,
                  "Interfaces along a path, instead of the scene's")
      ->check(CLI::Range(1, 4096));
  verb.add_option("--adc-bailout", options.adc_bailout,
                  "Weight at which a path is cut off, instead of the scene's")
      ->check(CLI::Range(0.0, 1.0));
  verb.add_option("--plugin", options.plugins,
                  "Shared object to load: a file, or a name to be looked for (see `nicol plugins`); may be repeated")
      ->allow_extra_args(false);
  verb.add_option("--polarization", options.polarization, "on or off, instead of the scene's")
      ->check(CLI::IsMember({"on", "off"}));
}

void add_device_options(CLI::App& verb, DeviceOptions& options,
                        const std::vector<std::string>& reals) {
  verb.add_option("--device", options.device,
                  "OpenCL device: its number or a part of its name (see `nicol devices`); render takes several with commas, or all");
  verb.add_option("--real", options.real, "Precision of the kernel")
      ->check(CLI::IsMember(reals))
      ->capture_default_str();
  verb.add_option("--lanes", options.lanes,
                  "Lanes of the kernel: 1, 4, 8, 16 (default: what suits the device)")
      ->check(CLI::IsMember({1, 4, 8, 16}));
  verb.add_flag("--generic", options.generic,
                "One kernel for all scenes instead of one for this scene's effects");
  verb.add_flag("--no-cache", options.no_cache, "Build the kernel anew");
}

// "0.1%" or "0.001".
CLI::Option* add_error_option(CLI::App& verb, const std::string& name, std::optional<double>& value,
                              const std::string& meaning) {
  const auto read = [name, &value](const CLI::results_t& given) {
    value = parse_relative_error(given.front());
    return true;
  };
  return verb.add_option(name, read, meaning)->type_name("PERCENT");
}

// Parts of a picture.
void add_part_options(CLI::App& verb, RenderCommand& command) {
  verb.add_option("--part", command.part, "i/n: only this share of the picture's pixels, for `nicol merge` (-o PART.exr)");
  verb.add_option("--wavelength-part", command.wavelength_part,
                  "A..B in nm: only those of the picture's wavelengths, for `nicol merge`; --wavelengths A..B is the same");
  WindowOptions& window = command.window;
  verb.add_option("--start-row", window.start_row, "First row of a window of the picture; up to 1: part of the height (+SR)");
  verb.add_option("--end-row", window.end_row, "Its last row (+ER)");
  verb.add_option("--start-column", window.start_column, "Its first column (+SC)");
  verb.add_option("--end-column", window.end_column, "Its last column (+EC)");
}

void add_animation_options(CLI::App& verb, RenderCommand& command) {
  AnimationOptions& animation = command.animation;
  verb.add_option("--clock", command.options.clock.clock, "The clock of a single picture (+K)");
  verb.add_option("--initial-frame", animation.initial_frame, "Number of an animation's first frame (+KFI)")->capture_default_str();
  verb.add_option("--final-frame", animation.final_frame, "Number of its last frame: makes it an animation (+KFF)");
  verb.add_option("--initial-clock", animation.initial_clock, "The clock of the first frame (+KI)")->capture_default_str();
  verb.add_option("--final-clock", animation.final_clock, "The clock of the last frame (+KF)")->capture_default_str();
  verb.add_flag("--cyclic", animation.cyclic, "The final clock is that of the frame after the last (+KC)");
  verb.add_option("--subset-start", animation.subset_start, "First frame to render (+SF)");
  verb.add_option("--subset-end", animation.subset_end, "Last frame to render (+EF)");
  verb.add_option("--film", animation.film, "Film to be made of the .png frames by ffmpeg");
  verb.add_option("--fps", animation.frames_per_second, "Its frames per second")->check(CLI::Range(0.01, 1000.0))->capture_default_str();
}

using Verb = std::function<int()>;

void add_render(CLI::App& app, RenderCommand& command, Verb& chosen) {
  CLI::App* verb =
      app.add_subcommand("render", "Render a scene to pictures: .exr (spectral Stokes) and .png");
  verb->footer(
      "POV-Ray's switches work too: +Iscene.pov +Oout.png +W640 +H480 +Lfolder Declare=name=value, windows (+SR +ER +SC +EC) and "
      "animations (+KFI +KFF +KI +KF +KC +SF +EF)");
  verb->add_option("scene,-i,--input", command.scene, "The scene")->required();
  verb->add_option("-o,--output", command.outputs,
                   "Picture to write (.exr or .png); may be repeated")
      ->allow_extra_args(false);
  add_scene_options(*verb, command.options);
  verb->add_option("--samples", command.options.samples,
                   "Samples per pixel, instead of the scene's")
      ->check(CLI::Range(1, 65536));
  add_error_option(*verb, "--sample-error", command.options.sample_error,
                   "RMS error of pixel sampling relative to the mean radiance: samples go where they matter");
  add_error_option(*verb, "--error", command.options.error,
                   "RMS error of the picture relative to its mean radiance: the settings that keep it are picked");
  verb->add_flag("--continue", command.resume, "Go on from what an interrupted or killed render has kept (OUTPUT.part)");
  verb->add_option("--keep-after", command.keep_after_s, "Seconds from which on finished tiles are kept for that")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  verb->add_option("--error-map", command.error_map, "Picture (.exr or .png) of what each pixel may be off by");
  verb->add_flag("--no-budget", command.no_budget, "Do not look into the picture's errors afterwards");
  add_device_options(*verb, command.device, {"float", "double"});
  verb->add_flag("--first-rank-idle", command.first_rank_idle, "Under mpirun: rank 0 only deals tiles and gathers them");
  verb->add_flag("-q,--quiet", command.quiet, "Tell only what went wrong");
  add_part_options(*verb, command);
  add_animation_options(*verb, command);
  verb->callback([&] {
    std::string& wavelengths = command.options.wavelengths;
    if (wavelengths.find("..") != std::string::npos && command.wavelength_part.empty()) command.wavelength_part.swap(wavelengths);
    chosen = [&] { return render_command(command); };
  });
}

void add_merge(CLI::App& app, MergeCommand& command, Verb& chosen) {
  CLI::App* verb = app.add_subcommand("merge", "Join parts of a picture, rendered by several runs, to the bits of one run");
  verb->add_option("parts", command.parts, "The parts (.exr)")->required();
  verb->add_option("-o,--output", command.outputs, "Picture to write (.exr or .png); may be repeated")
      ->required()
      ->allow_extra_args(false);
  verb->add_flag("--incomplete", command.incomplete, "Write what there is though parts are missing");
  verb->add_flag("-q,--quiet", command.quiet, "Tell only what went wrong");
  verb->callback([&] { chosen = [&] { return merge_command(command); }; });
}

void add_preview(CLI::App& app, PreviewCommand& command, Verb& chosen) {
  CLI::App* verb = app.add_subcommand("preview", "A window: one scene or two beside each other, live");
  verb->add_option("scene", command.scene, "The scene")->required();
  verb->add_option("second", command.second, "Another one, for the right pane");
  verb->add_option("--right", command.right,
                   "The right pane: the first scene with a change ('Declare=Name=Value', 'without EFFECT', "
                   "'device=NAME', 'real=double', 'error 0.1%', ...); may be repeated")
      ->allow_extra_args(false);
  command.options.width = 640;
  command.options.height = 480;
  add_scene_options(*verb, command.options);
  verb->add_option("--samples", command.options.samples, "Samples per pixel, at least")
      ->check(CLI::Range(1, 65536));
  verb->add_option("--script", command.script, "Commands in place of a person ('-': from standard input); needs no display");
  verb->add_flag("--show", command.show, "Show the window while a script runs, too");
  add_device_options(*verb, command.device, {"float", "double"});
  verb->callback([&command, &chosen, verb] {
    command.size_given = verb->count("--width") + verb->count("--height") > 0;
    chosen = [&command] { return preview_command(command); };
  });
}

void add_accuracy(CLI::App& app, AccuracyCommand& command, Verb& chosen) {
  CLI::App* verb = app.add_subcommand(
      "accuracy", "Measure what accuracy costs in time: table, .csv, and a plot as .png and .svg");
  verb->add_option("scene", command.scene, "The scene")->required();
  verb->add_option("-o,--output", command.output, "Table to write (.csv), the plots beside it");
  add_scene_options(*verb, command.options);
  verb->add_option("--samples", command.options.samples,
                   "Samples per pixel, instead of the scene's")
      ->check(CLI::Range(1, 65536));
  verb->add_option("--knobs", command.knobs, "Turn only these (with commas between)")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::IsMember(accuracy_knobs()));
  verb->add_option("--repeats", command.repeats, "Renderings of each setting")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  verb->add_option("--most-samples", command.most_samples, "Samples per pixel that are tried")
      ->check(CLI::Range(1, 65536))
      ->capture_default_str();
  verb->add_option("--longest", command.longest_seconds,
                   "Seconds: more samples are not tried where they would take longer")
      ->capture_default_str();
  verb->add_option("--reference-error", command.reference_error,
                   "RMS error of the reference's pixel sampling")
      ->type_name("PERCENT")
      ->capture_default_str();
  verb->add_option("--reference-step", command.reference_step_nm,
                   "nm: the reference's step of wavelength, or less")
      ->capture_default_str();
  verb->add_option("--reference-samples", command.reference_samples,
                   "Samples per pixel of the reference, at most")
      ->check(CLI::Range(4, 65536))
      ->capture_default_str();
  add_device_options(*verb, command.device, {"float", "double"});
  verb->add_flag("-q,--quiet", command.quiet, "No progress bar");
  verb->callback([&] { chosen = [&] { return accuracy_command(command); }; });
}

void add_explain(CLI::App& app, ExplainCommand& command, Verb& chosen) {
  CLI::App* verb = app.add_subcommand("explain", "Tell which effects a scene calls for, and why");
  verb->add_option("scene", command.scene, "The scene");
  verb->add_flag("--media", command.media,
                 "A table of the media of a scene or an include file (default: minerals.inc)");
  verb->add_option("--lambda", command.lambda_nm, "Wavelength of that table in nm")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  add_scene_options(*verb, command.options);
  add_device_options(*verb, command.device, {"float", "double"});
  verb->add_flag("--no-build", command.no_build, "Do not build the kernel");
  verb->callback([&] { chosen = [&] { return explain_command(command); }; });
}

void add_check(CLI::App& app, CheckCommand& command, Verb& chosen) {
  CLI::App* verb =
      app.add_subcommand("check", "Read scenes and build their solids: all errors at once");
  verb->add_option("scenes", command.scenes, "The scenes")->required();
  add_scene_options(*verb, command.options);
  verb->callback([&] { chosen = [&] { return check_command(command); }; });
}

void add_expect(CLI::App& app, ExpectCommand& command, Verb& chosen) {
  CLI::App* verb =
      app.add_subcommand("expect", "Hold scenes against the numbers in their `expect { }`");
  verb->add_option("scenes", command.scenes, "The scenes")->required();
  add_scene_options(*verb, command.options);
  command.device.real = "both";
  add_device_options(*verb, command.device, {"float", "double", "both"});
  verb->callback([&] { chosen = [&] { return expect_command(command); }; });
}

void add_device_verbs(CLI::App& app, DeviceOptions& options, Verb& chosen) {
  app.add_subcommand("devices", "The OpenCL devices, and which is used")->callback([&] {
    chosen = devices_command;
  });
  CLI::App* verb = app.add_subcommand(
      "probe", "Solve single faces: JSON from standard input to standard output");
  verb->add_option("--device", options.device, "OpenCL device: its number or a part of its name");
  verb->add_option("--real", options.real, "Precision of the kernel")
      ->check(CLI::IsMember({"float", "double"}))
      ->capture_default_str();
  verb->callback([&] { chosen = [&] { return probe_command(options); }; });
}

void add_plugins(CLI::App& app, SceneOptions& options, Verb& chosen) {
  CLI::App* verb = app.add_subcommand("plugins", "The plugins that are found, and what each takes");
  verb->add_option("--plugin", options.plugins, "A shared object, or a name to be looked for; may be repeated")
      ->allow_extra_args(false);
  verb->add_option("-L,--library", options.library_paths, "Folder to look in, too; may be repeated")->allow_extra_args(false);
  verb->callback([&] { chosen = [&] { return plugins_command(options); }; });
}

// CLI11 only says that a subcommand is required.
void check_verb(CLI::App& app, const std::vector<std::string>& arguments) {
  if (arguments.empty() || arguments.front().rfind('-', 0) == 0) return;
  std::vector<std::string> verbs;
  for (const CLI::App* verb : app.get_subcommands([](CLI::App*) { return true; }))
    verbs.push_back(verb->get_name());
  if (std::find(verbs.begin(), verbs.end(), arguments.front()) != verbs.end()) return;
  const std::string near = nicol::sdl::nearest_word(arguments.front(), verbs);
  throw UsageError(fmt::format("'{}' is no verb of nicol{}; there are {}", arguments.front(),
                               near.empty() ? "" : fmt::format(" (did you mean '{}'?)", near),
                               fmt::join(verbs, ", ")));
}

int run(const std::vector<std::string>& arguments, nicol::Ranks* ranks) {
  CLI::App app{"nicol renders crystals: spectral, polarized, exact at every face.", "nicol"};
  app.set_version_flag("--version", std::string("nicol ") + version());
  app.require_subcommand(1);
  app.failure_message([](const CLI::App*, const CLI::Error& error) {
    return fmt::format("nicol: {}\nTry `nicol --help` or `nicol VERB --help`.\n", error.what());
  });
  RenderCommand render;
  render.ranks = ranks;
  MergeCommand merge;
  PreviewCommand preview;
  AccuracyCommand accuracy;
  ExplainCommand explain;
  CheckCommand check;
  ExpectCommand expect;
  DeviceOptions device;
  SceneOptions plugin_options;
  Verb chosen;
  add_render(app, render, chosen);
  add_merge(app, merge, chosen);
  add_preview(app, preview, chosen);
  add_accuracy(app, accuracy, chosen);
  add_explain(app, explain, chosen);
  add_check(app, check, chosen);
  add_expect(app, expect, chosen);
  add_device_verbs(app, device, chosen);
  add_plugins(app, plugin_options, chosen);
  app.add_subcommand("words", "Every word that a scene may use, as Markdown")->callback([&] {
    chosen = words_command;
  });

  check_verb(app, arguments);
  std::vector<std::string> ignored, translated = arguments;
  if (!arguments.empty() && arguments.front() == "render") {
    translated = translate_povray_switches(arguments, ignored);
    for (const std::string& argument : ignored)
      fmt::print(stderr, "nicol: {} says nothing to nicol; ignored\n", argument);
  }
  render.command_line = merge.command_line = fmt::format("nicol {}", fmt::join(arguments, " "));
  std::reverse(translated.begin(), translated.end());  // CLI11 takes them last first
  try {
    app.parse(translated);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? exit_done : exit_error;
  }
  return chosen();
}

int complain(const char* message) {
  fmt::print(stderr, "nicol: {}\n", message);
  return exit_error;
}

int run_and_complain(const std::vector<std::string>& arguments, nicol::Ranks* ranks) {
  try {
    return run(arguments, ranks);
  } catch (const std::bad_alloc&) {
    return complain("the memory does not suffice; take a smaller picture or fewer wavelengths");
  } catch (const std::exception& error) {
    return complain(error.what());
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (const auto code = nicol::serve_as_builder(argc, argv)) return *code;
  std::unique_ptr<nicol::Ranks> ranks;
  try {
    ranks = nicol::join_ranks(fmt::format("{}; {}", version(), nicol::kernels_hash()));
    if (ranks && ranks->rank() > 0) return ranks->serve();
  } catch (const std::exception& error) {
    return complain(error.what());
  }
  catch_interrupts();
  if (ranks && !ranks->advice().empty()) fmt::print(stderr, "nicol: {}\n", ranks->advice());
  const int code = run_and_complain({argv + 1, argv + argc}, ranks.get());
  if (ranks) ranks->end(code);
  return code;
}
