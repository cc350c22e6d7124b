-- shadow_map_moments, for the scenes of this folder.
return require "shadow_map_moments"
