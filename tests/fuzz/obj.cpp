// Any bytes are a mesh that holds together, or an InputError.
#include "core/error.h"
#include "in_memory.h"
#include "scene/mesh.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size);
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace shadowlab;
  const fuzz::FileOf file({bytes, size});
  try {
    const scene::Mesh mesh = scene::read_obj(file.path());
    if (mesh.indices.size() % 3 != 0 || mesh.normals.size() != mesh.positions.size()) std::abort();
    if (!mesh.uvs.empty() && mesh.uvs.size() != mesh.positions.size()) std::abort();
    for (const auto index : mesh.indices) {
      if (index >= mesh.positions.size()) std::abort();
    }
  } catch (const InputError&) {
  }
  return 0;
}
