-- shadow_map_fbo, for the scenes of this folder.
return require "shadow_map_fbo"
