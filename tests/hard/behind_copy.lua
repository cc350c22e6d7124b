-- shadow_map_copy, for the scenes of this folder.
return require "shadow_map_copy"
