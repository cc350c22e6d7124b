// What a Tracer is made of, for the files that implement it.
#pragma once

#include "truth/traced_scene.h"
#include "truth/tracer.h"

namespace shadowlab::truth {

struct Tracer::Parts : TracedScene {
  using TracedScene::TracedScene;
};

}  // namespace shadowlab::truth
