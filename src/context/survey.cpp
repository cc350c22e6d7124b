#include "context/context.h"
#include "core/error.h"

namespace shadowlab::context {
namespace {

Report report_on(Report report) {
  try {
    Context context = create(report.backend);
    report.works = true;
    report.name = context.name;
    report.version = context.version;
    report.renderer = context.renderer;
    report.depth_bits = context.depth_bits;
    report.stencil_bits = context.stencil_bits;
    report.accum_bits = context.accum_bits;
  } catch (const MachineError& error) {
    report.why_not = error.what();
  }
  return report;
}

Report untried(Backend backend, const char* name, const char* package) {
  Report report;
  report.backend = backend;
  report.name = name;
  report.package = package;
  return report;
}

}  // namespace

std::vector<Report> survey() {
  return {report_on(untried(Backend::osmesa, "OSMesa", "libosmesa6")),
          report_on(untried(Backend::egl, "EGL", "libegl1")),
          report_on(untried(Backend::glfw, "GLFW", "libglfw3"))};
}

}  // namespace shadowlab::context
