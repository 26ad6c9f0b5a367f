// The commands of `lacquer`. Each function adds one to the command line: its options, its help text
// and what runs when it is chosen. What runs prints data to stdout, and throws Error or UsageError.
#pragma once

namespace CLI {
class App;
}

namespace lacquer {

void add_albedo_command(CLI::App& app);
void add_bake_command(CLI::App& app);
void add_bench_command(CLI::App& app);
void add_compare_command(CLI::App& app);
void add_doctor_command(CLI::App& app);
void add_eval_command(CLI::App& app);
void add_export_command(CLI::App& app);
void add_heightfield_command(CLI::App& app);
void add_interface_command(CLI::App& app);
void add_slice_command(CLI::App& app);
void add_sphere_command(CLI::App& app);
void add_view_command(CLI::App& app);

}  // namespace lacquer
