-- shadow_map_sampler, for the scenes of this folder.
return require "shadow_map_sampler"
