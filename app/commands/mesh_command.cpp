#include "app/commands/mesh_command.h"

#include <fmt/format.h>

#include <utility>

#include "app/assembly/mesh_io.h"
#include "app/assembly/mesh_mending.h"
#include "app/assembly/mesh_writer.h"
#include "app/base/console.h"
#include "app/base/exit_code.h"
#include "app/base/quoting.h"
#include "app/commands/mesh_report.h"
#include "app/scene/diagnostics.h"

namespace app {
namespace {

/// A mesh in its mesh frame, and where it comes from.
struct ReadMesh {
  hydro::TriMesh mesh;
  assembly::MeshSource source;
};

ReadMesh read(const MeshCommand& command) {
  assembly::MeshFile file = assembly::read_welded(command.file, command.formats);
  ReadMesh read{.mesh = {},
                .source = {command.file, assembly::applied_frame(file.frame, command.frame)}};
  print(fmt::format("{}: {}\n", command.file.string(), description(read.source.frame)));
  if (const std::string note = assembly::note_of_dropped(file); !note.empty())
    print(fmt::format("  {} as it was read\n", note));
  read.mesh = assembly::in_mesh_frame(std::move(file.mesh), read.source.frame);
  return read;
}

/// Prints what the mesh is, and what would make a solid of it.
void describe(const ReadMesh& read, const MeshCommand& command) {
  const hydro::MeshDiagnosis diagnosis = hydro::diagnosed(read.mesh);
  for (const std::string& line : diagnosis_lines(read.mesh, diagnosis))
    print(fmt::format("{}\n", line));
  if (const std::string warning = size_warning(read.mesh, read.source, "--unit "); !warning.empty())
    print(fmt::format("  {}\n", warning));
  if (diagnosis.report.sound()) {
    print(fmt::format("  a solid of {:.5g} m^3\n", diagnosis.report.volume));
    return;
  }
  if (command.repair) return;
  const std::string file = shell_word(command.file.string());
  if (const std::optional<hydro::Remedy> remedy = hydro::remedy_for(read.mesh)) {
    using assembly::RemedyWords;
    print(fmt::format(
        "  becomes a solid of {:.5g} m^3 by `plimsoll mesh {} {} -o solid.obj`,\n"
        "  or in a scene by `mesh: {{file: {}, {}}}`\n",
        remedy->volume, file, words_of(remedy->options, read.mesh, RemedyWords::options),
        command.file.string(), words_of(remedy->options, read.mesh, RemedyWords::keys)));
    return;
  }
  print("  no option of --repair alone makes a solid of it");
  for (const hydro::OpenLoop& loop : diagnosis.loops)
    if (loop.shape != hydro::LoopShape::line) {
      print("; --thickness M makes a plate of what is open");
      break;
    }
  print("\n");
}

/// Mends the mesh. @throws InputError if it is no solid then
hydro::TriMesh repaired(const ReadMesh& read, const MeshCommand& command) {
  hydro::MendedMesh mended = hydro::mended(read.mesh, assembly::mend_options(command.mending));
  std::vector<scene::Fault> faults;
  for (const std::string& failure : mended.failures)
    faults.push_back({{command.file}, "", failure});
  for (const std::string& change : mended.changes) print(fmt::format("  mended: {}\n", change));
  for (const std::string& fault : hydro::describe(mended.report))
    faults.push_back({{command.file}, "", fault});
  if (!mended.report.sound())
    faults.back().message +=
        "; " + assembly::remedy_text(read.mesh, command.file, assembly::RemedyWords::options);
  flush_output();
  if (!faults.empty()) throw scene::InputError(std::move(faults));
  const assembly::MendingRecord record = assembly::mending_record(read.mesh, mended);
  print(fmt::format("  now a solid of {} triangles and {}, before: {}\n", mended.mesh.face_count(),
                    volume_text(record.volume_after), volume_text(record.volume_before)));
  return std::move(mended.mesh);
}

}  // namespace

int mesh_command(const MeshCommand& command) {
  if (assembly::asks_for_mending(command.mending) && !command.repair)
    throw scene::InputError("--repair",
                            "missing, expected beside --weld, --cap, --mirror, --unite and "
                            "--thickness");
  if (!command.out.empty() && !assembly::is_writable_mesh(command.out))
    throw scene::InputError(command.out, "expected a file with the extension .obj or .stl");
  const ReadMesh mesh = read(command);
  describe(mesh, command);
  const hydro::TriMesh result = command.repair ? repaired(mesh, command) : mesh.mesh;
  if (!command.out.empty()) {
    assembly::write_mesh(command.out, result);
    print(fmt::format("{}: written, in metres with z up\n", command.out.string()));
  }
  flush_output();
  return kDone;
}

}  // namespace app
