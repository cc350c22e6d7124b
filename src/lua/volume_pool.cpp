#include "lua/volume_pool.h"

#include "shadow/back.h"

namespace shadowlab::lua {

VolumeSource::VolumeSource(gl::Graphics& graphics, const scene::Mesh& mesh)
    : bounds(scene::bounds(mesh)),
      solid_box(shadow::is_solid_box(mesh)),
      adjacency(scene::adjacency(mesh)),
      next(scene::next(adjacency)),
      facing(adjacency.positions, adjacency.triangles),
      builder(adjacency),
      layers(builder),
      vertices(std::make_shared<gl::VolumeVertices>(graphics.gl, graphics.calls(),
                                                    builder.vertices())) {}

VolumePool::Entry& VolumePool::entry(const std::shared_ptr<const scene::Mesh>& mesh) {
  Entry& entry = entries_[mesh.get()];
  // A new mesh may live where a dead one did.
  if (!entry.source || entry.mesh.lock() != mesh) {
    entry = {mesh, std::make_shared<VolumeSource>(graphics_, *mesh), {}, 0};
  }
  return entry;
}

std::shared_ptr<VolumeSource> VolumePool::source(const std::shared_ptr<const scene::Mesh>& mesh) {
  return entry(mesh).source;
}

VolumeBox& VolumePool::next(const std::shared_ptr<const scene::Mesh>& mesh) {
  Entry& found = entry(mesh);
  if (found.used == found.volumes.size()) {
    auto volume = std::make_shared<Volume>();
    volume->source = found.source;
    volume->buffers = std::make_unique<gl::VolumeBuffers>(graphics_.gl, graphics_.calls(),
                                                          found.source->vertices);
    found.volumes.push_back(std::move(volume));
  }
  return found.volumes[found.used++];
}

void VolumePool::keep_all() {
  for (auto& [mesh, entry] : entries_) {
    entry.volumes.clear();
    entry.used = 0;
  }
}

void VolumePool::begin_frame() {
  std::erase_if(entries_, [](const auto& item) { return item.second.mesh.expired(); });
  for (auto& [mesh, entry] : entries_) entry.used = 0;
}

}  // namespace shadowlab::lua
