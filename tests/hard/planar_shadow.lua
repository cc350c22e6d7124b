-- projected_stencil, for the scenes of this folder.
return require "projected_stencil"
