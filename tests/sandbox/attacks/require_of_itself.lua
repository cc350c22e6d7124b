-- Requires itself.
-- expect: recipe error
-- says: circle
require "require_of_itself"
