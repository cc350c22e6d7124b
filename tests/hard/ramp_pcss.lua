-- shadow_map_pcss, for the scenes of this folder.
return require "shadow_map_pcss"
