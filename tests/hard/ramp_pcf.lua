-- shadow_map_pcf, for the scenes of this folder.
return require "shadow_map_pcf"
